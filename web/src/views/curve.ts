/** The view of creep curves: any result over a creepage or force, with the present point on it. */
import type { Catalogue, RequestField } from '../catalogue';
import type { CaseModel } from '../case/model';
import { debounced, h, labelledControl } from '../dom';
import { Chart, type Curve } from '../draw/chart';
import { numberOf, numbers } from '../draw/fields';
import { sampled, united } from '../draw/sampling';
import type { Result } from '../explorer';
import { digits, labelled, numberTyped, shownFor } from '../quantity';
import type { Lane } from '../solver/lane';
import type { Table } from '../solver/protocol';
import { columnName, explained, nameOf, t } from '../texts';
import { Handle } from './handle';
import { Inquiry } from './inquiry';

/** How far a curve goes where the case says nothing, by the unit of its abscissa. */
const REACH: Record<string, number> = { '': 0.02, '1/m': 1, N: -20e3, 'N m': 20 };
/** How far it goes beyond the present point. */
const BEYOND = 3;

/** A curve and the case that it belongs to. */
interface Computed {
  key: string;
  table: Table;
}

/** The path of the field that a request of a curve varies. */
export function varied(name: string): string {
  return `kinematics.${name}`;
}

/** What can be varied along a curve. */
function abscissae(catalogue: Catalogue): RequestField[] {
  const fields = catalogue.task('curve')?.fields ?? [];
  return fields.filter(({ kind, name }) => kind === 'points' && catalogue.field(varied(name)));
}

/** The present value of a column of curves, at a contact. */
function presentOf(result: Result, name: string, contact: number): number {
  const solution = result.answered.tables['solution']?.[contact];
  const candidates = [numberOf(solution, name), numberOf(solution, varied(name))];
  return candidates.find((value) => !Number.isNaN(value)) ?? NaN;
}

/** Creep curves. */
export class CurveView {
  readonly element: HTMLElement;
  readonly chart = new Chart(400);
  private readonly abscissa: HTMLSelectElement;
  private readonly end = h('input', {
    type: 'text',
    inputmode: 'decimal',
    id: 'range-end',
    class: 'short',
    onchange: () => this.ended(),
  });
  private readonly count = h('input', {
    type: 'number',
    value: 31,
    id: 'curve-points',
    onchange: () => void this.compute(),
  });
  private readonly ordinate = h('select', { id: 'ordinate', onchange: () => this.draw() });
  private readonly refusal = h('p', { class: 'refusal', role: 'alert' });
  private readonly transient = h('p', { class: 'hint', hidden: true }, t('only_steady'));
  private readonly steady: HTMLElement;
  private readonly inquiry: Inquiry;
  private readonly handle = new Handle(t('present_point'), (value) => this.move(value));
  private readonly computeLater = debounced(250, () => void this.compute());
  private computed: Computed | null = null;
  private pinnedCurve: Computed | null = null;
  private result: Result | null = null;
  private pinned: Result | null = null;
  private contact = 0;
  private isShown = false;
  private isRefused = false;
  private hasOwnEnd = false;

  constructor(
    private readonly catalogue: Catalogue,
    private readonly model: CaseModel,
    lane: Lane,
  ) {
    this.inquiry = new Inquiry('curve', model, lane);
    this.abscissa = h(
      'select',
      {
        id: 'abscissa',
        onchange: () => {
          this.hasOwnEnd = false;
          this.computeLater();
        },
      },
      ...abscissae(catalogue).map(({ name, doc }) =>
        h('option', { value: name, title: doc }, nameOf(name)),
      ),
    );
    const points = catalogue.task('curve')?.fields.find(({ name }) => name === 'points');
    [this.count.min, this.count.max] = (points?.bounds ?? []).map(String) as [string, string];
    const bar = h(
      'div',
      { class: 'toolbar' },
      labelledControl(t('abscissa'), this.abscissa),
      labelledControl(t('range_end'), this.end),
      labelledControl(t('points'), this.count),
      labelledControl(t('ordinate'), this.ordinate),
    );
    const place = h('div', { class: 'curve-place' }, this.chart.element, this.handle.element);
    const hint = h('p', { class: 'hint' }, t('present_point'));
    // Whether the case has curves is known once it is described.
    const parts = [bar, this.refusal, place, hint, this.inquiry.element];
    this.steady = h('div', { hidden: true }, ...parts);
    this.element = h('div', {}, this.transient, this.steady);
    new ResizeObserver(() => this.placeHandle()).observe(place);
  }

  /** The request of the curve, as a person would give it. */
  request(): { name: string; range: string; points: number } {
    const { name, units } = this.field();
    const end = numberTyped(this.end.value);
    return { name, range: `0..${end} ${units}`.trim(), points: Number(this.count.value) };
  }

  /** The present value of what is varied, in SI. */
  present(): number {
    return this.result ? presentOf(this.result, this.field().name, this.contact) : NaN;
  }

  /** Moves the present point, in SI. */
  move(value: number): void {
    const field = this.catalogue.field(varied(this.field().name));
    this.hasOwnEnd = true;
    if (field) this.model.move(field, value);
  }

  /** Whether the view is seen: a curve is computed only then. */
  set visible(isShown: boolean) {
    this.isShown = isShown;
    if (isShown) this.update();
  }

  /** A case that rolls over time has no curves. */
  describe(isTransient: boolean): void {
    this.transient.hidden = !isTransient;
    this.steady.hidden = isTransient;
  }

  /** Shows the point of a contact of a result, and its curve as soon as that is known. */
  show(result: Result, pinned: Result | null, contact: number): void {
    if (pinned !== this.pinned) this.pinnedCurve = pinned ? this.computed : null;
    [this.result, this.pinned, this.contact] = [result, pinned, contact];
    if (this.isShown) this.update();
  }

  private update(): void {
    if (!this.hasOwnEnd) this.end.value = String(this.usualEnd());
    const isRefused = Number.isNaN(numberTyped(this.end.value));
    const refused = `“${this.end.value}” ${t('not_a_number')}`;
    this.refusal.textContent = isRefused ? refused : '';
    this.isRefused = isRefused;
    this.end.setAttribute('aria-invalid', String(isRefused));
    if (isRefused) return;
    if (this.key() !== this.computed?.key) this.computeLater();
    this.draw();
  }

  private field(): RequestField {
    const all = abscissae(this.catalogue);
    return (
      all.find(({ name }) => name === this.abscissa.value) ?? {
        name: 'creepage_x',
        doc: '',
        kind: 'points',
        units: '',
        bounds: [null, null],
      }
    );
  }

  private usualEnd(): number {
    const { name, units } = this.field();
    const now = this.present();
    const reach = REACH[units] ?? 0.02;
    if (!now) return name === 'traction_coefficient' ? 0.2 : reach;
    const kept = numberTyped(this.end.value);
    if (kept * now > 0 && Math.abs(now) < Math.abs(kept) && Math.abs(now) > 0.05 * Math.abs(kept))
      return kept;
    return Number((BEYOND * now).toPrecision(1));
  }

  /** What the curve depends on: all but what it varies. */
  private key(): string {
    const { name, range, points } = this.request();
    const input = this.model.whole();
    const others = input.assignments.filter((one) => !one.startsWith(`${varied(name)}=`));
    return JSON.stringify([input.text, others, name, range, points]);
  }

  private ended(): void {
    this.hasOwnEnd = this.end.value.trim() !== '';
    this.update();
  }

  private async compute(): Promise<void> {
    if (!this.isShown || this.steady.hidden || this.isRefused) return;
    const key = this.key();
    const { name, range, points } = this.request();
    const answered = await this.inquiry.ask('curve', { [name]: range, points });
    const table = answered?.tables['points']?.[0];
    if (!table) return;
    this.computed = { key, table };
    this.fillOrdinates(table);
    this.draw();
  }

  private fillOrdinates(table: Table): void {
    const names = Object.entries(table)
      .filter(
        ([, { values }]) =>
          values instanceof Float64Array && values.some((value) => Number.isFinite(value)),
      )
      .map(([name]) => name);
    const present = [...this.ordinate.options].map(({ value }) => value);
    if (names.join() === present.join()) return;
    const chosen = this.ordinate.value || 'traction_coefficient';
    this.ordinate.replaceChildren(
      ...names.map((name) => {
        const column = table[name];
        const title = column ? explained(name, column) : '';
        return h('option', { value: name, title }, columnName(name, column));
      }),
    );
    this.ordinate.value = names.includes(chosen) ? chosen : (names[0] ?? '');
  }

  private draw(): void {
    const { computed, pinnedCurve } = this;
    const { name, units } = this.field();
    const ordinate = this.ordinate.value;
    const column = computed?.table[ordinate];
    if (!computed || !column) return;
    this.ordinate.title = explained(ordinate, column);
    const xs = numbers(computed.table[name]);
    const ys = numbers(column);
    const [xScale, yScale] = [shownFor(units, xs), shownFor(column.units, ys)];
    const pinned = pinnedCurve?.table[ordinate] ? pinnedCurve.table : {};
    const places = united(xs, numbers(pinned[name]));
    const along = (table: Table) =>
      sampled(numbers(table[name]), numbers(table[ordinate]), places).map(
        (value) => value / yScale.factor,
      );
    const curves: Curve[] = [
      {
        label: columnName(ordinate, column, column.symbol),
        values: along(computed.table),
        colour: 0,
      },
    ];
    if (pinned[name]) {
      curves.push({ label: t('pinned'), colour: 2, dashed: true, values: along(pinned) });
    }
    const points = [this.pinned, this.result]
      .flatMap((one, index) =>
        one
          ? [
              {
                x: presentOf(one, name, this.contact) / xScale.factor,
                y: presentOf(one, ordinate, this.contact) / yScale.factor,
                isPinned: index === 0,
              },
            ]
          : [],
      )
      .filter((point) => Number.isFinite(point.x) && Number.isFinite(point.y));
    this.chart.show({
      x: places.map((place) => place / xScale.factor),
      curves,
      points,
      xLabel: labelled(columnName(name, computed.table[name]), xScale.unit),
      yLabel: labelled(columnName(ordinate, column), yScale.unit),
    });
    this.chart.touch(points);
    this.placeHandle();
  }

  /** The handle lies on the present point. */
  private placeHandle(): void {
    const { plot } = this.chart;
    const { name, units } = this.field();
    const ordinate = this.computed?.table[this.ordinate.value];
    if (!plot || !this.result || !ordinate || !this.computed) return;
    const si = this.present();
    const value = presentOf(this.result, this.ordinate.value, this.contact);
    const { factor } = shownFor(units, numbers(this.computed.table[name]));
    const y = value / shownFor(ordinate.units, numbers(ordinate)).factor;
    const end = numberTyped(this.end.value) || 0;
    const range: [number, number] = [Math.min(0, end), Math.max(0, end)];
    const text = `${nameOf(name)} ${digits(si)} ${units}`;
    this.handle.place({ plot, si, x: si / factor, y, factor, range, text });
  }
}
