/** A quantity as a surface over the patch, by WebGL; loaded only when asked for. */
import { dragged, h } from '../dom';
import type { ColourScale } from './colour_map';
import type { MapContent } from './heat_map';

const VERTEX = `
attribute vec3 place; attribute vec3 normal; attribute vec3 tint;
uniform mat4 view; varying vec3 shade;
void main() {
  vec3 light = normalize(vec3(-0.4, -0.5, 1.0));
  shade = tint * (0.55 + 0.45 * abs(dot(normalize(normal), light)));
  gl_Position = view * vec4(place, 1.0);
}`;
const FRAGMENT = `
precision mediump float; varying vec3 shade;
void main() { gl_FragColor = vec4(shade, 1.0); }`;
/** Numbers of a vertex: place, normal, colour. */
const STRIDE = 9;
/** Height of the largest value over half the length of the patch. */
const HEIGHT = 0.7;
const TURN = 0.01;

/** A surface that a person turns. */
export class Surface {
  readonly canvas = h('canvas', { class: 'surface', tabindex: 0, role: 'img' });
  private readonly gl = this.canvas.getContext('webgl', { antialias: true });
  private readonly program: WebGLProgram | null;
  private vertices = 0;
  private turn = -0.6;
  private tilt = 1.0;

  constructor() {
    this.program = this.gl ? linked(this.gl) : null;
    this.canvas.addEventListener('pointerdown', (event) => {
      let [x, y] = [event.clientX, event.clientY];
      dragged(this.canvas, event, ({ clientX, clientY }) => {
        this.rotate((clientX - x) * TURN, (clientY - y) * TURN);
        [x, y] = [clientX, clientY];
      });
    });
    this.canvas.addEventListener('keydown', (event) => {
      const steps: Record<string, [number, number]> = {
        ArrowLeft: [-0.1, 0],
        ArrowRight: [0.1, 0],
        ArrowUp: [0, -0.1],
        ArrowDown: [0, 0.1],
      };
      const step = steps[event.key];
      if (!step) return;
      event.preventDefault();
      this.rotate(...step);
    });
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /** Shows the values of a map in its colours. */
  show(content: MapContent, scale: ColourScale): void {
    const { gl } = this;
    if (!gl) return;
    this.canvas.setAttribute('aria-label', `${content.title}: 3D`);
    const data = mesh(content, scale);
    this.vertices = data.length / STRIDE;
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    this.draw();
  }

  private rotate(turn: number, tilt: number): void {
    this.turn += turn;
    this.tilt = Math.max(0, Math.min(Math.PI / 2, this.tilt + tilt));
    this.draw();
  }

  private draw(): void {
    const { gl, program, canvas } = this;
    if (!gl || !program || this.vertices === 0) return;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = canvas.clientWidth * ratio;
    canvas.height = canvas.clientHeight * ratio;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.useProgram(program);
    ['place', 'normal', 'tint'].forEach((name, index) => {
      const at = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, 3, gl.FLOAT, false, 4 * STRIDE, 12 * index);
    });
    const aspect = canvas.width / Math.max(1, canvas.height);
    gl.uniformMatrix4fv(gl.getUniformLocation(program, 'view'), false, this.view(aspect));
    gl.drawArrays(gl.TRIANGLES, 0, this.vertices);
  }

  /** Turned about the normal, tilted, and seen from far away. */
  private view(aspect: number): Float32Array {
    const [c, s] = [Math.cos(this.turn), Math.sin(this.turn)];
    const [ct, st] = [Math.cos(this.tilt), Math.sin(this.tilt)];
    const zoom = Math.min(1.15, 0.75 * aspect);
    const [x, y] = [zoom / aspect, zoom];
    return Float32Array.of(
      x * c,
      y * s * ct,
      0.4 * s * st,
      0,
      -x * s,
      y * c * ct,
      0.4 * c * st,
      0,
      0,
      y * st,
      -0.4 * ct,
      0,
      0,
      -0.3 * y * st,
      0,
      1,
    );
  }
}

function linked(gl: WebGLRenderingContext): WebGLProgram | null {
  const program = gl.createProgram();
  for (const [kind, source] of [
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, FRAGMENT],
  ] as const) {
    const shader = gl.createShader(kind);
    if (!shader || !program) return null;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  return program;
}

/** Two triangles between the middles of four cells; outside the contact the height is zero. */
function mesh({ xEdges, yEdges, values }: MapContent, scale: ColourScale): Float32Array {
  const [columns, rows] = [xEdges.length - 1, yEdges.length - 1];
  const [x0, y0] = [middle(xEdges, 0, columns), middle(yEdges, 0, rows)];
  const size = Math.max((xEdges[columns] ?? 1) - x0, (yEdges[rows] ?? 1) - y0);
  const largest = Math.max(Math.abs(scale.low), Math.abs(scale.high));
  const raw = (column: number, row: number) => {
    const isInside = column >= 0 && column < columns && row >= 0 && row < rows;
    return isInside ? (values[row * columns + column] ?? NaN) : NaN;
  };
  const cell = (edges: number[], index: number) => {
    const step = (edges[1] ?? 1) - (edges[0] ?? 0);
    return (edges[0] ?? 0) + (index + 0.5) * step;
  };
  const height = (column: number, row: number) => ((raw(column, row) || 0) / largest) * HEIGHT;
  const data: number[] = [];
  const vertex = (column: number, row: number) => {
    const [dx, dy] = [(2 * size) / columns, (2 * size) / rows];
    const slope = (one: number, other: number, step: number) => ((other - one) * size) / step;
    data.push(
      (cell(xEdges, column) - x0) / size,
      (cell(yEdges, row) - y0) / size,
      height(column, row),
      -slope(height(column - 1, row), height(column + 1, row), dx),
      -slope(height(column, row - 1), height(column, row + 1), dy),
      1,
      ...channels(scale.of(raw(column, row) || 0)),
    );
  };
  for (let row = -1; row < rows; row += 1) {
    for (let column = -1; column < columns; column += 1) {
      const corners = [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 0],
        [1, 1],
        [0, 1],
      ] as const;
      const isOutside = corners.every(([dx, dy]) => Number.isNaN(raw(column + dx, row + dy)));
      if (!isOutside) corners.forEach(([dx, dy]) => vertex(column + dx, row + dy));
    }
  }
  return Float32Array.from(data);
}

function middle(edges: number[], from: number, to: number): number {
  return ((edges[from] ?? 0) + (edges[to] ?? 0)) / 2;
}

function channels(colour: string): number[] {
  return (colour.match(/\d+/g) ?? []).map((part) => Number(part) / 255);
}
