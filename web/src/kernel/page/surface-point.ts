// Points of a surface as callers pass them.

import { failure } from '../types/errors.js';
import type { MeshInfo, SurfacePoint } from '../types/types.js';

/**
 * A copy of the point. Throws where the vertex or face does not exist, or a weight is no finite number. The
 * core checks that weights are at least 0 and add up to 1.
 */
export function checkedPoint(
  point: SurfacePoint,
  { vertexCount, faceCount }: Pick<MeshInfo, 'vertexCount' | 'faceCount'>,
): SurfacePoint {
  if (typeof point === 'number') {
    if (isBelow(point, vertexCount)) return point;
    throw failure('VERTEX_OUT_OF_RANGE', `vertex ${point} of ${vertexCount} does not exist`, {
      element: Number.isInteger(point) ? point : -1,
    });
  }
  const { face, weights } = point;
  const element = Number.isInteger(face) ? face : -1;
  if (!isBelow(face, faceCount)) {
    throw failure('INVALID_POINT', `face ${face} of ${faceCount} does not exist`, { element });
  }
  const [a, b, c] = weights;
  if (weights.length !== 3 || ![a, b, c].every(Number.isFinite)) {
    throw failure('INVALID_POINT', 'a point of a face has three numbers as weights', { element });
  }
  return { face, weights: [a, b, c] };
}

/** Points that a worker has packed: four numbers for each, a face and its weights, or a vertex and three NaN. */
export function unpackedPoints(packed: Float64Array): SurfacePoint[] {
  return Array.from({ length: packed.length / 4 }, (_, i): SurfacePoint => {
    const [number, a, b, c] = packed.subarray(4 * i, 4 * i + 4) as unknown as Packed;
    return Number.isNaN(a) ? number : { face: number, weights: [a, b, c] };
  });
}

type Packed = [number: number, a: number, b: number, c: number];

function isBelow(number: number, count: number): boolean {
  return Number.isInteger(number) && number >= 0 && number < count;
}
