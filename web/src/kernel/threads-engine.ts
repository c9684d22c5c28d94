// Fields by the threads of one module. A field is one call, which blocks the worker that hosts the module.

import { failure } from './errors.js';
import type { FieldRequest, ThreadsOperations } from './protocol.js';
import type { FieldEngine, FieldRun } from './field-run.js';
import type { SurfaceSource } from './surface-source.js';
import type { WorkerClient } from './worker-client.js';

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
    const { cancelFlag } = await this.#worker.start();
    if (!cancelFlag) throw failure('INTERNAL', 'the module with threads has no flag to cancel it');
    if (!signal.aborted) await this.#worker.adopt(surface);
    if (signal.aborted) return;
    // Only the page writes the flag. One field runs at a time: a late abort cannot stop the next one.
    const flag = new Uint8Array(cancelFlag.buffer, cancelFlag.byteOffset, 1);
    Atomics.store(flag, 0, 0);
    const stop = () => Atomics.store(flag, 0, 1);
    signal.addEventListener('abort', stop);
    try {
      const { complete } = await this.#worker.requestOn(
        surface,
        'field',
        { field, threads: this.#threads },
        {
          onReport: (report) => {
            if (!signal.aborted && 'partial' in report) run.add(report.partial);
          },
        },
      );
      if (!signal.aborted && !(complete && run.complete)) {
        throw failure('INTERNAL', 'the threads left vertices without a value');
      }
    } finally {
      signal.removeEventListener('abort', stop);
    }
  }
}
