/** Files for a person to keep. */
import type { Shown } from '../case/commands';
import type { Explorer } from '../explorer';
import { h } from '../dom';
import { showFigures } from './dialogs';

/** Offers a file to save. */
export function offer(name: string, content: Blob): void {
  const url = URL.createObjectURL(content);
  h('a', { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** Saves the case with all assignments in it. */
export function saveCase({ described, model }: Explorer): void {
  if (described) offer(model.name, new Blob([described.toml], { type: 'application/toml' }));
}

/** Saves what the program writes of the last solution or curve; of figures a person chooses. */
export async function saveResult(
  explorer: Explorer,
  task: Shown['task'],
  what: 'csv' | 'json' | 'figures',
): Promise<void> {
  const isLong = task === 'curve' || explorer.result?.isTransient;
  const lane = isLong ? explorer.long : explorer.contact;
  const of = task === 'curve' ? 'curve' : 'solution';
  const answer = await lane.ask('save', 'files', { of, what });
  const base = explorer.model.name.replace(/\.toml$/, '');
  const files = answer?.files ?? [];
  if (what === 'figures') {
    showFigures(files.map(([name, svg]) => [`${base}_${name}.svg`, svg]));
    return;
  }
  for (const [name, text] of files) offer(`${base}.${name}`, new Blob([text]));
}

/** Saves what is drawn in a view: the first drawing that is seen. */
export function savePicture(explorer: Explorer, view: HTMLElement): void {
  const canvas = [...view.querySelectorAll('canvas')].find((one) => one.offsetParent !== null);
  canvas?.toBlob((blob) => {
    if (blob) offer(explorer.model.name.replace(/\.toml$/, '.png'), blob);
  });
}
