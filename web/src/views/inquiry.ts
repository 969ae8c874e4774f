/** A task asked of the solver: how long it runs, a way to end it, and what is wrong. */
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import { problemList } from '../report/problems';
import { CaseProblems, type Lane } from '../solver/lane';
import type { Answered } from '../solver/protocol';
import { t } from '../texts';

/** Time after which it is told that a task runs, and between two tellings, in ms. */
const [PATIENCE, INTERVAL] = [500, 200];

/** Tasks of one topic, of which the newest counts. */
export class Inquiry {
  readonly element = h('div', { class: 'inquiry', 'aria-live': 'polite' });
  private count = 0;

  constructor(
    private readonly topic: string,
    private readonly model: CaseModel,
    private readonly lane: Lane,
  ) {
    model.listen((change) => {
      if (change === 'opened') this.end();
    });
  }

  /** Ends what runs, and takes back what was told. */
  private end(): void {
    this.count += 1;
    this.lane.cancel(this.topic);
    this.element.replaceChildren();
  }

  /** The answer; null if there is none, or a newer task took its place. */
  async ask(
    task: string,
    request: Record<string, unknown>,
    wantsFigures = false,
  ): Promise<Answered | null> {
    this.count += 1;
    const { count } = this;
    const show = (...children: Node[]) => {
      if (count === this.count) this.element.replaceChildren(...children);
    };
    show();
    const timer = this.startClock(show);
    try {
      const ask = { input: this.model.whole(), task, request, wantsFigures };
      const answered = await this.lane.ask(this.topic, 'task', ask);
      show();
      return count === this.count ? answered : null;
    } catch (error) {
      if (!(error instanceof CaseProblems)) throw error;
      show(problemList(error.problems, this.model.text));
      return null;
    } finally {
      clearInterval(timer);
    }
  }

  private startClock(show: (...children: Node[]) => void): number {
    const began = performance.now();
    const clock = h('span', { role: 'timer' });
    const running = h(
      'p',
      { class: 'hint' },
      `${t('solving')} `,
      clock,
      h('button', { type: 'button', onclick: () => this.end() }, t('cancel')),
    );
    return window.setInterval(() => {
      const elapsed = performance.now() - began;
      clock.textContent = `${(elapsed / 1e3).toFixed(1)} s`;
      if (elapsed > PATIENCE && !running.isConnected) show(running);
    }, INTERVAL);
  }
}
