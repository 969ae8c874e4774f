/** What is wrong with a case: each with its place, the line there and what helps. */
import { h } from '../dom';
import type { Problem } from '../solver/protocol';
import { t } from '../texts';

/** What the program proposes to take out of the case, and to put into it. */
const TO_REMOVE = /with explorer ([\w.]+)=$/;
const TO_ADD = /^such as \w+ = (.+)$/;

/** A value of a field that would help: its path, and the value as in a case file. */
function remedy({ field, help }: Problem): [string, string] | null {
  const path = TO_REMOVE.exec(help ?? '')?.[1];
  if (path) return [path, ''];
  const value = TO_ADD.exec(help ?? '')?.[1];
  return value && field ? [field, value] : null;
}

/** A list of problems under a title; `text` is the case in which places are lines. */
export function problemList(
  title: string,
  problems: Problem[],
  text: string,
  assign?: (values: [string, string][]) => void,
): HTMLElement {
  const lines = text.split('\n');
  const item = (problem: Problem) => {
    const { message, place, help } = problem;
    const at = /^(.*):(\d+):(\d+)$/.exec(place);
    const row = Number(at?.[2] ?? 0);
    const column = Number(at?.[3] ?? 1);
    const shown = at ? `${at[1]}, ${t('line')} ${row}` : place;
    const quoted = lines[row - 1];
    const parts: Node[] = [h('p', { class: 'place' }, shown), h('p', {}, message)];
    if (at && quoted !== undefined) {
      parts.push(h('pre', {}, `${quoted}\n${' '.repeat(Math.max(0, column - 1))}^`));
    }
    const found = remedy(problem);
    if (found && assign) {
      const [path, value] = found;
      const label = value ? `${path} = ${value}` : `${t('take_out')} ${path}`;
      parts.push(h('button', { type: 'button', onclick: () => assign([found]) }, label));
    } else if (help) {
      parts.push(h('p', { class: 'help' }, help));
    }
    return h('li', {}, ...parts);
  };
  return h(
    'section',
    { class: 'problems', role: 'alert' },
    h('h2', {}, title),
    h('ul', {}, ...problems.map(item)),
  );
}
