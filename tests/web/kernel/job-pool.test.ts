// Jobs find the surface where the last job left it: which worker gets a job, what it is sent, and when
// workers and surfaces are let go of.

import { beforeEach, describe, expect, test, vi } from 'vitest';
import { cancelled, GirthError } from '../../../web/src/kernel/types/errors.js';
import { JobPool, type JobNeeds } from '../../../web/src/kernel/page/job-pool.js';
import { openKernel } from '../../../web/src/kernel/page/kernel.js';
import type { JobOperations } from '../../../web/src/kernel/types/operations/job.js';
import type { SurfaceWithInput } from '../../../web/src/kernel/types/protocol.js';
import type { SurfaceSource } from '../../../web/src/kernel/page/surface-source.js';
import type { Field, Mesh } from '../../../web/src/kernel/types/types.js';
import type { WorkerClient } from '../../../web/src/kernel/page/worker-client.js';
import { FakeWorker, fakeSurface, fakeThickness, fakeValue } from './fake-worker.js';

/** Bytes above which the pools under test take a surface to be heavy. */
const heavy = 1000;
const never = new AbortController().signal;

let workers: FakeWorker[];
/** Operations that are not answered. */
let stuck: Set<string>;
beforeEach(() => {
  workers = [];
  stuck = new Set();
});

function fakePool(mostJobs = 2, rest = Infinity): JobPool<JobOperations> {
  const surface = fakeSurface(4);
  const create = () => {
    const worker = new FakeWorker((request, report) =>
      stuck.has(request.operation)
        ? new Promise<object>(() => undefined)
        : surface(request, report),
    );
    workers.push(worker);
    return worker;
  };
  return new JobPool<JobOperations>(create, { mostJobs, heavy, rest });
}

interface FakeSource extends SurfaceSource<SurfaceWithInput> {
  dispose(): void;
}

let lastNumber = 0;

/** A surface whose arrays have so many bytes. */
function source(bytes: number): FakeSource {
  const life = new AbortController();
  const arrays = {
    positions: new Float64Array(bytes / 8),
    indices: new Uint32Array(0),
    vertexOfInput: new Uint32Array(0),
    inputOfVertex: new Uint32Array(0),
  };
  return {
    number: ++lastNumber,
    arrays,
    life: life.signal,
    dispose: () => life.abort(),
  };
}

/** A job on some surfaces. */
function job(
  pool: JobPool<JobOperations>,
  surfaces: FakeSource[],
  { passing, signal = never }: JobNeeds & { signal?: AbortSignal } = {},
) {
  const needs = { surfaces, ...(passing === undefined ? {} : { passing }) };
  return pool.run(signal, needs, async (worker: WorkerClient<JobOperations>) => {
    for (const one of surfaces.slice(1)) await worker.adopt(one);
    return worker.requestOn(surfaces[0]!, 'vertexAreas', {});
  });
}

const codeOf = (promise: Promise<unknown>) =>
  promise.then(
    () => 'resolved',
    (error: unknown) => (error instanceof GirthError ? error.code : String(error)),
  );

/** The operations that a worker was asked, each with the number of its surface: 'adopt 3'. */
const asked = (worker: FakeWorker) =>
  worker.requests.map(({ operation, arguments: args }) =>
    [operation, (args as { surface?: number }).surface ?? []].flat().join(' '),
  );

const alive = () => workers.map(({ terminated }) => !terminated);

describe('a pool', () => {
  test('gives a worker a surface once; an ended worker gets it anew', async () => {
    const pool = fakePool();
    const a = source(80);
    await job(pool, [a]);
    await job(pool, [a]);
    const n = a.number;
    expect(workers.map(asked)).toEqual([
      ['start', `adopt ${n}`, `vertexAreas ${n}`, `vertexAreas ${n}`],
    ]);
    stuck.add('vertexAreas');
    const controller = new AbortController();
    const cancelled = codeOf(job(pool, [a], { signal: controller.signal }));
    await vi.waitFor(() => expect(workers[0]!.requests).toHaveLength(5));
    controller.abort();
    expect(await cancelled).toBe('CANCELLED');
    stuck.clear();
    await job(pool, [a]);
    expect(alive()).toEqual([false, true]);
    expect(asked(workers[1]!)).toEqual(['start', `adopt ${n}`, `vertexAreas ${n}`]);
  });

  test('a worker that has died of a fault gets its surfaces anew, too', async () => {
    const pool = fakePool();
    const a = source(80);
    await job(pool, [a]);
    workers[0]!.crash('unreachable executed');
    await job(pool, [a]);
    expect(asked(workers[1]!)).toEqual(['start', `adopt ${a.number}`, `vertexAreas ${a.number}`]);
  });

  test('jobs at a time on one surface have a worker each, and both keep it', async () => {
    const pool = fakePool();
    const a = source(2000);
    for (let i = 0; i < 3; ++i) await Promise.all([job(pool, [a]), job(pool, [a])]);
    expect(alive()).toEqual([true, true]);
    for (const worker of workers) {
      expect(worker.operations.filter((name) => name === 'adopt')).toHaveLength(1);
    }
  });

  test('a surface whose mesh is disposed of is freed; a worker that held much is ended', async () => {
    const pool = fakePool();
    const [light, large] = [source(80), source(2000)];
    await job(pool, [light]);
    await job(pool, [large]);
    expect(alive()).toEqual([true, true]);
    light.dispose();
    expect(asked(workers[0]!).at(-1)).toBe(`drop ${light.number}`);
    expect(alive()).toEqual([true, true]);
    large.dispose();
    expect(alive()).toEqual([true, false]);
    expect(await codeOf(job(pool, [large]))).toBe('CANCELLED');
  });

  test('a worker that holds much is ended when it has had no job for a while, a light one is not', async () => {
    const rest = 40;
    const pool = fakePool(2, rest);
    const [large, light] = [source(2 * heavy), source(80)];
    await job(pool, [light]);
    await job(pool, [large]);
    await job(pool, [large]);
    expect(alive()).toEqual([true, true]);
    await vi.waitFor(() => expect(alive()).toEqual([true, false]));
    // The next job has a worker that is given the surface again, and is not interrupted.
    stuck.add('vertexAreas');
    const begun = job(pool, [large]);
    await vi.waitFor(() => expect(asked(workers[2]!)).toHaveLength(3));
    await new Promise((done) => setTimeout(done, 2 * rest));
    expect(alive()).toEqual([true, false, true]);
    pool.terminate(cancelled());
    expect(await codeOf(begun)).toBe('CANCELLED');
  });

  test('a surface that is disposed of while its worker works is freed after the job', async () => {
    const pool = fakePool();
    const [a, b] = [source(2000), source(80)];
    await job(pool, [a]);
    const both = job(pool, [a, b]);
    await vi.waitFor(() => expect(asked(workers[0]!)).toContain(`adopt ${b.number}`));
    a.dispose();
    await both.catch(() => undefined);
    expect(asked(workers[0]!)).toContain(`drop ${a.number}`);
    b.dispose();
    expect(alive()).toEqual([false]);
  });

  test('light surfaces share a worker; heavy ones have one each, the oldest make room', async () => {
    const pool = fakePool();
    const lights = [source(400), source(400)];
    for (const light of lights) await job(pool, [light]);
    expect(workers).toHaveLength(1);
    const [a, b] = [source(2000), source(3000)];
    await job(pool, [a]);
    expect(workers).toHaveLength(2);
    // As many workers as jobs: the one that was used least recently takes the surface. It keeps as much of others as is
    // light.
    await job(pool, [b]);
    expect(workers).toHaveLength(2);
    expect(asked(workers[0]!)).not.toContain(`drop ${lights[0]!.number}`);
    await job(pool, [lights[1]!]);
    expect(asked(workers[0]!).at(-2)).toBe(`drop ${b.number}`);
    await job(pool, [a]);
    expect(asked(workers[1]!).slice(1)).toEqual([
      `adopt ${a.number}`,
      `vertexAreas ${a.number}`,
      `vertexAreas ${a.number}`,
    ]);
  });

  test('a job on two surfaces goes where most of them are', async () => {
    const pool = fakePool();
    const [a, b] = [source(2000), source(2000)];
    await Promise.all([job(pool, [a]), job(pool, [b])]);
    await job(pool, [b, a]);
    await job(pool, [b, a]);
    const adopted = workers.map((worker) => asked(worker).filter((one) => one.startsWith('adopt')));
    expect(adopted.flat()).toHaveLength(3);
  });

  test('a job through which much passes has a new worker, which is not kept', async () => {
    const pool = fakePool();
    const a = source(2000);
    await job(pool, [a]);
    await job(pool, [a], { passing: 2000 });
    await job(pool, [a]);
    expect(alive()).toEqual([true, false]);
    expect(asked(workers[0]!).slice(2)).toEqual([
      `vertexAreas ${a.number}`,
      `vertexAreas ${a.number}`,
    ]);
  });

  test('no more jobs at a time than allowed; ended, it takes none', async () => {
    const pool = fakePool(1);
    stuck.add('vertexAreas');
    const a = source(80);
    const jobs = [codeOf(job(pool, [a])), codeOf(job(pool, [a]))];
    await vi.waitFor(() => expect(asked(workers[0]!)).toContain(`vertexAreas ${a.number}`));
    expect(workers).toHaveLength(1);
    pool.terminate(new GirthError({ code: 'CANCELLED', element: -1, message: '', hint: '' }));
    expect(await Promise.all(jobs)).toEqual(['CANCELLED', 'CANCELLED']);
    expect(alive()).toEqual([false]);
  });
});

describe('the jobs of a mesh', () => {
  const count = 20;

  async function fakeKernel() {
    const jobWorkers: FakeWorker[] = [];
    const behaviour = fakeSurface(count);
    const plain = () => new FakeWorker(behaviour);
    const job = () => {
      const worker = plain();
      jobWorkers.push(worker);
      return worker;
    };
    const factory = { single: plain, threads: plain, job, studies: plain };
    const kernel = await openKernel({ threads: 1, mode: 'pool' }, factory);
    return { kernel, jobWorkers };
  }
  const load = ({ kernel }: Awaited<ReturnType<typeof fakeKernel>>) =>
    kernel.load({ positions: new Float64Array(3 * count), indices: new Uint32Array(3) });
  const fieldOf = (name: 'igf' | 'sdf' | 'thickness') =>
    ({
      name,
      values: Float64Array.from({ length: count }, (_, v) =>
        name === 'igf' ? fakeValue(v) : fakeThickness(v),
      ),
      unit: '',
    }) as Field;

  /** Every kind of job on one surface. */
  async function everyJob(mesh: Mesh) {
    const [igf, sdf] = [fieldOf('igf'), fieldOf('sdf')];
    const thresholds = { girth: 1, shapeDiameter: 1 };
    const limits = { tubeDiameter: 1, wallThickness: 1 };
    await mesh.vertexAreas();
    await mesh.tips(igf);
    await mesh.suggestedThresholds(igf, sdf);
    await mesh.parts(igf, sdf, thresholds);
    await mesh.maxima(igf);
    const printed = { igf, thickness: fieldOf('thickness') };
    await mesh.printCheck(printed, limits);
    await mesh.path(0, 1);
    await mesh.exportField(igf, 'csv');
    await mesh.exportTips(igf, 'json');
    await mesh.exportParts(igf, sdf, thresholds, 'json');
    await mesh.exportWeakPlaces(printed, limits, 'json');
    await mesh.exportLoops([0], 'obj');
    await mesh.difference(igf, mesh, igf);
    const remeshed = await mesh.remesh(4);
    await remeshed.carryBack(igf.values);
    await remeshed.carryField(igf);
    return remeshed;
  }

  test('refer to its surface, which its worker was given once, also by its input', async () => {
    const opened = await fakeKernel();
    const mesh = await load(opened);
    const remeshed = await everyJob(mesh);
    expect(opened.jobWorkers).toHaveLength(1);
    const { requests } = opened.jobWorkers[0]!;
    const adopted = requests.filter(({ operation }) => operation === 'adopt');
    // The mesh, and the remeshed one.
    expect(adopted).toHaveLength(2);
    const { surface, arrays } = adopted[0]!.arguments as {
      surface: number;
      arrays: SurfaceWithInput;
    };
    expect(Object.keys(arrays).sort()).toEqual([
      'indices',
      'inputOfVertex',
      'positions',
      'vertexOfInput',
    ]);
    for (const { operation, arguments: args } of requests.slice(2)) {
      if (operation === 'adopt') continue;
      expect(args).toMatchObject({ surface });
      expect(args).not.toHaveProperty('arrays');
    }
    remeshed.dispose();
    mesh.dispose();
    await vi.waitFor(() =>
      expect(asked(opened.jobWorkers[0]!).slice(-2)).toEqual([
        `drop ${surface + 1}`,
        `drop ${surface}`,
      ]),
    );
  });

  test('with a mesh of another kernel let go of that one with its mesh', async () => {
    const [one, other] = [await fakeKernel(), await fakeKernel()];
    const [mine, foreign] = [await load(one), await load(other)];
    await mine.difference(fieldOf('igf'), foreign, fieldOf('igf'));
    const numbers = asked(one.jobWorkers[0]!).filter((text) => text.startsWith('adopt'));
    expect(new Set(numbers).size).toBe(2);
    const before = one.jobWorkers[0]!.requests.length;
    foreign.dispose();
    expect(asked(one.jobWorkers[0]!).slice(before)).toEqual([
      numbers.find((text) => text !== numbers.at(-1))!.replace('adopt', 'drop'),
    ]);
    expect(await codeOf(mine.difference(fieldOf('igf'), foreign, fieldOf('igf')))).toBe(
      'CANCELLED',
    );
  });

  test('with fields of other meshes are refused', async () => {
    const opened = await fakeKernel();
    const mesh = await load(opened);
    const short = { ...fieldOf('igf'), values: new Float64Array(1) };
    expect(await codeOf(mesh.difference(short, mesh, fieldOf('igf')))).toBe('USAGE');
    expect(await codeOf(mesh.difference(fieldOf('igf'), mesh, short))).toBe('USAGE');
    const remeshed = await mesh.remesh(4);
    expect(await codeOf(remeshed.carryBack(short.values))).toBe('USAGE');
    expect(await codeOf(remeshed.carryField(short))).toBe('USAGE');
    const states = new Uint8Array(1);
    expect(await codeOf(mesh.exportField({ ...fieldOf('igf'), states } as Field, 'csv'))).toBe(
      'USAGE',
    );
  });
});
