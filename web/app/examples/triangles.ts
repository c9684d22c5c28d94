// Areas, normals and angles in a mesh. Vectors are written to arrays that the caller keeps: these are
// called a million times.

import type { HalfedgeMesh } from './halfedges.ts';

const u = new Float64Array(3);
const w = new Float64Array(3);

/** Writes b − a to `u` and c − a to `w`. */
function edgesFrom({ x, y, z }: HalfedgeMesh, a: number, b: number, c: number): void {
  u[0] = x[b]! - x[a]!;
  u[1] = y[b]! - y[a]!;
  u[2] = z[b]! - z[a]!;
  w[0] = x[c]! - x[a]!;
  w[1] = y[c]! - y[a]!;
  w[2] = z[c]! - z[a]!;
}

/** Writes to `out` the normal of the triangle a, b, c with twice its area as length. */
export function triangleNormal(
  mesh: HalfedgeMesh,
  a: number,
  b: number,
  c: number,
  out: Float64Array,
): void {
  edgesFrom(mesh, a, b, c);
  out[0] = u[1]! * w[2]! - u[2]! * w[1]!;
  out[1] = u[2]! * w[0]! - u[0]! * w[2]!;
  out[2] = u[0]! * w[1]! - u[1]! * w[0]!;
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
  edgesFrom(mesh, a, b, c);
  return cosine(u, w);
}

/** The cosine of the angle between two vectors. */
export function cosine(p: Float64Array, q: Float64Array): number {
  return dot(p, q) / Math.sqrt(dot(p, p) * dot(q, q));
}

function dot(p: Float64Array, q: Float64Array): number {
  return p[0]! * q[0]! + p[1]! * q[1]! + p[2]! * q[2]!;
}

function norm(p: Float64Array): number {
  return Math.sqrt(dot(p, p));
}
