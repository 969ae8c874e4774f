/** The head of the page: choice of the case, and what can be done with it. */
import { titles } from './case/gallery';
import { openFiles } from './case/open';
import { restore } from './case/share';
import type { Shown } from './case/commands';
import { h } from './dom';
import type { Explorer } from './explorer';
import { copied, editCase, showSame } from './report/dialogs';
import { saveCase, savePicture, saveResult } from './report/save';
import { currentLanguage, LANGUAGES, t } from './texts';
import { toggleTheme } from './theme';

/** Title, gallery, files, links, languages. */
export class Head {
  readonly element: HTMLElement;
  private readonly gallery: HTMLSelectElement;
  private readonly group = h('optgroup', { label: t('gallery') });
  private readonly own = h('option', { value: '' }, t('own_case'));

  constructor(
    private readonly explorer: Explorer,
    shownTask: () => Shown,
    view: () => HTMLElement,
    link: () => Promise<string>,
    leftOut: () => string[],
  ) {
    const { model } = explorer;
    this.gallery = h(
      'select',
      {
        'aria-label': t('case'),
        id: 'gallery',
        onchange: () => void restore(model, `#case=${this.gallery.value}`),
      },
      this.own,
      this.group,
    );
    void this.fill();
    const file = h('input', {
      type: 'file',
      multiple: true,
      hidden: true,
      onchange: () => {
        void openFiles(model, file.files ?? []).then(() => {
          file.value = '';
        });
      },
    });
    const share = h(
      'button',
      {
        type: 'button',
        id: 'share',
        onclick: () => {
          const left = leftOut().join(', ');
          const said = left ? `${t('not_in_link')} ${left}` : t('copied');
          void link().then((url) => copied(share, url, said));
        },
      },
      t('share'),
    );
    this.element = h(
      'header',
      { class: 'top' },
      h('h1', {}, 'schlupf ', h('span', {}, t('subtitle'))),
      this.gallery,
      this.button(t('open'), () => file.click()),
      file,
      this.button(t('edit'), () => editCase(model, explorer.described?.toml ?? model.text)),
      share,
      this.saveMenu(view, shownTask),
      this.button('>_', () => showSame(model, shownTask()), t('same')),
      h('span', { class: 'gap' }),
      this.languages(),
      this.button('◐', toggleTheme, t('theme')),
    );
  }

  /** Shows which case it is. */
  show(): void {
    const { gallery } = this.explorer.model;
    this.gallery.value = gallery ?? '';
    const title = this.explorer.described?.fields.values['title'];
    if (typeof title === 'string') document.title = `${title} – schlupf`;
    this.own.hidden = gallery !== null;
    this.own.textContent = gallery === null ? this.explorer.model.name : t('own_case');
  }

  private async fill(): Promise<void> {
    const option = ([name, title]: [string, string]) =>
      h('option', { value: name, title: name }, title);
    this.group.replaceChildren(...(await titles()).map(option));
    this.show();
  }

  private button(text: string, act: () => void, title = ''): HTMLButtonElement {
    return h(
      'button',
      { type: 'button', onclick: act, ...(title ? { title, 'aria-label': title } : {}) },
      text,
    );
  }

  private saveMenu(view: () => HTMLElement, shownTask: () => Shown): HTMLElement {
    const { explorer } = this;
    const acts: [string, () => void][] = [
      [t('save_toml'), () => saveCase(explorer)],
      [t('save_csv'), () => void saveResult(explorer, shownTask().task, 'csv')],
      [t('save_json'), () => void saveResult(explorer, shownTask().task, 'json')],
      [t('save_svg'), () => void saveResult(explorer, shownTask().task, 'figures')],
      [t('save_png'), () => savePicture(explorer, view())],
    ];
    const menu = h(
      'details',
      { class: 'menu' },
      h('summary', {}, t('save')),
      h(
        'div',
        {},
        ...acts.map(([label, act]) =>
          this.button(label, () => {
            menu.open = false;
            act();
          }),
        ),
      ),
    );
    menu.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') menu.open = false;
    });
    document.addEventListener('click', (event) => {
      if (event.target instanceof Node && !menu.contains(event.target)) menu.open = false;
    });
    return menu;
  }

  private languages(): HTMLElement {
    const choice = h(
      'select',
      {
        'aria-label': t('language'),
        onchange: () => {
          localStorage.setItem('language', choice.value);
          location.reload();
        },
      },
      ...Object.entries(LANGUAGES).map(([name, label]) =>
        h('option', { value: name, lang: name }, label),
      ),
    );
    choice.value = currentLanguage();
    return choice;
  }
}
