// Where on the canvas the surface is.

import { expect, test } from 'vitest';
import { Silhouette } from '../../../web/src/view/silhouette.js';

/** Clip space is the surface's own x and y: −1 to 1 across 100 × 100 CSS pixels. */
const flat = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

function castOf(positions: number[], indices: number[], matrix: readonly number[] = flat) {
  const silhouette = new Silhouette(100, 100, 10);
  const mesh = { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
  silhouette.cast({ ...mesh, matrix }, 100, 100);
  return silhouette;
}

/** The cells as rows of letters. */
const drawn = (silhouette: Silhouette): string[] =>
  Array.from({ length: silhouette.rows }, (_, row) =>
    Array.from({ length: silhouette.columns }, (_, column) =>
      silhouette.shareUnder({ left: 10 * column + 1, top: 10 * row + 1, width: 8, height: 8 }) > 0
        ? '#'
        : '.',
    ).join(''),
  );

test('a large face touches every cell that it covers in part, and no other', () => {
  // From the top left corner to the middle of the right and of the bottom side.
  const positions = [-0.99, 0.99, 0, 0.99, 0.01, 0, 0.01, -0.99, 0];
  expect(drawn(castOf(positions, [0, 1, 2]))).toEqual([
    '##........',
    '####......',
    '.######...',
    '.########.',
    '..########',
    '..########',
    '...######.',
    '...#####..',
    '....###...',
    '....##....',
  ]);
});

test('what is behind the eye or beside the canvas touches nothing', () => {
  const positions = [-0.5, -0.5, 0, 0.5, -0.5, 0, 0, 0.5, 0];
  const behind = [...flat.slice(0, 15), -1];
  expect(
    castOf(positions, [0, 1, 2], behind).shareUnder({ left: 0, top: 0, width: 99, height: 99 }),
  ).toBe(0);
  const beside = [2, 0, 0, 3, 0, 0, 3, 1, 0];
  expect(castOf(beside, [0, 1, 2]).shareUnder({ left: 0, top: 0, width: 99, height: 99 })).toBe(0);
});

test('where there are very many faces, their corners tell', () => {
  const positions: number[] = [];
  for (let i = 0; i < 1000; ++i) positions.push(-1 + i / 500, 0.35, 0);
  const indices = Array.from({ length: 3 * 150_001 }, (_, i) => i % 1000);
  expect(drawn(castOf(positions, indices)).map((row) => row.includes('#'))).toEqual(
    Array.from({ length: 10 }, (_, row) => row === 3),
  );
});

test('shares are exact, and what is outside of the canvas is no room', () => {
  const silhouette = new Silhouette(100, 100, 10);
  silhouette.add({ left: 20, top: 20, width: 19, height: 9 });
  expect(silhouette.shareUnder({ left: 20, top: 20, width: 39, height: 19 })).toBe(2 / 8);
  expect(silhouette.shareUnder({ left: 90, top: 50, width: 19, height: 9 })).toBe(1 / 2);
});
