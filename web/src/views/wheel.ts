/** The view of a wheel on a rail: drag it sideways, yaw it, see its contacts move and split. */
import type { Catalogue, Field } from '../catalogue';
import { openProfiles } from '../case/open';
import type { CaseModel } from '../case/model';
import { FieldControl } from '../controls/field_control';
import { tomlOfTyped } from '../catalogue';
import { dragged, h, perFrame } from '../dom';
import type { Frame } from '../draw/axes';
import { numberOf } from '../draw/fields';
import type { Result } from '../explorer';
import { digits } from '../quantity';
import { numberTable } from '../report/number_table';
import type { Lane } from '../solver/lane';
import type { Described, Table } from '../solver/protocol';
import { symbolOf } from '../symbols';
import { columnName, nameOf, t } from '../texts';
import { drawPlans, drawProfiles, type Scene } from './wheel_drawing';
import { WheelsetCurves } from './wheelset_curves';

/** Fields that the view moves. */
const LATERAL = 'wheelset.lateral_position';
const MOVED = [LATERAL, 'wheelset.yaw_angle'];
/** How far the wheel is dragged at most, in m. */
const REACH = 0.02;
/** Steps of the arrow keys, in m. */
const STEP = 1e-4;
/** Columns of contacts that are told. */
const TOLD = [
  'position.y',
  'angle',
  'rolling_radius',
  'normal.load',
  'normal.peak_pressure',
  'normal.semi_axis_x',
  'normal.semi_axis_y',
  'force.x',
  'force.y',
  'creepage_x',
  'creepage_y',
  'spin',
];

/** Wheel and rail. */
export class WheelView {
  readonly element: HTMLElement;
  readonly canvas = h('canvas', { tabindex: 0, role: 'slider', 'aria-label': t('drag_wheel') });
  private readonly plan = planCanvas('');
  private readonly pinnedPlan = planCanvas(`, ${t('pinned')}`);
  private readonly close = h('input', { type: 'checkbox', onchange: () => this.redraw() });
  private readonly contacts = h('div', { class: 'contacts' });
  private readonly none: HTMLElement;
  private readonly drawn: HTMLElement;
  private readonly controls: { field: Field; control: FieldControl }[];
  private readonly curves: WheelsetCurves;
  private readonly redraw = perFrame(() => this.draw());
  private described: Described | null = null;
  private result: Result | null = null;
  private pinned: Result | null = null;
  /** What was drawn when it was pinned. */
  private beside: Scene | null = null;
  private isShown = false;
  private frame: Frame | null = null;
  private held: Frame | null = null;

  constructor(
    catalogue: Catalogue,
    private readonly model: CaseModel,
    lane: Lane,
  ) {
    const actions = {
      move: (field: Field, si: number) => model.move(field, si),
      type: (field: Field, text: string) => model.assign([[field.path, tomlOfTyped(field, text)]]),
      reset: (field: Field) => model.reset([field.path]),
    };
    this.controls = MOVED.flatMap((path) => {
      const field = catalogue.field(path);
      return field ? [{ field, control: new FieldControl(field, actions, 'view') }] : [];
    });
    this.curves = new WheelsetCurves(model, lane);
    this.none = h(
      'div',
      { class: 'hint' },
      h('p', {}, t('no_profiles')),
      h('button', { type: 'button', onclick: () => void openProfiles(model) }, t('open_profiles')),
    );
    this.drawn = h(
      'div',
      {},
      h(
        'div',
        { class: 'toolbar' },
        ...this.controls.map(({ control }) => control.element),
        h('label', {}, this.close, ` ${t('zoom_contact')}`),
      ),
      h('div', { class: 'profiles' }, this.canvas, this.plan, this.pinnedPlan),
      h('p', { class: 'hint' }, t('drag_wheel'), ' ', legend()),
      this.contacts,
      this.curves.element,
    );
    this.element = h('div', {}, this.none, this.drawn);
    new ResizeObserver(this.redraw).observe(this.element);
    const [low, high] = this.range();
    this.canvas.setAttribute('aria-valuemin', String(low * 1e3));
    this.canvas.setAttribute('aria-valuemax', String(high * 1e3));
    this.canvas.addEventListener('pointerdown', (event) => this.drag(event));
    this.canvas.addEventListener('keydown', (event) => this.step(event));
  }

  /** Shows the profiles of a case. */
  describe(described: Described): void {
    this.described = described;
    const hasProfiles = described.outlines !== null;
    this.none.hidden = hasProfiles;
    this.drawn.hidden = !hasProfiles;
    const { values, given } = described.fields;
    for (const { field, control } of this.controls) {
      control.show({
        value: values[field.path],
        isGiven: given.includes(field.path),
        isChanged: this.model.assignments.has(field.path),
        problem: null,
      });
    }
    this.redraw();
  }

  /** Shows a result, beside a pinned one. */
  show(result: Result, pinned: Result | null): void {
    this.result = result;
    if (pinned !== this.pinned) {
      this.beside = pinned && this.scene();
      this.curves.pin(pinned !== null);
    }
    this.pinned = pinned;
    this.showResult();
  }

  /** Whether the view is seen: it is drawn only then. */
  set visible(isShown: boolean) {
    this.isShown = isShown;
    this.showResult();
  }

  private showResult(): void {
    if (!this.isShown) return;
    const { result, pinned } = this;
    const [present, others] = [result, pinned].map((one) => one?.answered.tables['contact']);
    this.contacts.replaceChildren(contactTable(present ?? [], others ?? null));
    this.curves.mark(this.lateral());
    this.draw();
  }

  /** Draws anew, in other colours. */
  refresh(): void {
    this.redraw();
  }

  /** The lateral position of the case, in m: as it is moved now. */
  private lateral(): number {
    const value = this.described?.fields.values[LATERAL];
    return this.model.assignments.get(LATERAL)?.si ?? (typeof value === 'number' ? value : 0);
  }

  /** What is drawn of the present result; null without profiles. */
  private scene(): Scene | null {
    const { described, result } = this;
    if (!described?.outlines || !result?.answered.tables['contact']) return null;
    const wheel = result.answered.tables['wheel']?.[0];
    const outlined = described.fields.values[LATERAL];
    return {
      outlines: described.outlines,
      answered: result.answered,
      pose: {
        lateral: Number(result.values[LATERAL] ?? 0),
        outlined: Number(outlined ?? 0),
        height: numberOf(wheel, 'wheelset.height'),
        roll: numberOf(wheel, 'wheelset.roll_angle'),
      },
    };
  }

  private draw(): void {
    const scene = this.scene();
    const width = this.element.clientWidth;
    if (!scene || width < 200) return;
    const { beside, held } = this;
    this.frame = drawProfiles(this.canvas, width, scene, {
      isClose: this.close.checked,
      held,
      beside,
    });
    if (this.frame) drawPlans([this.plan, this.pinnedPlan], width, this.frame, [scene, beside]);
    this.pinnedPlan.hidden = !beside;
    const shown = digits(this.lateral() * 1e3, 3);
    this.canvas.setAttribute('aria-valuenow', String(this.lateral() * 1e3));
    this.canvas.setAttribute('aria-valuetext', `${nameOf('lateral_position')} ${shown} mm`);
  }

  /** Lateral positions to which the wheel is dragged, in m. */
  private range(): [number, number] {
    const [low, high] = this.controls[0]?.field.usual ?? [null, null];
    return [Math.max(-REACH, low ?? -REACH), Math.min(REACH, high ?? REACH)];
  }

  private move(lateral: number): void {
    const [first] = this.controls;
    const [low, high] = this.range();
    const within = Math.max(low, Math.min(high, lateral));
    if (first) this.model.move(first.field, Number(within.toFixed(5)));
    this.redraw();
  }

  private drag(event: PointerEvent): void {
    const { frame } = this;
    if (!frame) return;
    const start = this.lateral();
    const scale = (frame.x[1] - frame.x[0]) / frame.width / 1e3;
    this.held = frame;
    dragged(
      this.canvas,
      event,
      ({ clientX }) => this.move(start + (clientX - event.clientX) * scale),
      () => {
        this.held = null;
        this.redraw();
      },
    );
  }

  private step(event: KeyboardEvent): void {
    const signs: Record<string, number> = {
      ArrowLeft: 1,
      ArrowUp: 1,
      ArrowRight: -1,
      ArrowDown: -1,
    };
    const sign = signs[event.key];
    if (!sign) return;
    event.preventDefault();
    this.move(this.lateral() + sign * STEP * (event.shiftKey ? 10 : 1));
  }
}

function planCanvas(note: string): HTMLCanvasElement {
  const label = nameOf('pressure', 'normal pressure') + note;
  return h('canvas', { role: 'img', 'aria-label': label });
}

function legend(): HTMLElement {
  return h(
    'span',
    { class: 'legend' },
    h('span', { class: 'dark' }, '→'),
    ` ${t('normal_load')} `,
    h('span', { class: 'light' }, '→'),
    ` ${nameOf('force_y', 'lateral force')}`,
  );
}

/** All contacts, beside those of a pinned result. */
function contactTable(contacts: Table[], others: Table[] | null): HTMLElement {
  const count = Math.max(contacts.length, others?.length ?? 0);
  const of = (tables: Table[], name: string) =>
    Array.from({ length: count }, (_, index) => numberOf(tables[index], name));
  const rows = TOLD.flatMap((name) => {
    const column = contacts[0]?.[name];
    if (!column) return [];
    const label = [columnName(name, column), ' ', symbolOf(column.symbol)];
    const pinned = others && of(others, name);
    return [{ name, label, column, present: of(contacts, name), pinned }];
  });
  const heads = Array.from({ length: count }, (_, index) => `${t('contact')} ${index + 1}`);
  return numberTable(heads, rows);
}
