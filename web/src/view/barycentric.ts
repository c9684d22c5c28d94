// A point's shares of a triangle's corners.

import { Triangle, Vector3 } from 'three';

/**
 * The shares of the corners a, b and c at a point of their triangle: none below 0, their sum 1, also
 * where the point is a little beside the triangle; the first corner where it has no area.
 */
export function weightsIn(
  a: Vector3,
  b: Vector3,
  c: Vector3,
  point: Vector3,
): [number, number, number] {
  const shares = Triangle.getBarycoord(point, a, b, c, new Vector3());
  if (!shares) return [1, 0, 0];
  const [x, y, z] = shares.toArray().map((share) => Math.max(0, share)) as [number, number, number];
  const sum = x + y + z;
  return [x / sum, y / sum, z / sum];
}
