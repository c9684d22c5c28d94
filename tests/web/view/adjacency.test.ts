import { expect, test } from 'vitest';
import { buildAdjacency, type Adjacency } from '../../../web/src/view/adjacency.js';

function finish<Result>(work: Generator<void, Result>): Result {
  for (;;) {
    const step = work.next();
    if (step.done) return step.value;
  }
}

const neighboursOf = ({ first, neighbours }: Adjacency, vertex: number) =>
  [...neighbours.subarray(first[vertex], first[vertex + 1])].sort((a, b) => a - b);

test('on a square of two triangles, edges of the boundary are edges like any other', () => {
  const boundary = [0, 1, 1, 2, 2, 3, 3, 0];
  const adjacency = finish(buildAdjacency(4, [0, 1, 2, 0, 2, 3], boundary));
  expect([0, 1, 2, 3].map((vertex) => neighboursOf(adjacency, vertex))).toEqual([
    [1, 2, 3],
    [0, 2],
    [0, 1, 3],
    [0, 2],
  ]);
});

test('on a tetrahedron every vertex has the three others', () => {
  const indices = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3];
  const adjacency = finish(buildAdjacency(4, indices));
  expect([0, 1, 2, 3].map((vertex) => neighboursOf(adjacency, vertex))).toEqual([
    [1, 2, 3],
    [0, 2, 3],
    [0, 1, 3],
    [0, 1, 2],
  ]);
});
