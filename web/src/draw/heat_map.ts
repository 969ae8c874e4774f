/** A map of values in cells on a canvas, with axes, colour bar, arrows and values to read. */
import { h, perFrame } from '../dom';
import { digits, labelled } from '../quantity';
import { colour } from '../theme';
import { drawArrows, drawBorder, type Arrows, type Segment } from './arrows';
import { atX, atY, drawAxes, FONT, penOf, ticks, valueAt, type Frame } from './axes';
import { colourScale, type ColourScale } from './colour_map';

/** What a map shows: lengths and values in the units of its labels. */
export interface MapContent {
  title: string;
  xEdges: number[];
  yEdges: number[];
  /** Row by row; not a number outside. */
  values: Float64Array;
  unit: string;
  labels: [string, string];
  /** Whether x and y have one scale. */
  isToScale: boolean;
  arrows?: Arrows;
  border?: Segment[];
  mark?: [number, number];
  note?: string;
  /** Lines of text on a cell. */
  describe(column: number, row: number): string[];
}

const MARGIN = { left: 52, right: 78, top: 26, bottom: 44 };
const BAR = { gap: 14, width: 14 };

/** A map that draws itself anew when its size or content changes. */
export class HeatMap {
  readonly element: HTMLElement;
  readonly canvas = h('canvas', { tabindex: 0, role: 'img' });
  /** Called when a cell is pressed, with its place. */
  onPick: (place: [number, number]) => void = () => {};
  private readonly tip = h('div', { class: 'tip', role: 'status', hidden: true });
  private content: MapContent | null = null;
  private scale: ColourScale | null = null;
  private frame: Frame | null = null;
  private cell: [number, number] | null = null;
  private readonly redraw = perFrame(() => this.draw());

  constructor(private readonly maxHeight: number) {
    this.element = h('figure', { class: 'map' }, this.canvas, this.tip);
    new ResizeObserver(this.redraw).observe(this.element);
    this.canvas.addEventListener('pointermove', (event) => this.point(event));
    this.canvas.addEventListener('pointerleave', () => this.choose(null));
    this.canvas.addEventListener('blur', () => this.choose(null));
    this.canvas.addEventListener('keydown', (event) => this.step(event));
    this.canvas.addEventListener('click', (event) => {
      if (this.frame) this.onPick(valueAt(this.frame, [event.offsetX, event.offsetY]));
    });
  }

  /** Shows another content; one scale makes maps comparable. */
  show(content: MapContent, scale = colourScale(content.values)): void {
    this.content = content;
    this.scale = scale;
    this.canvas.setAttribute('aria-label', this.label());
    this.draw();
    if (this.cell) this.choose(this.cell);
  }

  private label(): string {
    if (!this.content || !this.scale) return '';
    const { title, unit } = this.content;
    return `${labelled(title, unit)}: ${digits(this.scale.low)} … ${digits(this.scale.high)}`;
  }

  private draw(): void {
    const { content, scale } = this;
    const width = this.element.clientWidth;
    if (!content || !scale || width < 120) return;
    const frame = this.framed(content, width);
    this.frame = frame;
    const pen = penOf(this.canvas, width, frame.top + frame.height + MARGIN.bottom);
    if (!pen) return;
    drawCells(pen, frame, content, scale);
    drawAxes(pen, frame, content.labels);
    if (content.border) drawBorder(pen, frame, content.border);
    if (content.arrows) drawArrows(pen, frame, content.arrows, 20);
    if (content.mark) drawMark(pen, frame, content.mark);
    drawTitle(pen, frame, content);
    drawBar(pen, frame, scale, content.unit);
  }

  private framed(content: MapContent, width: number): Frame {
    const x: [number, number] = [content.xEdges[0] ?? 0, content.xEdges.at(-1) ?? 1];
    const y: [number, number] = [content.yEdges[0] ?? 0, content.yEdges.at(-1) ?? 1];
    const room = width - MARGIN.left - MARGIN.right;
    const ratio = content.isToScale ? (y[1] - y[0]) / (x[1] - x[0]) : 0.62;
    const height = Math.min(this.maxHeight, Math.max(room * ratio, 40));
    const used = content.isToScale ? height / ratio : room;
    const left = MARGIN.left + Math.max(0, (room - used) / 2);
    return { left, top: MARGIN.top, width: Math.min(used, room), height, x, y };
  }

  private point(event: PointerEvent): void {
    if (!this.frame || !this.content) return;
    const [x, y] = valueAt(this.frame, [event.offsetX, event.offsetY]);
    const column = this.content.xEdges.findLastIndex((edge) => edge <= x);
    const row = this.content.yEdges.findLastIndex((edge) => edge <= y);
    this.choose([column, row]);
  }

  private step(event: KeyboardEvent): void {
    const steps: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const step = steps[event.key];
    if (!step || !this.content) return;
    event.preventDefault();
    const size = [this.content.xEdges.length - 1, this.content.yEdges.length - 1] as const;
    const [column, row] = this.cell ?? [Math.floor(size[0] / 2), Math.floor(size[1] / 2)];
    const within = (at: number, count: number) => Math.max(0, Math.min(count - 1, at));
    this.choose([within(column + step[0], size[0]), within(row + step[1], size[1])]);
  }

  private choose(cell: [number, number] | null): void {
    this.cell = cell;
    const { content, frame } = this;
    const columns = (content?.xEdges.length ?? 1) - 1;
    const value = cell && content ? content.values[cell[1] * columns + cell[0]] : undefined;
    const isInside = cell && content && cell[0] >= 0 && cell[0] < columns && cell[1] >= 0;
    if (!isInside || !frame || value === undefined || Number.isNaN(value)) {
      this.tip.hidden = true;
      return;
    }
    const lines = content.describe(cell[0], cell[1]);
    this.tip.replaceChildren(...lines.map((text) => h('div', {}, text)));
    this.tip.hidden = false;
    const x = atX(frame, middle(content.xEdges, cell[0]));
    const y = atY(frame, middle(content.yEdges, cell[1]));
    const isRight = x > frame.left + frame.width / 2;
    this.tip.style.left = isRight ? '' : `${x + 14}px`;
    this.tip.style.right = isRight ? `${this.element.clientWidth - x + 14}px` : '';
    this.tip.style.top = `${Math.max(0, Math.min(y, frame.height - 120))}px`;
  }
}

function middle(edges: number[], index: number): number {
  return ((edges[index] ?? 0) + (edges[index + 1] ?? 0)) / 2;
}

function drawCells(
  pen: CanvasRenderingContext2D,
  frame: Frame,
  { xEdges, yEdges, values }: MapContent,
  scale: ColourScale,
): void {
  const columns = xEdges.length - 1;
  const xs = xEdges.map((edge) => Math.round(atX(frame, edge)));
  const ys = yEdges.map((edge) => Math.round(atY(frame, edge)));
  values.forEach((value, index) => {
    if (Number.isNaN(value)) return;
    const [column, row] = [index % columns, Math.floor(index / columns)];
    const [x0, x1] = [xs[column] ?? 0, xs[column + 1] ?? 0];
    const [y0, y1] = [ys[row] ?? 0, ys[row + 1] ?? 0];
    pen.fillStyle = scale.of(value);
    pen.fillRect(x0, y1, x1 - x0, y0 - y1);
  });
}

function drawMark(pen: CanvasRenderingContext2D, frame: Frame, [x, y]: [number, number]): void {
  const isWithin = (value: number, [low, high]: [number, number]) => value >= low && value <= high;
  if (!isWithin(x, frame.x) || !isWithin(y, frame.y)) return;
  pen.beginPath();
  pen.arc(atX(frame, x), atY(frame, y), 6, 0, 2 * Math.PI);
  pen.fillStyle = colour('accent');
  pen.fill();
  pen.strokeStyle = '#fff';
  pen.lineWidth = 2;
  pen.stroke();
}

function drawTitle(pen: CanvasRenderingContext2D, frame: Frame, content: MapContent): void {
  pen.fillStyle = colour('ink');
  pen.font = `600 ${FONT}`;
  pen.textAlign = 'left';
  pen.textBaseline = 'bottom';
  pen.fillText(labelled(content.title, content.unit), frame.left, frame.top - 8);
  if (!content.note) return;
  pen.font = FONT;
  pen.fillStyle = colour('muted');
  pen.textAlign = 'right';
  pen.fillText(content.note, frame.left + frame.width, frame.top - 8);
}

function drawBar(
  pen: CanvasRenderingContext2D,
  frame: Frame,
  scale: ColourScale,
  unit: string,
): void {
  const bar: Frame = {
    ...frame,
    left: frame.left + frame.width + BAR.gap,
    width: BAR.width,
    x: [0, 1],
    y: [scale.low, scale.high],
  };
  for (let pixel = 0; pixel < bar.height; pixel += 1) {
    pen.fillStyle = scale.of(valueAt(bar, [0, bar.top + pixel + 0.5])[1]);
    pen.fillRect(bar.left, bar.top + pixel, bar.width, 1.5);
  }
  pen.font = FONT;
  pen.fillStyle = colour('muted');
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  for (const value of ticks(bar.y, bar.height / 36)) {
    pen.fillText(digits(value), bar.left + bar.width + 5, atY(bar, value));
  }
  pen.textBaseline = 'bottom';
  pen.fillText(unit, bar.left, bar.top - 8);
}
