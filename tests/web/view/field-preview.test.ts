import { expect, test } from 'vitest';
import { buildAdjacency } from '../../../web/src/view/adjacency.js';
import { FieldPreview } from '../../../web/src/view/field-preview.js';
import { torus } from './torus.js';

function finish<Result>(work: Generator<void, Result>): Result {
  for (;;) {
    const step = work.next();
    if (step.done) return step.value;
  }
}

const { positions, indices } = torus(12, 8);
const vertexCount = positions.length / 3;
const adjacency = finish(buildAdjacency(vertexCount, indices));

/** Edges between two vertices, by breadth-first search. */
function hopsFrom(source: number): number[] {
  const hops = new Array<number>(vertexCount).fill(Infinity);
  hops[source] = 0;
  const queue = [source];
  for (const v of queue) {
    for (const n of adjacency.neighbours.subarray(adjacency.first[v], adjacency.first[v + 1])) {
      if (hops[n] !== Infinity) continue;
      hops[n] = hops[v]! + 1;
      queue.push(n);
    }
  }
  return hops;
}

function partial(vertices: number[]) {
  return {
    vertices: Uint32Array.from(vertices),
    values: Float64Array.from(vertices, (v) => 1000 + v),
    kinds: new Uint8Array(vertices.length),
  };
}

test('on a torus every vertex has the neighbours of its edges, both ways', () => {
  expect(adjacency.neighbours).toHaveLength(indices.length);
  for (let v = 0; v < vertexCount; ++v) {
    const around = adjacency.neighbours.subarray(adjacency.first[v], adjacency.first[v + 1]);
    expect(new Set(around).size).toBe(6);
    for (const n of around) {
      const back = adjacency.neighbours.subarray(adjacency.first[n], adjacency.first[n + 1]);
      expect([...back]).toContain(v);
    }
  }
});

test('every vertex shows the value of a nearest computed one, in whatever slices it spreads', () => {
  const sources = [5, 40, 77, 91];
  const hops = sources.map(hopsFrom);
  const preview = new FieldPreview(adjacency);
  let ticks = 0;
  for (const source of sources) {
    preview.receive(partial([source]), () => undefined);
    // Every look at the clock finds the time nearly up: spreading goes in many small pieces.
    preview.spread(
      () => undefined,
      1,
      () => ticks++ % 2,
    );
  }
  while (!preview.spread(() => undefined));
  for (let v = 0; v < vertexCount; ++v) {
    const nearest = Math.min(...hops.map((h) => h[v]!));
    const shown = preview.shown[v]! - 1000;
    expect(hops[sources.indexOf(shown)]![v]).toBe(nearest);
  }
});

test('reports each vertex that changes, and only once it has something to show', () => {
  const preview = new FieldPreview(adjacency);
  const changed = new Set<number>();
  expect(preview.range).toBeUndefined();
  preview.receive(partial([3, 9]), (v) => changed.add(v));
  expect([...changed]).toEqual([3, 9]);
  expect(preview.range).toEqual([1003, 1009]);
  expect(preview.computed).toBe(2);
  expect(preview.values[4]).toBeNaN();
  preview.spread((v) => changed.add(v));
  expect(changed.size).toBe(vertexCount);
  expect(preview.values[4]).toBeNaN();
  expect(preview.isComputed(3)).toBe(true);
  expect(preview.isComputed(4)).toBe(false);
});

test('a value that comes twice is counted once', () => {
  const preview = new FieldPreview(adjacency);
  preview.receive(partial([3]), () => undefined);
  preview.receive(partial([3, 4]), () => undefined);
  expect(preview.computed).toBe(2);
});

test('a vertex without a value lends none, and is none of the range', () => {
  // Four vertices in a row.
  const row = {
    first: Uint32Array.of(0, 1, 3, 5, 6),
    neighbours: Uint32Array.of(1, 0, 2, 1, 3, 2),
  };
  const preview = new FieldPreview(row);
  const changed: number[] = [];
  preview.receive(
    { vertices: Uint32Array.of(0, 3), values: Float64Array.of(NaN, 5), kinds: new Uint8Array() },
    (vertex) => changed.push(vertex),
  );
  expect(changed).toEqual([0, 3]);
  expect(preview.computed).toBe(2);
  expect(preview.range).toEqual([5, 5]);
  preview.spread(() => undefined);
  expect([...preview.shown]).toEqual([NaN, 5, 5, 5]);
});

test('it knows whether a value is left to spread', () => {
  const preview = new FieldPreview(adjacency);
  expect(preview.isSpread).toBe(true);
  preview.receive(partial([3]), () => undefined);
  expect(preview.isSpread).toBe(false);
  preview.spread(() => undefined);
  expect(preview.isSpread).toBe(true);
  preview.receive({ ...partial([4]), values: Float64Array.of(NaN) }, () => undefined);
  expect(preview.isSpread).toBe(true);
});

test('lent values take the place of all, and do not count as computed', () => {
  const preview = new FieldPreview(adjacency);
  preview.receive(partial([3, 40]), () => undefined);
  const values = Float64Array.from({ length: vertexCount }, (_, v) => v);
  preview.lend(values, [0, vertexCount - 1]);
  expect([...preview.values]).toEqual([...values]);
  expect([...preview.shown]).toEqual([...values]);
  expect(preview.range).toEqual([0, vertexCount - 1]);
  expect([preview.computed, preview.isSpread, preview.isComputed(3)]).toEqual([0, true, false]);
  preview.receive(partial([7]), () => undefined);
  expect([preview.computed, preview.values[7], preview.values[8]]).toEqual([1, 1007, 8]);
});
