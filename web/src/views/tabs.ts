/** Views of which one is seen. */
import { h } from '../dom';
import { t } from '../texts';

/** A view with its label. */
export interface Tab {
  name: string;
  label: string;
  children: HTMLElement[];
}

/** A list of tabs and the panel of the chosen one. */
export class Tabs {
  readonly list = h('div', { class: 'tabs', role: 'tablist', 'aria-label': t('views') });
  readonly body = h('div', { class: 'view' });
  /** The name of the view that is seen. */
  chosen = '';
  private readonly tabs: { name: string; button: HTMLButtonElement; panel: HTMLElement }[];

  constructor(
    tabs: Tab[],
    private readonly onChoice: (name: string) => void,
  ) {
    this.tabs = tabs.map(({ name, label, children }) => {
      const button = h(
        'button',
        {
          type: 'button',
          role: 'tab',
          id: `tab-${name}`,
          'aria-controls': `panel-${name}`,
          onclick: () => this.choose(name),
        },
        label,
      );
      const panel = h(
        'div',
        { role: 'tabpanel', id: `panel-${name}`, 'aria-labelledby': `tab-${name}` },
        ...children,
      );
      return { name, button, panel };
    });
    this.list.append(...this.tabs.map(({ button }) => button));
    this.body.append(...this.tabs.map(({ panel }) => panel));
    this.list.addEventListener('keydown', (event) => this.step(event));
  }

  /** The panel that is seen. */
  get panel(): HTMLElement {
    return this.tabs.find(({ name }) => name === this.chosen)?.panel ?? this.body;
  }

  /** Shows a view. */
  choose(wanted: string): void {
    const isKnown = this.tabs.some(({ name }) => name === wanted);
    this.chosen = isKnown ? wanted : (this.tabs[0]?.name ?? '');
    for (const { name, button, panel } of this.tabs) {
      const isChosen = name === this.chosen;
      button.setAttribute('aria-selected', String(isChosen));
      button.tabIndex = isChosen ? 0 : -1;
      panel.hidden = !isChosen;
    }
    this.onChoice(this.chosen);
  }

  private step(event: KeyboardEvent): void {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    const at = this.tabs.findIndex(({ name }) => name === this.chosen);
    const next = this.tabs[(at + step + this.tabs.length) % this.tabs.length];
    if (!next) return;
    this.choose(next.name);
    next.button.focus();
  }
}
