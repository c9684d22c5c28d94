// Areas, normals and angles in a mesh. Vectors are written to arrays that the caller keeps: these are
// called a million times.

import type { HalfedgeMesh } from './halfedges.ts';

/** Writes to `out` the normal of the triangle a, b, c with twice its area as length. */
export function triangleNormal(
  mesh: HalfedgeMesh,
  a: number,
  b: number,
  c: number,
  out: Float64Array,
): void {
  const { x, y, z } = mesh;
  const ux = x[b]! - x[a]!;
  const uy = y[b]! - y[a]!;
  const uz = z[b]! - z[a]!;
  const wx = x[c]! - x[a]!;
  const wy = y[c]! - y[a]!;
  const wz = z[c]! - z[a]!;
  out[0] = uy * wz - uz * wy;
  out[1] = uz * wx - ux * wz;
  out[2] = ux * wy - uy * wx;
}

/** The same for the face of halfedge h. */
export function faceNormal(mesh: HalfedgeMesh, h: number, out: Float64Array): void {
  triangleNormal(mesh, mesh.origin[h]!, mesh.target(h), mesh.opposite(h), out);
}

const scratch = new Float64Array(3);

export function faceArea(mesh: HalfedgeMesh, h: number): number {
  faceNormal(mesh, h, scratch);
  return norm(scratch) / 2;
}

/** Writes the unit normal at v to `out`: the faces' normals, weighted by area. */
export function vertexNormal(mesh: HalfedgeMesh, v: number, out: Float64Array): void {
  out.fill(0);
  const start = mesh.outgoing[v]!;
  let h = start;
  do {
    faceNormal(mesh, h, scratch);
    for (let k = 0; k < 3; ++k) out[k] = out[k]! + scratch[k]!;
    h = mesh.rotated(h);
  } while (h !== start);
  const size = norm(out) || 1;
  for (let k = 0; k < 3; ++k) out[k] = out[k]! / size;
}

/** The cosine of the angle at a between b and c. */
export function cosineAt(mesh: HalfedgeMesh, a: number, b: number, c: number): number {
  const { x, y, z } = mesh;
  const ux = x[b]! - x[a]!;
  const uy = y[b]! - y[a]!;
  const uz = z[b]! - z[a]!;
  const wx = x[c]! - x[a]!;
  const wy = y[c]! - y[a]!;
  const wz = z[c]! - z[a]!;
  const sizes = (ux * ux + uy * uy + uz * uz) * (wx * wx + wy * wy + wz * wz);
  return (ux * wx + uy * wy + uz * wz) / Math.sqrt(sizes);
}

/** The cosine of the angle between two vectors. */
export function cosine(u: Float64Array, w: Float64Array): number {
  return (u[0]! * w[0]! + u[1]! * w[1]! + u[2]! * w[2]!) / (norm(u) * norm(w));
}

function norm(u: Float64Array): number {
  return Math.sqrt(u[0]! * u[0]! + u[1]! * u[1]! + u[2]! * u[2]!);
}
