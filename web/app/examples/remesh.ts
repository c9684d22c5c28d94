// Even triangles on the surface of a solid: edges that are too long are split, those too short shrunk
// to a point, edges flipped towards six neighbours per vertex, vertices moved along the surface to the
// middle of their neighbours and back onto it (Botsch & Kobbelt, 'A remeshing approach to
// multiresolution modeling', 2004; edge lengths after Dunyach et al., 'Adaptive remeshing for real-time
// mesh deformation', 2013). Everything runs in the order of the arrays: the same input gives the same
// mesh to the last bit.

import type { Implicit } from './implicit.ts';
import { HalfedgeMesh, removed } from './halfedges.ts';
import { grade, relativeLengths, type Sizing } from './sizing.ts';
import type { Triangles } from './polygonise.ts';
import {
  cosine,
  cosineAt,
  faceArea,
  faceNormal,
  triangleNormal,
  vertexNormal,
} from './triangles.ts';

/** How often the wanted lengths are taken anew from the mesh so far. */
const sizeChanges = 5;
const roundsPerSize = 2;
const finishingRounds = 6;

/**
 * The same closed surface with about `faces` triangles, its vertices on the zero set of `solid`; genus and
 * components stay as they are. The face count is met to within a few per cent.
 */
export function remesh(
  surface: Triangles,
  solid: Implicit,
  faces: number,
  sizing: Sizing,
): Triangles {
  const mesh = new HalfedgeMesh(surface);
  const step = 0.25 * Math.sqrt((area(mesh) / faces) * (4 / Math.sqrt(3)));
  project(mesh, solid, step);
  // Faces obtained per face that the lengths ask for; learnt from round to round.
  let surplus = 1;
  for (let change = 0; change < sizeChanges; ++change) {
    const lengths = wantedLengths(mesh, solid, faces / surplus, sizing, step);
    for (let round = 0; round < roundsPerSize; ++round) {
      splitLong(mesh, lengths);
      collapseShort(mesh, lengths);
      flipTowardsSix(mesh);
      relax(mesh, lengths);
      project(mesh, solid, step);
    }
    // More than the ratio, since evener triangles are larger and the number keeps falling.
    surplus *= (mesh.faceCount / faces) ** 1.6;
  }
  const lengths = wantedLengths(mesh, solid, faces, sizing, step);
  for (let round = 0; round < finishingRounds; ++round) {
    flipTowardsDelaunay(mesh);
    relax(mesh, lengths);
    project(mesh, solid, step);
  }
  flipTowardsDelaunay(mesh);
  return mesh.triangles();
}

/** Edge length per vertex such that the surface takes about `faces` equilateral triangles. */
function wantedLengths(
  mesh: HalfedgeMesh,
  solid: Implicit,
  faces: number,
  sizing: Sizing,
  step: number,
): number[] {
  const relative = relativeLengths(mesh, solid, sizing, step);
  grade(mesh, relative, Math.sqrt(expectedFaces(mesh, relative) / faces));
  const scale = Math.sqrt(expectedFaces(mesh, relative) / faces);
  return Array.from(relative, (length) => length * scale);
}

function area(mesh: HalfedgeMesh): number {
  let sum = 0;
  for (let h = 0; h < mesh.halfedgeSlots; h += 3) {
    if (mesh.origin[h] !== removed) sum += faceArea(mesh, h);
  }
  return sum;
}

/** How many equilateral triangles of these edge lengths cover the surface. */
function expectedFaces(mesh: HalfedgeMesh, lengths: Float64Array): number {
  let sum = 0;
  for (let h = 0; h < mesh.halfedgeSlots; h += 3) {
    if (mesh.origin[h] === removed) continue;
    const [a, b, c] = [0, 1, 2].map((k) => lengths[mesh.origin[h + k]!]!) as [
      number,
      number,
      number,
    ];
    sum += faceArea(mesh, h) / ((Math.sqrt(3) / 4) * ((a + b + c) / 3) ** 2);
  }
  return sum;
}

function splitLong(mesh: HalfedgeMesh, lengths: number[]): void {
  for (let h = 0; h < mesh.halfedgeSlots; ++h) {
    if (mesh.origin[h] === removed) continue;
    const [a, b] = [mesh.origin[h]!, mesh.target(h)];
    const wanted = (lengths[a]! + lengths[b]!) / 2;
    if (mesh.length(h) <= (4 / 3) * wanted) continue;
    const middle = (of: number[]): number => (of[a]! + of[b]!) / 2;
    mesh.split(h, middle(mesh.x), middle(mesh.y), middle(mesh.z));
    lengths.push(wanted);
  }
}

function collapseShort(mesh: HalfedgeMesh, lengths: number[]): void {
  for (let h = 0; h < mesh.halfedgeSlots; ++h) {
    if (mesh.origin[h] === removed) continue;
    const [a, b] = [mesh.origin[h]!, mesh.target(h)];
    const wanted = (lengths[a]! + lengths[b]!) / 2;
    if (mesh.length(h) >= (4 / 5) * wanted || !mesh.canCollapse(h)) continue;
    const x = (mesh.x[a]! + mesh.x[b]!) / 2;
    const y = (mesh.y[a]! + mesh.y[b]!) / 2;
    const z = (mesh.z[a]! + mesh.z[b]!) / 2;
    if (!keepsShape(mesh, a, b, x, y, z, (4 / 3) * wanted)) continue;
    if (!keepsShape(mesh, b, a, x, y, z, (4 / 3) * wanted)) continue;
    mesh.collapse(h);
    mesh.x[b] = x;
    mesh.y[b] = y;
    mesh.z[b] = z;
    lengths[b] = wanted;
  }
}

const before = new Float64Array(3);
const after = new Float64Array(3);

/** Whether v can move without an edge growing too long or a face turning over; faces with `gone` apart. */
function keepsShape(
  mesh: HalfedgeMesh,
  v: number,
  gone: number,
  x: number,
  y: number,
  z: number,
  longest: number,
): boolean {
  const start = mesh.outgoing[v]!;
  let h = start;
  do {
    const [b, c] = [mesh.target(h), mesh.opposite(h)];
    if (b !== gone) {
      const squared = (mesh.x[b]! - x) ** 2 + (mesh.y[b]! - y) ** 2 + (mesh.z[b]! - z) ** 2;
      if (squared > longest * longest) return false;
      if (c !== gone) {
        faceNormal(mesh, h, before);
        const [oldX, oldY, oldZ] = [mesh.x[v]!, mesh.y[v]!, mesh.z[v]!];
        [mesh.x[v], mesh.y[v], mesh.z[v]] = [x, y, z];
        faceNormal(mesh, h, after);
        [mesh.x[v], mesh.y[v], mesh.z[v]] = [oldX, oldY, oldZ];
        if (!(cosine(before, after) > 0.5)) return false;
      }
    }
    h = mesh.rotated(h);
  } while (h !== start);
  return true;
}

function flipTowardsSix(mesh: HalfedgeMesh): void {
  for (let h = 0; h < mesh.halfedgeSlots; ++h) {
    const t = mesh.twin[h]!;
    if (mesh.origin[h] === removed || t < h) continue;
    const [a, b, c, d] = quad(mesh, h);
    const off = (v: number, change: number): number => Math.abs(mesh.valence(v) + change - 6);
    const now = off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
    const then = off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1);
    if (then < now && canFlip(mesh, h)) mesh.flip(h);
  }
}

/** Flips while that makes the smallest angles of the two faces larger. */
function flipTowardsDelaunay(mesh: HalfedgeMesh): void {
  for (let pass = 0, flips = 1; pass < 5 && flips > 0; ++pass) {
    flips = 0;
    for (let h = 0; h < mesh.halfedgeSlots; ++h) {
      const t = mesh.twin[h]!;
      if (mesh.origin[h] === removed || t < h) continue;
      const [a, b, c, d] = quad(mesh, h);
      if (cosineAt(mesh, c, a, b) + cosineAt(mesh, d, a, b) >= -1e-6) continue;
      if (!canFlip(mesh, h)) continue;
      mesh.flip(h);
      ++flips;
    }
  }
}

/** The ends of an edge and the vertices across it. */
function quad(mesh: HalfedgeMesh, h: number): [number, number, number, number] {
  return [mesh.origin[h]!, mesh.target(h), mesh.opposite(h), mesh.opposite(mesh.twin[h]!)];
}

/** Whether the other diagonal is new, no vertex is left with three neighbours, and no face turns over. */
function canFlip(mesh: HalfedgeMesh, h: number): boolean {
  const [a, b, c, d] = quad(mesh, h);
  if (mesh.valence(a) <= 4 || mesh.valence(b) <= 4) return false;
  if (mesh.findHalfedge(c, d) !== removed) return false;
  faceNormal(mesh, h, before);
  faceNormal(mesh, mesh.twin[h]!, after);
  for (let k = 0; k < 3; ++k) before[k] = before[k]! + after[k]!;
  triangleNormal(mesh, a, d, c, after);
  if (!(cosine(after, before) > 0.5)) return false;
  triangleNormal(mesh, d, b, c, after);
  return cosine(after, before) > 0.5;
}

/**
 * Moves each vertex in its tangent plane to the middle of its faces, a face weighing more where edges are
 * to be short, so that sizes stay as wanted.
 */
function relax(mesh: HalfedgeMesh, lengths: ArrayLike<number>): void {
  for (let v = 0; v < mesh.vertexSlots; ++v) {
    const start = mesh.outgoing[v]!;
    if (start === removed) continue;
    let [weights, dx, dy, dz] = [0, 0, 0, 0];
    let h = start;
    do {
      const [b, c] = [mesh.target(h), mesh.opposite(h)];
      const length = lengths[v]! + lengths[b]! + lengths[c]!;
      const weight = faceArea(mesh, h) / length ** 4;
      weights += weight;
      dx += weight * (mesh.x[b]! + mesh.x[c]! - 2 * mesh.x[v]!);
      dy += weight * (mesh.y[b]! + mesh.y[c]! - 2 * mesh.y[v]!);
      dz += weight * (mesh.z[b]! + mesh.z[c]! - 2 * mesh.z[v]!);
      h = mesh.rotated(h);
    } while (h !== start);
    vertexNormal(mesh, v, normal);
    const [nx, ny, nz] = normal as unknown as [number, number, number];
    const along = dx * nx + dy * ny + dz * nz;
    mesh.x[v] = mesh.x[v]! + (dx - along * nx) / (3 * weights);
    mesh.y[v] = mesh.y[v]! + (dy - along * ny) / (3 * weights);
    mesh.z[v] = mesh.z[v]! + (dz - along * nz) / (3 * weights);
  }
}

const normal = new Float64Array(3);

/** Moves each vertex onto the surface along the mesh's normal, by the secant method. */
function project(mesh: HalfedgeMesh, solid: Implicit, step: number): void {
  for (let v = 0; v < mesh.vertexSlots; ++v) {
    if (mesh.outgoing[v] === removed) continue;
    vertexNormal(mesh, v, normal);
    let value = solid(mesh.x[v]!, mesh.y[v]!, mesh.z[v]!);
    let slope = 1;
    for (let i = 0; i < 4 && Math.abs(value) > 1e-2 * step; ++i) {
      const way = -value / slope;
      mesh.x[v] = mesh.x[v]! + way * normal[0]!;
      mesh.y[v] = mesh.y[v]! + way * normal[1]!;
      mesh.z[v] = mesh.z[v]! + way * normal[2]!;
      const before = value;
      value = solid(mesh.x[v]!, mesh.y[v]!, mesh.z[v]!);
      slope = Math.min(Math.max((value - before) / way, 0.3), 1.5);
    }
  }
}
