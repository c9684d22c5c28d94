// The colours of parts: those that touch differ.

import { expect, test } from 'vitest';
import {
  colourParts,
  neighboursOf,
  partColours,
} from '../../../web/app/panels/necks/part-colours.js';

const none = 0xffffffff;
const part = (faces: number[], vertices: number[] = []) => ({
  faces: Uint32Array.from(faces),
  vertices: Uint32Array.from(vertices),
});

test('parts are neighbours where they share a face or a vertex of the whole; what cutting has made is nobody’s', () => {
  const parts = [
    part([0, 1, none]),
    part([1, 2, none], [7]),
    part([3], [7, none]),
    part([9], [none]),
  ];
  expect(neighboursOf(parts).map((of) => [...of].sort((a, b) => a - b))).toEqual([
    [1],
    [0, 2],
    [1],
    [],
  ]);
  expect(neighboursOf([])).toEqual([]);
});

test('in random trees of parts, as cuts of a body without handles leave them, neighbours never have one colour', () => {
  let seed = 7;
  const random = (below: number): number => {
    seed = (Math.imul(seed, 1103515245) + 12345) & 0x7fffffff;
    return (seed >> 8) % below;
  };
  for (let run = 0; run < 200; ++run) {
    const count = 2 + random(12);
    // Parts are sorted by area, and not from neighbour to neighbour.
    const order = Array.from({ length: count }, (_, i) => i);
    for (let i = count - 1; i > 0; --i) {
      const other = random(i + 1);
      [order[i], order[other]] = [order[other]!, order[i]!];
    }
    const faces = Array.from({ length: count }, () => [] as number[]);
    const edges: [number, number][] = [];
    for (let i = 1; i < count; ++i) {
      const pair: [number, number] = [order[i]!, order[random(i)]!];
      // Two faces that are cut.
      for (const face of [2 * i, 2 * i + 1]) for (const one of pair) faces[one]!.push(face);
      edges.push(pair);
    }
    const colours = colourParts(faces.map((of) => part(of)));
    expect(colours[0]).toBe(0);
    expect(Math.max(...colours)).toBeLessThan(partColours.length);
    // Colours that are used come first: the legend has no gaps.
    expect(new Set(colours).size).toBe(Math.max(...colours) + 1);
    const clashes = edges.filter(([a, b]) => colours[a] === colours[b]);
    expect(clashes.length).toBe(0);
  }
});
