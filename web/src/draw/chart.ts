/** Curves by uPlot in the colours of the theme. */
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h } from '../dom';
import { digits } from '../quantity';
import { colour, onTheme } from '../theme';

/** A curve of a chart. */
export interface Curve {
  label: string;
  values: ArrayLike<number>;
  /** Index of its colour. */
  colour: number;
  dashed?: boolean;
}

/** What a chart shows; curves share the abscissa. */
export interface ChartContent {
  x: ArrayLike<number>;
  xLabel: string;
  yLabel: string;
  curves: Curve[];
  /** A value of x to mark. */
  cursor?: number;
  /** Points to draw on top. */
  points?: { x: number; y: number; isPinned: boolean }[];
}

/** A chart that fits the width of its place. */
export class Chart {
  readonly element = h('div', { class: 'chart', role: 'img', hidden: true });
  /** The drawing, once there is one. */
  plot: uPlot | null = null;
  private content: ChartContent | null = null;
  private shape = '';

  constructor(private readonly height: number) {
    const resized = () => this.fit();
    new ResizeObserver(resized).observe(this.element);
    onTheme(() => {
      this.shape = '';
      if (this.content) this.show(this.content);
    });
  }

  /** Shows another content. */
  show(content: ChartContent): void {
    this.content = content;
    this.element.hidden = false;
    const width = this.element.clientWidth;
    if (width < 100) return;
    const names = content.curves.map(({ label }) => label).join(', ');
    this.element.setAttribute('aria-label', `${content.yLabel} – ${content.xLabel}: ${names}`);
    const shape = JSON.stringify([
      content.xLabel,
      content.yLabel,
      content.curves.map(({ label, colour: index, dashed }) => [label, index, dashed]),
    ]);
    // A gap is null: with one value that is not a number a chart stays blank.
    const drawn = (value: number) => (Number.isFinite(value) ? value : null);
    const data = [
      content.x,
      ...content.curves.map(({ values }) => Array.from(values, drawn)),
    ] as uPlot.AlignedData;
    if (shape === this.shape && this.plot) {
      this.plot.setData(data);
      return;
    }
    this.shape = shape;
    this.plot?.destroy();
    this.plot = new uPlot(this.options(content, width), data, this.element);
  }

  /** Draws points and cursor anew. */
  touch(points: ChartContent['points']): void {
    if (!this.content) return;
    this.content.points = points ?? [];
    this.plot?.redraw(false);
  }

  private fit(): void {
    const width = this.element.clientWidth;
    if (!this.plot) {
      if (this.content) this.show(this.content);
    } else if (width >= 100 && width !== this.plot.width) {
      this.plot.setSize({ width, height: this.height });
    }
  }

  private options(content: ChartContent, width: number): uPlot.Options {
    const ink = colour('muted');
    const axis = {
      stroke: ink,
      grid: { stroke: colour('grid'), width: 1 },
      ticks: { stroke: colour('line'), width: 1, size: 5 },
      font: '12px system-ui, sans-serif',
      labelFont: '12px system-ui, sans-serif',
      values: (_plot: uPlot, values: number[]) => values.map((value) => digits(value)),
    };
    const shown = (_plot: uPlot, value: number | null) => (value === null ? '–' : digits(value));
    return {
      width,
      height: this.height,
      scales: { x: { time: false } },
      axes: [
        { ...axis, label: content.xLabel, labelSize: 20, size: 32 },
        { ...axis, label: content.yLabel, labelSize: 20, size: 58 },
      ],
      series: [
        { label: content.xLabel.split(/[,(]/)[0]?.trim() ?? '', value: shown },
        ...content.curves.map((curve) => ({
          label: curve.label,
          value: shown,
          stroke: colour(`curve-${curve.colour % 6}`),
          width: 2,
          points: { show: false },
          ...(curve.dashed ? { dash: [6, 4] } : {}),
        })),
      ],
      hooks: { draw: [(plot) => this.drawMarks(plot)] },
    };
  }

  private drawMarks(plot: uPlot): void {
    const { cursor, points } = this.content ?? {};
    const pen = plot.ctx;
    const ratio = uPlot.pxRatio;
    pen.save();
    pen.setLineDash([]);
    if (cursor !== undefined) {
      const x = plot.valToPos(cursor, 'x', true);
      pen.strokeStyle = colour('accent');
      pen.lineWidth = 1.5 * ratio;
      pen.beginPath();
      pen.moveTo(x, plot.bbox.top);
      pen.lineTo(x, plot.bbox.top + plot.bbox.height);
      pen.stroke();
    }
    for (const point of points ?? []) {
      pen.beginPath();
      const [x, y] = [plot.valToPos(point.x, 'x', true), plot.valToPos(point.y, 'y', true)];
      pen.arc(x, y, 7 * ratio, 0, 2 * Math.PI);
      pen.fillStyle = point.isPinned ? colour('panel') : colour('accent');
      pen.fill();
      pen.strokeStyle = point.isPinned ? colour('accent') : colour('panel');
      pen.lineWidth = 2 * ratio;
      pen.stroke();
    }
    pen.restore();
  }
}
