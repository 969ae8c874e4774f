/** Fields of a contact as they are drawn: on their grid, with magnitudes, border and arrows. */
import type { Column, Grid, Table } from '../solver/protocol';
import type { Arrow, Segment } from './arrows';

/** Numbers of a column; empty if it holds text. */
export function numbers(column: Column | undefined): Float64Array {
  return column?.values instanceof Float64Array ? column.values : new Float64Array();
}

/** The first number of a column. */
export function numberOf(table: Table | undefined, name: string): number {
  return numbers(table?.[name])[0] ?? NaN;
}

/** The table with the magnitude of each vector, whose parts are columns `…_x` and `…_y`. */
export function withMagnitudes(table: Table): Table {
  const found: Table = {};
  for (const [name, column] of Object.entries(table)) {
    const across = name.endsWith('_x') ? table[name.replace(/_x$/, '_y')] : undefined;
    if (across) found[name.slice(0, -2)] = magnitude(name.slice(0, -2), column, across);
    found[name] = column;
  }
  return found;
}

function magnitude(quantity: string, along: Column, across: Column): Column {
  const [x, y] = [numbers(along), numbers(across)];
  const symbol = `|${along.symbol.replace(/_?x$/, '')}|`;
  return {
    values: x.map((value, index) => Math.hypot(value, y[index] ?? 0)),
    quantity,
    symbol,
    definition: `${symbol} = √(${along.symbol}² + ${across.symbol}²)`,
    units: along.units,
    long_name: along.long_name
      .replace(/,? ?(along rolling|along x|longitudinal|in x)\b/, '')
      .trim(),
  };
}

/** Values on all cells of a grid, row by row; not a number outside the contact. */
export function onGrid(values: Float64Array, grid: Grid, factor: number): Float64Array {
  const result = new Float64Array(grid.columns * grid.rows).fill(NaN);
  grid.cells.forEach(([column, row], index) => {
    result[row * grid.columns + column] = (values[index] ?? NaN) / factor;
  });
  return result;
}

/** Edges of cells along an axis, in mm. */
export function edges(grid: Grid, axis: 0 | 1): number[] {
  const count = axis === 0 ? grid.columns : grid.rows;
  const [start, step] = [grid.origin[axis], grid.spacing[axis]];
  return Array.from({ length: count + 1 }, (_, index) => (start + (index - 0.5) * step) * 1e3);
}

/** Edges of cells around points that need not be evenly spaced. */
export function edgesAround(points: number[]): number[] {
  const between = points.slice(1).map((point, index) => (point + (points[index] ?? 0)) / 2);
  const first = points[0] ?? 0;
  const last = points.at(-1) ?? 1;
  return [
    2 * first - (between[0] ?? first - 0.5),
    ...between,
    2 * last - (between.at(-1) ?? last - 0.5),
  ];
}

/** The border between cells that stick and cells that slide, in mm. */
export function borderOfStick(table: Table, grid: Grid): Segment[] {
  const sliding = onGrid(numbers(table['sliding']), grid, 1);
  const [xs, ys] = [edges(grid, 0), edges(grid, 1)];
  const at = (column: number, row: number) =>
    column < grid.columns && row < grid.rows ? sliding[row * grid.columns + column] : NaN;
  const differ = (one?: number, other?: number) =>
    (one === 0 && other === 1) || (one === 1 && other === 0);
  const border: Segment[] = [];
  grid.cells.forEach(([column, row]) => {
    const [x0, x1] = [xs[column] ?? 0, xs[column + 1] ?? 0];
    const [y0, y1] = [ys[row] ?? 0, ys[row + 1] ?? 0];
    if (differ(at(column, row), at(column + 1, row))) border.push([x1, y0, x1, y1]);
    if (differ(at(column, row), at(column, row + 1))) border.push([x0, y1, x1, y1]);
  });
  return border;
}

/** Arrows of the traction on the wheel, on every so many cells. */
export function tractionArrows(table: Table, grid: Grid, every: number): Arrow[] {
  const [u, v] = [numbers(table['traction_x']), numbers(table['traction_y'])];
  const sliding = numbers(table['sliding']);
  const offset = Math.floor(every / 2);
  const arrows: Arrow[] = [];
  grid.cells.forEach(([column, row], index) => {
    if (column % every !== offset || row % every !== offset) return;
    arrows.push({
      x: (grid.origin[0] + column * grid.spacing[0]) * 1e3,
      y: (grid.origin[1] + row * grid.spacing[1]) * 1e3,
      u: u[index] ?? 0,
      v: v[index] ?? 0,
      slides: sliding[index] === 1,
    });
  });
  return arrows;
}

/** Values along rolling in the row nearest to y = 0: x in mm and indices of cells. */
export function rowNear(grid: Grid, y: number): { y: number; x: number[]; cells: number[] } {
  const wanted = Math.round((y - grid.origin[1]) / grid.spacing[1]);
  const rows = [...new Set(grid.cells.map(([, row]) => row))];
  const row = rows.reduce(
    (best, at) => (Math.abs(at - wanted) < Math.abs(best - wanted) ? at : best),
    rows[0] ?? 0,
  );
  const members = grid.cells
    .map(([column, at], index) => ({ column, at, index }))
    .filter(({ at }) => at === row)
    .sort((one, other) => one.column - other.column);
  return {
    y: grid.origin[1] + row * grid.spacing[1],
    x: members.map(({ column }) => (grid.origin[0] + column * grid.spacing[0]) * 1e3),
    cells: members.map(({ index }) => index),
  };
}
