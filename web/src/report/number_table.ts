/** Numbers of results in rows, beside those of a pinned result and with their differences. */
import { h } from '../dom';
import { digits, shownIn } from '../quantity';
import type { Column } from '../solver/protocol';
import { explained, t } from '../texts';

/** A quantity with a number for each heading: those of results, in SI. */
export interface Row {
  name: string;
  label: (Node | string)[];
  column: Column;
  present: number[];
  /** As many of the pinned result, if there is one. */
  pinned: number[] | null;
}

/** A table; with a pinned result each heading is over three numbers. */
export function numberTable(heads: string[], rows: Row[]): HTMLElement {
  const isCompared = rows.some(({ pinned }) => pinned);
  const under = [t('pinned'), t('difference')];
  const titles = isCompared ? heads.flatMap((head) => [head, ...under]) : heads;
  const head = h(
    'thead',
    {},
    h('tr', {}, h('td', {}), ...titles.map((title) => h('th', { scope: 'col' }, title))),
  );
  return h(
    'table',
    { class: isCompared ? 'scalars compared' : 'scalars' },
    ...(titles.length > 0 ? [head] : []),
    h('tbody', {}, ...rows.map(rowOf)),
  );
}

function rowOf({ name, label, column, present, pinned }: Row): HTMLElement {
  const { units } = column;
  const known = [...present, ...(pinned ?? [])].map((value) => cleaned(value, units));
  const sizes = known.filter(Number.isFinite).map(Math.abs);
  const { unit, factor } = shownIn(units, Math.max(0, ...sizes));
  const cells = present.flatMap((_, index) => {
    const value = known[index] ?? NaN;
    if (!pinned) return [value];
    const before = known[present.length + index] ?? NaN;
    return [value, before, value - before];
  });
  return h(
    'tr',
    { title: explained(name, column) },
    h('th', { scope: 'row' }, ...label),
    ...cells.map((cell) => h('td', {}, digits(cell / factor))),
    h('td', { class: 'unit' }, unit),
  );
}

/** A number without the noise of a force that vanishes. */
export function cleaned(value: number, units: string): number {
  return (units === 'N' || units === 'N m') && Math.abs(value) < 1e-6 ? 0 : value;
}
