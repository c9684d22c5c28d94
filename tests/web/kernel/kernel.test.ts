// The kernel's logic with fake workers: who gets which vertices, what is told when, and how it ends.

import { readFileSync } from 'node:fs';
import { afterEach, describe, expect, test, vi } from 'vitest';
import { GirthError, fieldsOf, hints } from '../../../web/src/kernel/types/errors.js';
import { FieldRun, summaryOf } from '../../../web/src/kernel/page/field-run.js';
import { openKernel } from '../../../web/src/kernel/page/kernel.js';
import { chunkSize } from '../../../web/src/kernel/page/pool-engine.js';
import { callOptionNames } from '../../../web/src/kernel/types/option-names.js';
import type {
  Field,
  FileWithPath,
  Mesh,
  MeshArrays,
  PartialField,
} from '../../../web/src/kernel/types/types.js';
import { longestStart } from '../../../web/src/kernel/page/worker-client.js';
import { FakeWorker, fakeSurface, fakeValue, type Behaviour } from './fake-worker.js';

const anyArrays: MeshArrays = {
  positions: new Float64Array(9),
  indices: new Uint32Array(3),
};

/** A kernel of fakes; the first single worker is the interactive one. */
async function fakeKernel(behaviour: Behaviour, threads = 3) {
  const workers: FakeWorker[] = [];
  const readers: FakeWorker[] = [];
  const spectral: FakeWorker[] = [];
  const makeFor = (list: FakeWorker[]) => () => {
    const worker = new FakeWorker(behaviour);
    list.push(worker);
    return worker;
  };
  const [single, job] = [makeFor(workers), makeFor(readers)];
  const factory = { single, threads: single, job, studies: makeFor(spectral) };
  const kernel = await openKernel({ threads, mode: 'pool' }, factory);
  return { kernel, workers, readers, spectral };
}

/** A promise with its settling functions. */
function gate() {
  let open!: () => void;
  const opened = new Promise<void>((resolve) => (open = resolve));
  return { open, opened };
}

const codeOf = (promise: Promise<unknown>) =>
  promise.then(
    () => 'resolved',
    (error: unknown) =>
      error instanceof GirthError ? error.code : `not a GirthError: ${String(error)}`,
  );

afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

describe('errors', () => {
  test('the remedies are those of the one table', () => {
    const table = readFileSync(
      new URL('../../../cpp/include/girth/error_codes.def', import.meta.url),
      'utf8',
    );
    for (const [code, hint] of Object.entries(hints)) {
      expect(table).toMatch(new RegExp(`"${code}", \\d, "${hint}"`));
    }
  });

  test('running out of memory is recognised in its several wordings', () => {
    for (const text of [
      'Out of memory',
      'Array buffer allocation failed',
      'could not allocate memory',
    ]) {
      expect(fieldsOf(new RangeError(text)).code).toBe('OUT_OF_MEMORY');
    }
    expect(fieldsOf(new Error('memory access out of bounds')).code).toBe('INTERNAL');
  });
});

describe('chunks', () => {
  test('follow the speed, and become small towards the end', () => {
    expect(chunkSize(undefined, 1000, 4)).toBe(4);
    expect(chunkSize(undefined, 1, 4)).toBe(1);
    expect(chunkSize(5, 10000, 4)).toBe(200);
    expect(chunkSize(5, 400, 4)).toBe(50);
    // Ten of these are two milliseconds of work.
    expect(chunkSize(5, 40, 4)).toBe(10);
    expect(chunkSize(5, 3, 4)).toBe(3);
    expect(chunkSize(0.001, 1000, 4)).toBe(1);
    expect(chunkSize(5, 1, 4)).toBe(1);
  });
});

describe('a run', () => {
  test('puts reports together that come close together, and ends with 1', () => {
    let now = 0;
    const progress: number[] = [];
    const partials: PartialField[] = [];
    const run = new FieldRun(
      4,
      true,
      { onProgress: (f) => progress.push(f), onPartial: (p) => partials.push(p) },
      () => now,
    );
    const one = (vertex: number) => ({
      vertices: Uint32Array.of(vertex),
      values: Float64Array.of(vertex),
      kinds: Uint8Array.of(0),
    });
    run.add(one(2));
    now = 10;
    run.add(one(0));
    now = 100;
    run.add(one(3));
    now = 101;
    run.add(one(1));
    expect(partials.map((p) => [...p.vertices])).toEqual([[2], [0, 3], [1]]);
    expect(progress).toEqual([0.25, 0.75, 1]);
    expect(summaryOf(run.values)).toEqual({ range: [0, 3], withoutValue: 0 });
  });

  test('missing values count, and are not in the range', () => {
    const partials: PartialField[] = [];
    const run = new FieldRun(3, false, { onPartial: (p) => partials.push(p) }, () => 0);
    const none = new Uint8Array(0);
    run.add({ vertices: Uint32Array.of(1), values: Float64Array.of(NaN), kinds: none });
    expect(summaryOf(run.values)).toEqual({ range: [NaN, NaN], withoutValue: 3 });
    run.add({ vertices: Uint32Array.of(0), values: Float64Array.of(2), kinds: none });
    run.add({ vertices: Uint32Array.of(2), values: Float64Array.of(5), kinds: none });
    expect(summaryOf(run.values)).toEqual({ range: [2, 5], withoutValue: 1 });
    expect(run.kinds).toHaveLength(0);
    expect(partials.map((p) => [[...p.vertices], [...p.kinds]])).toEqual([
      [[1], []],
      [[0, 2], []],
    ]);
  });
});

describe('a field by a pool', () => {
  test('has every value, each reported once, coarse to fine', async () => {
    const { kernel, workers } = await fakeKernel(fakeSurface(1000));
    const mesh = await kernel.load(anyArrays);
    const progress: number[] = [];
    const seen: number[] = [];
    const field = await mesh.field('igf', {
      onProgress: (f) => progress.push(f),
      onPartial: (p) => {
        p.vertices.forEach((v, i) => expect(p.values[i]).toBe(fakeValue(v)));
        seen.push(...p.vertices);
      },
    });
    expect([...field.values]).toEqual(Array.from({ length: 1000 }, (_, v) => fakeValue(v)));
    expect(field.kinds[3]).toBe(1);
    expect(field.range).toEqual([fakeValue(0), fakeValue(999)]);
    expect(field.unit).toBe('metre');
    expect([...seen].sort((a, b) => a - b)).toEqual(Array.from({ length: 1000 }, (_, v) => v));
    expect(seen[0]! % 2).toBe(0);
    expect(progress).toEqual([...progress].sort((a, b) => a - b));
    expect(progress.at(-1)).toBe(1);
    // All but the interactive worker share the work; each gets the mesh once.
    for (const worker of workers.slice(1)) {
      expect(worker.operations.filter((name) => name === 'adopt')).toHaveLength(1);
      expect(worker.operations).toContain('values');
    }
    expect(workers[0]!.operations).not.toContain('values');
  });

  test('is cancelled at once, and the workers get no more chunks', async () => {
    const chunk = gate();
    const surface = fakeSurface(1000);
    const { kernel, workers } = await fakeKernel(async (request, report) => {
      if (request.operation === 'values') await chunk.opened;
      return surface(request, report);
    });
    const mesh = await kernel.load(anyArrays);
    const controller = new AbortController();
    const field = codeOf(mesh.field('igf', { signal: controller.signal }));
    await vi.waitFor(() => expect(workers[1]!.operations).toContain('values'));
    controller.abort();
    expect(await field).toBe('CANCELLED');
    const second = mesh.field('igf');
    const handedOut = workers.map(({ operations }) => operations.length);
    await new Promise((resolve) => setTimeout(resolve, 20));
    expect(workers.map(({ operations }) => operations.length)).toEqual(handedOut);
    chunk.open();
    expect((await second).values[7]).toBe(fakeValue(7));
  });

  test('pauses for an urgent one, and goes on where it stopped', async () => {
    const surface = fakeSurface(1000);
    const asked: { name: string; vertices: Uint32Array }[] = [];
    const seen: number[] = [];
    let knownBefore: Set<number> | undefined;
    const some = gate();
    const { kernel } = await fakeKernel(async (request, report) => {
      const { field, vertices } = request.arguments as {
        field: { name: string };
        vertices: Uint32Array;
      };
      if (request.operation === 'values') {
        asked.push({ name: field.name, vertices });
        if (field.name === 'thickness') knownBefore ??= new Set(seen);
        // Longer than a report takes, so that some are known when the urgent one comes.
        if (field.name === 'igf' && asked.length > 5) await some.opened;
      }
      return surface(request, report);
    });
    const mesh = await kernel.load(anyArrays);
    const ended: string[] = [];
    const girth = mesh.field('igf', { onPartial: ({ vertices }) => seen.push(...vertices) });
    void girth.then(() => ended.push('igf'));
    await vi.waitFor(() => expect(asked.length).toBeGreaterThan(6));
    const thickness = mesh.field('thickness', { urgent: true });
    void thickness.then(() => ended.push('thickness'));
    some.open();
    expect((await thickness).values[7]).toBeCloseTo(1 / 7);
    expect((await girth).values).toEqual(
      Float64Array.from({ length: 1000 }, (_, v) => fakeValue(v)),
    );
    expect(ended).toEqual(['thickness', 'igf']);
    expect(new Set(seen).size).toBe(1000);
    expect(seen).toHaveLength(1000);
    const names = asked.map(({ name }) => name);
    expect(names.lastIndexOf('igf')).toBeGreaterThan(names.lastIndexOf('thickness'));
    const later = asked.slice(names.indexOf('thickness')).filter(({ name }) => name === 'igf');
    expect(knownBefore?.size).toBeGreaterThan(0);
    const askedAgain = later.flatMap(({ vertices }) => [...vertices]);
    expect(askedAgain.filter((v) => knownBefore?.has(v))).toEqual([]);
    kernel.dispose();
  });

  test('is rejected as a fetch is, with the reason of the signal', async () => {
    const never = new Promise<object>(() => undefined);
    const surface = fakeSurface(10);
    const { kernel } = await fakeKernel((request, report) =>
      request.operation === 'values' ? never : surface(request, report),
    );
    const mesh = await kernel.load(anyArrays);
    const reason = new Error('the user has gone on');
    const controller = new AbortController();
    const field = mesh.field('igf', { signal: controller.signal });
    controller.abort(reason);
    await expect(field).rejects.toMatchObject({
      name: 'AbortError',
      code: 'CANCELLED',
      cause: reason,
    });
    await expect(field).rejects.toBeInstanceOf(GirthError);
    kernel.dispose();
  });

  test('a worker that does not come back from a cancelled chunk is replaced', async () => {
    let stuck = true;
    const surface = fakeSurface(100);
    const { kernel, workers } = await fakeKernel((request, report) => {
      if (request.operation === 'values' && stuck) return new Promise<object>(() => undefined);
      return surface(request, report);
    }, 1);
    const mesh = await kernel.load(anyArrays);
    const controller = new AbortController();
    const field = codeOf(mesh.field('igf', { signal: controller.signal }));
    await vi.waitFor(() => expect(workers[1]!.operations).toContain('values'));
    stuck = false;
    controller.abort();
    expect(await field).toBe('CANCELLED');
    expect((await mesh.field('igf')).values[7]).toBe(fakeValue(7));
    expect(workers.map(({ terminated }) => terminated)).toEqual([false, true, false]);
  });

  test('ends with CANCELLED when its mesh or its kernel is disposed of', async () => {
    const never = new Promise<object>(() => undefined);
    const surface = fakeSurface(10);
    const { kernel, workers } = await fakeKernel((request, report) =>
      request.operation === 'values' ? never : surface(request, report),
    );
    const mesh = await kernel.load(anyArrays);
    const other = await kernel.load(anyArrays);
    const [first, second] = [codeOf(mesh.field('igf')), codeOf(other.field('igf'))];
    mesh.dispose();
    expect(await first).toBe('CANCELLED');
    kernel.dispose();
    expect(await second).toBe('CANCELLED');
    expect(workers.every(({ terminated }) => terminated)).toBe(true);
    expect(await codeOf(kernel.load(anyArrays))).toBe('CANCELLED');
    expect(await codeOf(mesh.loop(0))).toBe('CANCELLED');
  });

  test('the end of a block disposes of what it uses', async () => {
    const surface = fakeSurface(10);
    const { kernel } = await fakeKernel((request, report) =>
      request.operation === 'values'
        ? new Promise<object>(() => undefined)
        : surface(request, report),
    );
    const mesh = await kernel.load(anyArrays);
    const field = codeOf(mesh.field('igf'));
    mesh[Symbol.dispose]();
    expect(await field).toBe('CANCELLED');
    kernel[Symbol.dispose]();
    expect(await codeOf(kernel.load(anyArrays))).toBe('CANCELLED');
  });

  test('fails with its code when a worker crashes, and the next one uses a new worker', async () => {
    let crashes = true;
    const surface = fakeSurface(100);
    const { kernel, workers } = await fakeKernel((request, report) => {
      if (request.operation === 'values' && crashes) throw new Error('unreachable executed');
      return surface(request, report);
    }, 2);
    const mesh = await kernel.load(anyArrays);
    expect(await codeOf(mesh.field('igf'))).toBe('INTERNAL');
    crashes = false;
    expect((await mesh.field('igf')).values[9]).toBe(fakeValue(9));
    expect(workers.filter(({ terminated }) => terminated).length).toBeGreaterThan(0);
  });
});

describe('fields', () => {
  test('have a unit, a method and a note; missing values are NaN', async () => {
    const { kernel } = await fakeKernel(fakeSurface(20));
    const mesh = await kernel.load(anyArrays);
    const sdf = await mesh.field('sdf');
    expect(sdf).toMatchObject({
      name: 'sdf',
      range: [1 / 19, 1],
      unit: 'metre',
      method: 'sdf by fakes',
      withoutValue: 1,
      note: 'some are missing',
    });
    expect(sdf.kinds).toHaveLength(0);
    expect(await mesh.field('angle')).toMatchObject({ name: 'angle', unit: 'radian' });
    expect(await mesh.field('igf')).toMatchObject({ withoutValue: 0, note: '', unit: 'metre' });
  });

  test('what was asked for reaches the workers; what was not, is left to C++', async () => {
    const asked: object[] = [];
    const surface = fakeSurface(1);
    const { kernel } = await fakeKernel((request, report) => {
      if (request.operation === 'values') {
        asked.push((request.arguments as { field: object }).field);
      }
      return surface(request, report);
    });
    const mesh = await kernel.load(anyArrays);
    await mesh.field('sdf', { sdf: { rays: 7 } });
    await mesh.field('thickness', { thickness: { sharpRadians: 1 } });
    await mesh.field('geofarthest', { distances: 'exact' });
    expect(asked).toEqual([
      { name: 'sdf', 'sdf.rays': 7 },
      { name: 'thickness', 'thickness.sharpRadians': 1 },
      { name: 'geofarthest', distances: 'exact' },
    ]);
    for (const name of ['toString', 'girth', ''] as unknown as 'igf'[]) {
      expect(await codeOf(mesh.field(name))).toBe('USAGE');
    }
  });

  test('of another mesh, or another field, are refused; nothing is asked of a worker', async () => {
    const { kernel, readers } = await fakeKernel(fakeSurface(20));
    const mesh = await kernel.load(anyArrays);
    const [igf, sdf] = [await mesh.field('igf'), await mesh.field('sdf')];
    const short = { ...igf, values: igf.values.slice(1) };
    const thresholds = { girth: 1, shapeDiameter: 1 };
    const limits = { tubeDiameter: 1, wallThickness: 1 };
    const before = readers[0]!.operations.length;
    for (const refused of [
      mesh.tips(sdf),
      mesh.tips(short),
      mesh.suggestedThresholds(igf, igf),
      mesh.parts(sdf, igf, thresholds),
      mesh.parts(short, sdf, thresholds),
      mesh.printCheck({ igf, thickness: sdf }, limits),
      mesh.printCheck({ igf }, limits),
      mesh.printCheck({ igf: short }, { tubeDiameter: 1, wallThickness: 0 }),
      mesh.exportField(short, 'csv'),
      mesh.exportFields([igf, { ...sdf, kinds: new Uint8Array(3) }], 'csv'),
      mesh.exportTips(sdf, 'json'),
      mesh.exportParts(igf, igf, thresholds, 'json'),
      mesh.exportWeakPlaces({ igf: sdf }, limits, 'json'),
    ]) {
      expect(await codeOf(refused)).toBe('USAGE');
    }
    expect(readers[0]!.operations).toHaveLength(before);
  });

  test('are written in the unit that is said; other units stay', async () => {
    const written: object[] = [];
    const surface = fakeSurface(4);
    const { kernel } = await fakeKernel((request, report) => {
      if (request.operation === 'writeFields') {
        const { model, named, format } = request.arguments as {
          model: { unit: string };
          named: { name: string; unit: string; method: string; kinds: Uint8Array }[];
          format: string;
        };
        const fields = named.map(({ name, unit, kinds }) => [name, unit, kinds.length]);
        written.push([model.unit, ...fields, format]);
      }
      return surface(request, report);
    });
    const mesh = await kernel.load(anyArrays);
    const [igf, angle] = [await mesh.field('igf'), await mesh.field('angle')];
    const part = { name: 'part', values: new Float64Array(4), unit: '' };
    await mesh.exportField(igf, 'csv');
    await mesh.exportField({ ...igf, unit: 'mm' }, 'npy');
    await mesh.exportField(angle, 'glb');
    await mesh.exportFields([igf, angle, part], 'ply', { unit: 'in' });
    await mesh.exportField(await mesh.field('hks'), 'csv');
    expect(written).toEqual([
      ['metre', ['igf', 'metre', 4], 'csv'],
      ['millimetre', ['igf', 'millimetre', 4], 'npy'],
      ['metre', ['angle', 'radian', 0], 'glb'],
      ['inch', ['igf', 'inch', 4], ['angle', 'radian', 0], ['part', '', 0], 'ply'],
      ['metre', ['hks', 'metre^-2', 0], 'csv'],
    ]);
  });
});

test('a result is written without being found again, with what files state besides', async () => {
  const written: object[] = [];
  const surface = fakeSurface(4);
  const { kernel, readers } = await fakeKernel((request, report) => {
    if (request.operation === 'writeFound') written.push(request.arguments);
    return surface(request, report);
  });
  const mesh = await kernel.load(anyArrays);
  const [igf, sdf] = [await mesh.field('igf', { persistence: 0.5 }), await mesh.field('sdf')];
  const [tips, thresholds] = [await mesh.tips(igf), { girth: 1, shapeDiameter: 2 }];
  const parts = await mesh.parts(igf, sdf, thresholds);
  const before = readers[0]!.operations.length;
  await mesh.write(tips, 'obj', { unit: 'mm' });
  await mesh.write(parts, 'json');
  expect(readers[0]!.operations.slice(before)).toEqual(['writeFound', 'writeFound']);
  expect(written).toMatchObject([
    { model: { unit: 'millimetre', persistence: 0.5 }, found: { kind: 'tips' }, format: 'obj' },
    { model: { unit: 'metre' }, found: { kind: 'parts', options: thresholds }, format: 'json' },
  ]);
  expect(await codeOf(mesh.write({ ...parts }, 'json'))).toBe('USAGE');
});

describe('spectral fields', () => {
  test('come from a worker that starts when it is needed, and keeps what it has', async () => {
    const { kernel, spectral } = await fakeKernel(fakeSurface(20));
    const mesh = await kernel.load(anyArrays);
    await mesh.field('igf');
    expect(spectral).toHaveLength(0);
    const progress: number[] = [];
    const [hks, maxima] = await Promise.all([
      mesh.field('hks', { onProgress: (f) => progress.push(f) }),
      mesh.heatMaxima(),
    ]);
    expect(hks).toMatchObject({
      name: 'hks',
      unit: 'metre^-2',
      method: 'by fakes',
      withoutValue: 0,
    });
    expect(hks.range).toEqual([fakeValue(0), fakeValue(19)]);
    expect(progress).toEqual([0.5, 1]);
    expect(maxima).toHaveLength(1);
    expect(await mesh.field('sihks')).toMatchObject({ unit: '' });
    expect(spectral.map(({ operations }) => operations)).toEqual([
      ['start', 'adopt', 'spectralField', 'heatMaxima', 'spectralField'],
    ]);
  });

  test('are cancelled by ending the worker; a disposed mesh leaves none behind', async () => {
    let stuck = true;
    const surface = fakeSurface(20);
    const { kernel, spectral } = await fakeKernel((request, report) =>
      request.operation === 'spectralField' && stuck
        ? new Promise<object>(() => undefined)
        : surface(request, report),
    );
    const mesh = await kernel.load(anyArrays);
    const other = await kernel.load(anyArrays);
    const controller = new AbortController();
    const field = codeOf(mesh.field('wks', { signal: controller.signal }));
    await vi.waitFor(() => expect(spectral[0]!.operations).toContain('spectralField'));
    controller.abort();
    expect(await field).toBe('CANCELLED');
    stuck = false;
    await mesh.field('wks');
    expect(spectral.map(({ terminated }) => terminated)).toEqual([true, false]);
    other.dispose();
    expect(spectral[1]!.terminated).toBe(false);
    mesh.dispose();
    expect(spectral[1]!.terminated).toBe(true);
    expect(await codeOf(mesh.field('wks'))).toBe('CANCELLED');
  });

  test('what was asked for reaches the worker; what was not, is left to C++', async () => {
    const asked: object[] = [];
    const surface = fakeSurface(5);
    const { kernel } = await fakeKernel((request, report) => {
      if (/spectralField|heatMaxima/.test(request.operation)) {
        asked.push((request.arguments as { signature: object }).signature);
      }
      return surface(request, report);
    });
    const mesh = await kernel.load(anyArrays);
    await mesh.field('hks', { spectral: { time: 0.01 } });
    await mesh.field('wks', { spectral: { pairs: 50, component: 7 } });
    await mesh.field('wks');
    await mesh.field('sihks');
    await mesh.heatMaxima({ time: 0.03 });
    expect(asked).toEqual([
      { name: 'hks', time: 0.01 },
      { name: 'wks', pairs: 50, component: 7 },
      { name: 'wks' },
      { name: 'sihks' },
      { name: 'hks', time: 0.03 },
    ]);
  });

  test('maxima of any field of the mesh', async () => {
    const asked: object[] = [];
    const surface = fakeSurface(5);
    const { kernel } = await fakeKernel((request, report) => {
      if (request.operation === 'maxima') asked.push(request.arguments);
      return surface(request, report);
    });
    const mesh = await kernel.load(anyArrays);
    const values = Float64Array.of(1, 2, 3, 4, 5);
    expect(await mesh.maxima({ name: 'a', values, unit: '' }, { minima: true })).toHaveLength(1);
    expect(asked).toMatchObject([{ values, minima: true }]);
    const few = { name: 'a', values: values.slice(1), unit: '' };
    expect(await codeOf(mesh.maxima(few))).toBe('USAGE');
  });
});

describe('comparing shapes', () => {
  /** Fakes whose shapes are as far apart as their vertex counts; `broken` faces fail. */
  const comparing = (asked: object[], broken = -1): Behaviour => {
    const vertexCounts = new Map<number, number>();
    return (request, report) => {
      const args = request.arguments as {
        surface: number;
        arrays: { positions: Float64Array };
        group: string;
        faces: number;
        models: { weights: Float64Array }[][];
        descriptors: string[];
      };
      switch (request.operation) {
        case 'take': {
          const { positions } = args.arrays;
          return fakeSurface(positions.length / 3)(request, report);
        }
        case 'adopt':
          vertexCounts.set(args.surface, args.arrays.positions.length / 3);
          return {};
        case 'fieldGroups':
          return { groups: ['igf', 'sdf'] };
        case 'studyFields': {
          const count = vertexCounts.get(args.surface)!;
          asked.push([count, args.group, args.faces]);
          if (count === broken) throw new GirthError({ ...usage, message: 'it is broken' });
          report({ progress: 0.5 });
          return { weights: new Float64Array(count), fields: [] };
        }
        case 'compare': {
          const sizes = args.models.map((groups) => groups[0]!.weights.length);
          const matrix = sizes.flatMap((a) => sizes.map((b) => Math.abs(a - b)));
          return { matrices: args.descriptors.map(() => Float64Array.from(matrix)) };
        }
        default:
          return {};
      }
    };
  };
  const usage = { code: 'USAGE', element: -1, hint: '' };
  const arraysOf = (count: number) => ({
    positions: new Float64Array(3 * count),
    indices: new Uint32Array(3),
  });

  test('every pair, by every descriptor; what is known is not computed again', async () => {
    const asked: object[] = [];
    const { kernel } = await fakeKernel(comparing(asked));
    const meshes = [];
    for (const count of [3, 5, 9]) meshes.push(await kernel.load(arraysOf(count)));
    const progress: number[] = [];
    const descriptors = ['igf', 'igf+sdf'];
    const result = await kernel.compare(meshes, {
      descriptors,
      onProgress: (share) => progress.push(share),
    });
    expect(result.failed).toEqual([]);
    expect(result.matrices.map(({ descriptor }) => descriptor)).toEqual(descriptors);
    expect([...result.matrices[1]!.distances]).toEqual([0, 2, 6, 2, 0, 4, 6, 4, 0]);
    expect(asked).toHaveLength(6);
    expect(asked).toContainEqual([5, 'sdf', 10_000]);
    expect(progress).toEqual([...progress].sort((a, b) => a - b));
    expect(progress.at(-1)).toBe(1);
    await kernel.compare([meshes[2]!, meshes[0]!], { descriptors });
    expect(asked).toHaveLength(6);
    await kernel.compare(meshes.slice(1), { descriptors, faces: 500 });
    expect(asked).toHaveLength(10);
  });

  test('a shape that fails is named, and the others are compared', async () => {
    const { kernel } = await fakeKernel(comparing([], 5));
    const meshes = [];
    for (const count of [3, 5, 9]) meshes.push(await kernel.load(arraysOf(count)));
    const { matrices, failed } = await kernel.compare(meshes, { descriptors: ['igf'] });
    expect(failed).toMatchObject([{ shape: 1, error: { code: 'USAGE', message: 'it is broken' } }]);
    expect([...matrices[0]!.distances]).toEqual([0, NaN, 6, NaN, NaN, NaN, 6, NaN, 0]);
  });

  test('is cancelled by its signal, and when one of the meshes is disposed of', async () => {
    const surface = comparing([]);
    const { kernel, spectral } = await fakeKernel((request, report) =>
      request.operation === 'studyFields'
        ? new Promise<object>(() => undefined)
        : surface(request, report),
    );
    const meshes = [await kernel.load(arraysOf(3)), await kernel.load(arraysOf(5))];
    const controller = new AbortController();
    const { signal } = controller;
    const first = codeOf(kernel.compare(meshes, { descriptors: ['igf'], signal }));
    await vi.waitFor(() => expect(spectral).toHaveLength(2));
    await vi.waitFor(() => expect(spectral[1]!.operations).toContain('studyFields'));
    controller.abort();
    expect(await first).toBe('CANCELLED');
    expect(spectral.every(({ terminated }) => terminated)).toBe(true);
    const second = codeOf(kernel.compare(meshes, { descriptors: ['igf'] }));
    meshes[0]!.dispose();
    expect(await second).toBe('CANCELLED');
    expect(await codeOf(kernel.compare([{}] as never, { descriptors: [] }))).toBe('USAGE');
  });
});

describe('names of options', () => {
  const wrong = (options: object) => options as never;

  test.each([
    [
      'persistance',
      'did you mean persistence?',
      (mesh: Mesh) => mesh.field('igf', wrong({ persistance: 0.1 })),
    ],
    [
      'sdf.ray',
      'did you mean sdf.rays?',
      (mesh: Mesh) => mesh.field('sdf', wrong({ sdf: { ray: 7 } })),
    ],
    [
      'station',
      'did you mean stations?',
      (mesh: Mesh) => mesh.exportLimbs({} as Field, 'csv', wrong({ station: 9 })),
    ],
    [
      'thickness',
      'there are tubeDiameter, wallThickness, gap',
      (mesh: Mesh) => mesh.printCheck({}, wrong({ thickness: 1 })),
    ],
  ] as const)('%s is refused: %s', async (name, hint, call) => {
    const { kernel } = await fakeKernel(fakeSurface(4));
    const mesh = await kernel.load(anyArrays);
    await expect(call(mesh)).rejects.toMatchObject({
      code: 'USAGE',
      message: `there is no option ${name}`,
      hint,
    });
  });

  test('older ones have their effect, with a warning', async () => {
    const warned = vi.spyOn(console, 'warn').mockImplementation(() => undefined);
    const asked: object[] = [];
    const surface = fakeSurface(4);
    const { kernel } = await fakeKernel((request, report) => {
      if (request.operation !== 'load') asked.push(request.arguments);
      return surface(request, report);
    });
    const mesh = await kernel.load(anyArrays);
    const [igf, sdf] = [await mesh.field('igf'), await mesh.field('sdf')];
    const sharp = { sharpAngle: 0.5 };
    await mesh.field('thickness', wrong({ thickness: sharp }));
    expect(asked.at(-1)).toMatchObject({ field: { 'thickness.sharpRadians': 0.5 } });
    expect(warned.mock.lastCall).toEqual([
      'thickness.sharpAngle is the older name of sharpRadians, until 2.0',
    ]);
    expect(sharp).toEqual({ sharpAngle: 0.5 });
    await mesh.parts(igf, sdf, wrong({ girth: 1, thickness: 2 }));
    expect(asked.at(-1)).toMatchObject({ options: { girth: 1, shapeDiameter: 2 } });
  });

  test('older ones of members are read, with one warning each, and are not listed', async () => {
    const warned = vi.spyOn(console, 'warn').mockImplementation(() => undefined);
    const surface = fakeSurface(4);
    const { kernel } = await fakeKernel((request, report) => {
      if (request.operation === 'suggestedThresholds') return { girth: 3, shapeDiameter: 2 };
      if (request.operation !== 'parts') return surface(request, report);
      return { parts: [1, 5].map((medianShapeDiameter) => ({ medianShapeDiameter })) };
    });
    const mesh = await kernel.load(anyArrays);
    const [igf, sdf] = [await mesh.field('igf'), await mesh.field('sdf')];
    const suggested = await mesh.suggestedThresholds(igf, sdf);
    const { parts } = await mesh.parts(igf, sdf, suggested);
    expect(Object.keys(suggested)).toEqual(['girth', 'shapeDiameter']);
    warned.mockClear();
    const older = (found: object, name: string) => (found as Record<string, unknown>)[name];
    expect(older(suggested, 'thickness')).toBe(2);
    expect(parts.map((part) => older(part, 'medianThickness'))).toEqual([1, 5]);
    expect(older(mesh.geometry, 'walls')).toBe(mesh.geometry.boundary);
    const texts = warned.mock.calls.map(([text]) => text as string);
    expect(texts.filter((text) => !text.startsWith('thickness '))).toEqual([
      'medianThickness is the older name of medianShapeDiameter, until 2.0',
      'walls is the older name of boundary, until 2.0',
    ]);
  });

  test('of a kernel, and of its calls', async () => {
    const { kernel } = await fakeKernel(fakeSurface(4));
    const prepare = { weldDistances: 1 };
    await expect(kernel.load(anyArrays, wrong({ prepare }))).rejects.toMatchObject({
      message: 'there is no option prepare.weldDistances',
      hint: 'did you mean prepare.weldDistance?',
    });
    await expect(kernel.compare([], wrong({ descriptor: [] }))).rejects.toMatchObject({
      hint: 'did you mean descriptors?',
    });
    const none = { single: vi.fn(), threads: vi.fn(), job: vi.fn(), studies: vi.fn() };
    await expect(openKernel(wrong({ thread: 2 }), none)).rejects.toMatchObject({
      hint: 'did you mean threads?',
    });
    expect(none.job).not.toHaveBeenCalled();
  });

  test('a kernel that is given no model says which it takes', async () => {
    const { kernel, readers } = await fakeKernel(fakeSurface(4));
    for (const nothing of [undefined, null, 5, {}, { positions: new Float64Array(9) }]) {
      await expect(kernel.load(nothing as never)).rejects.toMatchObject({
        code: 'USAGE',
        hint: expect.stringMatching(/^pass /) as string,
      });
    }
    expect(readers.flatMap(({ operations }) => operations)).not.toContain('take');
  });

  test('the table has every call that takes options', async () => {
    const { kernel } = await fakeKernel(fakeSurface(4));
    const mesh = await kernel.load(anyArrays);
    const calls = mesh as unknown as Record<string, (...args: unknown[]) => Promise<unknown>>;
    for (const [call, places] of Object.entries(callOptionNames.Mesh)) {
      for (const at of Object.keys(places)) {
        const args = Array.from({ length: Number(at) + 1 }, () => ({}));
        args[Number(at)] = { wrongName: 1 };
        await expect(calls[call]!(...args), call).rejects.toMatchObject({
          message: 'there is no option wrongName',
        });
      }
    }
  });
});

describe('loops', () => {
  test('the newest goes first, and aborted ones never run', async () => {
    const asked: number[] = [];
    const first = gate();
    const surface = fakeSurface(100);
    const { kernel } = await fakeKernel(async (request, report) => {
      if (request.operation === 'loop') {
        asked.push((request.arguments as { point: number }).point);
        if (asked.length === 1) await first.opened;
      }
      return surface(request, report);
    });
    const mesh = await kernel.load(anyArrays);
    const stale = new AbortController();
    const loops = [
      mesh.loop(1),
      codeOf(mesh.loop(2, { signal: stale.signal })),
      mesh.loop(3),
      mesh.loop(4),
    ];
    await vi.waitFor(() => expect(asked).toEqual([1]));
    stale.abort();
    expect(await loops[1]).toBe('CANCELLED');
    first.open();
    await Promise.all(loops);
    expect(asked).toEqual([1, 4, 3]);
  });

  test('a loop says its base as it was asked for', async () => {
    const { kernel } = await fakeKernel(fakeSurface(100));
    const mesh = await kernel.load(anyArrays);
    expect((await mesh.loop(7)).base).toBe(7);
    const weights: [number, number, number] = [0.2, 0.3, 0.5];
    const asking = mesh.loop({ face: 30, weights });
    weights[0] = 9;
    expect((await asking).base).toEqual({ face: 30, weights: [0.2, 0.3, 0.5] });
  });

  test('a point that does not exist is refused', async () => {
    const { kernel } = await fakeKernel(fakeSurface(100));
    const mesh = await kernel.load(anyArrays);
    for (const vertex of [-1, 100, 1.5, NaN]) {
      expect(await codeOf(mesh.loop(vertex))).toBe('VERTEX_OUT_OF_RANGE');
    }
    for (const face of [-1, 100, 1.5, NaN]) {
      expect(await codeOf(mesh.loop({ face, weights: [1, 0, 0] }))).toBe('INVALID_POINT');
    }
    expect(await codeOf(mesh.loop({ face: 0, weights: [NaN, 0, 1] }))).toBe('INVALID_POINT');
  });
});

describe('starting and loading', () => {
  test("asking for 'threads' on a page that is not isolated warns once and gives a pool", async () => {
    const warn = vi.spyOn(console, 'warn').mockImplementation(() => undefined);
    const make = () => new FakeWorker(fakeSurface(10));
    const threads = vi.fn(make);
    for (let i = 0; i < 2; ++i) {
      const kernel = await openKernel(
        { mode: 'threads', threads: 2 },
        { single: make, threads, job: make, studies: make },
      );
      expect(kernel.mode).toBe('pool');
    }
    expect(warn).toHaveBeenCalledTimes(1);
    expect(threads).not.toHaveBeenCalled();
  });

  test('threads that cannot be had give a pool', async () => {
    vi.stubGlobal('crossOriginIsolated', true);
    vi.spyOn(console, 'warn').mockImplementation(() => undefined);
    const kernel = await openKernel(
      { threads: 2 },
      {
        single: () => new FakeWorker(fakeSurface(10)),
        job: () => new FakeWorker(fakeSurface(10)),
        studies: () => new FakeWorker(fakeSurface(10)),
        threads: () =>
          new FakeWorker(() => {
            throw new Error('no nested workers');
          }),
      },
    );
    expect(kernel.mode).toBe('pool');
    expect((await (await kernel.load(anyArrays)).field('igf')).values).toHaveLength(10);
  });

  test('a module that does not load fails with a code', async () => {
    const worker = new FakeWorker(() => new Promise<object>(() => undefined));
    const opening = codeOf(
      openKernel(
        { mode: 'pool' },
        {
          single: () => worker,
          threads: () => worker,
          job: () => worker,
          studies: () => worker,
        },
      ),
    );
    worker.crash('');
    expect(await opening).toBe('PROGRAM_NOT_LOADED');
  });

  test('a module that never finishes loading is given up, with a code and a remedy', async () => {
    vi.useFakeTimers();
    const never = () => new FakeWorker(() => new Promise<object>(() => undefined));
    const opening = openKernel(
      { mode: 'pool' },
      { single: never, threads: never, job: never, studies: never },
    );
    const refused = expect(opening).rejects.toMatchObject({
      code: 'PROGRAM_NOT_LOADED',
      hint: expect.stringContaining('.wasm') as string,
    });
    await vi.advanceTimersByTimeAsync(longestStart);
    await refused;
    vi.useRealTimers();
  });

  test('an address that cannot be fetched is named, with a code', async () => {
    const { kernel } = await fakeKernel(fakeSurface(10));
    vi.stubGlobal('fetch', () => Promise.resolve(new Response('', { status: 404 })));
    expect(await codeOf(kernel.load('https://example.org/no.glb'))).toBe('FILE_NOT_FOUND');
    vi.stubGlobal('fetch', () => Promise.resolve(new Response('', { status: 403 })));
    expect(await codeOf(kernel.load('https://example.org/no.glb'))).toBe('FILE_UNREADABLE');
    vi.stubGlobal('fetch', () => Promise.reject(new TypeError('network')));
    await expect(kernel.load('https://example.org/no.glb')).rejects.toThrow(
      'https://example.org/no.glb',
    );
  });

  test("the caller's bytes stay the caller's; files keep their names and paths", async () => {
    const names: string[] = [];
    const surface = fakeSurface(10);
    const { kernel } = await fakeKernel((request, report) => {
      if (request.operation === 'read') {
        const { files, address } = request.arguments as { files: FileWithPath[]; address?: string };
        names.push([...files.map(({ path }) => path), ...(address ? [address] : [])].join());
      }
      return surface(request, report);
    });
    const bytes = new ArrayBuffer(8);
    await kernel.load({ bytes, name: 'a.obj' });
    expect(bytes.byteLength).toBe(8);
    await kernel.load(new Blob(['x']));
    vi.stubGlobal('fetch', () => Promise.resolve(new Response('x')));
    const address = 'https://example.org/m/a%20cup.glb?v=2';
    await kernel.load(new URL(address));
    const inFolder = Object.assign(new File(['x'], 'c.bin'), { webkitRelativePath: 'b/c.bin' });
    await kernel.load([new File(['x'], 'c.gltf'), inFolder]);
    await kernel.load([{ path: 'd/e.stl', content: new Blob(['x']) }]);
    expect(names).toEqual(['a.obj', 'model', `a cup.glb,${address}`, 'c.gltf,b/c.bin', 'd/e.stl']);
    expect(await codeOf(kernel.load([]))).toBe('FILE_NOT_FOUND');
  });

  test('what is asked of the surface goes along; progress comes back', async () => {
    const asked: object[] = [];
    const surface = fakeSurface(10);
    const { kernel } = await fakeKernel((request, report) => {
      if (request.operation === 'read') {
        asked.push(request.arguments);
        report({ progress: 0.25 });
        report({ progress: 1 });
      }
      return surface(request, report);
    });
    const progress: number[] = [];
    const prepare = { weldDistance: 0.1, closeHoles: true, components: [1] };
    await kernel.load([new File(['x'], 'a.obj')], {
      model: 'a.obj',
      prepare,
      onProgress: (fraction) => progress.push(fraction),
    });
    expect(asked).toMatchObject([{ model: 'a.obj', prepare }]);
    expect(progress).toEqual([0.25, 1]);
  });

  test('cancelled, the worker that reads is ended; others read on', async () => {
    const surface = fakeSurface(10);
    const { kernel, readers } = await fakeKernel((request, report) =>
      request.operation === 'read' &&
      (request.arguments as { files: FileWithPath[] }).files[0]!.path === 'endless.obj'
        ? new Promise<object>(() => undefined)
        : surface(request, report),
    );
    const controller = new AbortController();
    const { signal } = controller;
    const endless = codeOf(kernel.load(new File(['x'], 'endless.obj'), { signal }));
    await vi.waitFor(() => expect(readers[0]!.operations).toContain('read'));
    const other = kernel.load(new File(['x'], 'a.obj'));
    controller.abort();
    expect(await endless).toBe('CANCELLED');
    await other;
    expect(readers.map(({ terminated }) => terminated)).toEqual([true, false]);
    // The one that is left takes the next job.
    await kernel.load(new File(['x'], 'b.obj'));
    expect(readers).toHaveLength(2);
  });

  test('no more than two models are read at a time, the others in their turn', async () => {
    let [reading, most] = [0, 0];
    const surface = fakeSurface(10);
    const { kernel, readers } = await fakeKernel(async (request, report) => {
      if (request.operation === 'read') {
        most = Math.max(most, ++reading);
        await new Promise((resolve) => setTimeout(resolve, 5));
        --reading;
      }
      return surface(request, report);
    });
    await Promise.all(
      Array.from({ length: 7 }, (_, i) => kernel.load(new File(['x'], `${i}.obj`))),
    );
    expect(most).toBe(2);
    expect(readers.filter(({ terminated }) => !terminated)).toHaveLength(1);
  });

  test('a worker that has read much is not kept', async () => {
    const { kernel, readers } = await fakeKernel(fakeSurface(10));
    await kernel.load(new File([new Uint8Array(9 * 2 ** 20)], 'large.stl'));
    await kernel.load(new File(['x'], 'small.stl'));
    expect(readers.map(({ terminated }) => terminated)).toEqual([true, false]);
  });
});
