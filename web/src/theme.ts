/** Light or dark: that of the system until a person chooses. */

const system = matchMedia('(prefers-color-scheme: dark)');
const listeners: (() => void)[] = [];

/** Calls back when the theme changes. */
export function onTheme(listener: () => void): void {
  listeners.push(listener);
}

/** Sets the theme of the page and follows the system. */
export function startTheme(): void {
  const show = () => {
    const isDark =
      (localStorage.getItem('theme') ?? (system.matches ? 'dark' : 'light')) === 'dark';
    document.documentElement.dataset['theme'] = isDark ? 'dark' : 'light';
    for (const listener of listeners) listener();
  };
  system.addEventListener('change', show);
  show();
  onToggle = show;
}

let onToggle = (): void => {};

/** Changes between light and dark. */
export function toggleTheme(): void {
  const isDark = document.documentElement.dataset['theme'] === 'dark';
  localStorage.setItem('theme', isDark ? 'light' : 'dark');
  onToggle();
}

/** A colour of the theme, by the name of its property. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
