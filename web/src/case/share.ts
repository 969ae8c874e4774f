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

/** Where `schlupf explore` has its case, with its files in Base64. */
const SERVED = 'case.json';

interface Served {
  name: string;
  text: string;
  files: Record<string, string>;
}

/** Larger files are left out of links, in bytes. */
const LARGEST = 200e3;

/** Files of a person's that are too large for a link. */
export function leftOut(model: CaseModel): string[] {
  return ownFiles(model).flatMap(([name, { length }]) => (length > LARGEST ? [name] : []));
}

function ownFiles(model: CaseModel): [string, Uint8Array][] {
  return [...model.files].filter(([, bytes]) => !isOfGallery(bytes));
}

/** The hash of a case: the name of one of the gallery, or the whole case. */
export async function hashOf(model: CaseModel, view: string): Promise<string> {
  const own = ownFiles(model).filter(([, { length }]) => length <= LARGEST);
  if (model.gallery && model.assignments.size === 0 && own.length === 0) {
    return `#case=${model.gallery}&view=${view}`;
  }
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

/** Whether a hash names a case, be it damaged. */
export function namesCase(hash: string): boolean {
  const parts = new URLSearchParams(hash.slice(1));
  return ['case', 'state', 'open'].some((name) => parts.has(name));
}

/** Puts the case of a hash into the model; false if there is none that can be read. */
export async function restore(model: CaseModel, hash: string): Promise<boolean> {
  const parts = new URLSearchParams(hash.slice(1));
  const [name, state] = [parts.get('case'), parts.get('state')];
  try {
    if (name) {
      const found = await galleryCase(name);
      if (found) model.open(found);
      return found !== null;
    }
    if (parts.get('open') === SERVED) await openServed(model);
    else if (state) await openShared(model, state);
    else return false;
    return true;
  } catch {
    return false;
  }
}

/** Opens the case that `schlupf explore` was given. */
async function openServed(model: CaseModel): Promise<void> {
  const { name, text, files } = (await (await fetch(SERVED)).json()) as Served;
  const bytes = Object.entries(files).map(([file, encoded]) => [file, bytesOf(encoded)] as const);
  model.open({ name, text, files: new Map(bytes), gallery: null });
}

async function openShared(model: CaseModel, state: string): Promise<void> {
  const bytes = await through(bytesOf(state), new DecompressionStream('deflate-raw'));
  const shared = JSON.parse(new TextDecoder().decode(bytes)) as unknown;
  if (!isShared(shared)) throw new Error('no case');
  const { name, gallery, assignments } = shared;
  const found = gallery === null ? null : await galleryCase(gallery);
  if (gallery !== null && !found) throw new Error(`no case ${gallery}`);
  const text = found?.text ?? shared.text;
  const files = await filesNamedIn([text, ...assignments.map(([, toml]) => toml)].join('\n'));
  for (const [file, encoded] of shared.files) files.set(file, bytesOf(encoded));
  model.open(
    { name, text, files, gallery },
    assignments.map(([path, toml, si]) => [path, { toml, si }]),
  );
}

function isShared(value: unknown): value is Shared {
  if (typeof value !== 'object' || value === null) return false;
  const { name, text, gallery, assignments, files } = value as Record<keyof Shared, unknown>;
  const isText = (one: unknown) => typeof one === 'string';
  const areRows = (rows: unknown, ...kinds: ((one: unknown) => boolean)[]) =>
    Array.isArray(rows) &&
    rows.every(
      (row: unknown) => Array.isArray(row) && kinds.every((isKind, at) => isKind(row[at])),
    );
  return (
    [name, text].every(isText) &&
    (gallery === null || isText(gallery)) &&
    areRows(assignments, isText, isText, (si) => si === null || typeof si === 'number') &&
    areRows(files, isText, isText)
  );
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
