/** Arrows of a field, and lines between stick and slip. */
import { atX, atY, type Frame } from './axes';

/** An arrow at a place; hollow where the surfaces stick. */
export interface Arrow {
  x: number;
  y: number;
  u: number;
  v: number;
  slides: boolean;
}

/** A straight part of a border. */
export type Segment = [number, number, number, number];

const INK = '#10161c';
const PAPER = '#ffffff';

/** Arrows, and the value of which one is as long as the longest of all maps that are compared. */
export interface Arrows {
  all: Arrow[];
  longest: number;
}

/** Draws arrows; the longest is `reach` pixels long. */
export function drawArrows(
  pen: CanvasRenderingContext2D,
  frame: Frame,
  { all, longest }: Arrows,
  reach: number,
): void {
  const scale = reach / Math.max(longest, Number.MIN_VALUE);
  for (const { x, y, u, v, slides } of all) {
    const [dx, dy] = [u * scale, -v * scale];
    if (Math.hypot(dx, dy) < 1.5) continue;
    drawArrow(pen, [atX(frame, x) - dx / 2, atY(frame, y) - dy / 2], [dx, dy], slides);
  }
}

/** Draws one arrow from a place of the canvas: dark if filled, light otherwise. */
export function drawArrow(
  pen: CanvasRenderingContext2D,
  [x, y]: [number, number],
  [dx, dy]: [number, number],
  isDark: boolean,
): void {
  const length = Math.hypot(dx, dy);
  const head = Math.min(6, 0.5 * length);
  const [ex, ey] = [dx / length, dy / length];
  const [tx, ty] = [x + dx, y + dy];
  const shape = new Path2D();
  shape.moveTo(x, y);
  shape.lineTo(tx, ty);
  shape.moveTo(tx - head * (ex + 0.55 * ey), ty - head * (ey - 0.55 * ex));
  shape.lineTo(tx, ty);
  shape.lineTo(tx - head * (ex - 0.55 * ey), ty - head * (ey + 0.55 * ex));
  pen.lineCap = 'round';
  pen.lineJoin = 'round';
  pen.strokeStyle = isDark ? PAPER : INK;
  pen.lineWidth = 3.2;
  pen.stroke(shape);
  pen.strokeStyle = isDark ? INK : PAPER;
  pen.lineWidth = 1.3;
  pen.stroke(shape);
}

/** Draws a border so that it is seen on every colour. */
export function drawBorder(pen: CanvasRenderingContext2D, frame: Frame, border: Segment[]): void {
  const path = new Path2D();
  for (const [x0, y0, x1, y1] of border) {
    path.moveTo(atX(frame, x0), atY(frame, y0));
    path.lineTo(atX(frame, x1), atY(frame, y1));
  }
  pen.lineCap = 'round';
  for (const [width, ink] of [
    [3.6, INK],
    [1.6, PAPER],
  ] as const) {
    pen.lineWidth = width;
    pen.strokeStyle = ink;
    pen.stroke(path);
  }
}
