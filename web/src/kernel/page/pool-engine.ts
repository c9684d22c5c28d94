// Fields by a pool of workers without threads. Vertices are handed out in chunks, coarse to fine; a worker
// receives the next chunk when it has returned one.

import { cancelled } from '../types/errors.js';
import type { FieldRequest, SingleOperations } from '../types/protocol.js';
import type { FieldEngine, FieldRun } from './field-run.js';
import type { SurfaceSource } from './surface-source.js';
import type { WorkerClient } from './worker-client.js';

/** How long a chunk should take: long compared with a message, short compared with a user's patience. */
const chunkMilliseconds = 40;
/** The least time of a chunk: below it messages would cost more than the work. */
const leastMilliseconds = 2;
/** Each worker has one chunk in work and one pending, so that a busy page does not leave it idle. */
const chunksPerWorker = 2;
const firstChunk = 4;
/** A worker that is still busy this long after the work was stopped is ended, in milliseconds. */
const patience = 500;

/** Number of vertices of the next chunk, given the worker's speed in vertices per millisecond. */
export function chunkSize(speed: number | undefined, left: number, workers: number): number {
  // The last chunks are small, so that all workers finish together.
  const share = Math.ceil(left / (chunksPerWorker * workers));
  if (speed === undefined) return Math.min(firstChunk, share);
  const least = Math.ceil(speed * leastMilliseconds);
  const most = Math.ceil(speed * chunkMilliseconds);
  return Math.min(Math.max(share, least), most, left);
}

export class PoolEngine implements FieldEngine {
  readonly #workers: readonly WorkerClient<SingleOperations>[];

  constructor(workers: readonly WorkerClient<SingleOperations>[]) {
    this.#workers = workers;
  }

  async compute(
    surface: SurfaceSource,
    field: FieldRequest,
    run: FieldRun,
    signal: AbortSignal,
  ): Promise<void> {
    const whole = await this.#workers[0]!.requestOn(surface, 'order', {});
    if (signal.aborted) return;
    const { known } = run;
    const order = known.length > 0 ? whole.order.filter((v) => known[v] === 0) : whole.order;
    let next = 0;
    let failed = false;

    const work = async (worker: WorkerClient<SingleOperations>) => {
      let speed: number | undefined;
      const lane = async () => {
        try {
          // Each worker begins when it has the surface: copying it to all must not delay the first one.
          await worker.adopt(surface);
          while (next < order.length && !failed && !signal.aborted) {
            const size = chunkSize(speed, order.length - next, this.#workers.length);
            const vertices = order.slice(next, (next += size));
            const { milliseconds, ...found } = await worker.requestOn(surface, 'values', {
              field,
              vertices,
            });
            if (signal.aborted) return;
            speed = size / Math.max(milliseconds, 0.1);
            run.add({ vertices, ...found });
          }
        } catch (thrown) {
          failed = true;
          throw thrown;
        }
      };
      // A worker cannot be stopped in the middle of a chunk, and one vertex may take long.
      let overdue: ReturnType<typeof setTimeout> | undefined;
      const stop = () => (overdue = setTimeout(() => worker.restart(cancelled()), patience));
      signal.addEventListener('abort', stop);
      try {
        // All lanes settle before the run does. Then the workers have no request of it left.
        await settled(Array.from({ length: chunksPerWorker }, lane));
      } finally {
        signal.removeEventListener('abort', stop);
        clearTimeout(overdue);
      }
    };
    await settled(this.#workers.map(work));
  }
}

/** Waits for all; throws the first failure. */
async function settled(promises: Promise<void>[]): Promise<void> {
  const results = await Promise.allSettled(promises);
  const failure = results.find((result) => result.status === 'rejected');
  if (failure) throw failure.reason;
}
