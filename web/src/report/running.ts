/** What is being computed: for how long, how far it has got, and a way to end it. */
import { h } from '../dom';
import { digits } from '../quantity';
import type { Progress } from '../solver/protocol';
import { nameOf, t } from '../texts';

/** Time after which it is told that something runs, and between two tellings, in ms. */
const [PATIENCE, INTERVAL] = [500, 200];

/** Hidden but for what takes long. */
export class Running {
  readonly element: HTMLElement;
  private readonly clock = h('span', { role: 'timer' });
  private readonly bar = h('progress', { 'aria-label': t('solving') });
  private readonly cancel: HTMLElement;
  private timer = 0;

  constructor(onCancel: () => void) {
    this.cancel = h('button', { type: 'button', onclick: onCancel }, t('cancel'));
    this.element = h('p', { class: 'running', hidden: true });
  }

  /** Starts the clock. */
  begin(): void {
    this.end();
    const began = performance.now();
    const far = h('span', { class: 'far' });
    this.bar.hidden = true;
    this.element.replaceChildren(`${t('solving')} `, this.clock, far, this.bar, this.cancel);
    this.timer = window.setInterval(() => {
      const elapsed = performance.now() - began;
      this.clock.textContent = `${(elapsed / 1e3).toFixed(1)} s`;
      this.element.hidden = elapsed < PATIENCE;
    }, INTERVAL);
  }

  /** Tells how far it has got. */
  tell({ counted, done, total, change }: Progress): void {
    const far = this.element.querySelector('.far');
    if (!far) return;
    this.bar.hidden = total === null;
    if (total !== null) [this.bar.max, this.bar.value] = [total, done];
    const count = total === null ? String(done) : `${done}/${total}`;
    const isKnown = change !== null && change > 0 && Number.isFinite(change);
    const residual = isKnown ? `, ${t('residual')} ${digits(change, 2)}` : '';
    far.textContent = `${nameOf(counted, counted)} ${count}${residual}`;
  }

  /** Nothing runs any more; what there is to say of that. */
  end(...told: (Node | string)[]): void {
    clearInterval(this.timer);
    this.element.hidden = told.length === 0;
    this.element.replaceChildren(...told);
  }
}
