/** Round numbers on axes, and a canvas that fits its place. */
import { colour } from '../theme';
import { digits } from '../quantity';

/** A part of a canvas that shows a range of a plane; y grows upwards. */
export interface Frame {
  left: number;
  top: number;
  width: number;
  height: number;
  x: [number, number];
  y: [number, number];
}

/** The font of drawings. */
export const FONT = '12px system-ui, sans-serif';

/** Steps of round numbers, as parts of a power of ten. */
const STEPS = [1, 0.5, 0.25, 0.2];

/** Round numbers in a range, at most about so many, and three at least. */
export function ticks(range: [number, number], about: number): number[] {
  const [low, high] = [Math.min(...range), Math.max(...range)];
  const size = high - low;
  if (!(size > 0) || !Number.isFinite(size)) return [];
  const largest = 10 ** Math.ceil(Math.log10(size));
  const steps = [1, 0.1, 0.01].flatMap((part) => STEPS.map((step) => step * part * largest));
  const all = steps.map((step) => multiples(step, low, high));
  return all.find(({ length }) => length >= Math.max(3, about / 2)) ?? [];
}

function multiples(step: number, low: number, high: number): number[] {
  const first = Math.ceil(low / step - 1e-9);
  const count = Math.floor(high / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, index) =>
    Number(((first + index) * step).toPrecision(12)),
  );
}

/** Where a value is on the canvas, along x. */
export function atX(frame: Frame, x: number): number {
  return frame.left + ((x - frame.x[0]) / (frame.x[1] - frame.x[0])) * frame.width;
}

/** Where a value is on the canvas, along y. */
export function atY(frame: Frame, y: number): number {
  return frame.top + frame.height - ((y - frame.y[0]) / (frame.y[1] - frame.y[0])) * frame.height;
}

/** The value at a place of the canvas. */
export function valueAt(frame: Frame, [px, py]: [number, number]): [number, number] {
  const [x0, x1] = frame.x;
  const [y0, y1] = frame.y;
  return [
    x0 + ((px - frame.left) / frame.width) * (x1 - x0),
    y0 + ((frame.top + frame.height - py) / frame.height) * (y1 - y0),
  ];
}

/** Draws both axes with numbers and labels. */
export function drawAxes(
  pen: CanvasRenderingContext2D,
  frame: Frame,
  [xLabel, yLabel]: [string, string],
): void {
  const { left, top, width, height } = frame;
  pen.font = FONT;
  pen.fillStyle = colour('muted');
  pen.strokeStyle = colour('line');
  pen.lineWidth = 1;
  pen.strokeRect(left + 0.5, top + 0.5, width - 1, height - 1);
  pen.textAlign = 'center';
  pen.textBaseline = 'top';
  for (const x of ticks(frame.x, width / 70)) {
    const at = Math.round(atX(frame, x)) + 0.5;
    line(pen, [at, top + height], [at, top + height + 4]);
    pen.fillText(digits(x), at, top + height + 6);
  }
  pen.textAlign = 'right';
  pen.textBaseline = 'middle';
  for (const y of ticks(frame.y, height / 45)) {
    const at = Math.round(atY(frame, y)) + 0.5;
    line(pen, [left - 4, at], [left, at]);
    pen.fillText(digits(y), left - 6, at);
  }
  pen.textAlign = 'center';
  pen.textBaseline = 'bottom';
  pen.fillText(xLabel, left + width / 2, top + height + 38);
  pen.save();
  pen.translate(left - 38, top + height / 2);
  pen.rotate(-Math.PI / 2);
  pen.fillText(yLabel, 0, 0);
  pen.restore();
}

/** Draws a straight line. */
export function line(
  pen: CanvasRenderingContext2D,
  [x0, y0]: [number, number],
  [x1, y1]: [number, number],
): void {
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
}

/** Sets the size of a canvas in pixels of the page; a clean pen. */
export function penOf(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D | null {
  const ratio = window.devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  canvas.style.width = `${width}px`;
  canvas.style.height = `${height}px`;
  const pen = canvas.getContext('2d');
  pen?.scale(ratio, ratio);
  if (pen) {
    pen.fillStyle = colour('panel');
    pen.fillRect(0, 0, width, height);
  }
  return pen;
}
