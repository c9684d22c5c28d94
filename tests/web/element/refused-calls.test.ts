// Meshes without a kernel: what takes one is refused, whatever it is called.

import { expect, test } from 'vitest';
import { refusedCalls } from '../../../web/src/element/attributes/refused-calls.js';
import { shownMesh } from '../../../web/src/element/model/shown-mesh.js';
import { MeshOfWorkers } from '../../../web/src/kernel/page/mesh.js';

const mesh = shownMesh({
  ...{ name: 'points', unit: 'metre', origin: [0, 0, 0], size: [1, 1, 0], area: 0.5 },
  positions: new Float32Array(9),
  indices: Uint32Array.of(0, 1, 2),
  boundary: Uint32Array.of(0, 1, 1, 2, 2, 0),
  areas: new Float64Array(3),
  ...{ field: undefined, loops: [] },
});

const known = ['analyse', 'constructor', 'dispose', 'vertexAreas'];
const { prototype } = MeshOfWorkers;
const calls = [prototype, Object.getPrototypeOf(prototype) as object].flatMap((one) =>
  Object.getOwnPropertyNames(one),
);

test.each(calls.filter((name) => !known.includes(name)))('%s is refused', async (name) => {
  const call = mesh[name as 'tips'] as (...given: unknown[]) => Promise<unknown>;
  await expect(call('igf')).rejects.toMatchObject({ code: 'CANCELLED' });
});

test('nothing else pretends to be a call', () => {
  const others = Object.keys(mesh).filter((name) => !calls.includes(name));
  expect(others.filter((name) => typeof mesh[name as 'tips'] === 'function')).toEqual([]);
});

test('members that every mesh answers are not refused, wherever the refusals stand', () => {
  const refused = Object.keys(refusedCalls(() => Promise.reject(new Error('refused'))));
  expect(refused.filter((name) => known.includes(name))).toEqual([]);
});
