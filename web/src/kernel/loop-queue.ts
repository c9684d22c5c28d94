// Requests for loops, which follow the pointer. The worker receives one at a time, the latest first.
// Requests that were aborted before that are dropped.

import type { Answer, SingleOperations } from './protocol.js';
import type { SurfacePoint } from './types.js';
import type { SurfaceSource } from './surface-source.js';
import type { WorkerClient } from './worker-client.js';

type FoundLoop = Answer<SingleOperations, 'loop'>;

interface PendingLoop {
  surface: SurfaceSource;
  point: SurfacePoint;
  signal: AbortSignal;
  resolve(loop: FoundLoop): void;
  reject(error: unknown): void;
}

export class LoopQueue {
  readonly #worker: WorkerClient<SingleOperations>;
  #pending: PendingLoop[] = [];
  #running = false;

  constructor(worker: WorkerClient<SingleOperations>) {
    this.#worker = worker;
  }

  /** The loop. The promise never settles where the signal fires before the request is sent. */
  loop(surface: SurfaceSource, point: SurfacePoint, signal: AbortSignal): Promise<FoundLoop> {
    return new Promise((resolve, reject) => {
      this.#pending.push({ surface, point, signal, resolve, reject });
      void this.#run();
    });
  }

  async #run(): Promise<void> {
    if (this.#running) return;
    this.#running = true;
    for (let next; (next = this.#newest());) {
      const { surface, point } = next;
      await this.#worker.requestOn(surface, 'loop', { point }).then(
        (loop) => next.resolve(loop),
        (error: unknown) => next.reject(error),
      );
    }
    this.#running = false;
  }

  #newest(): PendingLoop | undefined {
    this.#pending = this.#pending.filter(({ signal }) => !signal.aborted);
    return this.#pending.pop();
  }
}
