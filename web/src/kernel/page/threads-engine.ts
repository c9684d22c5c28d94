// Fields by the threads of one module. A field is one call, which blocks the worker that hosts the module.

import { cancelled, failure } from '../types/errors.js';
import type {
  FieldRequest,
  FoundRefined,
  RefinedRequest,
  Report,
  ThreadsOperations,
} from '../types/protocol.js';
import type { FieldEngine, FieldRun } from './field-run.js';
import { bytesOf, type SurfaceSource } from './surface-source.js';
import type { WorkerClient } from './worker-client.js';

/** The refined girth of a surface of more bytes leaves much memory behind: about 150,000 vertices. */
const heavy = 8 * 2 ** 20;

export class ThreadsEngine implements FieldEngine {
  readonly #worker: WorkerClient<ThreadsOperations>;
  readonly #threads: number;

  constructor(worker: WorkerClient<ThreadsOperations>, threads: number) {
    this.#worker = worker;
    this.#threads = threads;
  }

  async compute(
    surface: SurfaceSource,
    field: FieldRequest,
    run: FieldRun,
    signal: AbortSignal,
  ): Promise<void> {
    const onReport = (report: Report) => {
      if (!signal.aborted && 'partial' in report) run.add(report.partial);
    };
    const [threads, { known }] = [this.#threads, run];
    const answer = await this.#until(signal, surface, () =>
      this.#worker.requestOn(surface, 'field', { field, known, threads }, { onReport }),
    );
    if (!signal.aborted && !(answer?.complete && run.complete)) {
      throw failure('INTERNAL', 'the threads left vertices without a value');
    }
  }

  async refined(
    surface: SurfaceSource,
    request: RefinedRequest,
    onReport: (report: Report) => void,
    signal: AbortSignal,
  ): Promise<FoundRefined> {
    const threads = this.#threads;
    try {
      const found = await this.#until(signal, surface, () =>
        this.#worker.requestOn(surface, 'refinedGirth', { request, threads }, { onReport }),
      );
      if (!found) throw cancelled();
      return found;
    } finally {
      // A module's memory never shrinks: the next field has another one.
      if (bytesOf(surface) > heavy) this.#worker.restart(cancelled());
    }
  }

  /** Runs a call on a surface, which the flag stops when the signal fires; undefined where it has fired before. */
  async #until<T>(
    signal: AbortSignal,
    surface: SurfaceSource,
    call: () => Promise<T>,
  ): Promise<T | undefined> {
    const { cancelFlag } = await this.#worker.start();
    if (!cancelFlag) throw failure('INTERNAL', 'the module with threads has no flag to cancel it');
    if (!signal.aborted) await this.#worker.adopt(surface);
    if (signal.aborted) return undefined;
    // Only the page writes the flag. One call runs at a time: a late abort cannot stop the next one.
    const flag = new Uint8Array(cancelFlag.buffer, cancelFlag.byteOffset, 1);
    Atomics.store(flag, 0, 0);
    const stop = () => Atomics.store(flag, 0, 1);
    signal.addEventListener('abort', stop);
    try {
      return await call();
    } finally {
      signal.removeEventListener('abort', stop);
    }
  }
}
