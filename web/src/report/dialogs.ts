/** Dialogs: the case as text, figures, and the commands that give the same. */
import { commandOf, pythonOf, type Shown } from '../case/commands';
import type { CaseModel } from '../case/model';
import { h } from '../dom';
import type { NamedText } from '../solver/protocol';
import { t } from '../texts';

/** Shows a dialog until it is closed. */
export function shown(title: string, ...children: Node[]): HTMLDialogElement {
  const closed = () => dialog.close();
  const dialog = h(
    'dialog',
    { 'aria-label': title },
    h(
      'header',
      {},
      h('h2', {}, title),
      h('button', { type: 'button', 'aria-label': t('close'), onclick: closed }, '✕'),
    ),
    ...children,
  );
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  return dialog;
}

/** Edits the text of the case. */
export function editCase(model: CaseModel, toml: string): void {
  const text = h('textarea', {
    class: 'code',
    spellcheck: 'false',
    'aria-label': t('edit'),
    rows: 26,
  });
  text.value = toml;
  const apply = () => {
    dialog.close();
    const { name, files } = model;
    model.open({ name, text: text.value, files, gallery: null });
  };
  const dialog = shown(
    t('edit'),
    text,
    h(
      'div',
      { class: 'toolbar' },
      h('button', { type: 'button', class: 'main', onclick: apply }, t('apply')),
    ),
  );
}

/** Shows command and Python. */
export function showSame(model: CaseModel, task: Shown): void {
  const block = (title: string, text: string) => {
    const copy = h('button', { type: 'button', onclick: () => void copied(copy, text) }, t('copy'));
    return h(
      'section',
      {},
      h('header', {}, h('h3', {}, title), copy),
      h('pre', { tabindex: 0 }, text),
    );
  };
  shown(
    t('same'),
    block(t('command_line'), commandOf(model, task)),
    block('Python', pythonOf(model, task)),
  );
}

/** Shows figures by their file names; each can be saved. */
export function showFigures(figures: NamedText[]): void {
  const drawn = figures.map(([name, svg]) => {
    const url = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    const image = h('img', { src: url, alt: name, class: 'drawing' });
    return h('a', { href: url, download: name, title: name }, image, h('span', {}, name));
  });
  const dialog = shown(t('save_svg'), h('div', { class: 'drawings' }, ...drawn));
  dialog.addEventListener('close', () => drawn.forEach(({ href }) => URL.revokeObjectURL(href)));
}

/** Copies a text, and says so on the button. */
export async function copied(
  button: HTMLElement,
  text: string,
  said = t('copied'),
): Promise<void> {
  await navigator.clipboard.writeText(text);
  const before = button.textContent;
  button.textContent = `✓ ${said}`;
  setTimeout(() => {
    button.textContent = before;
  }, 1500);
}
