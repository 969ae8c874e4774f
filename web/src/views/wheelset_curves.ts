/** Rolling-radius difference and conicity of the wheelset over its lateral position. */
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import { Chart, type Curve } from '../draw/chart';
import { numbers } from '../draw/fields';
import { sampled, united } from '../draw/sampling';
import type { Lane } from '../solver/lane';
import type { Table } from '../solver/protocol';
import { nameOf, t } from '../texts';
import { Inquiry } from './inquiry';

/** Positions at which the wheelset is solved. */
const POINTS = 17;
/** What the curves are over. */
const LATERAL = 'wheelset.lateral_position';
/** Rolling-radius differences of a table of contacts. */
const DIFFERENCES = ['rolling_radius_difference', 'rigid_rolling_radius_difference'];

/** Rolling-radius differences over the lateral position, conicity over the amplitude. */
interface Curves {
  contacts: Table;
  conicity: Table;
}

/** Curves of a wheelset, on demand. */
export class WheelsetCurves {
  readonly element: HTMLElement;
  private readonly difference = new Chart(240);
  private readonly conicity = new Chart(240);
  private readonly inquiry: Inquiry;
  private tables: Curves | null = null;
  private pinned: Curves | null = null;
  private cursor = 0;
  private key = '';
  private readonly stale = h('p', { class: 'hint', hidden: true }, t('outdated'));
  private readonly charts: HTMLElement;

  constructor(
    private readonly model: CaseModel,
    lane: Lane,
  ) {
    this.inquiry = new Inquiry('wheelset', model, lane);
    const button = h(
      'button',
      { type: 'button', 'data-task': 'wheelset', onclick: () => void this.compute() },
      t('compute'),
    );
    this.charts = h(
      'div',
      { class: 'pair', hidden: true },
      this.difference.element,
      this.conicity.element,
    );
    this.element = h(
      'section',
      { class: 'task' },
      h('h2', {}, t('wheelset')),
      h('div', { class: 'toolbar' }, button),
      this.stale,
      this.inquiry.element,
      this.charts,
    );
    model.listen((change) => {
      if (change === 'opened') this.clear();
      this.markStale();
    });
  }

  /** Marks the present lateral position, in m. */
  mark(lateral: number): void {
    this.cursor = lateral * 1e3;
    this.draw();
  }

  /** Keeps the present curves beside later ones, or no longer. */
  pin(isPinned: boolean): void {
    this.pinned = isPinned ? this.tables : null;
  }

  private clear(): void {
    this.tables = null;
    this.charts.hidden = true;
  }

  /** Curves depend on all but the lateral position. */
  private markStale(): void {
    const isStale = this.tables !== null && this.model.key([LATERAL]) !== this.key;
    this.stale.hidden = !isStale;
    this.element.classList.toggle('old', isStale);
  }

  private async compute(): Promise<void> {
    const key = this.model.key([LATERAL]);
    const answered = await this.inquiry.ask('wheelset', { points: POINTS });
    if (!answered) return;
    this.key = key;
    const { contacts, conicity } = answered.tables;
    if (contacts?.[0] && conicity?.[0]) {
      this.tables = { contacts: positions(contacts[0]), conicity: conicity[0] };
    }
    this.charts.hidden = this.tables === null;
    this.draw();
    this.markStale();
  }

  private draw(): void {
    const { tables, pinned } = this;
    if (!tables) return;
    const isRigid = (name: string) => name.startsWith('rigid');
    this.difference.show({
      xLabel: `${nameOf('lateral_position')} (mm)`,
      yLabel: `${t('radius_difference')} (mm)`,
      cursor: this.cursor,
      ...curvesOf(tables.contacts, pinned?.contacts, 'lateral_position', {
        names: DIFFERENCES,
        factor: 1e-3,
        label: (name) => (isRigid(name) ? `Δr, ${t('rigid')}` : 'Δr'),
      }),
    });
    this.conicity.show({
      xLabel: 'ŷ (mm)',
      yLabel: t('conicity'),
      ...curvesOf(tables.conicity, pinned?.conicity, 'amplitude', {
        names: Object.keys(tables.conicity).filter((name) => name !== 'amplitude'),
        factor: 1,
        label: (name) => tables.conicity[name]?.symbol ?? name,
      }),
    });
  }
}

/** The first row of each position. */
function positions(contacts: Table): Table {
  const places = numbers(contacts['lateral_position']);
  const isFirst = (_: number, row: number) => row === 0 || places[row] !== places[row - 1];
  const names = ['lateral_position', ...DIFFERENCES];
  return Object.fromEntries(
    Object.entries(contacts)
      .filter(([name]) => names.includes(name))
      .map(([name, column]) => [name, { ...column, values: numbers(column).filter(isFirst) }]),
  );
}

interface Drawn {
  names: string[];
  /** From the unit shown to SI. */
  factor: number;
  label: (name: string) => string;
}

/** Curves over lengths in mm, those of pinned results dashed. */
function curvesOf(
  table: Table,
  pinned: Table | undefined,
  abscissa: string,
  { names, factor, label }: Drawn,
): { x: number[]; curves: Curve[] } {
  const x = united(numbers(table[abscissa]), numbers(pinned?.[abscissa]));
  const along = (of: Table, name: string) =>
    sampled(numbers(of[abscissa]), numbers(of[name]), x).map((value) => value / factor);
  const own = names.map((name, colour) => ({
    label: label(name),
    values: along(table, name),
    colour,
  }));
  const others = names.map((name, index) => ({
    label: `${label(name)}, ${t('pinned')}`,
    values: along(pinned ?? {}, name),
    colour: index + 2,
    dashed: true,
  }));
  return { x: x.map((at) => at * 1e3), curves: pinned ? [...own, ...others] : own };
}
