// Smooth shading that keeps creases.

/** A surface ready to draw: the first vertices are those of the mesh, copies at creases follow. */
export interface CreasedSurface {
  /** x, y, z per drawn vertex. */
  positions: Float32Array;
  /** Unit normals, x, y, z per drawn vertex. */
  normals: Float32Array;
  indices: Uint32Array;
  /** The mesh vertex of each copy; copy i is drawn vertex `vertexCount + i`. */
  copyOf: Uint32Array;
}

/** Round a vertex of up to so many faces, the face beyond an edge is sought one by one. */
const fewFaces = 16;

/** A corner's face, as its first corner; and the vertices after and before the corner in it. */
const faceOf = (c: number): number => c - (c % 3);
const ahead = (indices: Uint32Array, c: number): number =>
  c % 3 === 2 ? indices[c - 2]! : indices[c + 1]!;
const behind = (indices: Uint32Array, c: number): number =>
  c % 3 === 0 ? indices[c + 2]! : indices[c - 1]!;

/**
 * Splits vertices along edges whose faces' normals differ by more than `creaseAngle` (radians) and
 * gives every drawn vertex the mean normal of its faces, weighted by their angles at it. Yields
 * between chunks of work.
 */
export function* splitCreases(
  positions: Float32Array,
  indices: Uint32Array,
  creaseAngle: number,
): Generator<void, CreasedSurface> {
  const vertexCount = positions.length / 3;
  const cornerCount = indices.length;
  const cosine = Math.cos(creaseAngle);
  const chunk = 1 << 11;

  // Unit face normals and the corners' angles.
  const faceNormals = new Float32Array(cornerCount);
  const angles = new Float32Array(cornerCount);
  const e = new Float64Array(9);
  for (let f = 0; f < cornerCount; f += 3) {
    for (let k = 0; k < 3; ++k) {
      const a = 3 * indices[f + k]!;
      const b = 3 * indices[f + ((k + 1) % 3)]!;
      const x = positions[b]! - positions[a]!;
      const y = positions[b + 1]! - positions[a + 1]!;
      const z = positions[b + 2]! - positions[a + 2]!;
      const length = Math.sqrt(x * x + y * y + z * z) || 1;
      e[3 * k] = x / length;
      e[3 * k + 1] = y / length;
      e[3 * k + 2] = z / length;
    }
    for (let k = 0; k < 3; ++k) {
      const p = 3 * ((k + 2) % 3);
      const q = 3 * k;
      const dot = e[p]! * e[q]! + e[p + 1]! * e[q + 1]! + e[p + 2]! * e[q + 2]!;
      angles[f + k] = Math.acos(Math.min(1, Math.max(-1, -dot)));
    }
    const x = e[1]! * e[5]! - e[2]! * e[4]!;
    const y = e[2]! * e[3]! - e[0]! * e[5]!;
    const z = e[0]! * e[4]! - e[1]! * e[3]!;
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    faceNormals[f] = x / length;
    faceNormals[f + 1] = y / length;
    faceNormals[f + 2] = z / length;
    if (f % (3 * chunk) === 0) yield;
  }

  // Corners round each vertex.
  const first = new Uint32Array(vertexCount + 1);
  for (let c = 0; c < cornerCount; ++c) {
    first[indices[c]! + 1]! += 1;
    if (c % (32 * chunk) === 0) yield;
  }
  for (let v = 0; v < vertexCount; ++v) first[v + 1]! += first[v]!;
  yield;
  const corners = new Uint32Array(cornerCount);
  const fill = first.slice(0, vertexCount);
  for (let c = 0; c < cornerCount; ++c) {
    corners[fill[indices[c]!]!++] = c;
    if (c % (32 * chunk) === 0) yield;
  }

  // Faces round a vertex belong together when one can walk from one to the other across soft edges.
  const drawn = new Uint32Array(cornerCount);
  const copies: number[] = [];
  const group: number[] = [];
  const drawnOfGroup: number[] = [];
  const find = (i: number): number => {
    while (group[i] !== i) i = group[i] = group[group[i]!]!;
    return i;
  };
  for (let v = 0; v < vertexCount; ++v) {
    const start = first[v]!;
    const count = first[v + 1]! - start;
    const faceBefore = count > fewFaces ? new Map<number, number>() : undefined;
    for (let i = 0; i < count; ++i) {
      group[i] = i;
      drawnOfGroup[i] = -1;
      faceBefore?.set(behind(indices, corners[start + i]!), i);
    }
    for (let i = 0; i < count; ++i) {
      const c = corners[start + i]!;
      const next = ahead(indices, c);
      let j = 0;
      if (faceBefore) j = faceBefore.get(next) ?? count;
      else while (j < count && behind(indices, corners[start + j]!) !== next) ++j;
      if (j === count) continue;
      const a = faceOf(c);
      const b = faceOf(corners[start + j]!);
      const dot =
        faceNormals[a]! * faceNormals[b]! +
        faceNormals[a + 1]! * faceNormals[b + 1]! +
        faceNormals[a + 2]! * faceNormals[b + 2]!;
      if (dot >= cosine) group[find(i)] = find(j);
    }
    let isOwnTaken = false;
    for (let i = 0; i < count; ++i) {
      const root = find(i);
      let vertex = drawnOfGroup[root]!;
      if (vertex < 0) {
        vertex = isOwnTaken ? vertexCount + copies.push(v) - 1 : v;
        isOwnTaken = true;
        drawnOfGroup[root] = vertex;
      }
      drawn[corners[start + i]!] = vertex;
    }
    if (v % chunk === 0) yield;
  }

  const drawnCount = vertexCount + copies.length;
  const drawnPositions = new Float32Array(3 * drawnCount);
  drawnPositions.set(positions);
  copies.forEach((v, i) =>
    drawnPositions.set(positions.subarray(3 * v, 3 * v + 3), 3 * (vertexCount + i)),
  );
  const normals = new Float32Array(3 * drawnCount);
  for (let c = 0; c < cornerCount; ++c) {
    const to = 3 * drawn[c]!;
    const from = faceOf(c);
    for (let k = 0; k < 3; ++k) normals[to + k]! += angles[c]! * faceNormals[from + k]!;
    if (c % (8 * chunk) === 0) yield;
  }
  for (let i = 0; i < normals.length; i += 3) {
    if (i % (24 * chunk) === 0) yield;
    const [x, y, z] = [normals[i]!, normals[i + 1]!, normals[i + 2]!];
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    for (let k = 0; k < 3; ++k) normals[i + k]! /= length;
  }
  return { positions: drawnPositions, normals, indices: drawn, copyOf: Uint32Array.from(copies) };
}
