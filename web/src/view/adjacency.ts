// Which vertices share an edge.

/** The neighbours of vertex v are `neighbours[first[v]]` up to `neighbours[first[v + 1] - 1]`. */
export interface Adjacency {
  first: Uint32Array;
  neighbours: Uint32Array;
}

/**
 * Neighbours along edges. Inside the surface every halfedge has its opposite: the origins' next
 * vertices are then all neighbours. `boundary` has the two vertices of each halfedge that has none.
 * Yields between chunks of work.
 */
export function* buildAdjacency(
  vertexCount: number,
  indices: ArrayLike<number>,
  boundary: ArrayLike<number> = [],
): Generator<void, Adjacency> {
  const first = new Uint32Array(vertexCount + 1);
  const chunk = 1 << 12;
  for (let i = 0; i < indices.length; ++i) {
    first[indices[i]! + 1]!++;
    if (i % chunk === chunk - 1) yield;
  }
  for (let w = 1; w < boundary.length; w += 2) first[boundary[w]! + 1]!++;
  for (let v = 0; v < vertexCount; ++v) first[v + 1]! += first[v]!;
  const next = first.slice(0, vertexCount);
  const neighbours = new Uint32Array(indices.length + boundary.length / 2);
  for (let i = 0; i < indices.length; ++i) {
    const to = i % 3 === 2 ? indices[i - 2]! : indices[i + 1]!;
    neighbours[next[indices[i]!]!++] = to;
    if (i % chunk === chunk - 1) yield;
  }
  for (let w = 1; w < boundary.length; w += 2) neighbours[next[boundary[w]!]!++] = boundary[w - 1]!;
  return { first, neighbours };
}
