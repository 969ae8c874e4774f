/** The cases of the gallery and the files that they name. */
import type { Source } from './model';

const places = import.meta.glob<string>('../../../cases/*.{csv,npy,slcs,slcw}', {
  query: '?url',
  import: 'default',
  eager: true,
});

const base = (path: string): string => path.slice(path.lastIndexOf('/') + 1);

/** Names and titles of the cases. */
export async function titles(): Promise<[string, string][]> {
  const { TEXTS } = await import('./gallery_texts');
  return [...TEXTS].map(([name, text]) => [name, titleOf(text) ?? name]);
}

/** The case that a new page shows. */
export const FIRST_CASE = 'steel_wheel_driving';

/** Names of files of the gallery. */
const FILE_URLS = new Map(Object.entries(places).map(([path, url]) => [base(path), url]));

/** Files that were taken from the gallery. */
const taken = new WeakSet<Uint8Array>();

/** Whether a file was taken from the gallery. */
export function isOfGallery(bytes: Uint8Array): boolean {
  return taken.has(bytes);
}

/** A case by its name. */
export async function galleryCase(name: string): Promise<Source | null> {
  const { TEXTS } = await import('./gallery_texts');
  const text = TEXTS.get(name);
  if (text === undefined) return null;
  return { name: `${name}.toml`, text, files: await filesNamedIn(text), gallery: name };
}

/** Files of the gallery that a text names, and those that they name. */
export async function filesNamedIn(
  text: string,
  found = new Map<string, Uint8Array>(),
): Promise<Map<string, Uint8Array>> {
  const lines = text.replace(/^\s*#.*$/gm, '');
  const isNamed = (name: string) => lines.includes(`"${name}"`) || lines.includes(`'${name}'`);
  for (const [name, url] of FILE_URLS) {
    if (found.has(name) || !isNamed(name)) continue;
    const bytes = new Uint8Array(await (await fetch(url)).arrayBuffer());
    taken.add(bytes);
    found.set(name, bytes);
    if (/\.slc[sw]$/.test(name)) await filesNamedIn(new TextDecoder().decode(bytes), found);
  }
  return found;
}

/** The title that a text gives itself. */
function titleOf(text: string): string | null {
  return /^title\s*=\s*"([^"]*)"/m.exec(text)?.[1] ?? null;
}
