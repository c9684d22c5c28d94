// Points moved onto the surface of a solid.

import type { Implicit } from './implicit.ts';

/** Newton's steps: enough for the surface to be met to rounding wherever it is smooth. */
const steps = 4;

/** Slopes below this have no direction to trust: a solid's value is close to a distance elsewhere. */
const leastSlope = 0.2;

/**
 * Moves every point (x, y, z each) that is nearer to the surface than `reach` onto it, along the slope of
 * the solid's values. Others stay: where two parts nearly touch, the slope may point to the wrong one.
 */
export function project(points: Float64Array, solid: Implicit, reach: number): void {
  const h = reach / 2;
  for (let i = 0; i < points.length; i += 3) {
    for (let step = 0; step < steps; ++step) {
      const [x, y, z] = points.subarray(i, i + 3) as unknown as [number, number, number];
      const dx = (solid(x + h, y, z) - solid(x - h, y, z)) / (2 * h);
      const dy = (solid(x, y + h, z) - solid(x, y - h, z)) / (2 * h);
      const dz = (solid(x, y, z + h) - solid(x, y, z - h)) / (2 * h);
      const squared = dx * dx + dy * dy + dz * dz;
      const share = solid(x, y, z) / squared;
      if (!(squared > leastSlope ** 2) || Math.abs(share) * Math.sqrt(squared) > reach) break;
      points[i] = x - share * dx;
      points[i + 1] = y - share * dy;
      points[i + 2] = z - share * dz;
    }
  }
}
