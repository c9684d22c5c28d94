// An estimate of the memory that the refined girth takes, before it is computed.

import type { MeshInfo } from '../../../src/kernel/index.js';

/** Bytes for each vertex, whatever its loop: the surface laid flat, and what is known of it. */
const perVertex = 800;
/** Bytes for each edge that the loop of a vertex crosses. */
const perCrossing = 4;
/** Edges that a loop crosses on the length of one. */
const crossingsPerEdge = 2;

/** Bytes of each thread, for the square root of the number of triangles: the front of its search. */
const perThread = 70_000;
/** Bytes that a page has for it. */
export const mostMemory = 2e9;
/** Vertices that the mean girth is known by. */
const enough = 10_000;

/** The memory in bytes, from the girth of a coarse surface, one value for each vertex. */
export function refinedMemory(
  { vertexCount, faceCount, area }: Pick<MeshInfo, 'vertexCount' | 'faceCount' | 'area'>,
  girth: Float64Array,
  threads: number,
): number {
  // The edge of triangles with equal sides.
  const edge = Math.sqrt(((4 / Math.sqrt(3)) * area) / faceCount);
  let [sum, count] = [0, 0];
  const step = Math.max(1, Math.floor(girth.length / enough));
  for (let vertex = 0; vertex < girth.length; vertex += step) {
    const value = girth[vertex]!;
    if (Number.isNaN(value)) continue;
    sum += value;
    ++count;
  }
  const crossings = count > 0 ? (crossingsPerEdge * sum) / count / edge : 0;
  const fronts = threads * perThread * Math.sqrt(faceCount);
  return vertexCount * (perVertex + perCrossing * crossings) + fronts;
}

/** How many triangles of the same surface a page has the memory for, in thousands rounded down. */
export function mostFaces(
  info: Pick<MeshInfo, 'vertexCount' | 'faceCount' | 'area'>,
  girth: Float64Array,
  threads: number,
): number {
  let [fits, isTooMuch] = [0, 1];
  for (let step = 0; step < 20; ++step) {
    const share = (fits + isTooMuch) / 2;
    const { vertexCount, faceCount, area } = info;
    const fewer = { vertexCount: share * vertexCount, faceCount: share * faceCount, area };
    if (refinedMemory(fewer, girth, threads) > mostMemory) isTooMuch = share;
    else fits = share;
  }
  return Math.floor((fits * info.faceCount) / 1000) * 1000;
}

/** '300 MB', '1.2 GB'. */
export function memoryWords(bytes: number): string {
  const hundreds = Math.ceil(bytes / 1e8);
  return hundreds < 10 ? `${hundreds}00 MB` : `${(hundreds / 10).toFixed(1)} GB`;
}
