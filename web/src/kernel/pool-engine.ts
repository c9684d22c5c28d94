// Fields by a pool of workers without threads: vertices go out coarse to fine in chunks, and each
// worker gets the next chunk as soon as it has returned one.

import { cancelled } from './errors.js';
import type { FieldRequest, SingleOperations } from './protocol.js';
import type { FieldEngine, FieldRun } from './field-run.js';
import type { SurfaceSource } from './surface-source.js';
import type { WorkerClient } from './worker-client.js';

/** How long a chunk should take: long against a message, short against a person's patience. */
const chunkMilliseconds = 40;
/** Towards the end chunks become small, but not so small that messages cost more than the work. */
const leastMilliseconds = 2;
/** Each worker has one chunk in work and one waiting, so that a busy page does not leave it idle. */
const chunksPerWorker = 2;
const firstChunk = 4;
/** A worker that is still busy this long after the work was stopped is ended, in milliseconds. */
const patience = 500;

/** How many vertices to hand out, given a worker's speed in vertices per millisecond. */
export function chunkSize(speed: number | undefined, left: number, workers: number): number {
  // Towards the end the chunks become small, so that all workers finish together.
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
    const { order } = await this.#workers[0]!.requestOn(surface, 'order', {});
    if (signal.aborted) return;
    let next = 0;
    let failed = false;

    const work = async (worker: WorkerClient<SingleOperations>) => {
      let speed: number | undefined;
      const lane = async () => {
        try {
          // Copying the surface to all workers at once must not hold up the first one's chunks.
          await worker.adopt(surface);
          while (next < order.length && !failed && !signal.aborted) {
            const size = chunkSize(speed, order.length - next, this.#workers.length);
            const vertices = order.slice(next, (next += size));
            const { values, kinds, milliseconds } = await worker.requestOn(surface, 'values', {
              field,
              vertices,
            });
            if (signal.aborted) return;
            speed = size / Math.max(milliseconds, 0.1);
            run.add({ vertices, values, kinds });
          }
        } catch (thrown) {
          failed = true;
          throw thrown;
        }
      };
      // Nothing stops a worker in the middle of a chunk, and one vertex may take long.
      let impatience: ReturnType<typeof setTimeout> | undefined;
      const stop = () => (impatience = setTimeout(() => worker.restart(cancelled()), patience));
      signal.addEventListener('abort', stop);
      try {
        // All lanes settle before the run does: then nothing of it is left in the workers.
        await settled(Array.from({ length: chunksPerWorker }, lane));
      } finally {
        signal.removeEventListener('abort', stop);
        clearTimeout(impatience);
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
