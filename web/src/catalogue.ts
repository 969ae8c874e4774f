/** Sections and fields of a case, tasks and presets, as the module lists them. */
import { numberTyped } from './quantity';
import type { FieldValue } from './solver/protocol';

/** A field of a case. */
export interface Field {
  path: string;
  name: string;
  doc: string;
  definition: string;
  kind: string;
  units: string;
  requirement: string;
  bounds: [number | null, number | null];
  usual: [number | null, number | null] | null;
  default: string | null;
  given_in: [string, number] | null;
  is_optional: boolean;
  choices: [string, string][];
  columns: [string, string][][];
}

/** A section of a case. */
export interface Section {
  name: string;
  doc: string;
  fields: Field[];
}

/** A field of a request. */
export interface RequestField {
  name: string;
  doc: string;
  kind: string;
  units: string;
  bounds: [number | null, number | null];
}

/** What a case can be asked. */
export interface Task {
  name: string;
  about: string;
  fields: RequestField[];
}

/** Values of fields that go together. */
export interface Preset {
  group: string;
  name: string;
  doc: string;
  source: string;
  section: string;
  fields: [string, string][];
}

interface Contents {
  version: string;
  sections: Section[];
  tasks: Task[];
  presets: Preset[];
}

/** The catalogue with its fields by path. */
export class Catalogue {
  readonly version: string;
  readonly sections: Section[];
  readonly tasks: Task[];
  readonly presets: Preset[];
  private readonly fields: Map<string, Field>;

  constructor(json: string) {
    const contents = JSON.parse(json) as Contents;
    this.version = contents.version;
    this.sections = contents.sections;
    this.tasks = contents.tasks;
    this.presets = contents.presets;
    const fields = contents.sections.flatMap((section) => section.fields);
    this.fields = new Map(fields.map((field) => [field.path, field]));
  }

  /** The field of a path. */
  field(path: string): Field | undefined {
    return this.fields.get(path);
  }

  /** The task of a name. */
  task(name: string): Task | undefined {
    return this.tasks.find((task) => task.name === name);
  }
}

/** Whether a field is a number that a slider may move. */
export function isNumeric(field: Field): boolean {
  return ['quantity', 'number', 'count', 'number-or-choice'].includes(field.kind);
}

/** The unit in which a field is shown, and its factor to SI. */
export function shownUnit(field: Field): [string, number] {
  return field.given_in ?? [field.units, 1];
}

/** A number of a field as it stands in a case file, from SI. */
export function tomlOf(field: Field, si: number): string {
  const [unit, factor] = shownUnit(field);
  const number = Number((si / factor).toPrecision(12));
  if (field.kind !== 'quantity') return String(number);
  return Number.isFinite(number) ? JSON.stringify(`${number} ${unit}`.trim()) : '"inf"';
}

/** A value as it stands in a case file, in SI where it has the unit shown; null if unknown. */
export function siOf(field: Field, toml: string): FieldValue {
  try {
    const value = JSON.parse(toml) as FieldValue;
    const [unit, factor] = shownUnit(field);
    if (typeof value !== 'string' || field.kind !== 'quantity') return value;
    const number = Number(value.replace(unit, ''));
    return value.endsWith(unit) && Number.isFinite(number) ? number * factor : value;
  } catch {
    return null;
  }
}

/** What a person typed as it stands in a case file: a bare number takes the unit shown. */
export function tomlOfTyped(field: Field, typed: string): string {
  const text = typed.trim().replace(/−/g, '-');
  const number = numberTyped(text);
  if (isNumeric(field) && !Number.isNaN(number)) {
    if (field.kind === 'quantity') return JSON.stringify(`${number} ${shownUnit(field)[0]}`.trim());
    return String(number);
  }
  if (field.kind === 'flag') return text;
  if (field.kind === 'numbers' || field.kind === 'quantities') return text;
  return JSON.stringify(text);
}
