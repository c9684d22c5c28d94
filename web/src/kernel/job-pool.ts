// Workers for jobs (surfaces, files, spectra), each job in a worker of its own: it can be ended at any
// moment without harm to anything else, and what it needed of memory goes with it.

import { cancelled, type GirthError } from './errors.js';
import type { CommonOperations } from './protocol.js';
import { WorkerClient, type WorkerLike } from './worker-client.js';

/** A worker that has had this many bytes to work on is not kept: a module's memory never shrinks. */
const heavy = 8 * 2 ** 20;

export class JobPool<T extends CommonOperations> {
  readonly #create: () => WorkerLike;
  readonly #mostJobs: number;
  readonly #busy = new Set<WorkerClient<T>>();
  #idle: WorkerClient<T> | undefined;
  #waiting: (() => void)[] = [];
  #jobs = 0;
  #closed: GirthError | undefined;

  /** `mostJobs` at a time: each may need several times the memory of a model. */
  constructor(create: () => WorkerLike, mostJobs = 2) {
    this.#create = create;
    this.#mostJobs = mostJobs;
  }

  /** Starts a worker to have it ready. */
  async start(): Promise<void> {
    this.#idle ??= new WorkerClient(this.#create);
    await this.#idle.start();
  }

  /**
   * Runs a job, when its turn has come. `bytes` says how large its input is. When the signal fires
   * the job's worker is ended, and the job fails.
   */
  async run<R>(
    signal: AbortSignal,
    bytes: number,
    job: (worker: WorkerClient<T>) => Promise<R>,
  ): Promise<R> {
    while (this.#jobs >= this.#mostJobs)
      await new Promise<void>((turn) => this.#waiting.push(turn));
    ++this.#jobs;
    let worker: WorkerClient<T> | undefined;
    const stop = () => worker?.terminate(this.#closed ?? cancelled());
    try {
      if (this.#closed) throw this.#closed;
      if (signal.aborted) throw cancelled();
      worker = this.#idle ?? new WorkerClient(this.#create);
      this.#idle = undefined;
      this.#busy.add(worker);
      signal.addEventListener('abort', stop);
      return await job(worker);
    } finally {
      signal.removeEventListener('abort', stop);
      --this.#jobs;
      this.#waiting.shift()?.();
      if (worker) {
        this.#busy.delete(worker);
        if (this.#closed || signal.aborted || this.#idle || bytes > heavy) stop();
        else this.#idle = worker;
      }
    }
  }

  /** Lets go of a surface: the worker that knows it is ended, as its memory would never shrink. */
  drop(surface: number): void {
    for (const worker of this.#busy) worker.drop(surface);
    if (!this.#idle?.knows(surface)) return;
    this.#idle.terminate(cancelled());
    this.#idle = undefined;
  }

  /** Ends all workers at once and for good. */
  terminate(error: GirthError): void {
    this.#closed = error;
    this.#idle?.terminate(error);
    for (const worker of this.#busy) worker.terminate(error);
  }
}
