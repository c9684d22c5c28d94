// Points of a surface as callers pass them.

import { failure } from './errors.js';
import type { MeshInfo, SurfacePoint } from './types.js';

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

function isBelow(number: number, count: number): boolean {
  return Number.isInteger(number) && number >= 0 && number < count;
}
