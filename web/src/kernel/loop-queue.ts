// The loops under the pointer: one request at a time goes to the worker, the newest first, and those
// that have been aborted meanwhile never run.

import type { Answer, SingleOperations } from './protocol.js';
import type { SurfacePoint } from './types.js';
import type { SurfaceSource } from './surface-source.js';
import type { WorkerClient } from './worker-client.js';

type FoundLoop = Answer<SingleOperations, 'loop'>;

interface Waiting {
  surface: SurfaceSource;
  point: SurfacePoint;
  signal: AbortSignal;
  resolve(loop: FoundLoop): void;
  reject(error: unknown): void;
}

export class LoopQueue {
  readonly #worker: WorkerClient<SingleOperations>;
  #waiting: Waiting[] = [];
  #running = false;

  constructor(worker: WorkerClient<SingleOperations>) {
    this.#worker = worker;
  }

  /** The loop; a promise that never settles where the signal fires before its turn. */
  loop(surface: SurfaceSource, point: SurfacePoint, signal: AbortSignal): Promise<FoundLoop> {
    return new Promise((resolve, reject) => {
      this.#waiting.push({ surface, point, signal, resolve, reject });
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

  #newest(): Waiting | undefined {
    this.#waiting = this.#waiting.filter(({ signal }) => !signal.aborted);
    return this.#waiting.pop();
  }
}
