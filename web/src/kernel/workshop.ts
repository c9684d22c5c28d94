// Workers that make surfaces and files, each job in a worker of its own: it can be ended at any
// moment without harm to anything else, and what it needed of memory goes with it.

import { cancelled, type GirthError } from './errors.js';
import type { WorkshopOperations } from './protocol.js';
import { WorkerClient, type WorkerLike } from './worker-client.js';

type Worker = WorkerClient<WorkshopOperations>;

/** So many jobs at a time: each may need several times the memory of a model. */
const mostJobs = 2;
/** A worker that has had this many bytes to work on is not kept: a module's memory never shrinks. */
const heavy = 8 * 2 ** 20;

export class Workshop {
  readonly #create: () => WorkerLike;
  readonly #busy = new Set<Worker>();
  #idle: Worker | undefined;
  #waiting: (() => void)[] = [];
  #jobs = 0;
  #closed: GirthError | undefined;

  constructor(create: () => WorkerLike) {
    this.#create = create;
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
  async run<T>(
    signal: AbortSignal,
    bytes: number,
    job: (worker: Worker) => Promise<T>,
  ): Promise<T> {
    while (this.#jobs >= mostJobs) await new Promise<void>((turn) => this.#waiting.push(turn));
    ++this.#jobs;
    let worker: Worker | undefined;
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

  /** Ends all workers at once and for good. */
  terminate(error: GirthError): void {
    this.#closed = error;
    this.#idle?.terminate(error);
    for (const worker of this.#busy) worker.terminate(error);
  }
}
