/** Solves the case whenever it changes, and tells who shows it. */
import type { CaseModel, Change } from './case/model';
import { debounced } from './dom';
import { CaseProblems, type Lane } from './solver/lane';
import type { Answered, Described, Fields, Problem, Progress } from './solver/protocol';

/** A solution with the case that it belongs to. */
export interface Result {
  answered: Answered;
  /** Values of its fields, those that move as they were when it was asked for. */
  values: Fields['values'];
  milliseconds: number;
  isTransient: boolean;
}

/** Who is told what happens. */
export interface Audience {
  described(described: Described): void;
  solving(): void;
  progress(progress: Progress): void;
  cancelled(): void;
  solved(result: Result): void;
  failed(problems: Problem[]): void;
}

/** Steps of a transient between two frames. */
const EVERY = 2;
/** Time that a solution is left to end by itself while a field moves, in ms. */
const PATIENCE = 2000;

/** The loop from the case to its solution. */
export class Explorer {
  /** The case as it was read last. */
  described: Described | null = null;
  /** The last solution. */
  result: Result | null = null;
  private readonly describeLater = debounced(250, () => void this.describe());
  private readonly settleLater = debounced(150, () => void this.solve());
  private readonly playLater = debounced(200, () => void this.solve());
  private count = 0;
  /** Counts cases: answers of another one are stale. */
  private opened = 0;

  constructor(
    readonly model: CaseModel,
    readonly contact: Lane,
    readonly long: Lane,
    private readonly audience: Audience,
  ) {
    model.listen((change) => void this.changed(change));
  }

  private async changed(change: Change): Promise<void> {
    this.count += 1;
    // What is asked next, be it only whether the case is right, waits for what runs.
    this.contact.cancel('solve', change === 'moved' ? PATIENCE : 0);
    this.long.cancel('play');
    if (change === 'opened') {
      this.opened += 1;
      [this.described, this.result] = [null, null];
      const files = this.model.fileBytes();
      this.contact.setFiles(files);
      this.long.setFiles(files);
    }
    if (change === 'moved') {
      this.describeLater();
      if (this.isTransient()) this.playLater();
      else if (await this.solve(true)) this.settleLater();
      return;
    }
    if (await this.describe()) await this.solve();
  }

  /** Whether the case rolls over time. */
  isTransient(): boolean {
    const given = this.described?.fields.given ?? [];
    return given.includes('history.time') || given.includes('history.file');
  }

  private async describe(): Promise<boolean> {
    const described = await this.tried(
      this.contact.ask('describe', 'describe', { input: this.model.whole() }),
    );
    if (!described) return false;
    this.described = described;
    this.audience.described(described);
    return true;
  }

  /** Solves the case, a wheel that moves by quick methods; whether it was by those. */
  private async solve(isMoving = false): Promise<boolean> {
    const { model } = this;
    const started = performance.now();
    this.audience.solving();
    const isTransient = this.isTransient();
    const tell = this.audience.progress;
    const [input, moving] = [model.fixed(), model.moving()];
    const moved = moving.paths.map((path, index) => [path, moving.values[index] ?? NaN]);
    const values = { ...this.described?.fields.values, ...Object.fromEntries(moved) };
    const answered = await this.tried(
      isTransient
        ? this.long.ask('play', 'play', { input: model.whole(), every: EVERY }, tell)
        : this.contact.ask('solve', 'solve', { input, ...moving, isMoving }, tell),
    );
    if (!answered || !this.described) return false;
    const milliseconds = performance.now() - started;
    this.result = { answered, values, milliseconds, isTransient };
    this.audience.solved(this.result);
    return answered.isQuick;
  }

  /** Solves the case once more. */
  again(): void {
    void this.solve();
  }

  /** Ends the solution that is under way. */
  cancel(): void {
    this.contact.cancel('solve');
    this.long.cancel('play');
    this.audience.cancelled();
  }

  /** The answer; null if it is stale or there is none, which the audience is told. */
  private async tried<T>(answer: Promise<T | null>): Promise<T | null> {
    const { count, opened } = this;
    try {
      const found = await answer;
      return opened === this.opened ? found : null;
    } catch (error) {
      if (!(error instanceof CaseProblems)) throw error;
      if (count === this.count) this.audience.failed(error.problems);
      return null;
    }
  }
}
