import { expect, test } from 'vitest';
import { splitCreases } from '../../../web/src/view/creases.js';
import { boxes } from './boxes.js';
import { torus } from './torus.js';

function finish<Result>(work: Generator<void, Result>): Result {
  for (;;) {
    const step = work.next();
    if (step.done) return step.value;
  }
}

/** A cube of side 2 about the origin. */
const cube = boxes([
  [-1, -1, -1],
  [1, 1, 1],
]);

test('a cube keeps its creases: three normals at each corner, each of one side', () => {
  const { positions, indices } = cube;
  const surface = finish(splitCreases(positions, indices, 0.7));
  expect(surface.positions).toHaveLength(3 * 24);
  expect(surface.copyOf).toHaveLength(16);
  surface.copyOf.forEach((vertex, i) => {
    expect(surface.positions.subarray(3 * (8 + i), 3 * (9 + i))).toEqual(
      positions.subarray(3 * vertex, 3 * vertex + 3),
    );
  });
  for (let i = 0; i < surface.normals.length; i += 3) {
    const sorted = [...surface.normals.subarray(i, i + 3)].map(Math.abs).sort((a, b) => a - b);
    expect(sorted[2]).toBeCloseTo(1, 6);
    expect(sorted[1]).toBeCloseTo(0, 6);
  }
});

test('with a wide angle the cube is smooth, its normals point outwards from its middle', () => {
  const { positions, indices } = cube;
  const surface = finish(splitCreases(positions, indices, 2));
  expect(surface.copyOf).toHaveLength(0);
  for (let i = 0; i < 24; ++i) {
    expect(surface.normals[i]).toBeCloseTo(positions[i]! / Math.sqrt(3), 6);
  }
});

test('a fine torus has no creases and its faces stay where they are', () => {
  const { positions, indices } = torus(60, 30);
  const surface = finish(splitCreases(positions, indices, 0.66));
  expect(surface.copyOf).toHaveLength(0);
  expect(surface.indices).toEqual(indices);
});

test('round a vertex of many faces, and beside a boundary, soft edges stay soft', () => {
  // A flat fan of 40 faces with one gap: one vertex, one normal.
  const count = 40;
  const angles = Array.from({ length: count + 1 }, (_, i) => (1.9 * Math.PI * i) / count);
  const positions = Float32Array.from([
    0,
    0,
    0,
    ...angles.flatMap((angle) => [Math.cos(angle), Math.sin(angle), 0]),
  ]);
  const indices = Uint32Array.from(
    Array.from({ length: count }, (_, i) => [0, i + 1, i + 2]).flat(),
  );
  const surface = finish(splitCreases(positions, indices, 0.6));
  expect(surface.copyOf).toHaveLength(0);
  for (let v = 0; v < count + 2; ++v) expect(surface.normals[3 * v + 2]).toBeCloseTo(1, 6);
});
