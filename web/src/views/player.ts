/** Plays the frames of a transient, with the forces over time beside it. */
import { h } from '../dom';
import { Chart } from '../draw/chart';
import { numbers } from '../draw/fields';
import type { Result } from '../explorer';
import { digits, labelled, shownFor } from '../quantity';
import { columnName, t } from '../texts';

/** Time between two frames on the screen, in ms. */
const INTERVAL = 60;
/** Forces over time, in units of force. */
const FORCES = ['force_x', 'force_y'];

/** Play, pause and scrub. */
export class Player {
  readonly element: HTMLElement;
  /** The frame that is shown; null without frames. */
  frame: number | null = null;
  private readonly button = h(
    'button',
    { type: 'button', onclick: () => this.toggle() },
    `▶ ${t('play')}`,
  );
  private readonly scrub = h('input', {
    type: 'range',
    min: 0,
    step: 1,
    'aria-label': t('time'),
    oninput: () => this.go(Number(this.scrub.value)),
  });
  private readonly clock = h('output', {});
  private readonly chart = new Chart(200);
  private times: number[] = [];
  private timer = 0;
  private result: Result | null = null;

  constructor(private readonly onFrame: () => void) {
    this.element = h(
      'div',
      { class: 'player', hidden: true },
      h('div', { class: 'toolbar' }, this.button, this.scrub, this.clock),
      this.chart.element,
    );
  }

  /** Shows the frames of a result, if it has any. */
  show(result: Result, frames: number): void {
    this.pause();
    this.result = result;
    this.element.hidden = frames === 0;
    this.frame = frames === 0 ? null : frames - 1;
    if (frames === 0) return;
    this.times = result.answered.grids.slice(-frames).map(({ time }) => time ?? 0);
    this.scrub.max = String(frames - 1);
    this.scrub.value = String(frames - 1);
    this.drawForces();
  }

  private toggle(): void {
    if (this.timer) {
      this.pause();
      return;
    }
    this.button.textContent = `⏸ ${t('pause')}`;
    const last = this.times.length - 1;
    this.timer = window.setInterval(
      () => this.go(this.frame === last ? 0 : (this.frame ?? 0) + 1),
      INTERVAL,
    );
  }

  private pause(): void {
    clearInterval(this.timer);
    this.timer = 0;
    this.button.textContent = `▶ ${t('play')}`;
  }

  private go(frame: number): void {
    this.frame = frame;
    this.scrub.value = String(frame);
    this.drawForces();
    this.onFrame();
  }

  private drawForces(): void {
    const history = this.result?.answered.tables['history']?.[0];
    const now = this.times[this.frame ?? 0] ?? 0;
    if (!history) return;
    const time = numbers(history['time']);
    const scale = shownFor('s', time);
    const forces = FORCES.map((name) => numbers(history[name]));
    const unit = shownFor(
      'N',
      forces.flatMap((values) => [...values]),
    );
    const shownTime = digits(now / scale.factor, 3);
    this.clock.textContent = `${shownTime} ${scale.unit}`;
    this.scrub.setAttribute('aria-valuetext', `${shownTime} ${scale.unit}`);
    this.chart.show({
      x: time.map((value) => value / scale.factor),
      xLabel: labelled(t('time'), scale.unit),
      yLabel: labelled(t('force'), unit.unit),
      cursor: now / scale.factor,
      curves: FORCES.map((name, index) => ({
        label: columnName(name, history[name]),
        colour: index,
        values: (forces[index] ?? new Float64Array()).map((value) => value / unit.factor),
      })),
    });
  }
}
