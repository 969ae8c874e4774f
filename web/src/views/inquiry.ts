/** A task asked of the solver: how far it has got, a way to end it, and what is wrong. */
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import { problemList } from '../report/problems';
import { Running } from '../report/running';
import { CaseProblems, type Lane } from '../solver/lane';
import type { Answered } from '../solver/protocol';
import { t } from '../texts';

/** Tasks of one topic, of which the newest counts. */
export class Inquiry {
  readonly element: HTMLElement;
  private readonly running = new Running(() => this.end());
  private readonly problems = h('div', { 'aria-live': 'polite' });
  private count = 0;

  constructor(
    private readonly topic: string,
    private readonly model: CaseModel,
    private readonly lane: Lane,
  ) {
    this.element = h('div', { class: 'inquiry' }, this.running.element, this.problems);
    model.listen((change) => {
      if (change === 'opened') this.end();
    });
  }

  /** Ends what runs, and takes back what was told. */
  private end(): void {
    this.count += 1;
    this.lane.cancel(this.topic);
    this.running.end();
    this.problems.replaceChildren();
  }

  /** The answer; null if there is none, or a newer task took its place. */
  async ask(
    task: string,
    request: Record<string, unknown>,
    wantsFigures = false,
  ): Promise<Answered | null> {
    this.count += 1;
    const { count } = this;
    const isNewest = () => count === this.count;
    this.problems.replaceChildren();
    this.running.begin();
    try {
      const ask = { input: this.model.whole(), task, request, wantsFigures };
      const tell = this.running.tell.bind(this.running);
      const answered = await this.lane.ask(this.topic, 'task', ask, tell);
      return isNewest() ? answered : null;
    } catch (error) {
      if (!(error instanceof CaseProblems)) throw error;
      const told = problemList(t('problems_of_task'), error.problems, this.model.text);
      if (isNewest()) this.problems.replaceChildren(told);
      return null;
    } finally {
      if (isNewest()) this.running.end();
    }
  }
}
