// Counts of a surface that nobody has prepared: components, genus, boundary. Faults that the kernel
// would mend are found, not mended.

import type { MeshInfo } from '../../kernel/types/types.js';

/** Steps of work between two chances to let the page go on. */
const chunk = 1 << 14;

const none = 0xffffffff;

const nextOf = (h: number): number => (h % 3 === 2 ? h - 2 : h + 1);
const previousOf = (h: number): number => (h % 3 === 0 ? h + 2 : h - 1);

/** The counts of a surface; lengths in the positions' unit. */
export interface SurfaceCounts extends Pick<
  MeshInfo,
  'edgeCount' | 'components' | 'genus' | 'boundaries' | 'area' | 'size' | 'parts'
> {
  /** Two vertices of each edge of the boundary. */
  boundary: Uint32Array<ArrayBuffer>;
}

/** How much of a face belongs to its corners: the mixed Voronoi areas of `voronoi_share.h`. */
export function* vertexAreasOf(
  positions: Float32Array,
  indices: Uint32Array,
): Generator<void, Float64Array> {
  const areas = new Float64Array(positions.length / 3);
  for (let f = 0; f < indices.length; f += 3) {
    if (f % chunk === 0) yield;
    const { area, squares } = faceOf(positions, indices, f);
    for (let k = 0; k < 3; ++k) {
      const [a, b, c] = [squares[k]!, squares[(k + 1) % 3]!, squares[(k + 2) % 3]!];
      const vertex = indices[f + k]!;
      if (a > b + c) areas[vertex]! += area / 2;
      else if (b > a + c || c > a + b) areas[vertex]! += area / 4;
      else areas[vertex]! += (b * (a + c - b) + c * (a + b - c)) / (32 * area);
    }
  }
  return areas;
}

/** A face's area, and the square of the side opposite to each corner. */
function faceOf(positions: Float32Array, indices: Uint32Array, f: number) {
  const at = (k: number, axis: number): number => positions[3 * indices[f + (k % 3)]! + axis]!;
  const side = (k: number): [number, number, number] => [
    at(k + 2, 0) - at(k + 1, 0),
    at(k + 2, 1) - at(k + 1, 1),
    at(k + 2, 2) - at(k + 1, 2),
  ];
  const sides = [side(0), side(1), side(2)];
  const squares = sides.map(([x, y, z]) => x * x + y * y + z * z);
  const [[a, b, c], [d, e, g]] = sides as [[number, number, number], [number, number, number]];
  const area = 0.5 * Math.hypot(b * g - c * e, c * d - a * g, a * e - b * d);
  return { area, squares };
}

/**
 * Counts; undefined where the kernel would have something to mend: vertices that no face uses, that lie on each
 * other or where parts only touch, faces without area, edges of more than two faces or with one side only.
 */
export function* countSurface(
  positions: Float32Array,
  indices: Uint32Array,
): Generator<void, SurfaceCounts | undefined> {
  const vertexCount = positions.length / 3;
  if (areAlike(positions)) return undefined;
  yield;
  const opposite = yield* oppositesOf(vertexCount, indices);
  if (!opposite) return undefined;
  const component = new Uint32Array(vertexCount).fill(none);
  const parts: MeshInfo['parts'] = [];
  const tally: { vertices: number; edges: number; faces: number; rims: number }[] = [];
  // A vertex's faces are reached by turning about it, and all faces of a component across edges.
  const from = firstHalfedges(vertexCount, indices, opposite);
  const queue = new Uint32Array(vertexCount);
  const rim = new Uint8Array(indices.length);
  const boundary: number[] = [];
  for (let seed = 0; seed < vertexCount; ++seed) {
    if (component[seed] !== none) continue;
    const counts = { vertices: 0, edges: 0, faces: 0, rims: 0 };
    let [area, head, tail] = [0, 0, 0];
    component[seed] = tally.length;
    queue[tail++] = seed;
    while (head < tail) {
      if (head % chunk === 0) yield;
      const vertex = queue[head++]!;
      ++counts.vertices;
      for (let h = from[vertex]!; h !== none;) {
        // Each face is counted at its first corner, each edge where it has no opposite or the smaller number.
        const other = opposite[h]!;
        if (h % 3 === 0) {
          ++counts.faces;
          const face = faceOf(positions, indices, h);
          if (!(face.area > 0)) return undefined;
          area += face.area;
        }
        if (other === none || h < other) ++counts.edges;
        for (const reached of [indices[nextOf(h)]!, indices[previousOf(h)]!]) {
          if (component[reached] !== none) continue;
          component[reached] = tally.length;
          queue[tail++] = reached;
        }
        h = opposite[previousOf(h)]!;
        if (h === from[vertex]) break;
      }
    }
    tally.push(counts);
    parts.push({ faceCount: counts.faces, area });
  }
  for (let h = 0; h < indices.length; ++h) {
    if (opposite[h] !== none) continue;
    boundary.push(indices[h]!, indices[nextOf(h)]!);
    if (rim[h]) continue;
    // The curve goes on with the halfedge that leaves the next vertex along the boundary.
    for (let at = h; !rim[at]; at = from[indices[nextOf(at)]!]!) rim[at] = 1;
    ++tally[component[indices[h]!]!]!.rims;
  }
  const boundaries = tally.map(({ rims }) => rims);
  return {
    boundary: Uint32Array.from(boundary),
    edgeCount: tally.reduce((sum, { edges }) => sum + edges, 0),
    components: tally.length,
    genus: tally.map(
      ({ vertices, edges, faces, rims }) => (2 - rims - (vertices - edges + faces)) / 2,
    ),
    boundaries,
    area: parts.reduce((sum, part) => sum + part.area, 0),
    size: extentOf(positions),
    parts,
  };
}

/** Whether two vertices lie on each other. */
function areAlike(positions: Float32Array): boolean {
  const count = positions.length / 3;
  const bits = new Uint32Array(positions.length);
  // 0 and -0 are the same place.
  new Float32Array(bits.buffer).set(positions.map((x) => x + 0));
  const size = 2 ** Math.ceil(Math.log2(2 * count + 1));
  const table = new Uint32Array(size).fill(none);
  for (let v = 0; v < count; ++v) {
    const [x, y, z] = [bits[3 * v]!, bits[3 * v + 1]!, bits[3 * v + 2]!];
    let hash = Math.imul(x ^ (x >>> 15), 0x85ebca6b) ^ Math.imul(y ^ (y >>> 13), 0xc2b2ae35);
    hash = Math.imul(hash ^ (hash >>> 16) ^ z, 0x27d4eb2f);
    let place = (hash ^ (hash >>> 15)) & (size - 1);
    for (; table[place] !== none; place = (place + 1) & (size - 1)) {
      const w = 3 * table[place]!;
      if (bits[w] === x && bits[w + 1] === y && bits[w + 2] === z) return true;
    }
    table[place] = v;
  }
  return false;
}

/** The opposite of each halfedge; undefined where an edge has two that run the same way. */
function* oppositesOf(
  vertexCount: number,
  indices: Uint32Array,
): Generator<void, Uint32Array | undefined> {
  const first = new Uint32Array(vertexCount + 1);
  for (const vertex of indices) ++first[vertex + 1]!;
  for (let v = 0; v < vertexCount; ++v) {
    if (first[v + 1] === 0) return undefined;
    first[v + 1]! += first[v]!;
  }
  const leaving = new Uint32Array(indices.length);
  const next = first.slice(0, vertexCount);
  for (let h = 0; h < indices.length; ++h) leaving[next[indices[h]!]!++] = h;
  const opposite = new Uint32Array(indices.length).fill(none);
  for (let h = 0; h < indices.length; ++h) {
    if (h % chunk === 0) yield;
    const [a, b] = [indices[h]!, indices[nextOf(h)]!];
    if (a === b) return undefined;
    for (let i = first[a]!; i < first[a + 1]!; ++i) {
      const other = leaving[i]!;
      if (other !== h && indices[nextOf(other)] === b) return undefined;
    }
    for (let i = first[b]!; i < first[b + 1]!; ++i) {
      if (indices[nextOf(leaving[i]!)] === a) opposite[h] = leaving[i]!;
    }
  }
  // Turning about a vertex must meet all its faces.
  const start = firstHalfedges(vertexCount, indices, opposite);
  for (let v = 0; v < vertexCount; ++v) {
    let count = 0;
    let h = start[v]!;
    do {
      ++count;
      h = opposite[previousOf(h)]!;
    } while (h !== none && h !== start[v]);
    if (count !== first[v + 1]! - first[v]!) return undefined;
  }
  return opposite;
}

/** For each vertex a halfedge that leaves it: at the boundary, the one without an opposite. */
function firstHalfedges(vertexCount: number, indices: Uint32Array, opposite: Uint32Array) {
  const start = new Uint32Array(vertexCount).fill(none);
  for (let h = 0; h < indices.length; ++h) {
    const vertex = indices[h]!;
    if (start[vertex] === none || opposite[h] === none) start[vertex] = h;
  }
  return start;
}

function extentOf(positions: Float32Array): [number, number, number] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    low[i % 3] = Math.min(low[i % 3]!, positions[i]!);
    high[i % 3] = Math.max(high[i % 3]!, positions[i]!);
  }
  return [high[0]! - low[0]!, high[1]! - low[1]!, high[2]! - low[2]!];
}
