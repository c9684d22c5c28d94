import { expect, test } from 'vitest';
import { cancelled, failure } from '../../../web/src/kernel/types/errors.js';
import type { CommonOperations, Request } from '../../../web/src/kernel/types/protocol.js';
import { WorkerClient } from '../../../web/src/kernel/page/worker-client.js';
import { FakeWorker } from './fake-worker.js';

function clientOfFakes() {
  const workers: FakeWorker[] = [];
  const client = new WorkerClient<CommonOperations>(() => {
    const worker = new FakeWorker(() => ({}));
    workers.push(worker);
    return worker;
  });
  return { client, workers };
}

/** A surface so large that it is copied piece by piece. */
const largeSurface = () => ({
  number: 7,
  arrays: {
    positions: Float64Array.from({ length: 300_001 }, (_, i) => i / 3),
    indices: Uint32Array.from({ length: 400_003 }, (_, i) => i),
  },
  life: new AbortController().signal,
});

const arraysOf = (request: Request) =>
  (request.arguments as { arrays: ReturnType<typeof largeSurface>['arrays'] }).arrays;

test('a large surface is copied while other tasks run', async () => {
  const { client, workers } = clientOfFakes();
  const surface = largeSurface();
  await client.start();
  const adopted = client.adopt(surface);
  let tasks = 0;
  const other = setInterval(() => ++tasks);
  await adopted;
  clearInterval(other);
  expect(tasks).toBeGreaterThan(1);
  const request = workers[0]!.requests.at(-1)!;
  expect(request.operation).toBe('adopt');
  const { positions, indices } = arraysOf(request);
  // Quicker than toEqual.
  const isSame = (a: ArrayBufferView, b: ArrayBufferView) =>
    Buffer.from(a.buffer).equals(Buffer.from(b.buffer));
  expect(isSame(positions, surface.arrays.positions)).toBe(true);
  expect(isSame(indices, surface.arrays.indices)).toBe(true);
  // The page keeps its own.
  expect(positions.buffer).not.toBe(surface.arrays.positions.buffer);
});

test('a small surface is sent at once', async () => {
  const { client, workers } = clientOfFakes();
  const arrays = { positions: new Float64Array(9), indices: new Uint32Array(3) };
  await client.start();
  const adopted = client.adopt({ number: 1, arrays, life: new AbortController().signal });
  await Promise.resolve();
  expect(workers[0]!.operations).toEqual(['start', 'adopt']);
  await adopted;
});

test('a surface that is dropped while it is copied is not sent', async () => {
  const { client, workers } = clientOfFakes();
  await client.start();
  const adopted = client.adopt(largeSurface());
  await new Promise((done) => setTimeout(done));
  client.drop(7);
  await expect(adopted).rejects.toMatchObject({ code: 'CANCELLED' });
  expect(workers[0]!.operations).toEqual(['start']);
  // Asked for anew, it is.
  await client.adopt(largeSurface());
  expect(workers[0]!.operations).toEqual(['start', 'adopt']);
});

test('a worker that is ended meanwhile does not get it, and says why', async () => {
  const { client, workers } = clientOfFakes();
  await client.start();
  const adopted = client.adopt(largeSurface());
  await new Promise((done) => setTimeout(done));
  client.restart(failure('OUT_OF_MEMORY', 'no more'));
  await expect(adopted).rejects.toMatchObject({ code: 'OUT_OF_MEMORY' });
  await client.adopt(largeSurface());
  expect(workers.map(({ operations }) => operations)).toEqual([['start'], ['start', 'adopt']]);
  client.terminate(cancelled());
});
