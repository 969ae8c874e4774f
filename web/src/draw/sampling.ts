/** Curves over places that are not their own, so that several share the abscissa of a chart. */

/** All places of several curves, in order. */
export function united(...places: ArrayLike<number>[]): number[] {
  const all = new Set(places.flatMap((xs) => Array.from(xs)));
  return [...all].sort((one, other) => one - other);
}

/** Values of a curve at other places; not a number beyond its own. */
export function sampled(
  xs: ArrayLike<number>,
  ys: ArrayLike<number>,
  places: readonly number[],
): number[] {
  return places.map((x) => interpolated(xs, ys, x));
}

function interpolated(xs: ArrayLike<number>, ys: ArrayLike<number>, x: number): number {
  for (let index = 0; index < xs.length; index += 1) {
    const [x0, x1] = [xs[index] ?? NaN, xs[index + 1] ?? NaN];
    const [y0, y1] = [ys[index] ?? NaN, ys[index + 1] ?? NaN];
    if (x === x0) return y0;
    if ((x - x0) * (x - x1) < 0) return y0 + ((x - x0) / (x1 - x0)) * (y1 - y0);
  }
  return NaN;
}
