/** The solver in a worker: answers one message after the other. */
import init, {
  Answer,
  Case,
  Files,
  catalogue,
  provide_table,
  watch,
} from '../../pkg/schlupf_wasm.js';
import type {
  Answered,
  CaseInput,
  Described,
  Fields,
  Grid,
  Kind,
  Message,
  NamedText,
  Outlines,
  Problem,
  Reply,
  Requests,
  Tables,
  Told,
} from './protocol';

/** What solutions are kept as. */
const SOLUTION = 'solution';

let files!: Files;
/** Where the standard table is, until the module has it. */
let table: string | null = null;
/**
 * The case that was solved last keeps its set-up for the next; the same wheel for while it moves,
 * null for a case that has none.
 */
let kept: { key: string; solved: Case; quick?: Case | null } | null = null;
/** The last answer of each kind, of which files may be wanted. */
const last = new Map<string, Answer>();

/** Time between two messages of progress, in ms. */
const INTERVAL = 100;
/** The message that is acted on, and when its progress was told last. */
let [acting, lastTold] = [0, 0];

/** Tells how far a computation has got: the page cannot ask while it goes on. */
function tellProgress(counted: string, done: number, total?: number, change?: number): void {
  if (performance.now() - lastTold < INTERVAL) return;
  lastTold = performance.now();
  const progress = { counted, done, total: total ?? null, change: change ?? null };
  self.postMessage({ id: acting, progress } satisfies Reply);
}

/** The case; one that lacks the standard table gets it. */
async function opened(input: CaseInput): Promise<Case> {
  const open = () => new Case(input.text, input.name, input.assignments, files);
  try {
    return open();
  } catch (error) {
    const lacksTable = problemsOf(error).some(({ field }) => field === 'solver.method');
    const response = table && lacksTable ? await fetch(table).catch(() => null) : null;
    if (!response?.ok) throw error;
    provide_table(new Uint8Array(await response.arrayBuffer()));
    table = null;
    return open();
  }
}

async function described(input: CaseInput): Promise<Described> {
  const opening = await opened(input);
  try {
    return {
      toml: opening.toml(),
      fields: JSON.parse(opening.fields()) as Fields,
      outlines: JSON.parse(opening.outlines()) as Outlines | null,
    };
  } finally {
    opening.free();
  }
}

function answered(of: string, answer: Answer, wantsFigures: boolean): Answered {
  last.get(of)?.free();
  last.set(of, answer);
  return {
    tables: answer.tables() as Tables,
    grids: JSON.parse(answer.grids()) as Grid[],
    told: JSON.parse(answer.told()) as Told,
    figures: wantsFigures ? (answer.figures() as NamedText[]) : [],
    isQuick: false,
  };
}

async function solved({
  input,
  paths,
  values,
  isMoving,
}: Requests['solve']['ask']): Promise<Answered> {
  const key = JSON.stringify(input);
  if (kept?.key !== key) {
    forget();
    kept = { key, solved: await opened(input) };
  }
  if (isMoving) kept.quick ??= kept.solved.quick() ?? null;
  const quick = isMoving ? kept.quick : null;
  const answer = (quick ?? kept.solved).solve(paths, Float64Array.from(values));
  return { ...answered(SOLUTION, answer, false), isQuick: Boolean(quick) };
}

function forget(): void {
  kept?.solved.free();
  kept?.quick?.free();
  kept = null;
}

async function played({ input, every }: Requests['play']['ask']): Promise<Answered> {
  const opening = await opened(input);
  try {
    return answered(SOLUTION, opening.play(every), false);
  } finally {
    opening.free();
  }
}

async function done({
  input,
  task,
  request,
  wantsFigures,
}: Requests['task']['ask']): Promise<Answered> {
  const opening = await opened(input);
  try {
    const of = 'over' in request ? `${task} over` : task;
    return answered(of, opening.ask(task, JSON.stringify(request), wantsFigures), wantsFigures);
  } finally {
    opening.free();
  }
}

function filesOf({ of, what }: Requests['files']['ask']): NamedText[] {
  const answer = last.get(of);
  if (!answer) return [];
  if (what === 'figures') return answer.figures() as NamedText[];
  const text = what === 'csv' ? answer.csv() : answer.json();
  return text === undefined ? [] : [[what, text]];
}

async function act(message: Message): Promise<Requests[Kind]['answer']> {
  switch (message.kind) {
    case 'start':
      await init({ module_or_path: message.ask.module });
      watch(tellProgress);
      files = new Files();
      table = message.ask.table;
      return { catalogue: catalogue() };
    case 'inputs':
      forget();
      files = new Files();
      for (const [name, bytes] of message.ask.files) files.set(name, bytes);
      return {};
    case 'describe':
      return described(message.ask.input);
    case 'solve':
      return solved(message.ask);
    case 'play':
      return played(message.ask);
    case 'task':
      return done(message.ask);
    case 'files':
      return { files: filesOf(message.ask) };
  }
}

/** The buffers of the numbers in tables, which move to the page without a copy. */
function buffers(answer: Requests[Kind]['answer']): ArrayBuffer[] {
  if (!('tables' in answer)) return [];
  const columns = Object.values(answer.tables)
    .flat()
    .flatMap((table) => Object.values(table));
  return columns.flatMap(({ values }) =>
    values instanceof Float64Array && values.buffer instanceof ArrayBuffer ? [values.buffer] : [],
  );
}

function problemsOf(error: unknown): Problem[] {
  const told = String(error);
  try {
    return JSON.parse(told) as Problem[];
  } catch {
    return [{ field: '', message: told, place: 'schlupf', help: null }];
  }
}

self.onmessage = async ({ data }: MessageEvent<Message>) => {
  const reply: Reply = { id: data.id };
  acting = data.id;
  try {
    reply.answer = await act(data);
    self.postMessage(reply, { transfer: buffers(reply.answer) });
  } catch (error) {
    self.postMessage({ id: data.id, problems: problemsOf(error) } satisfies Reply);
    // After a trap the module's memory cannot be trusted: the page starts another worker.
    if (typeof error !== 'string') self.close();
  }
};
