// Requests for loops and barcodes, which follow the pointer. The worker receives one at a time, the latest
// first. Requests that were aborted before that are dropped.

import type { Answer, Arguments, SingleOperations } from '../types/protocol.js';
import type { SurfaceSource } from './surface-source.js';
import type { WorkerClient } from './worker-client.js';

/** The operations at a point. */
export type PointOperation = 'loop' | 'barcode';
/** The arguments of an operation besides the surface. */
export type PointArguments<K extends PointOperation> = Omit<
  Arguments<SingleOperations, K>,
  'surface'
>;

interface Pending {
  signal: AbortSignal;
  /** Settles when the worker has answered. */
  ask(): Promise<void>;
}

export class LoopQueue {
  readonly #worker: WorkerClient<SingleOperations>;
  #pending: Pending[] = [];
  #running = false;

  constructor(worker: WorkerClient<SingleOperations>) {
    this.#worker = worker;
  }

  /** The answer. The promise never settles where the signal fires before the request is sent. */
  answer<K extends PointOperation>(
    surface: SurfaceSource,
    operation: K,
    args: PointArguments<K>,
    signal: AbortSignal,
  ): Promise<Answer<SingleOperations, K>> {
    return new Promise((resolve, reject) => {
      const ask = () => this.#worker.requestOn(surface, operation, args).then(resolve, reject);
      this.#pending.push({ signal, ask });
      void this.#run();
    });
  }

  async #run(): Promise<void> {
    if (this.#running) return;
    this.#running = true;
    for (let next; (next = this.#newest());) await next.ask();
    this.#running = false;
  }

  #newest(): Pending | undefined {
    this.#pending = this.#pending.filter(({ signal }) => !signal.aborted);
    return this.#pending.pop();
  }
}
