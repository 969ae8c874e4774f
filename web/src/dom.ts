/** What an element may be given: attributes, properties that start with a dot, listeners. */
export type Attributes = Record<string, string | number | boolean | null | EventListener>;

/** Makes an element with attributes, listeners (`onclick`) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name.slice(2), value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== null) element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

/** The element of the page with an identifier, which must be there. */
export function byId(id: string): HTMLElement {
  const element = document.getElementById(id);
  if (!element) throw new Error(`no element #${id}`);
  return element;
}

/** Calls a function once, some time after the last call. */
export function debounced(milliseconds: number, act: () => void): () => void {
  let timer = 0;
  return () => {
    clearTimeout(timer);
    timer = window.setTimeout(act, milliseconds);
  };
}

/** Calls a function at most once per frame. */
export function perFrame(act: () => void): () => void {
  let isAsked = false;
  return () => {
    if (isAsked) return;
    isAsked = true;
    requestAnimationFrame(() => {
      isAsked = false;
      act();
    });
  };
}

/** A label with its control, which stay together. */
export function labelledControl(label: string, control: HTMLElement): HTMLElement {
  return h('label', {}, `${label} `, control);
}

/** Follows a pointer from its press on an element until it is let go. */
export function dragged(
  element: HTMLElement,
  { pointerId }: PointerEvent,
  moved: (event: PointerEvent) => void,
  released: () => void = () => {},
): void {
  element.setPointerCapture(pointerId);
  element.addEventListener('pointermove', moved);
  const ended = () => {
    element.removeEventListener('pointermove', moved);
    released();
  };
  element.addEventListener('lostpointercapture', ended, { once: true });
}
