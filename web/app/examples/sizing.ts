// How long edges should be, relative to each other: full length where a surface is gently curved,
// shorter where it bends more sharply, so that rims, bars and tips get the triangles they need.

import type { Implicit } from './implicit.ts';
import { removed, type HalfedgeMesh } from './halfedges.ts';
import { vertexNormal } from './triangles.ts';

export interface Sizing {
  /** Radius of curvature, in metres, from which on edges have their full length. */
  gentle: number;
  /** The shortest edges as a share of the full length. */
  finest: number;
}

/** Lengths may grow by this share of the distance. */
const grading = 0.2;

/**
 * The relative edge length per vertex, in (0, 1]. It goes with the square root of the smaller radius of
 * curvature, which keeps the distance between surface and triangles even where curvature varies.
 * `step` is the distance over which curvature is measured, in metres.
 */
export function relativeLengths(
  mesh: HalfedgeMesh,
  solid: Implicit,
  { gentle, finest }: Sizing,
  step: number,
): Float64Array {
  const lengths = new Float64Array(mesh.vertexSlots).fill(1);
  for (let v = 0; v < lengths.length; ++v) {
    if (mesh.outgoing[v] === removed) continue;
    const curvature = totalCurvature(mesh, solid, v, step);
    const length = 1 / Math.sqrt(Math.max(curvature * gentle, 1));
    lengths[v] = Math.max(length, finest);
  }
  return lengths;
}

/**
 * Evens out the lengths between neighbours, then lets them, times `scale`, change no faster from vertex
 * to vertex than the grading allows.
 */
export function grade(mesh: HalfedgeMesh, lengths: Float64Array, scale: number): void {
  for (let pass = 0; pass < 3; ++pass) {
    const before = lengths.slice();
    for (let v = 0; v < lengths.length; ++v) {
      if (mesh.outgoing[v] === removed) continue;
      let sum = 0;
      let count = 0;
      mesh.around(v, (neighbour) => {
        sum += before[neighbour]!;
        ++count;
      });
      lengths[v] = (before[v]! + sum / count) / 2;
    }
  }
  for (let pass = 0; pass < 4; ++pass) {
    for (let h = 0; h < mesh.halfedgeSlots; ++h) {
      const a = mesh.origin[h]!;
      if (a === removed) continue;
      const most = lengths[a]! + (grading * mesh.length(h)) / scale;
      const b = mesh.target(h);
      if (lengths[b]! > most) lengths[b] = most;
    }
  }
}

const normal = new Float64Array(3);

/**
 * Root of the sum of the squared principal curvatures, from second differences of the solid's values in
 * the tangent plane and their slope across it.
 */
function totalCurvature(mesh: HalfedgeMesh, solid: Implicit, v: number, step: number): number {
  const [x, y, z] = [mesh.x[v]!, mesh.y[v]!, mesh.z[v]!];
  vertexNormal(mesh, v, normal);
  const [nx, ny, nz] = normal as unknown as [number, number, number];
  // One direction in the tangent plane from the axis farther from the normal, one across both.
  const [ax, ay] = Math.abs(nx) < 0.6 ? [1, 0] : [0, 1];
  const along = ax * nx + ay * ny;
  const size = Math.sqrt((ax - along * nx) ** 2 + (ay - along * ny) ** 2 + (along * nz) ** 2);
  const [ux, uy, uz] = [(ax - along * nx) / size, (ay - along * ny) / size, (-along * nz) / size];
  const [wx, wy, wz] = [ny * uz - nz * uy, nz * ux - nx * uz, nx * uy - ny * ux];
  const value = solid(x, y, z);
  const slope = Math.abs(solid(x + step * nx, y + step * ny, z + step * nz) - value) / step;
  const bend = (du: number, dw: number): number => {
    const [dx, dy, dz] = [
      step * (du * ux + dw * wx),
      step * (du * uy + dw * wy),
      step * (du * uz + dw * wz),
    ];
    return (
      (solid(x + dx, y + dy, z + dz) + solid(x - dx, y - dy, z - dz) - 2 * value) / (step * step)
    );
  };
  const alongU = bend(1, 0);
  const alongW = bend(0, 1);
  const mixed = bend(Math.SQRT1_2, Math.SQRT1_2) - (alongU + alongW) / 2;
  return Math.sqrt(alongU * alongU + alongW * alongW + 2 * mixed * mixed) / Math.max(slope, 0.2);
}
