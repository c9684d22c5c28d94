import { strToU8, unzipSync, zipSync } from 'fflate';
import { expect, test } from 'vitest';
import {
  type Project,
  type Results,
  readProject,
  surfaceKey,
  writeProject,
} from '../../../web/app/model/project-file.js';
import { spectralIn } from '../../../web/app/state/address-state.js';
import type { Field, Loop, MeshGeometry, RefinedGirth } from '../../../web/src/kernel/index.js';

const geometry: MeshGeometry = {
  positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
  indices: Uint32Array.of(0, 1, 2),
  boundary: new Uint32Array(),
  origin: [0, 0, 0],
};
const igf: Field = {
  name: 'igf',
  values: Float64Array.of(0.1, NaN, 1 / 3),
  kinds: Uint8Array.of(0, 2, 1),
  range: [0.1, 1 / 3],
  withoutValue: 1,
  unit: 'metre',
  method: 'exact',
  note: 'a note',
  persistence: 0.02,
};
const loop: Loop = {
  length: Math.PI,
  kind: 'antipodal',
  base: { face: 0, weights: [0.5, 0.25, 0.25] },
  points: [],
  polyline: Float32Array.of(0, 0, 0, 0.1, 0.2, 0.3),
  midpoint: [0.1, 0.2, 0.3],
  angle: NaN,
  unit: 'metre',
};
const project: Project = {
  name: 'tri.obj',
  files: [{ path: 'tri.obj', content: new Blob(['v 0 0 0']) }],
  model: undefined,
  state: { model: 'chair', field: 'igf-sdf', section: 'x 40%', loops: [loop.base], panel: 'tips' },
};
const results: Results = { fields: [igf], loops: [loop] };
const written = () => writeProject(project, geometry, results);

/** A project with entries of it changed; undefined takes one away. */
async function changed(entries: Record<string, Uint8Array | undefined>): Promise<Uint8Array> {
  const all = { ...unzipSync(await written()), ...entries };
  const kept = Object.entries(all).filter((entry): entry is [string, Uint8Array] => !!entry[1]);
  return zipSync(Object.fromEntries(kept));
}

/** With members of its manifest changed. */
async function manifest(members: Record<string, unknown>): Promise<Uint8Array> {
  const name = 'girth-project.json';
  const before = JSON.parse(new TextDecoder().decode(unzipSync(await written())[name])) as object;
  return changed({ [name]: strToU8(JSON.stringify({ ...before, ...members })) });
}

test('a project is read as it was written, to the bit', async () => {
  const read = readProject(await written())!;
  expect(read.name).toBe('tri.obj');
  expect(read.model).toBeUndefined();
  // The file is in it: no link is needed.
  const { model, ...shown } = project.state;
  expect(model).toBe('chair');
  expect(read.state).toEqual({ ...shown, file: 'tri.obj' });
  expect(read.files.map(({ path }) => path)).toEqual(['tri.obj']);
  expect(await read.files[0]!.content.text()).toBe('v 0 0 0');
  expect(read.resultsFor(geometry)).toEqual(results);
});

test('units of older projects, which are symbols, become names', async () => {
  const older = { fields: [{ ...igf, unit: '1/m²' }], loops: [{ ...loop, unit: 'm' }] };
  const read = readProject(await writeProject(project, geometry, older))!.resultsFor(geometry)!;
  expect([read.fields[0]!.unit, read.loops[0]!.unit]).toEqual(['metre^-2', 'metre']);
});

test('a refined girth keeps its states and its audit; states that are invalid are refused', async () => {
  const audit = {
    ...{ vertices: 200, equal: 198, atLeast: 0.96, atMost: 0.997, median: 0 },
    ...{ percentile95: 0, greatest: 0.05 },
  };
  const states = Uint8Array.of(0, 2, 1);
  const faces = { coarseFaces: 9_998, leanFaces: 50_084 };
  const refined: RefinedGirth = { ...igf, method: 'refined', states, audit, ...faces };
  const all = await writeProject(project, geometry, { fields: [refined], loops: [] });
  expect(readProject(all)!.resultsFor(geometry)!.fields).toEqual([refined]);
  const wrong = { ...unzipSync(all), 'results/igf-states.u8': Uint8Array.of(0, 3, 1) };
  const read = readProject(zipSync(wrong))!;
  expect(() => read.resultsFor(geometry)).toThrow('a state is invalid');
});

test('results are those of one surface, and of no other', async () => {
  const read = readProject(await written())!;
  const positions = geometry.positions.slice();
  positions[4] = 1e-7;
  expect(surfaceKey({ ...geometry, positions })).not.toBe(surfaceKey(geometry));
  expect(read.resultsFor({ ...geometry, positions })).toBeUndefined();
  expect(read.resultsFor({ ...geometry, indices: Uint32Array.of(0, 2, 1) })).toBeUndefined();
});

test('which number of its signature a field was is in the state', () => {
  expect(spectralIn({ time: 0.5, energy: 3 }, 'hks')).toEqual({ time: 0.5 });
  expect(spectralIn({ time: 0.5, energy: 3 }, 'wks')).toEqual({ component: 3 });
  expect(spectralIn({ time: 0.5 }, 'sihks')).toBeUndefined();
  expect(spectralIn({ time: 0.5 }, 'igf')).toBeUndefined();
});

test('other zips are invalid, and neither is what is no zip', async () => {
  expect(readProject(zipSync({ 'a.obj': strToU8('v 0 0 0') }))).toBeUndefined();
  expect(readProject(strToU8('nothing at all'))).toBeUndefined();
  expect(readProject((await written()).slice(0, 200))).toBeUndefined();
});

test('paths that lead out of it are not there', async () => {
  const read = readProject(
    await changed({
      'model/../../etc/x.obj': strToU8('x'),
      'model/.hidden': strToU8('x'),
      '/model/y.obj': strToU8('x'),
      'model/parts/z.obj': strToU8('x'),
    }),
  )!;
  expect(read.files.map(({ path }) => path).sort()).toEqual(['parts/z.obj', 'tri.obj']);
});

test.each([
  ['no JSON', () => changed({ 'girth-project.json': strToU8('{') }), 'MALFORMED_FILE', /no JSON/],
  ['a list', () => changed({ 'girth-project.json': strToU8('[]') }), 'MALFORMED_FILE', /no object/],
  ['another format', () => manifest({ format: 'x' }), 'MALFORMED_FILE', /is another/],
  ['a newer version', () => manifest({ version: 2 }), 'UNSUPPORTED_FEATURE', /newer version/],
  ['no state', () => manifest({ state: 3 }), 'MALFORMED_FILE', /state is no text/],
  ['no fields', () => manifest({ fields: {} }), 'MALFORMED_FILE', /fields is no list/],
  ['no model', () => changed({ 'model/tri.obj': undefined }), 'MALFORMED_FILE', /no model/],
])('%s is refused, with what helps', async (_, made, code, message) => {
  const archive = await made();
  expect(() => readProject(archive)).toThrow(
    expect.objectContaining({
      code,
      message: expect.stringMatching(message) as string,
      hint: expect.stringMatching(/save the project again|reload/) as string,
    }),
  );
});

test.each([
  ['values of another number', () => changed({ 'results/igf.f64': new Uint8Array(16) }), /size/],
  ['no values', () => changed({ 'results/igf.f64': undefined }), /size/],
  ['no numbers', () => changed({ 'results/igf.f64': infinite() }), /are invalid/],
  ['no kinds', () => changed({ 'results/igf-kinds.u8': Uint8Array.of(0, 3, 1) }), /are invalid/],
  ['no field', () => manifest({ fields: [{ name: '../igf' }] }), /no field/],
  ['half a loop', () => manifest({ loops: [{ base: '3' }] }), /midpoint is no list/],
])('results with %s are refused', async (_, made, message) => {
  const read = readProject(await made())!;
  expect(() => read.resultsFor(geometry)).toThrow(
    expect.objectContaining({
      code: 'MALFORMED_FILE',
      message: expect.stringMatching(message) as string,
    }),
  );
});

function infinite(): Uint8Array {
  return new Uint8Array(Float64Array.of(1, Infinity, 2).buffer);
}
