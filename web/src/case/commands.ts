/** The command and the lines of Python that give the same as the page. */
import type { CaseModel } from './model';

/** What the page shows of a case: a task with its request. */
export interface Shown {
  task: 'solve' | 'curve';
  name: string;
  range: string;
  points: number;
}

const place = (model: CaseModel): string => (model.gallery ? `cases/${model.name}` : model.name);

/** The command, for a shell. */
export function commandOf(model: CaseModel, shown: Shown): string {
  const sets = [...model.assignments].map(([path, { toml }]) => `--set ${path}=${shell(toml)}`);
  const curve =
    shown.task === 'curve'
      ? [
          `--${shown.name.replace(/_/g, '-')} ${shell(JSON.stringify(shown.range))}`,
          `--points ${shown.points}`,
        ]
      : [];
  return [`schlupf ${shown.task} ${place(model)}`, ...sets, ...curve].join(' \\\n  ');
}

function shell(toml: string): string {
  if (toml === '') return '';
  return /^"[^"$`\\!]*"$/.test(toml) ? toml : /^[\w.+-]+$/.test(toml) ? toml : `'${toml}'`;
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
  return `import schlupf\n\ncase = schlupf.Case.from_file("${place(model)}")\n${changed}${asked}\n`;
}

function python(toml: string): string {
  if (toml === '') return 'None';
  if (toml === 'true') return 'True';
  return toml === 'false' ? 'False' : toml;
}

function dictionary(value: string | Keywords): string {
  if (typeof value === 'string') return value;
  const members = Object.entries(value).map(([name, inner]) => `"${name}": ${dictionary(inner)}`);
  return `{${members.join(', ')}}`;
}
