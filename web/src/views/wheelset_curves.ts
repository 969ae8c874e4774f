/** Rolling-radius difference and conicity of the wheelset over its lateral position. */
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import { Chart, type ChartContent } from '../draw/chart';
import { numbers } from '../draw/fields';
import { problemList } from '../report/problems';
import { CaseProblems, type Lane } from '../solver/lane';
import type { Table } from '../solver/protocol';
import { nameOf, t } from '../texts';

/** Positions at which the wheelset is solved. */
const POINTS = 17;
/** Rolling-radius differences of a table of contacts. */
const DIFFERENCES = ['rolling_radius_difference', 'rigid_rolling_radius_difference'];

/** Curves of a wheelset, on demand. */
export class WheelsetCurves {
  readonly element: HTMLElement;
  private readonly difference = new Chart(240);
  private readonly conicity = new Chart(240);
  private readonly problems = h('div', { 'aria-live': 'polite' });
  private content: ChartContent | null = null;

  constructor(
    private readonly model: CaseModel,
    private readonly lane: Lane,
  ) {
    const button = h(
      'button',
      { type: 'button', 'data-task': 'wheelset', onclick: () => void this.compute() },
      t('compute'),
    );
    this.element = h(
      'section',
      { class: 'task' },
      h('h2', {}, t('wheelset')),
      h('div', { class: 'toolbar' }, button),
      this.problems,
      h('div', { class: 'pair' }, this.difference.element, this.conicity.element),
    );
  }

  /** Marks the present lateral position, in m. */
  mark(lateral: number): void {
    if (!this.content) return;
    this.content.cursor = lateral * 1e3;
    this.difference.show(this.content);
  }

  private async compute(): Promise<void> {
    this.problems.replaceChildren(h('p', { class: 'hint' }, t('solving')));
    const ask = {
      input: this.model.whole(),
      task: 'wheelset',
      request: { points: POINTS },
      wantsFigures: false,
    };
    try {
      const answered = await this.lane.ask('wheelset', 'task', ask);
      if (!answered) return;
      this.problems.replaceChildren();
      this.show(answered.tables['contacts']?.[0], answered.tables['conicity']?.[0]);
    } catch (error) {
      if (!(error instanceof CaseProblems)) throw error;
      this.problems.replaceChildren(problemList(error.problems, this.model.text));
    }
  }

  private show(contacts: Table | undefined, conicity: Table | undefined): void {
    if (!contacts || !conicity) return;
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
  }
}
