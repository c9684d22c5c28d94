// The surface of a solid as triangles: marching tetrahedra. Each cube of a grid is cut into the six
// tetrahedra around its diagonal, so that neighbours agree on every face and the result is closed and
// manifold whatever the solid is. The triangles are uneven; the core's remeshing makes them even.

import type { Implicit, Point } from './implicit.ts';

/** x, y, z per vertex, three vertices per triangle, counterclockwise seen from outside. */
export interface Triangles {
  positions: ArrayLike<number>;
  indices: ArrayLike<number>;
}

export interface Box {
  min: Point;
  max: Point;
}

/**
 * The first two axes of a way from a cube's corner to the far corner, as bits: one tetrahedron each. The
 * first three are even permutations of the axes.
 */
const orders = [
  [1, 2],
  [2, 4],
  [4, 1],
  [2, 1],
  [1, 4],
  [4, 2],
] as const;

/** A vertex closer than this share of an edge to the edge's end is moved away from it. */
const nearest = 0.08;

/** Throws where the solid reaches the sides of the box: the surface would not be closed. */
export function polygonise(solid: Implicit, box: Box, cell: number): Triangles {
  const count = [0, 1, 2].map((k) => Math.ceil((box.max[k]! - box.min[k]!) / cell) + 1);
  const [nx, ny, nz] = count as [number, number, number];
  const strides = [1, nx, nx * ny];
  const values = sample(solid, box, cell, [nx, ny, nz]);

  const positions: number[] = [];
  const indices: number[] = [];
  const vertexOfEdge = new Map<number, number>();

  /** The vertex on the grid edge from corner `a` to corner `b`, on different sides of the surface. */
  const vertexBetween = (a: number, b: number): number => {
    const low = Math.min(a, b);
    const high = Math.max(a, b);
    const key = low * 8 + directionBetween(low, high);
    const known = vertexOfEdge.get(key);
    if (known !== undefined) return known;
    const t = values[low]! / (values[low]! - values[high]!);
    const share = Math.min(Math.max(t, nearest), 1 - nearest);
    for (let k = 0; k < 3; ++k) {
      const from = coordinate(low, k);
      positions.push(box.min[k]! + cell * (from + share * (coordinate(high, k) - from)));
    }
    const vertex = positions.length / 3 - 1;
    vertexOfEdge.set(key, vertex);
    return vertex;
  };
  const coordinate = (n: number, k: number): number => Math.floor(n / strides[k]!) % count[k]!;
  const directionBetween = (low: number, high: number): number => {
    let direction = 0;
    for (let k = 0; k < 3; ++k) if (coordinate(low, k) !== coordinate(high, k)) direction |= 1 << k;
    return direction;
  };

  for (let k = 0; k + 1 < nz; ++k) {
    for (let j = 0; j + 1 < ny; ++j) {
      for (let i = 0; i + 1 < nx; ++i) {
        const corner = i + strides[1]! * j + strides[2]! * k;
        const offset = (bits: number): number =>
          corner + (bits & 1) + strides[1]! * ((bits >> 1) & 1) + strides[2]! * (bits >> 2);
        let inside = 0;
        for (let bits = 0; bits < 8; ++bits) if (values[offset(bits)]! < 0) ++inside;
        if (inside === 0 || inside === 8) continue;
        orders.forEach(([first, second], turn) => {
          // Odd permutations give tetrahedra of negative volume, so two corners are swapped.
          const b = offset(turn < 3 ? first : first | second);
          const c = offset(turn < 3 ? first | second : first);
          cut([corner, b, c, offset(7)]);
        });
      }
    }
  }

  /** The one or two triangles in a positively oriented tetrahedron. */
  function cut(corners: readonly [number, number, number, number]): void {
    const inside = corners.filter((n) => values[n]! < 0);
    const outside = corners.filter((n) => !(values[n]! < 0));
    if (inside.length === 0 || outside.length === 0) return;
    const even = isEven([...inside, ...outside].map((n) => corners.indexOf(n)));
    const add = (a: number, b: number, c: number): void => {
      if (even) indices.push(a, b, c);
      else indices.push(a, c, b);
    };
    if (inside.length === 1) {
      const [a, b, c] = outside.map((n) => vertexBetween(inside[0]!, n));
      add(a!, b!, c!);
    } else if (inside.length === 3) {
      const [a, b, c] = inside.map((n) => vertexBetween(n, outside[0]!));
      add(a!, b!, c!);
    } else {
      const [p, q] = inside as [number, number];
      const [r, s] = outside as [number, number];
      const [pr, ps, qs, qr] = [
        vertexBetween(p, r),
        vertexBetween(p, s),
        vertexBetween(q, s),
        vertexBetween(q, r),
      ];
      add(pr, ps, qs);
      add(pr, qs, qr);
    }
  }

  return { positions, indices };
}

/** Points of the grid along each side of a block that is looked at as a whole first. */
const block = 4;

/** Bound on how fast a solid's value changes with distance. */
const steepest = 1.5;

/** The solid at the points of the grid; of blocks that the surface cannot reach, the sign only. */
function sample(
  solid: Implicit,
  { min }: Box,
  cell: number,
  [nx, ny, nz]: readonly [number, number, number],
): Float64Array {
  const values = new Float64Array(nx * ny * nz);
  const middle = ((block - 1) / 2) * cell;
  const far = steepest * Math.sqrt(3) * middle;
  for (let k0 = 0; k0 < nz; k0 += block) {
    for (let j0 = 0; j0 < ny; j0 += block) {
      for (let i0 = 0; i0 < nx; i0 += block) {
        const [x, y, z] = [min[0] + i0 * cell, min[1] + j0 * cell, min[2] + k0 * cell];
        const whole = solid(x + middle, y + middle, z + middle);
        for (let k = k0; k < Math.min(k0 + block, nz); ++k) {
          for (let j = j0; j < Math.min(j0 + block, ny); ++j) {
            for (let i = i0; i < Math.min(i0 + block, nx); ++i) {
              const value =
                Math.abs(whole) > far
                  ? whole
                  : solid(min[0] + i * cell, min[1] + j * cell, min[2] + k * cell);
              const side = [i, j, k, nx - 1 - i, ny - 1 - j, nz - 1 - k].includes(0);
              if (side && value <= 0) {
                throw new Error(`the solid leaves its box at grid point ${i}, ${j}, ${k}`);
              }
              values[i + nx * (j + ny * k)] = value;
            }
          }
        }
      }
    }
  }
  return values;
}

function isEven(permutation: number[]): boolean {
  let inversions = 0;
  for (let i = 0; i < permutation.length; ++i) {
    for (let j = 0; j < i; ++j) if (permutation[j]! > permutation[i]!) ++inversions;
  }
  return inversions % 2 === 0;
}
