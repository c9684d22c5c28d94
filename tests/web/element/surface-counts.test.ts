// Counting on surfaces of known shape.

import { expect, test } from 'vitest';
import { countSurface, vertexAreasOf } from '../../../web/src/element/model/surface-counts.js';
import { arraysOf, beside, box, torus, tube } from '../../browser/meshes.js';

function finished<Answer>(steps: Generator<void, Answer>): Answer {
  for (;;) {
    const step = steps.next();
    if (step.done) return step.value;
  }
}

function counted(obj: string, change = (indices: Uint32Array) => indices) {
  const { positions, indices } = arraysOf(obj);
  return finished(countSurface(Float32Array.from(positions), change(indices)));
}

test('a box, a torus, an open tube, and two boxes', () => {
  const solid = counted(box(3, 2, 1))!;
  expect(solid).toMatchObject({ components: 1, genus: [0], boundaries: [0], edgeCount: 66 });
  expect(solid.area).toBeCloseTo(2 * (3 * 2 + 3 * 1 + 2 * 1), 9);
  expect(solid.size).toEqual([3, 2, 1]);
  expect(counted(torus(12, 8))).toMatchObject({ genus: [1], boundaries: [0] });
  const open = counted(tube(5, 8, 4))!;
  expect(open).toMatchObject({ genus: [0], boundaries: [2] });
  expect(open.boundary).toHaveLength(2 * 16);
  const two = counted(beside(box(1, 1, 1), tube(3, 6, 2), 5))!;
  expect(two).toMatchObject({ components: 2, genus: [0, 0], boundaries: [0, 2] });
  expect(two.parts.map(({ faceCount }) => faceCount)).toEqual([12, 24]);
});

test('areas of vertices add up to that of the surface', () => {
  const { positions, indices } = arraysOf(torus(12, 8));
  const areas = finished(vertexAreasOf(Float32Array.from(positions), indices));
  const sum = areas.reduce((one, other) => one + other);
  expect(sum).toBeCloseTo(counted(torus(12, 8))!.area, 9);
  expect(Math.min(...areas)).toBeGreaterThan(0);
});

test('what would have to be mended is not counted', () => {
  const cube = box(1, 1, 1);
  expect(counted(cube, (indices) => indices.slice(3))).toMatchObject({ boundaries: [1] });
  const turned = (indices: Uint32Array) => {
    const copy = indices.slice();
    [copy[0], copy[1]] = [copy[1]!, copy[0]!];
    return copy;
  };
  expect(counted(cube, turned), 'one face is turned over').toBeUndefined();
  const twice = (indices: Uint32Array) => Uint32Array.of(...indices, ...indices.slice(0, 3));
  expect(counted(cube, twice), 'a face comes twice').toBeUndefined();
  const few = (indices: Uint32Array) => indices.slice(0, 6);
  expect(counted(cube, few), 'vertices are left over').toBeUndefined();
  const flat = (indices: Uint32Array) => Uint32Array.of(...indices, 0, 0, 1);
  expect(counted(cube, flat), 'a face without area').toBeUndefined();
  expect(counted(beside(cube, cube, 0)), 'vertices lie on each other').toBeUndefined();
  // Two boxes that touch in one vertex.
  const { positions, indices } = arraysOf(beside(cube, cube, 5));
  const touching = indices.map((vertex) => (vertex === 8 ? 0 : vertex));
  const moved = Float32Array.from(positions);
  const last = moved.length / 3 - 1;
  moved.copyWithin(3 * 8, 3 * last);
  const joined = touching.map((vertex) => (vertex === last ? 8 : vertex));
  expect(
    finished(countSurface(moved.slice(0, -3), joined)),
    'parts touch in a vertex',
  ).toBeUndefined();
});
