/** Colour maps that the colour-blind can read: viridis, and blue to red through white. */

const VIRIDIS = [
  '440154',
  '472d7b',
  '3b528b',
  '2c728e',
  '21918c',
  '28ae80',
  '5ec962',
  'addc30',
  'fde725',
];
const DIVERGING = [
  '053061',
  '2166ac',
  '4393c3',
  '92c5de',
  'd1e5f0',
  'f7f7f7',
  'fddbc7',
  'f4a582',
  'd6604d',
  'b2182b',
  '67001f',
];
const LEVELS = 256;

function sampled(stops: string[]): string[] {
  const channels = stops.map((stop) => [0, 2, 4].map((at) => parseInt(stop.slice(at, at + 2), 16)));
  return Array.from({ length: LEVELS }, (_, level) => {
    const place = (level / (LEVELS - 1)) * (stops.length - 1);
    const below = Math.min(Math.floor(place), stops.length - 2);
    const part = place - below;
    const mixed = [0, 1, 2].map((channel) => {
      const [low, high] = [channels[below]?.[channel] ?? 0, channels[below + 1]?.[channel] ?? 0];
      return Math.round(low + part * (high - low));
    });
    return `rgb(${mixed.join(',')})`;
  });
}

const SEQUENTIAL_LEVELS = sampled(VIRIDIS);
const DIVERGING_LEVELS = sampled(DIVERGING);

/** A range of values with its colours. */
export interface ColourScale {
  low: number;
  high: number;
  of(value: number): string;
}

/** Colours for values: diverging about zero where signs differ. */
export function colourScale(values: ArrayLike<number>): ColourScale {
  let [low, high] = [Infinity, -Infinity];
  for (let index = 0; index < values.length; index += 1) {
    const value = values[index] ?? NaN;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (!(low <= high)) [low, high] = [0, 1];
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const isSigned = low < -1e-6 * largest;
  if (isSigned) [low, high] = [-largest, largest];
  else if (low > 0 && low < 0.5 * high) low = 0;
  if (low === high) high = low + (Math.abs(low) || 1);
  const levels = isSigned ? DIVERGING_LEVELS : SEQUENTIAL_LEVELS;
  const of = (value: number) => {
    const level = Math.round(((value - low) / (high - low)) * (LEVELS - 1));
    return levels[Math.max(0, Math.min(LEVELS - 1, level))] ?? '';
  };
  return { low, high, of };
}
