import { expect, test } from 'vitest';
import { FieldRun } from '../../../web/src/kernel/page/field-run.js';
import type { FieldRequest, Report } from '../../../web/src/kernel/types/protocol.js';
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

test('a field that was stopped goes on with the vertices that are not known', async () => {
  const asked: number[][] = [];
  const flag = new SharedArrayBuffer(1);
  const client = new WorkerClient<never>(
    () =>
      new FakeWorker(async ({ operation, arguments: args }, report) => {
        if (operation === 'start') return { cancelFlag: { buffer: flag, byteOffset: 0 } };
        if (operation !== 'field') return {};
        const { known } = args as { known: Uint8Array };
        asked.push([...known]);
        const vertices = Uint32Array.of(0, 1, 2, 3).filter((v) => !known[v]);
        const some = asked.length === 1 ? vertices.slice(0, 2) : vertices;
        const values = Float64Array.from(some, (v) => v + 1);
        report({ partial: { vertices: some, values, kinds: new Uint8Array(some.length) } });
        while (asked.length === 1 && new Uint8Array(flag)[0] === 0) {
          await new Promise((resolve) => setTimeout(resolve, 1));
        }
        return { complete: asked.length > 1 };
      }),
    2,
  );
  const engine = new ThreadsEngine(client, 2);
  const run = new FieldRun(4, true, {});
  const field = { name: 'igf' } as FieldRequest;
  const pause = new AbortController();
  const first = engine.compute(surfaceOf(1, 4), field, run, pause.signal);
  await expect.poll(() => run.known).toHaveLength(4);
  pause.abort();
  await first;
  expect(run.complete).toBe(false);
  await engine.compute(surfaceOf(1, 4), field, run, new AbortController().signal);
  expect(asked).toEqual([[], [1, 1, 0, 0]]);
  expect([...run.values]).toEqual([1, 2, 3, 4]);
});
