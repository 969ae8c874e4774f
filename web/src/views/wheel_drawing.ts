/** Both profiles to scale in the track, seen along rolling, with contacts and patches in place. */
import { drawArrow } from '../draw/arrows';
import { atX, atY, drawAxes, FONT, penOf, type Frame } from '../draw/axes';
import { colourScale } from '../draw/colour_map';
import { numberOf, numbers } from '../draw/fields';
import { digits } from '../quantity';
import type { Answered, Grid, Line, Outlines, Table } from '../solver/protocol';
import { nameOf, t } from '../texts';
import { colour } from '../theme';
import { placedWheel, type Pose } from './pose';

/** A place of the picture, or a vector in it, in pixels. */
type Place = [number, number];

/** What is drawn. */
export interface Scene {
  outlines: Outlines;
  pose: Pose;
  answered: Answered;
}

/** How it is drawn. */
export interface Showing {
  /** Whether only the surroundings of the contacts are shown. */
  isClose: boolean;
  /** The frame to keep, while the wheel is dragged. */
  held: Frame | null;
  /** A pinned wheel. */
  beside: Scene | null;
}

const MARGIN = { left: 54, right: 16, top: 22, bottom: 42 };
/** Surroundings of contacts and of both profiles in mm; of patches in the plan, in mm per m. */
const AROUND = { close: 9, far: 6, plan: 1.3e3 };
/** Room above the contacts for the arrow of the normal force, in mm. */
const HEADROOM = 14;
/** Length of the arrow of the largest force, in pixels. */
const REACH = 90;

/** Draws the profiles; the frame tells where places are. */
export function drawProfiles(
  canvas: HTMLCanvasElement,
  width: number,
  { outlines, pose, answered }: Scene,
  { isClose, held, beside }: Showing,
): Frame | null {
  const wheel = placedWheel(outlines, pose);
  const contacts = answered.tables['contact'] ?? [];
  const frame = held ?? framed([outlines.rail, wheel], isClose ? contacts : [], width);
  const pen = penOf(canvas, width, frame.top + frame.height + MARGIN.bottom);
  if (!pen) return null;
  pen.save();
  pen.beginPath();
  pen.rect(frame.left, frame.top, frame.width, frame.height);
  pen.clip();
  drawBody(pen, frame, outlines.rail, 'rail', false);
  drawBody(pen, frame, wheel, 'wheel', true);
  if (beside) drawPinned(pen, frame, beside);
  contacts.forEach((contact) => drawPatch(pen, frame, contact, 'accent'));
  pen.restore();
  const largest = Math.max(...contacts.map((contact) => numberOf(contact, 'normal.load')));
  contacts.forEach((contact, index) => drawForces(pen, frame, contact, index, largest));
  drawAxes(pen, frame, [`y (mm), ${t('seen_along')}`, 'z (mm)']);
  drawNames(pen, frame, contacts);
  return frame;
}

function framed(lines: Line[], contacts: Table[], width: number): Frame {
  const ys =
    contacts.length > 0
      ? contacts.map((contact) => numberOf(contact, 'position.y'))
      : lines.flatMap(({ y }) => y);
  const zs =
    contacts.length > 0
      ? contacts.map((contact) => numberOf(contact, 'position.z'))
      : lines.flatMap(({ z }) => z);
  const around = contacts.length > 0 ? AROUND.close : AROUND.far;
  const y: [number, number] = [Math.max(...ys) * 1e3 + around, Math.min(...ys) * 1e3 - around];
  let z: [number, number] = [Math.min(...zs) * 1e3 - around, Math.max(...zs) * 1e3 + around];
  if (contacts.length === 0) z[1] += HEADROOM;
  const inner = width - MARGIN.left - MARGIN.right;
  const scale = inner / (y[0] - y[1]);
  const height = Math.max(220, Math.min(420, (z[1] - z[0]) * scale));
  const extra = height / scale - (z[1] - z[0]);
  z =
    contacts.length > 0
      ? [z[0] - extra / 2, z[1] + extra / 2]
      : [z[0] - extra / 3, z[1] + (2 * extra) / 3];
  return { left: MARGIN.left, top: MARGIN.top, width: inner, height, x: y, y: z };
}

function pathOf(frame: Frame, { y, z }: Line): Path2D {
  const path = new Path2D();
  y.forEach((at, index) => {
    const place: Place = [atX(frame, at * 1e3), atY(frame, (z[index] ?? 0) * 1e3)];
    if (index === 0) path.moveTo(...place);
    else path.lineTo(...place);
  });
  return path;
}

/** The wheel as it was pinned, with its contacts. */
function drawPinned(
  pen: CanvasRenderingContext2D,
  frame: Frame,
  { outlines, pose, answered }: Scene,
): void {
  pen.save();
  pen.strokeStyle = colour('curve-2');
  pen.lineWidth = 1.5;
  pen.setLineDash([6, 4]);
  pen.stroke(pathOf(frame, placedWheel(outlines, pose)));
  pen.restore();
  for (const contact of answered.tables['contact'] ?? []) drawPatch(pen, frame, contact, 'curve-2');
}

function drawBody(
  pen: CanvasRenderingContext2D,
  frame: Frame,
  { y, z }: Line,
  name: 'rail' | 'wheel',
  isAbove: boolean,
): void {
  const path = pathOf(frame, { y, z });
  const filled = new Path2D(path);
  const edge = isAbove ? frame.top - 10 : frame.top + frame.height + 10;
  filled.lineTo(atX(frame, (y.at(-1) ?? 0) * 1e3), edge);
  filled.lineTo(atX(frame, (y[0] ?? 0) * 1e3), edge);
  pen.fillStyle = colour(`${name}-fill`);
  pen.fill(filled);
  pen.strokeStyle = colour(`${name}-line`);
  pen.lineWidth = 1.8;
  pen.stroke(path);
}

/** The patch as a thick line, as wide as it is. */
function drawPatch(
  pen: CanvasRenderingContext2D,
  frame: Frame,
  contact: Table,
  colourName: string,
): void {
  const angle = numberOf(contact, 'angle');
  const half = numberOf(contact, 'normal.semi_axis_y');
  const [y, z] = [numberOf(contact, 'position.y'), numberOf(contact, 'position.z')];
  pen.beginPath();
  for (const sign of [-1, 1]) {
    const across = sign * half;
    pen.lineTo(
      atX(frame, (y + across * Math.cos(angle)) * 1e3),
      atY(frame, (z - across * Math.sin(angle)) * 1e3),
    );
  }
  pen.strokeStyle = colour(colourName);
  pen.lineCap = 'round';
  pen.lineWidth = 5;
  pen.stroke();
}

/** Normal and lateral force on the wheel, in the plane of the picture. */
function drawForces(
  pen: CanvasRenderingContext2D,
  frame: Frame,
  contact: Table,
  index: number,
  largest: number,
): void {
  const angle = numberOf(contact, 'angle');
  const [load, lateral] = [numberOf(contact, 'normal.load'), numberOf(contact, 'force.y')];
  const from: Place = [
    atX(frame, numberOf(contact, 'position.y') * 1e3),
    atY(frame, numberOf(contact, 'position.z') * 1e3),
  ];
  const scale = Math.max(20, Math.min(REACH, from[1] - frame.top - 10)) / largest;
  // To the left in the track is to the left in the picture, upwards is upwards.
  const normal: Place = [-load * Math.sin(angle) * scale, -load * Math.cos(angle) * scale];
  const tangent: Place = [-lateral * Math.cos(angle) * scale, lateral * Math.sin(angle) * scale];
  drawArrow(pen, from, normal, true);
  if (Math.hypot(...tangent) > 3) drawArrow(pen, from, tangent, false);
  pen.font = `600 ${FONT}`;
  pen.fillStyle = colour('ink');
  pen.textAlign = 'left';
  pen.textBaseline = 'middle';
  pen.fillText(String(index + 1), from[0] + 10, from[1] - 16);
}

/** Names of the bodies, and the forces of all contacts. */
function drawNames(pen: CanvasRenderingContext2D, frame: Frame, contacts: Table[]): void {
  pen.font = `600 ${FONT}`;
  pen.textAlign = 'left';
  pen.textBaseline = 'top';
  pen.fillStyle = colour('ink');
  pen.fillText(t('of_wheel'), frame.left + 8, frame.top + 8);
  pen.textBaseline = 'bottom';
  pen.fillText(t('of_rail'), frame.left + 8, frame.top + frame.height - 8);
  pen.textAlign = 'right';
  contacts.forEach((contact, index) => {
    const [load, lateral] = ['normal.load', 'force.y'].map((name) =>
      digits(numberOf(contact, name) / 1e3, 3),
    );
    const bottom = frame.top + frame.height - 8 - 18 * (contacts.length - 1 - index);
    const told = `${index + 1}: N = ${load} kN, Fy = ${lateral} kN`;
    pen.fillText(told, frame.left + frame.width - 8, bottom);
  });
}

/** Draws the pressure of all patches from above, under the profiles; of several in one scale. */
export function drawPlans(
  canvases: HTMLCanvasElement[],
  width: number,
  frame: Frame,
  scenes: (Scene | null)[],
): void {
  const pressures = scenes.map((scene) =>
    (scene?.answered.tables['fields'] ?? []).map((table) => numbers(table['pressure'])),
  );
  const { of } = colourScale(pressures.flat().flatMap((values) => [...values]));
  canvases.forEach((canvas, index) => {
    const [scene, pressure] = [scenes[index], pressures[index]];
    const note = index > 0 ? `, ${t('pinned')}` : '';
    if (scene && pressure) drawPlan(canvas, width, frame, { scene, pressure, of, note });
  });
}

interface Plan {
  scene: Scene;
  pressure: Float64Array[];
  of: (value: number) => string;
  note: string;
}

function drawPlan(
  canvas: HTMLCanvasElement,
  width: number,
  frame: Frame,
  { scene, pressure, of, note }: Plan,
): void {
  const { tables, grids } = scene.answered;
  const contacts = tables['contact'] ?? [];
  const scale = frame.width / Math.abs(frame.x[0] - frame.x[1]);
  const middles = contacts.map((contact) => numberOf(contact, 'position.x') * 1e3);
  const reach = contacts.map((contact) => numberOf(contact, 'normal.semi_axis_x') * AROUND.plan);
  const low = Math.min(...middles.map((x, index) => x - (reach[index] ?? 0)));
  const high = Math.max(...middles.map((x, index) => x + (reach[index] ?? 0)));
  const height = (high - low) * scale;
  const plan: Frame = { ...frame, top: 10, height, y: [low, high] };
  const pen = penOf(canvas, width, plan.top + height + MARGIN.bottom);
  if (!pen) return;
  pen.save();
  pen.beginPath();
  pen.rect(plan.left, plan.top, plan.width, plan.height);
  pen.clip();
  pressure.forEach((values, index) => {
    const [contact, grid] = [contacts[index], grids[index]];
    if (contact && grid) drawCells(pen, plan, contact, grid, values, of);
  });
  pen.restore();
  drawAxes(pen, plan, [`y (mm) – ${nameOf('pressure', 'normal pressure')}${note}`, 'x (mm)']);
}

function drawCells(
  pen: CanvasRenderingContext2D,
  plan: Frame,
  contact: Table,
  grid: Grid,
  values: Float64Array,
  colourOf: (value: number) => string,
): void {
  const known = (name: string) => numberOf(contact, name) || 0;
  const cosine = Math.cos(known('angle'));
  const [dx, dy] = grid.spacing;
  grid.cells.forEach(([column, row], index) => {
    const x = known('position.x') + grid.centre[0] + grid.origin[0] + column * dx;
    const across = grid.centre[1] + grid.origin[1] + row * dy;
    const y = known('position.y') + cosine * across;
    const [left, right] = [
      atX(plan, (y + (cosine * dy) / 2) * 1e3),
      atX(plan, (y - (cosine * dy) / 2) * 1e3),
    ];
    const [low, high] = [atY(plan, (x - dx / 2) * 1e3), atY(plan, (x + dx / 2) * 1e3)];
    pen.fillStyle = colourOf(values[index] ?? 0);
    pen.fillRect(left, high, right - left + 0.5, low - high + 0.5);
  });
}
