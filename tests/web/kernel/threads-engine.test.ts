import { expect, test } from 'vitest';
import type { Report } from '../../../web/src/kernel/types/protocol.js';
import { ThreadsEngine } from '../../../web/src/kernel/page/threads-engine.js';
import { WorkerClient } from '../../../web/src/kernel/page/worker-client.js';
import { FakeWorker } from './fake-worker.js';

const request = { coarseFaces: 10_000, audit: 200, seed: 1 };

/** An engine of fakes that refine when they are told to. */
function engineOfFakes() {
  const workers: FakeWorker[] = [];
  const flags: Uint8Array[] = [];
  let finish = (): void => undefined;
  const client = new WorkerClient<never>(() => {
    const buffer = new SharedArrayBuffer(1);
    flags.push(new Uint8Array(buffer));
    const worker = new FakeWorker(({ operation }, report) => {
      if (operation === 'start') return { cancelFlag: { buffer, byteOffset: 0 } };
      if (operation !== 'refinedGirth') return {};
      report({ progress: 0.5 });
      return new Promise((resolve) => (finish = () => resolve({ coarseFaces: 9_998 })));
    });
    workers.push(worker);
    return worker;
  }, 2);
  return { engine: new ThreadsEngine(client, 2), workers, flags, finish: () => finish() };
}

const surfaceOf = (number: number, vertices: number) => ({
  number,
  arrays: { positions: new Float64Array(3 * vertices), indices: new Uint32Array(3) },
  life: new AbortController().signal,
});

test('the refined girth of a heavy surface leaves no memory behind, that of a light one its worker', async () => {
  const { engine, workers, finish } = engineOfFakes();
  const reports: Report[] = [];
  for (const [number, vertices] of [
    [1, 10],
    [2, 400_000],
    [3, 10],
  ] as const) {
    const { signal } = new AbortController();
    const refined = engine.refined(
      surfaceOf(number, vertices),
      request,
      (report) => reports.push(report),
      signal,
    );
    await expect.poll(() => reports).toHaveLength(number);
    finish();
    expect((await refined).coarseFaces).toBe(9_998);
  }
  expect(workers.map(({ terminated }) => terminated)).toEqual([true, false]);
  expect(workers.map(({ operations }) => operations.join(' '))).toEqual([
    'start adopt refinedGirth adopt refinedGirth',
    'start adopt refinedGirth',
  ]);
});

test('a signal sets the flag of the threads', async () => {
  const { engine, flags, finish } = engineOfFakes();
  const reports: Report[] = [];
  const controller = new AbortController();
  const onReport = (report: Report) => reports.push(report);
  const refined = engine.refined(surfaceOf(1, 10), request, onReport, controller.signal);
  await expect.poll(() => reports).toHaveLength(1);
  expect(flags[0]![0]).toBe(0);
  controller.abort();
  expect(flags[0]![0]).toBe(1);
  finish();
  await refined;
  const late = engine.refined(surfaceOf(1, 10), request, onReport, controller.signal);
  await expect(late).rejects.toMatchObject({ code: 'CANCELLED' });
});
