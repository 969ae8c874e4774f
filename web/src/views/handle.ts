/** A point of a chart that a person drags along, by pointer or arrow keys. */
import type uPlot from 'uplot';
import { dragged, h } from '../dom';

/** Part of the range that an arrow key moves the point. */
const KEY_STEP = 0.01;

/** Where the point is: SI abscissa, and both coordinates as the chart shows them. */
export interface Point {
  plot: uPlot;
  si: number;
  x: number;
  y: number;
  /** From the abscissa as it is shown to SI. */
  factor: number;
  range: [number, number];
  text: string;
}

/** The handle on a chart. */
export class Handle {
  readonly element: HTMLElement;
  private point: Point | null = null;

  /** `onMove` is told the abscissa, in SI. */
  constructor(
    label: string,
    private readonly onMove: (si: number) => void,
  ) {
    this.element = h('div', { class: 'handle', role: 'slider', tabindex: 0, 'aria-label': label });
    this.element.hidden = true;
    this.element.addEventListener('pointerdown', (event) => this.drag(event));
    this.element.addEventListener('keydown', (event) => this.step(event));
  }

  /** Puts the handle on a point. */
  place(point: Point): void {
    this.point = point;
    const { plot, si, x, y, range, text } = point;
    const left = plot.valToPos(x, 'x');
    this.element.hidden = !(left >= -1 && left <= plot.over.clientWidth + 1) || Number.isNaN(y);
    this.element.style.left = `${plot.over.offsetLeft + left}px`;
    this.element.style.top = `${plot.over.offsetTop + plot.valToPos(y, 'y')}px`;
    this.element.setAttribute('aria-valuemin', String(range[0]));
    this.element.setAttribute('aria-valuemax', String(range[1]));
    this.element.setAttribute('aria-valuenow', String(si));
    this.element.setAttribute('aria-valuetext', text);
  }

  private move(si: number): void {
    const [low, high] = this.point?.range ?? [0, 0];
    this.onMove(Number(Math.max(low, Math.min(high, si)).toPrecision(4)));
  }

  private drag(event: PointerEvent): void {
    if (!this.point) return;
    const { plot, factor } = this.point;
    event.preventDefault();
    this.element.focus();
    dragged(this.element, event, ({ clientX }) => {
      const left = clientX - plot.over.getBoundingClientRect().left;
      this.move(plot.posToVal(left, 'x') * factor);
    });
  }

  private step(event: KeyboardEvent): void {
    const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (!sign || !this.point) return;
    event.preventDefault();
    const { range, si } = this.point;
    this.move(si + sign * (range[1] - range[0]) * KEY_STEP * (event.shiftKey ? 10 : 1));
  }
}
