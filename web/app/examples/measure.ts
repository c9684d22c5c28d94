// Measures of a mesh: whether it is closed and manifold, its genus, its triangles.

import type { Triangles } from './polygonise.ts';

export interface Measures {
  vertices: number;
  faces: number;
  /** Every edge has two faces, in opposite directions, and every vertex one ring of faces. */
  closedManifold: boolean;
  components: number;
  /** The genus of all components together; meaningful for a closed manifold only. */
  genus: number;
  /** Enclosed volume in cubic metres; positive where faces are counterclockwise seen from outside. */
  volume: number;
  /** The smallest angle of all faces, in degrees. */
  smallestAngle: number;
  /** The largest angle of all faces, in degrees. */
  largestAngle: number;
  smallestValence: number;
  largestValence: number;
  /** Lengths in metres. */
  shortestEdge: number;
  longestEdge: number;
}

export function measure({ positions, indices }: Triangles): Measures {
  const vertices = positions.length / 3;
  const faces = indices.length / 3;
  // Per vertex, where the ring of faces goes on from each neighbour.
  const rings = Array.from({ length: vertices }, () => new Map<number, number>());
  const parent = Array.from({ length: vertices }, (_, v) => v);
  const root = (v: number): number => {
    while (parent[v] !== v) v = parent[v] = parent[parent[v]!]!;
    return v;
  };
  const point = (v: number): [number, number, number] => [
    positions[3 * v]!,
    positions[3 * v + 1]!,
    positions[3 * v + 2]!,
  ];

  let closedManifold = true;
  let volume = 0;
  let [smallestAngle, largestAngle] = [180, 0];
  let [shortestEdge, longestEdge] = [Infinity, 0];
  for (let f = 0; f < faces; ++f) {
    const corners = [0, 1, 2].map((k) => indices[3 * f + k]!);
    const [p, q, r] = corners.map(point) as [Vector, Vector, Vector];
    volume += dot(p, cross(q, r)) / 6;
    for (let k = 0; k < 3; ++k) {
      const [a, b, c] = [0, 1, 2].map((j) => corners[(k + j) % 3]!) as Vector;
      if (rings[a]!.has(b)) closedManifold = false;
      rings[a]!.set(b, c);
      parent[root(a)] = root(b);
      const u = minus(point(b), point(a));
      const w = minus(point(c), point(a));
      const degrees = (Math.atan2(Math.hypot(...cross(u, w)), dot(u, w)) * 180) / Math.PI;
      smallestAngle = Math.min(smallestAngle, degrees);
      largestAngle = Math.max(largestAngle, degrees);
      shortestEdge = Math.min(shortestEdge, Math.hypot(...u));
      longestEdge = Math.max(longestEdge, Math.hypot(...u));
    }
  }
  let [smallestValence, largestValence] = [Infinity, 0];
  for (const ring of rings) {
    smallestValence = Math.min(smallestValence, ring.size);
    largestValence = Math.max(largestValence, ring.size);
    if (!isOneCycle(ring)) closedManifold = false;
  }
  const components = parent.filter((_, v) => root(v) === v).length;
  const euler = vertices - faces / 2;
  return {
    vertices,
    faces,
    closedManifold,
    components,
    genus: components - euler / 2,
    volume,
    smallestAngle,
    largestAngle,
    smallestValence,
    largestValence,
    shortestEdge,
    longestEdge,
  };
}

type Vector = [number, number, number];

function isOneCycle(ring: Map<number, number>): boolean {
  const [start] = ring.keys();
  let v = start;
  for (let i = 0; i < ring.size; ++i) {
    v = v === undefined ? undefined : ring.get(v);
    if (v === start) return i === ring.size - 1;
  }
  return false;
}

function minus(u: Vector, w: Vector): Vector {
  return [u[0] - w[0], u[1] - w[1], u[2] - w[2]];
}

function dot(u: Vector, w: Vector): number {
  return u[0] * w[0] + u[1] * w[1] + u[2] * w[2];
}

function cross(u: Vector, w: Vector): Vector {
  return [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
}
