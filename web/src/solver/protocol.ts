/** A column of a table: SI values with symbol, unit, description and defining equation. */
export interface Column {
  values: Float64Array | string[];
  /** The name of its quantity. */
  quantity: string;
  symbol: string;
  units: string;
  long_name: string;
  definition: string;
}

/** Columns by name. */
export type Table = Record<string, Column>;

/** Tables by name, each an array of tables. */
export type Tables = Record<string, Table[]>;

/** Where the cells of a table of fields lie, in m; `time` (s) of a frame. */
export interface Grid {
  columns: number;
  rows: number;
  spacing: [number, number];
  origin: [number, number];
  /** Centre of the patch, beside the place of its contact. */
  centre: [number, number];
  cells: [number, number][];
  time: number | null;
}

/** What is wrong with a case, and where. */
export interface Problem {
  field: string;
  message: string;
  place: string;
  help: string | null;
}

/** A warning with its code. */
export interface Warning {
  code: string;
  text: string;
}

/** What the program tells about an answer. */
export interface Told {
  status: string;
  summary: (string | [string, string, string, string])[];
  warnings: Warning[];
}

/** A value of a field: SI numbers; null where it is infinite. */
export type FieldValue = number | string | boolean | null | (number | null)[];

/** Fields of a case: values in effect, those that are given, those that have an effect. */
export interface Fields {
  values: Record<string, FieldValue>;
  given: string[];
  effective: string[];
}

/** A line in the plane across the track, in m. */
export interface Line {
  y: number[];
  z: number[];
}

/** Both profiles in the track. */
export interface Outlines {
  outwards: number;
  /** Nominal rolling radius. */
  radius: number;
  rail: Line;
  wheel: Line;
}

/** A case as it is read. */
export interface CaseInput {
  name: string;
  text: string;
  assignments: string[];
}

/** Files that cases may name. */
export type FileBytes = [string, Uint8Array][];

/** A case with its fields, as the module has read it. */
export interface Described {
  toml: string;
  fields: Fields;
  outlines: Outlines | null;
}

/** An answer of the module, with what was wanted of it. */
export interface Answered {
  tables: Tables;
  grids: Grid[];
  told: Told;
  figures: [string, string][];
  /** Whether it is that of the quick methods for a wheel that moves. */
  isQuick: boolean;
}

/** What a worker is asked. */
export interface Requests {
  start: { ask: { module: WebAssembly.Module; table: string }; answer: { catalogue: string } };
  inputs: { ask: { files: FileBytes }; answer: Record<string, never> };
  describe: { ask: { input: CaseInput }; answer: Described };
  solve: {
    ask: { input: CaseInput; paths: string[]; values: number[]; isMoving: boolean };
    answer: Answered;
  };
  play: { ask: { input: CaseInput; every: number }; answer: Answered };
  task: {
    ask: {
      input: CaseInput;
      task: string;
      request: Record<string, unknown>;
      wantsFigures: boolean;
    };
    answer: Answered;
  };
  /** Files of the last answer to a topic: `solution`, or a task. */
  files: { ask: { of: string; what: 'csv' | 'json' | 'figures' }; answer: { files: NamedText[] } };
}

/** A file of text. */
export type NamedText = [string, string];

/** Names of requests. */
export type Kind = keyof Requests;

/** A message to a worker. */
export type Message = {
  [K in Kind]: { id: number; kind: K; ask: Requests[K]['ask'] };
}[Kind];

/** How far a computation has got. */
export interface Progress {
  /** What is counted. */
  counted: string;
  done: number;
  total: number | null;
  /** The residual, which decreases. */
  change: number | null;
}

/** A message from a worker: progress, then the answer. */
export interface Reply {
  id: number;
  progress?: Progress;
  answer?: Requests[Kind]['answer'];
  problems?: Problem[];
}
