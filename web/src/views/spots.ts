/** The real contact of a rough surface: the pressure in the cells that touch. */
import { edgesAround, numbers } from '../draw/fields';
import { HeatMap } from '../draw/heat_map';
import { shownFor, withUnit } from '../quantity';
import type { Table } from '../solver/protocol';
import { columnName } from '../texts';

/** A map of a table of all cells, row by row. */
export function spotsMap(table: Table): HTMLElement {
  const [x, y, pressure] = ['x', 'y', 'pressure'].map((name) => numbers(table[name]));
  if (!x || !y || !pressure) throw new Error('no cells');
  const columns = y.findIndex((value) => value !== y[0]);
  const [length, scale] = [shownFor('m', x), shownFor('Pa', pressure)];
  const edges = (values: Float64Array) =>
    edgesAround([...values].map((value) => value / length.factor));
  const mean = pressure.reduce((sum, value) => sum + value, 0) / pressure.length;
  const map = new HeatMap(430);
  map.show({
    title: columnName('pressure', table['pressure']),
    unit: scale.unit,
    xEdges: edges(x.slice(0, columns)),
    yEdges: edges(y.filter((_, index) => index % columns === 0)),
    values: pressure.map((value) => (value > 0 ? value / scale.factor : NaN)),
    labels: [`x (${length.unit})`, `y (${length.unit})`],
    isToScale: true,
    note: `⟨p⟩ = ${withUnit(mean, 'Pa')}`,
    describe: (column, row) => [`p  ${withUnit(pressure[row * columns + column] ?? NaN, 'Pa')}`],
  });
  return map.element;
}
