/** A worker to which the newest request of each topic goes; older ones that wait are dropped. */
import type { FileBytes, Kind, Problem, Progress, Reply, Requests } from './protocol';

/** Errors of a case. */
export class CaseProblems extends Error {
  constructor(readonly problems: Problem[]) {
    super(problems.map((problem) => problem.message).join('\n'));
  }
}

interface Job {
  topic: string;
  kind: Kind;
  ask: Requests[Kind]['ask'];
  resolve: (answer: Requests[Kind]['answer'] | null) => void;
  reject: (error: unknown) => void;
  onProgress: (progress: Progress) => void;
}

/** Requests to one worker, one after the other. */
export class Lane {
  private worker: Worker | null = null;
  private running: Job | null = null;
  private readonly waiting = new Map<string, Job>();
  private files: FileBytes = [];
  private count = 0;

  /** `endsStale`: a running request is ended when a newer one of its topic arrives. */
  constructor(
    private readonly module: WebAssembly.Module,
    private readonly endsStale: boolean,
  ) {}

  /** Starts the worker, which else starts when it is first asked; the text of the catalogue. */
  async start(): Promise<string> {
    this.begin();
    const answer = await this.ask('start', 'start', this.origin());
    return answer?.catalogue ?? '';
  }

  /** Gives the files that cases may name. */
  setFiles(files: FileBytes): void {
    this.files = files;
    if (this.worker) this.ask('inputs', 'inputs', { files }).catch(() => undefined);
  }

  /** The answer, or null if a newer request of the topic took its place. */
  ask<K extends Kind>(
    topic: string,
    kind: K,
    ask: Requests[K]['ask'],
    onProgress: (progress: Progress) => void = () => {},
  ): Promise<Requests[K]['answer'] | null> {
    return new Promise((resolve, reject) => {
      if (!this.worker && kind !== 'start') this.restart();
      this.waiting.get(topic)?.resolve(null);
      // What is asked last comes last: it may need what was asked between.
      this.waiting.delete(topic);
      const taken = resolve as Job['resolve'];
      this.waiting.set(topic, { topic, kind, ask, resolve: taken, reject, onProgress });
      if (this.endsStale && this.running?.topic === topic) this.restart();
      this.next();
    });
  }

  /** Ends a request, which gets no answer unless it runs and comes to its end in time, in ms. */
  cancel(topic: string, time = 0): void {
    this.waiting.get(topic)?.resolve(null);
    this.waiting.delete(topic);
    const { running } = this;
    if (running?.topic !== topic) return;
    const end = () => {
      if (this.running === running) this.restart();
    };
    if (time > 0) setTimeout(end, time);
    else end();
  }

  /** The module, and where the standard table of creep forces is. */
  private origin(): Requests['start']['ask'] {
    return { module: this.module, table: new URL('standard.npz', document.baseURI).href };
  }

  private begin(): void {
    this.worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' });
    this.worker.onmessage = ({ data }: MessageEvent<Reply>) => this.take(data);
    this.worker.onerror = ({ message }) =>
      this.fail([{ field: '', message, place: 'schlupf', help: null }]);
  }

  /** Another worker, set up as the first. */
  private restart(): void {
    this.worker?.terminate();
    this.running?.resolve(null);
    this.running = null;
    this.begin();
    const others = [...this.waiting.values()];
    this.waiting.clear();
    // Who waits is told if the worker does not start.
    this.ask('start', 'start', this.origin()).catch(() => undefined);
    this.ask('inputs', 'inputs', { files: this.files }).catch(() => undefined);
    for (const job of others) this.waiting.set(job.topic, job);
  }

  private next(): void {
    const [job] = this.waiting.values();
    if (this.running || !job || !this.worker) return;
    this.waiting.delete(job.topic);
    this.running = job;
    this.count += 1;
    this.worker.postMessage({ id: this.count, kind: job.kind, ask: job.ask });
  }

  private take(reply: Reply): void {
    const job = this.running;
    if (!job || reply.id !== this.count) return;
    if (reply.progress) {
      job.onProgress(reply.progress);
      return;
    }
    if (reply.problems?.some((problem) => problem.place === 'schlupf')) {
      this.fail(reply.problems);
      return;
    }
    this.running = null;
    if (reply.problems) job.reject(new CaseProblems(reply.problems));
    else job.resolve(reply.answer ?? null);
    this.next();
  }

  /** The worker cannot go on: another takes its place, unless it did not even start. */
  private fail(problems: Problem[]): void {
    const failed = this.running;
    this.running = null;
    failed?.reject(new CaseProblems(problems));
    if (failed && failed.kind !== 'start') {
      this.restart();
      return;
    }
    this.worker?.terminate();
    this.worker = null;
    for (const job of this.waiting.values()) job.reject(new CaseProblems(problems));
    this.waiting.clear();
  }
}
