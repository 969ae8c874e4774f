/** The view of a contact patch: a map of any quantity, traction arrows, a section along rolling. */
import { h } from '../dom';
import { colourScale } from '../draw/colour_map';
import { Chart, type Curve } from '../draw/chart';
import {
  borderOfStick,
  edges,
  numbers,
  onGrid,
  rowNear,
  tractionArrows,
  withMagnitudes,
} from '../draw/fields';
import { HeatMap, type MapContent } from '../draw/heat_map';
import { sampled, united } from '../draw/sampling';
import type { Surface } from '../draw/surface';
import type { Result } from '../explorer';
import { digits, labelled, largestOf, shownFor, withUnit, type Shown } from '../quantity';
import type { Grid, Table } from '../solver/protocol';
import { columnName, explained, t } from '../texts';
import { Player } from './player';

/** A table of fields with its grid. */
interface Field {
  table: Table;
  grid: Grid;
}

/** Columns that say where a cell is. */
const PLACES = ['x', 'y'];

/** Fields of a contact of a result; of one of its frames in time, if it has any. */
function fieldOf(result: Result, contact: number, frame: number | null): Field | null {
  const { tables, grids } = result.answered;
  const own = tables['fields'] ?? [];
  const table = frame === null ? own[contact] : tables['frame']?.[frame];
  const grid = grids[frame === null ? contact : own.length + frame];
  if (!table || !grid || grid.cells.length === 0) return null;
  return { table: withMagnitudes(table), grid };
}

/** Maps and sections of a contact patch. */
export class PatchView {
  readonly element: HTMLElement;
  /** The map that is saved as a picture. */
  readonly map = new HeatMap(430);
  private readonly pinnedMap = new HeatMap(430);
  private readonly section = new Chart(230);
  private readonly player = new Player(() => this.draw());
  private readonly quantity = h('select', { id: 'quantity', onchange: () => this.draw() });
  private readonly contact = h('select', { id: 'contact', onchange: () => this.chosen() });
  private readonly arrows = h('input', {
    type: 'checkbox',
    checked: true,
    onchange: () => this.draw(),
  });
  private readonly border = h('input', {
    type: 'checkbox',
    checked: true,
    onchange: () => this.draw(),
  });
  private readonly isSurface = h('input', {
    type: 'checkbox',
    onchange: () => void this.toggleSurface(),
  });
  private readonly surfacePlace = h('div', {});
  private surface: Surface | null = null;
  private readonly contactLabel: HTMLElement;
  private readonly none = h('p', { class: 'hint' }, t('no_fields'));
  private readonly drawn: HTMLElement;
  private result: Result | null = null;
  private pinned: Result | null = null;
  private isShown = false;
  private framed: { result: Result; name: string; extremes: number[] } | null = null;

  /** `onContact` is told which contact is shown. */
  constructor(private readonly onContact: (contact: number) => void) {
    this.contactLabel = h('label', {}, t('contact'), ' ', this.contact);
    const bar = h(
      'div',
      { class: 'toolbar' },
      h('label', { for: 'quantity' }, t('quantity')),
      this.quantity,
      this.contactLabel,
      h('label', {}, this.arrows, ` ${t('arrows')}`),
      h('label', {}, this.border, ` ${t('border')}`),
      h('label', {}, this.isSurface, ` ${t('surface_3d')}`),
      h(
        'span',
        { class: 'legend' },
        h('span', { class: 'dark' }, '→'),
        ` ${t('slip')} `,
        h('span', { class: 'light' }, '→'),
        ` ${t('stick')}`,
      ),
    );
    this.drawn = h(
      'div',
      {},
      bar,
      h('div', { class: 'maps' }, this.map.element, this.pinnedMap.element),
      this.surfacePlace,
      this.player.element,
      this.section.element,
    );
    this.element = h('div', {}, this.none, this.drawn);
  }

  /** The contact that is shown. */
  get contactIndex(): number {
    return Math.max(0, Number(this.contact.value) || 0);
  }

  /** Shows a result, beside a pinned one. */
  show(result: Result, pinned: Result | null): void {
    const frames = result.answered.tables['frame']?.length ?? 0;
    const isNew = this.result !== result;
    [this.result, this.pinned] = [result, pinned];
    if (isNew) this.player.show(result, frames);
    this.fillChoices(result);
    this.draw();
  }

  /** Whether the view is seen: it is drawn only then. */
  set visible(isShown: boolean) {
    this.isShown = isShown;
    this.draw();
  }

  /** Draws anew, in other colours. */
  refresh(): void {
    this.draw();
  }

  private async toggleSurface(): Promise<void> {
    const { Surface: Loaded } = await import('../draw/surface');
    this.surface = this.isSurface.checked ? new Loaded() : null;
    this.surfacePlace.replaceChildren(...(this.surface ? [this.surface.canvas] : []));
    this.draw();
  }

  private chosen(): void {
    this.draw();
    this.onContact(this.contactIndex);
  }

  private fillChoices(result: Result): void {
    const contacts = result.answered.tables['fields']?.length ?? 0;
    this.contactLabel.hidden = contacts < 2;
    if (this.contact.options.length !== contacts) {
      this.contact.replaceChildren(
        ...Array.from({ length: contacts }, (_, index) =>
          h('option', { value: index }, String(index + 1)),
        ),
      );
    }
    const field = fieldOf(result, this.contactIndex, null);
    const names = Object.keys(field?.table ?? {}).filter((name) => !PLACES.includes(name));
    const present = [...this.quantity.options].map(({ value }) => value);
    if (names.length === 0 || names.join() === present.join()) return;
    const chosen = this.quantity.value || 'pressure';
    this.quantity.replaceChildren(
      ...names.map((name) => {
        const column = field?.table[name];
        const label = `${columnName(name, column)} ${column?.symbol ?? ''}`.trim();
        return h('option', { value: name, title: column ? explained(name, column) : '' }, label);
      }),
    );
    this.quantity.value = names.includes(chosen) ? chosen : (names[0] ?? '');
  }

  private draw(): void {
    const { result, pinned } = this;
    if (!result || !this.isShown) return;
    const field = fieldOf(result, this.contactIndex, this.player.frame);
    this.none.hidden = field !== null;
    this.drawn.hidden = field === null;
    const name = this.quantity.value;
    if (!field?.table[name]) return;
    this.quantity.title = explained(name, field.table[name]);
    const beside = pinned ? fieldOf(pinned, this.contactIndex, null) : null;
    const one = [...numbers(field.table[name]), ...numbers(beside?.table[name])];
    const seen = [...one, ...this.extremes(result, name)];
    const shown = shownFor(field.table[name].units, seen);
    const scale = colourScale(seen.map((value) => value / shown.factor));
    const tractions = [field, beside].flatMap((one) => [...numbers(one?.table['traction'])]);
    const longest = largestOf(tractions);
    const content = this.content(field, name, shown, { note: beside ? t('present') : '', longest });
    this.map.show(content, scale);
    this.pinnedMap.element.hidden = !beside?.table[name];
    if (beside?.table[name]) {
      this.pinnedMap.show(this.content(beside, name, shown, { note: t('pinned'), longest }), scale);
    }
    this.surface?.show(content, scale);
    this.drawSection(field, beside, name, shown);
  }

  /** The extremes of all frames, so that colours mean the same while time passes. */
  private extremes(result: Result, name: string): number[] {
    if (this.framed?.result === result && this.framed.name === name) return this.framed.extremes;
    const extremes = (result.answered.tables['frame'] ?? []).flatMap((table) => {
      const values = numbers(withMagnitudes(table)[name]);
      return [Math.min(...values), Math.max(...values)];
    });
    this.framed = { result, name, extremes };
    return extremes;
  }

  private content(
    { table, grid }: Field,
    name: string,
    shown: Shown,
    { note, longest }: { note: string; longest: number },
  ): MapContent {
    const places = new Map(
      grid.cells.map(([column, row], index) => [row * grid.columns + column, index]),
    );
    const column = table[name];
    const every = Math.max(1, Math.round(Math.max(grid.columns, grid.rows) / 18));
    const describe = (at: number, row: number) => {
      const index = places.get(row * grid.columns + at) ?? 0;
      return Object.entries(table).map(([key, one]) => {
        const value = Number(one.values[index]);
        return `${one.symbol || columnName(key, one)}  ${withUnit(value, one.units)}`;
      });
    };
    return {
      title: columnName(name, column),
      unit: shown.unit,
      xEdges: edges(grid, 0),
      yEdges: edges(grid, 1),
      values: onGrid(numbers(column), grid, shown.factor),
      labels: [`x (mm) – ${t('rolling')} →`, 'y (mm)'],
      isToScale: true,
      describe,
      note,
      ...(this.arrows.checked
        ? { arrows: { all: tractionArrows(table, grid, every), longest } }
        : {}),
      ...(this.border.checked ? { border: borderOfStick(table, grid) } : {}),
    };
  }

  private drawSection(field: Field, beside: Field | null, name: string, shown: Shown): void {
    const row = rowNear(field.grid, 0);
    const other = beside?.table[name] ? rowNear(beside.grid, 0) : null;
    const x = united(row.x, other?.x ?? []);
    const along = ({ x: xs, cells }: typeof row, values: Float64Array) => {
      const own = cells.map((cell) => (values[cell] ?? NaN) / shown.factor);
      return sampled(xs, own, x);
    };
    const taken = (values: Float64Array) => along(row, values);
    const curves: Curve[] = [
      {
        label: columnName(name, field.table[name], field.table[name]?.symbol),
        values: taken(numbers(field.table[name])),
        colour: 0,
      },
    ];
    if (name.startsWith('traction')) {
      const pressure = numbers(field.table['pressure']);
      const friction = numbers(field.table['friction_coefficient']);
      const limit = taken(pressure.map((value, index) => value * (friction[index] ?? NaN)));
      const own = numbers(field.table[name]);
      const isNegative = row.cells.reduce((sum, cell) => sum + (own[cell] ?? 0), 0) < 0;
      curves.push({
        label: t('friction_limit'),
        values: isNegative ? limit.map((value) => -value) : limit,
        colour: 1,
        dashed: true,
      });
    }
    if (other) {
      curves.push({
        label: t('pinned'),
        values: along(other, numbers(beside?.table[name])),
        colour: 2,
        dashed: true,
      });
    }
    this.section.show({
      x,
      xLabel: `x (mm), ${t('section_at')} y = ${digits(row.y * 1e3, 2)} mm`,
      yLabel: labelled(
        field.table[name]?.symbol || columnName(name, field.table[name]),
        shown.unit,
      ),
      curves,
    });
  }
}
