/** The case of the page: a TOML text, files and assignments of fields. */
import { tomlOf, type Field } from '../catalogue';
import type { CaseInput, FileBytes } from '../solver/protocol';

/** A value given to a field: as in a case file, and as SI number where a slider may move it. */
export interface Assignment {
  toml: string;
  si: number | null;
}

/** What kind of change was made. */
export type Change = 'opened' | 'assigned' | 'moved';

/** A case with listeners to its changes. */
export class CaseModel {
  name = 'case.toml';
  text = '';
  /** Name in the gallery, as long as the text is from there. */
  gallery: string | null = null;
  files = new Map<string, Uint8Array>();
  readonly assignments = new Map<string, Assignment>();
  private readonly listeners: ((change: Change) => void)[] = [];

  /** Calls back after each change. */
  listen(listener: (change: Change) => void): void {
    this.listeners.push(listener);
  }

  /** Another case, without assignments. */
  open(name: string, text: string, files: Map<string, Uint8Array>, gallery: string | null): void {
    this.name = name;
    this.text = text;
    this.files = files;
    this.gallery = gallery;
    this.assignments.clear();
    this.tell('opened');
  }

  /** Another case with its assignments: paths, values as in a case file, SI values. */
  restore(
    name: string,
    text: string,
    files: Map<string, Uint8Array>,
    gallery: string | null,
    assignments: [string, string, number | null][],
  ): void {
    Object.assign(this, { name, text, files, gallery });
    this.assignments.clear();
    for (const [path, toml, si] of assignments) this.assignments.set(path, { toml, si });
    this.tell('opened');
  }

  /** Adds a file that fields may name. */
  addFile(name: string, bytes: Uint8Array): void {
    this.files = new Map(this.files).set(name, bytes);
    this.tell('opened');
  }

  /** Gives several fields values as in a case file. */
  assign(values: [string, string][]): void {
    for (const [path, toml] of values) this.assignments.set(path, { toml, si: null });
    this.tell('assigned');
  }

  /** Moves a number, in SI. */
  move(field: Field, si: number): void {
    this.assignments.set(field.path, { toml: tomlOf(field, si), si });
    this.tell('moved');
  }

  /** Takes assignments back. */
  reset(paths: string[]): void {
    for (const path of paths) this.assignments.delete(path);
    this.tell('assigned');
  }

  /** The case with all assignments. */
  whole(): CaseInput {
    return this.input(() => true);
  }

  /** The case with all assignments but numbers that move. */
  fixed(): CaseInput {
    return this.input(({ si }) => si === null);
  }

  /** Numbers that move: their paths and SI values. */
  moving(): { paths: string[]; values: number[] } {
    const moving = [...this.assignments].filter(([, { si }]) => si !== null);
    const value = ({ toml, si }: Assignment) => (toml === '"inf"' ? Infinity : (si ?? NaN));
    return { paths: moving.map(([path]) => path), values: moving.map(([, a]) => value(a)) };
  }

  /** The files, for a worker. */
  fileBytes(): FileBytes {
    return [...this.files];
  }

  private input(isWanted: (assignment: Assignment) => boolean): CaseInput {
    const wanted = [...this.assignments].filter(([, assignment]) => isWanted(assignment));
    const assignments = wanted.map(([path, { toml }]) => `${path}=${toml}`);
    return { name: this.name, text: this.text, assignments };
  }

  private tell(change: Change): void {
    for (const listener of this.listeners) listener(change);
  }
}
