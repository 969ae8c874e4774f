/** Opens files of a person's: cases, profiles, and others that a case names. */
import { h } from '../dom';
import { shown } from '../report/dialogs';
import { t } from '../texts';
import { filesNamedIn, galleryCase } from './gallery';
import type { Assignment, CaseModel } from './model';

/** A case with profiles. */
const EXAMPLE = 'wheel_on_rail';
/** What a file may be for a case. */
const USES = ['wheel.profile', 'rail.profile', ''] as const;
/** Types of files that no case reads. */
const USELESS = /^(image|audio|video)\/|\/pdf$/;

/** Opens files: a case with those that it names, or files for the present case. */
export async function openFiles(model: CaseModel, list: Iterable<File>): Promise<void> {
  const all = [...list];
  const isCase = (file: File) => file.name.toLowerCase().endsWith('.toml');
  const useless = all.filter(({ type }) => USELESS.test(type));
  if (useless.length > 0) {
    refuse(`${useless.map(({ name }) => name).join(', ')}: ${t('no_input')}`);
    return;
  }
  const given = all.filter((file) => !isCase(file));
  const bytes = new Map<string, Uint8Array>();
  for (const file of given) bytes.set(file.name, new Uint8Array(await file.arrayBuffer()));
  const chosen = all.find(isCase);
  if (chosen) {
    const text = textOf(chosen.name, await chosen.arrayBuffer());
    if (text === null) return;
    const named = await filesNamedIn(text);
    const files = new Map([...named, ...bytes]);
    model.open({ name: chosen.name, text, files, gallery: null });
    return;
  }
  const uses: [string, Assignment][] = [];
  for (const name of bytes.keys()) {
    const use = model.text.includes(`"${name}"`) ? '' : await askUse(name);
    if (use === null) bytes.delete(name);
    if (use) uses.push([use, { toml: JSON.stringify(name), si: null }]);
  }
  if (bytes.size === 0) return;
  const example = uses.length > 0 && !hasProfiles(model) ? await galleryCase(EXAMPLE) : null;
  const { name, text, files, gallery } = example ?? model;
  const kept = example ? [] : model.assignments;
  const together = new Map([...files, ...bytes]);
  model.open({ name, text, files: together, gallery }, [...kept, ...uses]);
}

function refuse(told: string): void {
  shown(t('refused'), h('p', {}, told));
}

/** The text of a case; null if it is none, which is told as the command does. */
function textOf(name: string, bytes: ArrayBuffer): string | null {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    const [before = ''] = new TextDecoder().decode(bytes).split('\ufffd');
    const line = before.split('\n').length;
    refuse(`${name}: the case file must be text in UTF-8, but is not in line ${line}`);
    return null;
  }
}

function hasProfiles(model: CaseModel): boolean {
  return `${model.text}${model.assignments.get('normal.model')?.toml}`.includes('"wheel-rail"');
}

/** Opens the case of the gallery that has profiles. */
export async function openProfiles(model: CaseModel): Promise<void> {
  const found = await galleryCase(EXAMPLE);
  if (found) model.open(found);
}

/** Asks what a file is; null if a person thinks better of it. */
function askUse(name: string): Promise<string | null> {
  const labels = {
    'wheel.profile': t('of_wheel'),
    'rail.profile': t('of_rail'),
    '': t('other_file'),
  };
  return new Promise((resolve) => {
    const answer = (use: string | null) => () => {
      dialog.close();
      resolve(use);
    };
    const dialog = h(
      'dialog',
      { 'aria-label': t('which_body'), oncancel: answer(null) },
      h('h2', {}, t('which_body')),
      h('p', {}, h('code', {}, name)),
      h(
        'div',
        { class: 'toolbar' },
        ...USES.map((use) => h('button', { type: 'button', onclick: answer(use) }, labels[use])),
        h('button', { type: 'button', onclick: answer(null) }, t('cancel')),
      ),
    );
    dialog.addEventListener('close', () => dialog.remove());
    document.body.append(dialog);
    dialog.showModal();
  });
}

/** Opens what is dropped on the page. */
export function acceptDrops(model: CaseModel): void {
  const veil = h('div', { class: 'veil', hidden: true }, t('drop_here'));
  document.body.append(veil);
  document.addEventListener('dragover', (event) => {
    event.preventDefault();
    veil.hidden = false;
  });
  document.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) veil.hidden = true;
  });
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    veil.hidden = true;
    if (event.dataTransfer) void openFiles(model, event.dataTransfer.files);
  });
}
