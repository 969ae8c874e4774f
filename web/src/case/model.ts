/** The case of the page: a TOML text, files and assignments of fields. */
import { tomlOf, type Field } from '../catalogue';
import type { CaseInput, FileBytes } from '../solver/protocol';

/** A value given to a field: as in a case file, and as SI number where a slider may move it. */
export interface Assignment {
  toml: string;
  si: number | null;
}

/** A case without assignments: its text, the files that it may name. */
export interface Source {
  name: string;
  text: string;
  files: Map<string, Uint8Array>;
  /** Name in the gallery, as long as the text is from there. */
  gallery: string | null;
}

/** What kind of change was made. */
export type Change = 'opened' | 'assigned' | 'moved';

/** A case with listeners to its changes. */
export class CaseModel implements Source {
  name = 'case.toml';
  text = '';
  gallery: string | null = null;
  files = new Map<string, Uint8Array>();
  readonly assignments = new Map<string, Assignment>();
  private readonly listeners: ((change: Change) => void)[] = [];

  /** Assignments of what is no field are dropped. */
  constructor(private readonly isField: (path: string) => boolean) {}

  /** Calls back after each change. */
  listen(listener: (change: Change) => void): void {
    this.listeners.push(listener);
  }

  /** Another case with its assignments, in one change. */
  open({ name, text, files, gallery }: Source, assignments: [string, Assignment][] = []): void {
    Object.assign(this, { name, text, files, gallery });
    this.assignments.clear();
    this.put(assignments);
    this.tell('opened');
  }

  /** Gives several fields values as in a case file. */
  assign(values: [string, string][]): void {
    this.put(values.map(([path, toml]) => [path, { toml, si: null }]));
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

  /** What results depend on: the case but for some fields. */
  key(without: string[]): string {
    const others = [...this.assignments].filter(([path]) => !without.includes(path));
    return JSON.stringify([this.text, others.map(([path, { toml }]) => [path, toml])]);
  }

  /** The files, for a worker. */
  fileBytes(): FileBytes {
    return [...this.files];
  }

  private put(assignments: [string, Assignment][]): void {
    for (const [path, assignment] of assignments) {
      if (this.isField(path)) this.assignments.set(path, assignment);
    }
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
