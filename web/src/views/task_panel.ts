/** Tasks on demand: a button for each, and what the program tells and draws. */
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import { warnings, whole } from '../report/summary';
import type { Lane } from '../solver/lane';
import type { Answered, Fields } from '../solver/protocol';
import { t } from '../texts';
import { Inquiry } from './inquiry';
import { spotsMap } from './spots';

/** A button and the task that it starts, or the change of the case. */
export interface Offer {
  label: string;
  task: string | (() => void);
  /** It is offered in cases that give one of these fields. */
  fields?: string[];
}

/** A panel of tasks. */
export class TaskPanel {
  readonly element: HTMLElement;
  private readonly buttons: { offer: Offer; button: HTMLButtonElement }[];
  private readonly answer = h('div', { class: 'answer', 'aria-live': 'polite' });
  private readonly stale = h('p', { class: 'hint', hidden: true }, t('outdated'));
  private readonly inquiry: Inquiry;
  private key = '';
  private urls: string[] = [];

  constructor(
    title: string,
    offers: Offer[],
    private readonly model: CaseModel,
    lane: Lane,
  ) {
    this.inquiry = new Inquiry('task', model, lane);
    const start = ({ task }: Offer) => (typeof task === 'string' ? void this.run(task) : task());
    this.buttons = offers.map((offer) => ({
      offer,
      button: h(
        'button',
        {
          type: 'button',
          'data-task': typeof offer.task === 'string' ? offer.task : null,
          onclick: () => start(offer),
        },
        offer.label,
      ),
    }));
    this.element = h(
      'section',
      { class: 'task' },
      h('h2', {}, title),
      h('p', { class: 'hint' }, t('below_hint')),
      h('div', { class: 'toolbar' }, ...this.buttons.map(({ button }) => button)),
      this.inquiry.element,
      this.stale,
      this.answer,
    );
    model.listen((change) => {
      if (change === 'opened') this.answer.replaceChildren();
      this.markStale();
    });
  }

  /** Offers what a case can be asked. */
  describe({ given }: Fields): void {
    for (const { offer, button } of this.buttons) {
      button.hidden = !(offer.fields?.some((path) => given.includes(path)) ?? true);
    }
    this.element.hidden = this.buttons.every(({ button }) => button.hidden);
  }

  private markStale(): void {
    const isStale = this.answer.childElementCount > 0 && this.model.key([]) !== this.key;
    this.stale.hidden = !isStale;
    this.element.classList.toggle('old', isStale);
  }

  private async run(task: string): Promise<void> {
    this.answer.replaceChildren();
    this.markStale();
    const key = this.model.key([]);
    const answered = await this.inquiry.ask(task, {}, true);
    if (!answered) return;
    this.key = key;
    this.show(answered);
    this.markStale();
  }

  private show({ told, figures: all, tables }: Answered): void {
    const spots = tables['spots']?.[0];
    // A map with values to read takes the place of the picture.
    const figures = all.filter(([name]) => !spots || !name.endsWith('_spots'));
    for (const url of this.urls) URL.revokeObjectURL(url);
    this.urls = figures.map(([, svg]) =>
      URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' })),
    );
    const drawn = figures.map(([name], index) =>
      h('img', { src: this.urls[index] ?? '', alt: name.replace(/_/g, ' '), class: 'drawing' }),
    );
    this.answer.replaceChildren(
      spots ? spotsMap(spots) : '',
      h('div', { class: 'drawings' }, ...drawn),
      warnings(told),
      whole(told, true),
    );
  }
}
