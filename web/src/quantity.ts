/** How SI values are shown: units that fit, and digits that a person reads. */

/** A unit to show: its text and the factor from it to SI. */
export interface Shown {
  unit: string;
  factor: number;
}

/** Units to show in place of SI units, the larger ones first. */
const SCALES: Record<string, [string, number][]> = {
  m: [
    ['m', 1],
    ['mm', 1e-3],
    ['µm', 1e-6],
    ['nm', 1e-9],
  ],
  'm^2': [
    ['m²', 1],
    ['mm²', 1e-6],
  ],
  'm/s': [
    ['m/s', 1],
    ['mm/s', 1e-3],
  ],
  Pa: [
    ['GPa', 1e9],
    ['MPa', 1e6],
    ['kPa', 1e3],
    ['Pa', 1],
  ],
  'Pa/m': [['MPa/mm', 1e9]],
  N: [
    ['kN', 1e3],
    ['N', 1],
  ],
  'N m': [
    ['kN m', 1e3],
    ['N m', 1],
  ],
  W: [
    ['kW', 1e3],
    ['W', 1],
  ],
  'W/m^2': [
    ['W/mm²', 1e6],
    ['W/m²', 1],
  ],
  'kg/m^3': [['kg/m³', 1]],
  J: [
    ['J', 1],
    ['mJ', 1e-3],
  ],
  s: [
    ['s', 1],
    ['ms', 1e-3],
    ['µs', 1e-6],
  ],
  degC: [['°C', 1]],
  'm^4': [['µm⁴', 1e-24]],
  'rad/m': [
    ['rad/µm', 1e6],
    ['rad/mm', 1e3],
    ['rad/m', 1],
  ],
};

/** The unit in which the largest of some values is easily read. */
export function shownIn(si: string, largest: number): Shown {
  const scales = SCALES[si];
  if (!scales) return { unit: si, factor: 1 };
  const size = Math.abs(largest);
  const fitting = scales.find(([, factor]) => size >= 0.9999 * factor);
  const own = scales.find(([, factor]) => factor === 1);
  const fallback = size > 0 ? scales[scales.length - 1] : own;
  const [unit, factor] = fitting ?? fallback ?? [si, 1];
  return { unit, factor };
}

/** The unit for all values of an array. */
export function shownFor(si: string, values: ArrayLike<number>): Shown {
  return shownIn(si, largestOf(values));
}

/** The largest magnitude of finite values. */
export function largestOf(values: ArrayLike<number>): number {
  let largest = 0;
  for (let index = 0; index < values.length; index += 1) {
    const size = Math.abs(values[index] ?? 0);
    if (size > largest && Number.isFinite(size)) largest = size;
  }
  return largest;
}

/** A number with a few digits, as in case files: a point, and a real minus sign. */
export function digits(value: number, significant = 4): string {
  if (Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const isPlain = size >= 1e-4 && size < 1e6;
  const text = isPlain
    ? String(Number(value.toPrecision(significant)))
    : value.toExponential(significant - 1).replace(/\.?0+e\+?/, 'e');
  return text.replace(/-/g, '−');
}

/** A value with its unit. */
export function withUnit(si: number, units: string): string {
  const { unit, factor } = shownIn(units, si);
  return `${digits(si / factor)}${unit ? ` ${unit}` : ''}`;
}

/** The number that a person typed, with a point or a comma; else not a number. */
export function numberTyped(text: string): number {
  const plain = text.trim().replace(/−/g, '-').replace(/^([-+]?\d*),(\d)/, '$1.$2');
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
}

/** A label: name or symbol with the unit in brackets. */
export function labelled(name: string, unit: string): string {
  return unit ? `${name} (${unit})` : name;
}
