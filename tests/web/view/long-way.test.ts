// The way along which a loop slides.

import { expect, test } from 'vitest';
import { longWay } from '../../../web/src/view/long-way.js';

/** Neighbours from a list of edges. */
function adjacencyOf(count: number, edges: [number, number][]) {
  const of = Array.from({ length: count }, (_, v) =>
    edges.filter((edge) => edge.includes(v)).map(([a, b]) => (a === v ? b : a)),
  );
  const first = new Uint32Array(count + 1);
  of.forEach((neighbours, v) => (first[v + 1] = first[v]! + neighbours.length));
  return { first, neighbours: Uint32Array.from(of.flat()) };
}

test('of a body with limbs it goes from the end of one to the end of another', () => {
  // Vertex 0 is the body; limbs of 1, 3 and 4 edges.
  const edges: [number, number][] = [
    [0, 1],
    [0, 2],
    [2, 3],
    [3, 4],
    [0, 5],
    [5, 6],
    [6, 7],
    [7, 8],
  ];
  const way = longWay(adjacencyOf(9, edges));
  expect(way).toEqual(way[0] === 4 ? [4, 3, 2, 0, 5, 6, 7, 8] : [8, 7, 6, 5, 0, 2, 3, 4]);
});

test('of another component there is none, nor of nothing', () => {
  expect(longWay(adjacencyOf(3, [[1, 2]]))).toEqual([0]);
  expect(longWay(adjacencyOf(0, []))).toEqual([]);
});
