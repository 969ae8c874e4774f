/** Symbols with their indices set low. */
import { h } from './dom';

/** A symbol such as `F_x` as an element. */
export function symbolOf(symbol: string): HTMLElement {
  const parts = symbol
    .split(/_(\w+)/)
    .map((part, index) => (index % 2 ? h('sub', {}, part) : part));
  return h('i', {}, ...parts);
}
