// A long way over a surface, from edge to edge: something to slide along.

import type { Adjacency } from './adjacency.js';

/**
 * The vertices of a shortest way, counted in edges, between two that are far apart: the farthest from vertex
 * 0 and the farthest from that one. In the first one's component; linear in the edges.
 */
export function longWay({ first, neighbours }: Adjacency): number[] {
  if (first.length < 2) return [];
  const explore = (from: number): { last: number; cameFrom: Int32Array } => {
    const cameFrom = new Int32Array(first.length - 1).fill(-1);
    cameFrom[from] = from;
    const queue = new Int32Array(first.length - 1);
    queue[0] = from;
    let end = 1;
    for (let at = 0; at < end; ++at) {
      const vertex = queue[at]!;
      for (let k = first[vertex]!; k < first[vertex + 1]!; ++k) {
        const next = neighbours[k]!;
        if (cameFrom[next] !== -1) continue;
        cameFrom[next] = vertex;
        queue[end++] = next;
      }
    }
    return { last: queue[end - 1]!, cameFrom };
  };
  const start = explore(0).last;
  const { last, cameFrom } = explore(start);
  const way = [last];
  while (way.at(-1) !== start) way.push(cameFrom[way.at(-1)!]!);
  return way;
}
