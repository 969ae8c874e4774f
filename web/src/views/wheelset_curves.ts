/** Rolling-radius difference and conicity of the wheelset over its lateral position. */
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import { Chart, type ChartContent } from '../draw/chart';
import { numbers } from '../draw/fields';
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

/** Curves of a wheelset, on demand. */
export class WheelsetCurves {
  readonly element: HTMLElement;
  private readonly difference = new Chart(240);
  private readonly conicity = new Chart(240);
  private readonly inquiry: Inquiry;
  private content: ChartContent | null = null;
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
    if (!this.content) return;
    this.content.cursor = lateral * 1e3;
    this.difference.show(this.content);
  }

  private clear(): void {
    this.content = null;
    this.charts.hidden = true;
  }

  /** Curves depend on all but the lateral position. */
  private markStale(): void {
    const isStale = this.content !== null && this.model.key([LATERAL]) !== this.key;
    this.stale.hidden = !isStale;
    this.element.classList.toggle('old', isStale);
  }

  private async compute(): Promise<void> {
    const key = this.model.key([LATERAL]);
    const answered = await this.inquiry.ask('wheelset', { points: POINTS });
    if (!answered) return;
    this.key = key;
    this.show(answered.tables['contacts']?.[0], answered.tables['conicity']?.[0]);
  }

  private show(contacts: Table | undefined, conicity: Table | undefined): void {
    if (!contacts || !conicity) return;
    this.charts.hidden = false;
    const places = numbers(contacts['lateral_position']);
    const rows = [...places.keys()].filter((row) => row === 0 || places[row] !== places[row - 1]);
    this.content = {
      x: rows.map((row) => (places[row] ?? 0) * 1e3),
      xLabel: `${nameOf('lateral_position')} (mm)`,
      yLabel: `${t('radius_difference')} (mm)`,
      curves: DIFFERENCES.map((name, colour) => ({
        label: contacts[name]?.long_name.startsWith('the same') ? 'Δr, rigid' : 'Δr',
        values: rows.map((row) => (numbers(contacts[name])[row] ?? NaN) * 1e3),
        colour,
        dashed: colour > 0,
      })),
    };
    this.difference.show(this.content);
    const amplitude = numbers(conicity['amplitude']);
    this.conicity.show({
      x: amplitude.map((value) => value * 1e3),
      xLabel: 'ŷ (mm)',
      yLabel: t('conicity'),
      curves: Object.entries(conicity)
        .filter(([name]) => name !== 'amplitude')
        .map(([, column], index) => ({
          label: column.symbol,
          values: numbers(column),
          colour: index,
          dashed: index > 0,
        })),
    });
    this.markStale();
  }
}
