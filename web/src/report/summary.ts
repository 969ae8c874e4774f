/** Scalars of a solution, beside those of a pinned one, with warnings. */
import { h } from '../dom';
import { numberOf } from '../draw/fields';
import type { Result } from '../explorer';
import { digits, shownIn } from '../quantity';
import type { Column, Table, Told } from '../solver/protocol';
import { symbolOf } from '../symbols';
import { columnName, explained, t } from '../texts';
import { cleaned, numberTable } from './number_table';

/** Quantities that are shown large. */
const LARGE = ['force.x', 'force.y', 'traction_coefficient', 'temperature.max_rise'];
/** Parts of a solution that say how it was found. */
const OWN = /^(work|residual|extrapolation|normalised)/;

/** The summary of a result. */
export function summary(result: Result, pinned: Result | null, contact: number): HTMLElement {
  const { told, tables } = result.answered;
  const solution = tables['solution']?.[contact] ?? {};
  const before = pinned?.answered.tables;
  const isConverged = told.status === 'converged';
  const status = h(
    'p',
    { class: isConverged ? 'status' : 'status bad', role: 'status' },
    t(isConverged ? 'converged' : 'not_converged'),
    ' · ',
    t('solved_in'),
    ` ${digits(result.milliseconds, 2)} ms`,
    result.answered.isQuick ? ` · ${t('quick')}` : '',
  );
  return h(
    'div',
    {},
    status,
    result.isTransient ? h('p', { class: 'hint' }, t('at_end')) : '',
    large(solution),
    scalars(tables['wheel']?.[0], before?.['wheel']?.[0]),
    scalars(solution, before?.['solution']?.[contact]),
    warnings(told),
    whole(told),
  );
}

function isKnown([name, column]: [string, Column]): boolean {
  const value = column.values[0];
  return !OWN.test(name) && typeof value === 'number' && !Number.isNaN(value);
}

/** What a column is called. */
function label(name: string, column: Column): Node[] {
  const { long_name: meaning, symbol } = column;
  const body = /_(wheel|rail)$/.exec(name)?.[1];
  const own = body && !meaning.includes(body) ? `${meaning}, ${body}` : meaning;
  const english = name.startsWith('t_gamma.') ? `Tγ ${name.slice(8).replace('_', ' ')}` : own;
  const parts: Node[] = [document.createTextNode(`${columnName(name, column, english)} `)];
  if (symbol && !name.startsWith('t_gamma')) parts.push(symbolOf(symbol));
  return parts;
}

function large(solution: Table): HTMLElement {
  const shown = Object.entries(solution).filter(
    (entry) => LARGE.includes(entry[0]) && isKnown(entry),
  );
  return h(
    'dl',
    { class: 'large' },
    ...shown.map(([name, column]) => {
      const value = cleaned(numberOf(solution, name), column.units);
      const { unit, factor } = shownIn(column.units, value);
      return h(
        'div',
        { title: explained(name, column) },
        h('dt', {}, columnName(name, column)),
        h(
          'dd',
          { 'data-quantity': name, 'data-value': value },
          digits(value / factor),
          h('span', { class: 'unit' }, ` ${unit}`),
        ),
      );
    }),
  );
}

function scalars(table: Table | undefined, other: Table | undefined): HTMLElement | string {
  if (!table) return '';
  const rows = Object.entries(table)
    .filter(isKnown)
    .map(([name, column]) => ({
      name,
      label: label(name, column),
      column,
      present: [numberOf(table, name)],
      pinned: other ? [numberOf(other, name)] : null,
    }));
  return numberTable(other ? [t('present')] : [], rows);
}

/** Warnings with their codes. */
export function warnings({ warnings: list }: Told): HTMLElement | string {
  if (list.length === 0) return '';
  return h(
    'section',
    { class: 'warnings' },
    h('h3', {}, t('warnings')),
    h('ul', {}, ...list.map(({ code, text }) => h('li', {}, h('code', {}, code), ` ${text}`))),
  );
}

/** The summary as the program writes it. */
export function whole(told: Told, isOpen = false): HTMLElement {
  const line = (entry: Told['summary'][number]) => {
    if (typeof entry === 'string') return entry;
    const [name, value, unit, remark] = entry;
    return `${name.padEnd(26)} ${value.padStart(9)} ${unit.padEnd(5)} ${remark}`.trimEnd();
  };
  const details = h(
    'details',
    { class: 'whole' },
    h('summary', {}, t('summary')),
    h('pre', { tabindex: 0 }, told.summary.map(line).join('\n')),
  );
  details.open = isOpen;
  return details;
}
