import { checkWords } from '../../../web/src/element/model/large-girth.js';
import { afterEach, expect, test, vi } from 'vitest';
import { combine as combineBy } from '../../../web/src/element/model/combined-field.js';
import { Fields, type FieldState } from '../../../web/src/element/model/fields.js';
import { failure } from '../../../web/src/kernel/types/errors.js';
import { summaryOf } from '../../../web/src/kernel/page/field-run.js';
import type { GirthMethod } from '../../../web/src/element/attributes/attribute-types.js';
import type { Field, FieldName, FieldOptions, Mesh } from '../../../web/src/kernel/types/types.js';

const vertexCount = 3;
const adjacency = { first: Uint32Array.of(0, 1, 3, 4), neighbours: Uint32Array.of(1, 0, 2, 1) };

/** A mesh whose fields are finished by hand, and what the host was told. */
function drawn(method: GirthMethod = 'exact', persistence = 0) {
  const runs: { name: FieldName; options: FieldOptions; finish: () => void }[] = [];
  const lent: number[][] = [];
  const disposed: string[] = [];
  /** The promise that a whole field waits for. */
  const waiting: { for: Promise<void> | undefined } = { for: undefined };
  /** One on fewer triangles: it has other values. */
  const remeshed = {
    info: { vertexCount: 2, faceCount: 9_998 },
    field: (_: FieldName, options: FieldOptions) => {
      runs.push({ name: 'igf', options, finish: () => undefined });
      return Promise.resolve({ name: 'igf', values: Float64Array.of(5, 6), method: 'exact' });
    },
    carryField: (field: Field) =>
      Promise.resolve({
        ...field,
        values: Float64Array.of(5, 6, 6),
        range: [5, 6],
        note: '',
        method: 'exact on 9998 faces',
      }),
    dispose: () => disposed.push('remeshed'),
  };
  const mesh = {
    info: { vertexCount, faceCount: 400_000 },
    remesh: (faces: number) => {
      disposed.push(`remeshed to ${faces}`);
      return Promise.resolve(remeshed);
    },
    refinedGirth: () => {
      const values = Float64Array.of(1, 2, 3);
      return Promise.resolve({ name: 'igf', values, range: [1, 3], method: 'refined' });
    },
    field: (name: FieldName, options: FieldOptions) =>
      new Promise<Field>((resolve, reject) => {
        const values = Float64Array.of(1, 2, 3);
        const field = { name, values, range: [1, 3], method: 'exact' } as unknown as Field;
        runs.push({ name, options, finish: () => resolve(field) });
        options.signal!.addEventListener('abort', () =>
          reject(Object.assign(new Error('cancelled'), { code: 'CANCELLED' })),
        );
      }),
  } as unknown as Mesh;
  const ended: { name: FieldName; whole: boolean; code: string | undefined }[] = [];
  const fields = new Fields(mesh, adjacency, {
    spectral: (name) => (name === 'hks' ? { time: 0.5 } : undefined),
    persistence: () => persistence,
    method: () => method,
    lent: ({ preview }) => lent.push([...preview!.values]),
    received: ({ preview }, partial) => preview!.receive(partial, () => undefined),
    progressed: () => undefined,
    arriving: () => waiting.for,
    ended: ({ name, field }: FieldState, error) =>
      ended.push({ name, whole: !!field, code: (error as { code?: string } | undefined)?.code }),
  });
  return { fields, runs, ended, lent, disposed, waiting };
}

afterEach(() => vi.unstubAllGlobals());

test('a field is computed once, however often it is asked for', async () => {
  const { fields, runs, ended } = drawn();
  const both = [fields.compute('igf'), fields.compute('igf')];
  expect(runs).toHaveLength(1);
  expect(fields.computing).toBe('igf');
  runs[0]!.finish();
  const [one, other] = await Promise.all(both);
  expect(one).toBe(other);
  expect(await fields.compute('igf')).toBe(one);
  expect(runs).toHaveLength(1);
  expect(fields.shareOf('igf')).toBe(1);
  expect(ended).toEqual([{ name: 'igf', whole: true, code: undefined }]);
});

test('what was cancelled keeps its values and can be computed again', async () => {
  const { fields, runs, ended } = drawn();
  const first = fields.compute('igf');
  runs[0]!.options.onPartial!({
    vertices: Uint32Array.of(1),
    values: Float64Array.of(7),
    kinds: new Uint8Array(1),
  });
  fields.cancel();
  await expect(first).rejects.toThrow('cancelled');
  expect(ended).toEqual([{ name: 'igf', whole: false, code: 'CANCELLED' }]);
  expect(fields.shareOf('igf')).toBeCloseTo(1 / 3);
  expect([...fields.valuesOf('igf')]).toEqual([NaN, 7, NaN]);
  const second = fields.compute('igf');
  runs[1]!.finish();
  expect((await second).values).toHaveLength(vertexCount);
});

test('a whole field counts once its host is ready for it, and is not lost where it is cancelled meanwhile', async () => {
  const { fields, runs, ended, waiting } = drawn();
  let ready = (): void => undefined;
  waiting.for = new Promise((resolve) => (ready = resolve));
  const computed = fields.compute('igf');
  runs[0]!.finish();
  await new Promise((resolve) => setTimeout(resolve));
  expect([fields.wholeOf('igf'), fields.computing, ended]).toEqual([undefined, 'igf', []]);
  fields.cancel();
  ready();
  expect((await computed).values).toHaveLength(vertexCount);
  expect(ended).toEqual([{ name: 'igf', whole: true, code: undefined }]);
});

test('asked for again before the cancelled computation has ended', async () => {
  const { fields, runs, ended } = drawn();
  const first = fields.compute('sdf').catch((error: Error) => error.message);
  fields.cancel();
  const second = fields.compute('sdf');
  expect(await first).toBe('cancelled');
  expect(fields.computing).toBeDefined();
  runs[1]!.finish();
  await second;
  expect(fields.computing).toBeUndefined();
  expect(ended).toEqual([{ name: 'sdf', whole: true, code: undefined }]);
});

test('another number of a signature is computed anew; the one before ends without a word', async () => {
  const { fields, runs, ended } = drawn();
  const first = fields.compute('hks').catch((error: Error) => error.message);
  expect(runs[0]!.options.spectral).toEqual({ time: 0.5 });
  fields.forget('hks');
  expect(await first).toBe('cancelled');
  expect(fields.computing).toBeUndefined();
  const second = fields.compute('hks');
  runs[1]!.finish();
  await second;
  expect(fields.shareOf('hks')).toBe(1);
  fields.forget('hks');
  expect(fields.shareOf('hks')).toBe(0);
  void fields.compute('igf');
  expect(runs[2]!.options.spectral).toBeUndefined();
  expect(ended.filter(({ name }) => name === 'hks').map(({ whole }) => whole)).toEqual([
    false,
    true,
  ]);
});

test('on few triangles: they are let go of, and what was computed on them is known again', async () => {
  const { fields, runs, disposed } = drawn('coarse', 0.5);
  const field = await fields.compute('igf');
  expect([...field.values]).toEqual([5, 6, 6]);
  expect(field).toMatchObject({
    method: 'exact on 9998 faces',
    note: 'computed on 9,998 triangles',
  });
  expect(disposed).toEqual(['remeshed to 10000', 'remeshed']);
  expect(runs.map(({ options }) => options.persistence)).toEqual([0.5]);
  const girth = await fields.girth(new AbortController().signal);
  expect(await fields.girth(new AbortController().signal)).toBe(girth);
  expect(runs.map(({ options }) => options.persistence)).toEqual([0.5, 0]);
});

test('on few triangles: exact values of some vertices are seen meanwhile, where they take no memory of their own', async () => {
  vi.stubGlobal('crossOriginIsolated', true);
  const { fields, runs } = drawn('coarse', 0.5);
  const computing = fields.compute('igf');
  await expect.poll(() => runs).toHaveLength(2);
  const [some] = runs;
  expect(some!.options.persistence).toBe(0.5);
  expect(some!.options.signal!.aborted).toBe(true);
  expect(some!.options.onPartial).toBeDefined();
  expect((await computing).method).toBe('exact on 9998 faces');
});

test('refined: values of few triangles are lent until it is there, and know of persistence', async () => {
  const { fields, lent, ended } = drawn('refined');
  const computing = fields.compute('igf');
  await expect.poll(() => lent).toEqual([[5, 6, 6]]);
  expect([...(await computing).values]).toEqual([1, 2, 3]);
  expect(ended).toEqual([{ name: 'igf', whole: true, code: undefined }]);
  fields.forget('igf');
  expect(await fields.compute('igf')).toBe(await computing);
  expect(lent).toHaveLength(1);
  expect(drawn('refined', 0.5).fields.method).toBe('coarse');
});

test('a field that nobody asked for has no values', () => {
  const { fields } = drawn();
  expect([...fields.valuesOf('angle')]).toEqual([NaN, NaN, NaN]);
  expect(fields.shareOf('angle')).toBe(0);
});

test('two fields in one are computed when they are asked for, and anew when one of them is another', async () => {
  const { fields, runs } = drawn();
  const asked = fields.combine('igf/sdf');
  await expect.poll(() => runs.map(({ name }) => name)).toEqual(['igf', 'sdf']);
  expect(fields.combinedOf('igf/sdf')).toBeUndefined();
  for (const { finish } of runs) finish();
  const made = await asked;
  expect([...made.values]).toEqual([1, 1, 1]);
  expect([...fields.valuesOf('igf/sdf')]).toEqual([1, 1, 1]);
  expect(fields.combinedOf('igf/sdf')).toBe(made);
  expect(await fields.combine('igf/sdf')).toBe(made);
  fields.forget('igf');
  expect(fields.combinedOf('igf/sdf')).toBeUndefined();
  expect([...fields.valuesOf('igf/sdf')]).toEqual([NaN, NaN, NaN]);
  await expect(fields.combine('igf-_heat')).rejects.toMatchObject({ code: 'USAGE' });
});

const combine = (by: 'difference' | 'ratio', first: Field, second: Field) =>
  combineBy(by, first, second, { failure, summaryOf });

test('values of different units have no difference, and nothing is divided by 0', () => {
  const operand = (unit: string, ...values: number[]) =>
    ({ name: 'igf', unit, values: Float64Array.from(values) }) as unknown as Field;
  const [lengths, others] = [operand('m', 3, NaN, 2), operand('m', 1, 1, 0)];
  const difference = combine('difference', lengths, others);
  expect([...difference.values]).toEqual([2, NaN, 2]);
  expect(difference).toMatchObject({ range: [2, 2], withoutValue: 1 });
  expect([...combine('ratio', lengths, others).values]).toEqual([3, NaN, NaN]);
  const refused = () => combine('difference', lengths, operand('K', 1, 1, 1));
  expect(refused).toThrow(/values in m and in K have no difference/);
  expect(combine('difference', lengths, operand('', 1, 1, 1)).range).toEqual([1, 2]);
});

test('carried values are compared with the exact ones that are there', () => {
  const carried = [10, 20, NaN, 31];
  const exact = (pairs: [number, number][]) => checkWords(carried, new Map(pairs));
  expect(exact([])).toBe('');
  expect(exact([[2, 5]])).toBe('');
  expect(exact([[0, 10.1]])).toBe('1 of 1 exact values is within 5%');
  expect(
    exact([
      [0, 10],
      [1, 60],
      [3, NaN],
    ]),
  ).toBe('1 of 2 exact values is within 5%');
});
