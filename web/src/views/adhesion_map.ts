/** A map of a result over what a curve varies and any other number of the case. */
import { isNumeric, shownUnit, type Catalogue, type Field } from '../catalogue';
import type { CaseModel } from '../case/model';
import { h, labelledControl } from '../dom';
import { edgesAround, numbers } from '../draw/fields';
import { HeatMap } from '../draw/heat_map';
import { digits, labelled, numberTyped, shownFor, withUnit } from '../quantity';
import type { Lane } from '../solver/lane';
import type { Fields, Table } from '../solver/protocol';
import { columnName, fieldName, nameOf, sectionWords, t } from '../texts';
import { prettyUnit } from '../controls/field_control';
import { varied, type CurveView } from './curve';
import { Inquiry } from './inquiry';

/** Curves of a map. */
const CURVES = 9;
/** The field that a map is over at first. */
const FIRST_OVER = 'kinematics.speed';

/** The adhesion map. */
export class AdhesionMap {
  readonly element: HTMLElement;
  private readonly map = new HeatMap(330);
  private readonly over = h('select', { id: 'map-over', onchange: () => this.proposeRange() });
  private readonly from = h('input', {
    id: 'map-from',
    type: 'text',
    inputmode: 'decimal',
    class: 'short',
  });
  private readonly to = h('input', {
    id: 'map-to',
    type: 'text',
    inputmode: 'decimal',
    class: 'short',
  });
  private readonly unit = h('span', { class: 'unit' });
  private readonly ordinate = h('select', { id: 'map-ordinate', onchange: () => this.draw() });
  private readonly choice = labelledControl(t('ordinate'), this.ordinate);
  private readonly inquiry: Inquiry;
  private fields: Fields | null = null;
  private tables: Table[] = [];
  private levels: number[] = [];
  /** What the map is over, and what its curves vary. */
  private drawnOver: Field | null = null;
  private drawnAlong = '';
  private drawnKey = '';
  private readonly stale = h('p', { class: 'hint', hidden: true }, t('outdated'));

  constructor(
    private readonly catalogue: Catalogue,
    private readonly model: CaseModel,
    lane: Lane,
    private readonly curve: CurveView,
  ) {
    this.inquiry = new Inquiry('map', model, lane);
    const bar = h(
      'div',
      { class: 'toolbar' },
      labelledControl(t('over'), this.over),
      labelledControl(t('from'), this.from),
      labelledControl(t('to'), this.to),
      this.unit,
      h(
        'button',
        { type: 'button', 'data-task': 'map', onclick: () => void this.compute() },
        t('compute'),
      ),
      this.choice,
    );
    this.choice.hidden = true;
    this.map.element.hidden = true;
    this.element = h(
      'section',
      { class: 'task' },
      h('h2', {}, t('adhesion_map')),
      bar,
      this.stale,
      this.map.element,
      this.inquiry.element,
    );
    model.listen((change) => (change === 'opened' ? this.clear() : this.markStale()));
  }

  /** Offers the numbers of a case. */
  show(fields: Fields): void {
    this.fields = fields;
    const isOffered = (path: string) => {
      const field = this.catalogue.field(path);
      return field !== undefined && isNumeric(field) && typeof fields.values[path] === 'number';
    };
    const paths = fields.effective.filter(isOffered);
    const present = [...this.over.options].map(({ value }) => value);
    if (paths.join() === present.join()) return;
    const chosen = this.over.value || FIRST_OVER;
    this.over.replaceChildren(
      ...paths.map((path) => h('option', { value: path }, this.label(path))),
    );
    this.over.value = paths.includes(chosen) ? chosen : (paths[0] ?? '');
    this.proposeRange();
  }

  /** Draws anew, in other colours or with another present point. */
  refresh(): void {
    this.draw();
  }

  /** Section and name of a field. */
  private label(path: string): string {
    const of = path.slice(0, path.lastIndexOf('.'));
    const section = this.catalogue.sections.find(({ name }) => name === of);
    const field = this.catalogue.field(path);
    return section && field ? `${sectionWords(section)[0]}: ${fieldName(field)}` : path;
  }

  private clear(): void {
    this.tables = [];
    this.ordinate.replaceChildren();
    for (const one of [this.map.element, this.choice, this.stale]) one.hidden = true;
  }

  /** What a map depends on: all but what it is over and what its curves vary. */
  private key(over: Field, along: string): string {
    return this.model.key([over.path, varied(along)]);
  }

  private markStale(): void {
    const { tables, drawnOver } = this;
    const isPresent =
      tables.length === 0 ||
      (drawnOver !== null && this.key(drawnOver, this.drawnAlong) === this.drawnKey);
    this.stale.hidden = isPresent;
    this.element.classList.toggle('old', !isPresent);
  }

  private proposeRange(): void {
    const field = this.catalogue.field(this.over.value);
    const value = this.fields?.values[this.over.value];
    if (!field || typeof value !== 'number') return;
    const [unit, factor] = shownUnit(field);
    this.unit.textContent = prettyUnit(unit);
    const shown = value / factor;
    this.from.value = String(Number((shown / 2).toPrecision(2)));
    this.to.value = String(Number((shown * 2 || 1).toPrecision(2)));
  }

  private async compute(): Promise<void> {
    const field = this.catalogue.field(this.over.value);
    if (!field) return;
    const [unit] = shownUnit(field);
    const [low, high] = [numberTyped(this.from.value), numberTyped(this.to.value)];
    this.from.setAttribute('aria-invalid', String(Number.isNaN(low)));
    this.to.setAttribute('aria-invalid', String(Number.isNaN(high)));
    if (Number.isNaN(low + high)) return;
    const { name, range, points } = this.curve.request();
    const over = `${field.path}=${low}..${high} ${field.kind === 'quantity' ? unit : ''}`.trim();
    const request = { [name]: range, points, over: `${over}:${CURVES}` };
    const key = this.key(field, name);
    const answered = await this.inquiry.ask('curve', request);
    if (!answered) return;
    this.tables = answered.tables['points'] ?? [];
    this.levels = this.tables.map((_, index) => low + ((high - low) * index) / (CURVES - 1));
    [this.drawnOver, this.drawnAlong, this.drawnKey] = [field, name, key];
    this.markStale();
    this.fillOrdinates();
    this.draw();
  }

  /** The present value of a number of the case, in SI. */
  private valueOf(path: string): number {
    const value = this.model.assignments.get(path)?.si ?? this.fields?.values[path];
    return typeof value === 'number' ? value : NaN;
  }

  private fillOrdinates(): void {
    if (this.ordinate.options.length > 0) return;
    const names = Object.entries(this.tables[0] ?? {})
      .filter(([, { values }]) => values instanceof Float64Array && values.some(Number.isFinite))
      .map(([name]) => name);
    this.ordinate.replaceChildren(
      ...names.map((name) =>
        h('option', { value: name }, columnName(name, this.tables[0]?.[name])),
      ),
    );
    this.ordinate.value = 'traction_coefficient';
  }

  private draw(): void {
    const [first] = this.tables;
    const name = this.ordinate.value;
    const column = first?.[name];
    const over = this.drawnOver;
    if (!first || !column || !over) return;
    const [overUnit, overFactor] = shownUnit(over);
    const overLabel = labelled(fieldName(over), prettyUnit(overUnit));
    const along = numbers(first[this.drawnAlong]);
    const scale = shownFor(first[this.drawnAlong]?.units ?? '', along);
    const all = this.tables.flatMap((table) => [...numbers(table[name])]);
    const shown = shownFor(column.units, all);
    const isDown = (along[0] ?? 0) > (along.at(-1) ?? 0);
    const ordered = (values: number[]) => (isDown ? values.reverse() : values);
    const x = ordered([...along].map((value) => value / scale.factor));
    const values = this.tables.flatMap((table) =>
      ordered([...numbers(table[name])].map((value) => value / shown.factor)),
    );
    const told = (value: number) => withUnit(value * shown.factor, column.units);
    this.map.element.hidden = false;
    this.choice.hidden = false;
    this.map.onPick = ([picked, level]) => {
      this.model.move(over, Number((level * overFactor).toPrecision(3)));
      this.curve.move(Number((picked * scale.factor).toPrecision(3)));
    };
    this.map.show({
      title: columnName(name, column),
      unit: shown.unit,
      xEdges: edgesAround(x),
      yEdges: edgesAround(this.levels),
      values: Float64Array.from(values),
      labels: [
        labelled(columnName(this.drawnAlong, first[this.drawnAlong]), scale.unit),
        overLabel,
      ],
      isToScale: false,
      mark: [this.curve.present() / scale.factor, this.valueOf(over.path) / overFactor],
      describe: (at, row) => [
        `${nameOf(this.drawnAlong)}  ${digits(x[at] ?? NaN)} ${scale.unit}`,
        `${overLabel}  ${digits(this.levels[row] ?? NaN)}`,
        `${columnName(name, column, column.symbol)}  ${told(values[row * x.length + at] ?? NaN)}`,
      ],
    });
  }
}
