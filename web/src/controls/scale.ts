/** Slider positions of numbers: linear, logarithmic, or both signs with finer steps about zero. */
import type { Field } from '../catalogue';

/** Steps of a slider. */
export const STEPS = 1000;

/** What a slider does. */
export interface Scale {
  toValue(position: number): number;
  toPosition(value: number): number;
}

/** How much finer the middle of a slider with both signs is than its ends. */
const FINENESS = 1e3;
/** A slider of positive numbers spans so much about the present one. */
const SPAN = 10;

/** The scale of a field about a value; null where no range is known. */
export function scaleOf(field: Field, about: number): Scale | null {
  const range = rangeOf(field, about);
  if (!range) return null;
  const [low, high] = range;
  const isCount = field.kind === 'count';
  if (low > 0 && high / low > 100 * 0.999) {
    return between(Math.log(low), Math.log(high), Math.log, (value) =>
      tidy(Math.exp(value), isCount),
    );
  }
  if (low < 0 && high > 0 && low === -high) {
    const unit = high / FINENESS;
    const forth = (value: number) => Math.asinh(value / unit);
    const back = (value: number) => tidy(unit * Math.sinh(value), isCount);
    // The ends are left out: a creepage of 1 is a wheel that is locked.
    const end = forth(high) * (1 - 1 / STEPS);
    return between(-end, end, forth, back);
  }
  return between(
    low,
    high,
    (value) => value,
    (value) => tidy(value, isCount),
  );
}

function rangeOf(field: Field, about: number): [number, number] | null {
  const [low, high] = field.usual ?? field.bounds;
  const isKnown = low !== null && high !== null && (field.usual !== null || Math.abs(high) <= 1024);
  if (isKnown && low > 0 && high / low > 100) {
    const known = about > 0 ? about : Math.sqrt(low * high);
    return [Math.max(low, known / SPAN), Math.min(high, known * SPAN)];
  }
  if (isKnown) return [low, high];
  if (!Number.isFinite(about) || about === 0) return null;
  const size = SPAN * Math.abs(about);
  return low !== null && low < 0 ? [-size, size] : [Math.abs(about) / SPAN, size];
}

function between(
  low: number,
  high: number,
  forth: (value: number) => number,
  back: (value: number) => number,
): Scale {
  return {
    toValue: (position) => back(low + (position / STEPS) * (high - low)),
    toPosition: (value) => Math.round(((forth(value) - low) / (high - low)) * STEPS),
  };
}

/** Four digits, as a person would give a number. */
function tidy(value: number, isCount: boolean): number {
  if (Math.abs(value) < 1e-12) return 0;
  return isCount ? Math.round(value) : Number(value.toPrecision(4));
}
