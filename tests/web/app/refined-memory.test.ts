import { expect, test } from 'vitest';
import {
  memoryWords,
  mostFaces,
  mostMemory,
  refinedMemory,
} from '../../../web/app/panels/field/refined-memory.js';

/** A surface of triangles with sides of length 1. */
const surfaceOf = (vertexCount: number) => {
  const faceCount = 2 * vertexCount;
  return { vertexCount, faceCount, area: (faceCount * Math.sqrt(3)) / 4 };
};

test('longer loops take more memory, and so do more of them', () => {
  const girth = (length: number) => new Float64Array(1000).fill(length);
  const short = refinedMemory(surfaceOf(100_000), girth(10), 1);
  expect(refinedMemory(surfaceOf(200_000), girth(10), 1)).toBeGreaterThan(1.8 * short);
  expect(refinedMemory(surfaceOf(100_000), girth(10), 3) - short).toBeCloseTo(6.26e7, -5);
  // For each vertex four bytes of 90 times two edges more.
  const long = refinedMemory(surfaceOf(100_000), girth(100), 1);
  expect(long - short).toBeCloseTo(100_000 * 4 * 2 * 90);
  const half = girth(10).map((value, v) => (v % 2 === 0 ? value : NaN));
  expect(refinedMemory(surfaceOf(100_000), half, 1)).toBeCloseTo(short);
  expect(refinedMemory(surfaceOf(10), new Float64Array(10).fill(NaN), 1)).toBeGreaterThan(0);
});

test('as many triangles fit as the page has memory for', () => {
  const girth = new Float64Array(1000).fill(300);
  const surface = surfaceOf(2_000_000);
  const faces = mostFaces(surface, girth, 2);
  const share = faces / surface.faceCount;
  const of = (share: number) => ({
    ...{ vertexCount: share * surface.vertexCount, area: surface.area },
    faceCount: share * surface.faceCount,
  });
  expect(faces % 1000).toBe(0);
  expect(refinedMemory(of(share), girth, 2)).toBeLessThanOrEqual(mostMemory);
  expect(refinedMemory(of(1.01 * share), girth, 2)).toBeGreaterThan(mostMemory);
});

test('memory in words is rounded up', () => {
  expect([1, 1e8, 1.01e8, 9.5e8, 1.42e9].map(memoryWords)).toEqual([
    ...['100 MB', '100 MB', '200 MB', '1.0 GB', '1.5 GB'],
  ]);
});
