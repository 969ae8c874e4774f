/** The command and the lines of Python that give the same as the page. */
import type { CaseModel } from './model';

/** What the page shows of a case: a task with its request. */
export interface Shown {
  task: 'solve' | 'curve';
  name: string;
  range: string;
  points: number;
}

/** Where the case lies: never an option, and without what steers a terminal. */
function place(model: CaseModel): string {
  const name = model.name.replace(CONTROL, ' ').replace(/^-/, './-');
  return model.gallery ? `cases/${name}` : name;
}

const CONTROL = /[\u0000-\u001f\u007f-\u009f]/g;

/** The command, for a shell. */
export function commandOf(model: CaseModel, shown: Shown): string {
  const sets = [...model.assignments].map(([path, { toml }]) => `--set ${word(`${path}=${toml}`)}`);
  const curve =
    shown.task === 'curve'
      ? [`--${shown.name.replace(/_/g, '-')} ${word(shown.range)}`, `--points ${shown.points}`]
      : [];
  return [`schlupf ${shown.task} ${word(place(model))}`, ...sets, ...curve].join(' \\\n  ');
}

/** A word of a POSIX shell, as it is. */
function word(text: string): string {
  const plain = text.replace(CONTROL, ' ');
  return /^[\w.,:/=+-]+$/.test(plain) ? plain : `'${plain.replace(/'/g, "'\\''")}'`;
}

interface Keywords {
  [name: string]: string | Keywords;
}

/** Lines of Python. */
export function pythonOf(model: CaseModel, shown: Shown): string {
  const keywords: Keywords = {};
  for (const [path, { toml }] of model.assignments) {
    const parts = path.split('.');
    let inner = keywords;
    for (const part of parts.slice(0, -1)) {
      const next = inner[part];
      inner = typeof next === 'object' ? next : (inner[part] = {});
    }
    inner[parts.at(-1) ?? path] = python(toml);
  }
  const changes = Object.entries(keywords).map(
    ([name, value]) => `    ${name}=${dictionary(value)},\n`,
  );
  const changed = changes.length > 0 ? `case = case.with_(\n${changes.join('')})\n` : '';
  const [start = '0', end = ''] = shown.range.split('..');
  const number = end.split(' ')[0] ?? '';
  const ends = `(${start}, ${number})`;
  const asked =
    shown.task === 'solve'
      ? 'result = case.solve()\nprint(result.force.x, result.force.y)'
      : `curve = case.curve(${shown.name}=${ends}, points=${shown.points})\nprint(curve)`;
  const file = JSON.stringify(place(model));
  return `import schlupf\n\ncase = schlupf.Case.from_file(${file})\n${changed}${asked}\n`;
}

/** A value of a case file as a literal of Python; what is no plain value is text. */
function python(toml: string): string {
  if (toml === '') return 'None';
  try {
    return literal(JSON.parse(toml) as unknown);
  } catch {
    return JSON.stringify(toml);
  }
}

function literal(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(literal).join(', ')}]`;
  if (typeof value === 'boolean') return value ? 'True' : 'False';
  return JSON.stringify(typeof value === 'object' ? String(value) : value);
}

function dictionary(value: string | Keywords): string {
  if (typeof value === 'string') return value;
  const members = Object.entries(value).map(([name, inner]) => `"${name}": ${dictionary(inner)}`);
  return `{${members.join(', ')}}`;
}
