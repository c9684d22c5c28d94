// Solids as functions of space: negative inside, positive outside, zero on the surface. The primitives
// are signed distances or close to it, so that lengths given to the blends are lengths in space.

import type { Tube } from './tube.ts';

/** The value at (x, y, z). Lengths in metres. */
export type Implicit = (x: number, y: number, z: number) => number;

export type Point = readonly [number, number, number];

export function sphere([cx, cy, cz]: Point, radius: number): Implicit {
  return (x, y, z) => Math.sqrt((x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2) - radius;
}

/** An ellipsoid along the axes. The value is a distance to first order near the surface. */
export function ellipsoid([cx, cy, cz]: Point, [rx, ry, rz]: Point): Implicit {
  const smallest = Math.min(rx, ry, rz);
  return (x, y, z) => {
    const u = (x - cx) / rx;
    const v = (y - cy) / ry;
    const w = (z - cz) / rz;
    const value = Math.sqrt(u * u + v * v + w * w);
    const slope = Math.sqrt((u / rx) ** 2 + (v / ry) ** 2 + (w / rz) ** 2);
    return slope < 1e-9 ? -smallest : (value * (value - 1)) / slope;
  };
}

/**
 * A flat figure of the xz plane made a plate: `outline` is the signed distance to the figure, `height`
 * the plate's middle above a point of the plane. The rim is round, with the plate's half thickness.
 */
export function plate(
  outline: (x: number, z: number) => number,
  height: (x: number, z: number) => number,
  thickness: number,
): Implicit {
  const rim = thickness / 2;
  return (x, y, z) => {
    const across = Math.max(outline(x, z) + rim, 0);
    const up = y - height(x, z);
    return Math.sqrt(across * across + up * up) - rim;
  };
}

/** A tube with round ends. */
export function tube(path: Tube): Implicit {
  return (x, y, z) => path.distance(x, y, z);
}

/**
 * The smaller of two values, with the edge between them rounded over a width of `blend`. Cubic, so
 * that curvature is continuous too; exactly the smaller one where they differ by more than `blend`.
 */
export function smoothMin(a: number, b: number, blend: number): number {
  const overlap = blend - Math.abs(a - b);
  if (overlap <= 0) return Math.min(a, b);
  const h = overlap / blend;
  return Math.min(a, b) - (h * h * h * blend) / 6;
}

/** Everything that lies in any of the solids, with fillets of width `blend` where they meet. */
export function smoothUnion(blend: number, first: Implicit, ...others: Implicit[]): Implicit {
  return (x, y, z) => {
    let value = first(x, y, z);
    for (const other of others) value = smoothMin(value, other(x, y, z), blend);
    return value;
  };
}

/** The solid and its mirror image at the plane x = 0, in one; the fillet between them is `blend` wide. */
export function mirrored(blend: number, solid: Implicit): Implicit {
  return (x, y, z) => smoothMin(solid(x, y, z), solid(-x, y, z), blend);
}
