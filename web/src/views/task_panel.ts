/** Tasks on demand: a button for each, and what the program tells and draws. */
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import { warnings, whole } from '../report/summary';
import { problemList } from '../report/problems';
import { CaseProblems, type Lane } from '../solver/lane';
import type { Answered } from '../solver/protocol';
import { t } from '../texts';

/** A button and the task that it starts. */
export interface Offer {
  label: string;
  task: string;
  /** Changes the case before. */
  before?: () => void;
}

/** A panel of tasks. */
export class TaskPanel {
  readonly element: HTMLElement;
  private readonly answer = h('div', { class: 'answer', 'aria-live': 'polite' });
  private readonly stale = h('p', { class: 'hint', hidden: true }, t('outdated'));
  private urls: string[] = [];

  constructor(
    title: string,
    offers: Offer[],
    private readonly model: CaseModel,
    private readonly lane: Lane,
  ) {
    const button = (offer: Offer) =>
      h(
        'button',
        { type: 'button', 'data-task': offer.task, onclick: () => void this.run(offer) },
        offer.label,
      );
    this.element = h(
      'section',
      { class: 'task' },
      h('h2', {}, title),
      h('p', { class: 'hint' }, t('below_hint')),
      h('div', { class: 'toolbar' }, ...offers.map(button)),
      this.stale,
      this.answer,
    );
    model.listen(() => {
      this.stale.hidden = this.answer.childElementCount === 0;
    });
  }

  private async run(offer: Offer): Promise<void> {
    offer.before?.();
    this.answer.replaceChildren(h('p', { class: 'hint' }, t('solving')));
    this.stale.hidden = true;
    const ask = {
      input: this.model.whole(),
      task: offer.task,
      request: {},
      wantsFigures: true,
    };
    try {
      const answered = await this.lane.ask('task', 'task', ask);
      if (answered) this.show(answered);
    } catch (error) {
      if (!(error instanceof CaseProblems)) throw error;
      this.answer.replaceChildren(problemList(error.problems, this.model.text));
    }
  }

  private show({ told, figures }: Answered): void {
    for (const url of this.urls) URL.revokeObjectURL(url);
    this.urls = figures.map(([, svg]) =>
      URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' })),
    );
    const drawn = figures.map(([name], index) =>
      h('img', { src: this.urls[index] ?? '', alt: name.replace(/_/g, ' '), class: 'drawing' }),
    );
    this.answer.replaceChildren(
      h('div', { class: 'drawings' }, ...drawn),
      warnings(told),
      whole(told, true),
    );
  }
}
