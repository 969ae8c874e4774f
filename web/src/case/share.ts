/** A case in the URL's hash: deflated and in base64url. */
import { filesNamedIn, galleryCase, isOfGallery } from './gallery';
import type { CaseModel } from './model';

interface Shared {
  name: string;
  text: string;
  gallery: string | null;
  assignments: [string, string, number | null][];
  files: [string, string][];
}

/** The hash of a case: the name of one of the gallery, or the whole case. */
export async function hashOf(model: CaseModel, view: string): Promise<string> {
  if (model.gallery && model.assignments.size === 0) return `#case=${model.gallery}&view=${view}`;
  const own = [...model.files].filter(([name]) => !isOfGallery(name));
  const shared: Shared = {
    name: model.name,
    text: model.gallery ? '' : model.text,
    gallery: model.gallery,
    assignments: [...model.assignments].map(([path, { toml, si }]) => [path, toml, si]),
    files: own.map(([name, bytes]) => [name, base64(bytes)]),
  };
  const bytes = new TextEncoder().encode(JSON.stringify(shared));
  const packed = await through(bytes, new CompressionStream('deflate-raw'));
  return `#state=${base64(packed)}&view=${view}`;
}

/** The view that a hash names. */
export function viewOf(hash: string): string | null {
  return new URLSearchParams(hash.slice(1)).get('view');
}

/** Puts the case of a hash into the model; false if there is none. */
export async function restore(model: CaseModel, hash: string): Promise<boolean> {
  const parts = new URLSearchParams(hash.slice(1));
  const name = parts.get('case');
  const state = parts.get('state');
  if (name) {
    const found = await galleryCase(name);
    if (found) model.open(`${name}.toml`, found.text, found.files, name);
    return found !== null;
  }
  const toml = parts.get('toml');
  if (toml !== null) model.open('case.toml', toml, await filesNamedIn(toml), null);
  if (!state) return toml !== null;
  const bytes = await through(bytesOf(state), new DecompressionStream('deflate-raw'));
  const shared = JSON.parse(new TextDecoder().decode(bytes)) as Shared;
  const found = shared.gallery ? await galleryCase(shared.gallery) : null;
  const text = found?.text ?? shared.text;
  const named = [text, ...shared.assignments.map(([, toml]) => toml)].join('\n');
  const files = await filesNamedIn(named);
  for (const [file, encoded] of shared.files) files.set(file, bytesOf(encoded));
  model.restore(shared.name, text, files, found ? shared.gallery : null, shared.assignments);
  return true;
}

async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const result = new Response(new Blob([bytes]).stream().pipeThrough(stream));
  return new Uint8Array(await result.arrayBuffer());
}

function base64(bytes: Uint8Array): string {
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(letters).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

function bytesOf(text: string): Uint8Array<ArrayBuffer> {
  const letters = atob(text.replace(/-/g, '+').replace(/_/g, '/'));
  return Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
}
