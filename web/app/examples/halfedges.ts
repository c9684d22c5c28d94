// A closed triangle mesh that can be changed in place. Halfedges 3f, 3f + 1, 3f + 2 belong to face f, in
// order; removed faces and vertices stay as holes in the arrays until `triangles` leaves them out.

import type { Triangles } from './polygonise.ts';

export const removed = -1;

export class HalfedgeMesh {
  readonly x: number[] = [];
  readonly y: number[] = [];
  readonly z: number[] = [];
  /** Per vertex: a halfedge that starts there; `removed` for a vertex that is no more. */
  readonly outgoing: number[] = [];
  /** Per halfedge: the vertex it starts from; `removed` for those of a face that is no more. */
  readonly origin: number[] = [];
  readonly twin: number[] = [];
  faceCount = 0;

  /** Throws where the triangles are not closed and consistently oriented. */
  constructor({ positions, indices }: Triangles) {
    for (let v = 0; 3 * v < positions.length; ++v) {
      this.addVertex(positions[3 * v]!, positions[3 * v + 1]!, positions[3 * v + 2]!);
    }
    const vertices = this.vertexSlots;
    const halfedgeOf = new Map<number, number>();
    for (let h = 0; h < indices.length; ++h) {
      this.origin.push(indices[h]!);
      this.twin.push(removed);
      this.outgoing[indices[h]!] = h;
    }
    this.faceCount = indices.length / 3;
    for (let h = 0; h < indices.length; ++h) {
      const key = this.origin[h]! * vertices + this.target(h);
      if (halfedgeOf.has(key))
        throw new Error(`two faces have the edge ${this.origin[h]} ${this.target(h)}`);
      halfedgeOf.set(key, h);
    }
    for (let h = 0; h < indices.length; ++h) {
      const other = halfedgeOf.get(this.target(h) * vertices + this.origin[h]!);
      if (other === undefined)
        throw new Error(`edge ${this.origin[h]} ${this.target(h)} has one face only`);
      this.twin[h] = other;
    }
  }

  get vertexSlots(): number {
    return this.x.length;
  }

  get halfedgeSlots(): number {
    return this.origin.length;
  }

  next(h: number): number {
    return h % 3 === 2 ? h - 2 : h + 1;
  }

  previous(h: number): number {
    return h % 3 === 0 ? h + 2 : h - 1;
  }

  target(h: number): number {
    return this.origin[this.next(h)]!;
  }

  /** The third vertex of the halfedge's face. */
  opposite(h: number): number {
    return this.origin[this.previous(h)]!;
  }

  /** The next halfedge from the same vertex; going on, all of them. */
  rotated(h: number): number {
    return this.twin[this.previous(h)]!;
  }

  valence(v: number): number {
    const start = this.outgoing[v]!;
    let count = 0;
    let h = start;
    do {
      ++count;
      h = this.rotated(h);
    } while (h !== start);
    return count;
  }

  length(h: number): number {
    const a = this.origin[h]!;
    const b = this.target(h);
    const dx = this.x[b]! - this.x[a]!;
    const dy = this.y[b]! - this.y[a]!;
    const dz = this.z[b]! - this.z[a]!;
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  addVertex(x: number, y: number, z: number): number {
    this.x.push(x);
    this.y.push(y);
    this.z.push(z);
    this.outgoing.push(removed);
    return this.x.length - 1;
  }

  /** Cuts the edge of h, and its two faces, at a new vertex, which is returned. */
  split(h: number, x: number, y: number, z: number): number {
    const { origin, twin, outgoing } = this;
    const t = twin[h]!;
    const [h1, h2, t2] = [this.next(h), this.previous(h), this.previous(t)];
    const [b, c, d] = [origin[t]!, origin[h2]!, origin[t2]!];
    const [outer, lower] = [twin[h1]!, twin[t2]!];
    const m = this.addVertex(x, y, z);
    const n = origin.length;
    // Faces (a, m, c) and (m, a, d) in the old slots, (m, b, c) and (b, m, d) in new ones.
    origin[h1] = m;
    origin[t] = m;
    origin.push(m, b, c, b, m, d);
    twin.push(0, 0, 0, 0, 0, 0);
    this.pair(n, n + 3);
    this.pair(h1, n + 2);
    this.pair(t2, n + 4);
    this.pair(n + 1, outer);
    this.pair(n + 5, lower);
    outgoing[m] = n;
    outgoing[b] = n + 1;
    this.faceCount += 2;
    return m;
  }

  /** Replaces the edge of h by the other diagonal of its two faces. */
  flip(h: number): void {
    const { origin, twin, outgoing } = this;
    const t = twin[h]!;
    const [h1, h2, t1, t2] = [this.next(h), this.previous(h), this.next(t), this.previous(t)];
    const [a, b, c, d] = [origin[h]!, origin[t]!, origin[h2]!, origin[t2]!];
    const [bc, ca, ad, db] = [twin[h1]!, twin[h2]!, twin[t1]!, twin[t2]!];
    [origin[h], origin[h1], origin[h2]] = [c, d, b];
    [origin[t], origin[t1], origin[t2]] = [d, c, a];
    this.pair(h1, db);
    this.pair(h2, bc);
    this.pair(t1, ca);
    this.pair(t2, ad);
    outgoing[a] = t2;
    outgoing[b] = h2;
    outgoing[c] = h;
    outgoing[d] = t;
  }

  /**
   * Whether the edge of h can be shrunk to a point with the mesh staying manifold and no vertex getting
   * fewer than four neighbours.
   */
  canCollapse(h: number): boolean {
    const a = this.origin[h]!;
    const b = this.target(h);
    let common = 0;
    this.around(a, (v) => {
      if (this.findHalfedge(b, v) !== removed) ++common;
    });
    return (
      common === 2 &&
      this.valence(this.opposite(h)) > 4 &&
      this.valence(this.opposite(this.twin[h]!)) > 4
    );
  }

  /** Removes the edge of h, its two faces and its origin; its target takes over the origin's faces. */
  collapse(h: number): void {
    const { origin, twin, outgoing } = this;
    const t = twin[h]!;
    const [h1, h2, t1, t2] = [this.next(h), this.previous(h), this.next(t), this.previous(t)];
    const [a, b, c, d] = [origin[h]!, origin[t]!, origin[h2]!, origin[t2]!];
    const fromA: number[] = [];
    let g = h;
    do {
      fromA.push(g);
      g = this.rotated(g);
    } while (g !== h);
    for (const other of fromA) origin[other] = b;
    const [cb, ac, da, bd] = [twin[h1]!, twin[h2]!, twin[t1]!, twin[t2]!];
    this.pair(cb, ac);
    this.pair(da, bd);
    outgoing[a] = removed;
    outgoing[b] = ac;
    outgoing[c] = cb;
    outgoing[d] = da;
    for (const gone of [h, h1, h2, t, t1, t2]) origin[gone] = removed;
    this.faceCount -= 2;
  }

  findHalfedge(from: number, to: number): number {
    const start = this.outgoing[from]!;
    let h = start;
    do {
      if (this.target(h) === to) return h;
      h = this.rotated(h);
    } while (h !== start);
    return removed;
  }

  /** Calls with each vertex next to v. */
  around(v: number, visit: (neighbour: number) => void): void {
    const start = this.outgoing[v]!;
    let h = start;
    do {
      visit(this.target(h));
      h = this.rotated(h);
    } while (h !== start);
  }

  /** The mesh as arrays, without the holes; vertices in the order of their first use by a face. */
  triangles(): Triangles {
    const numbers = new Map<number, number>();
    const positions: number[] = [];
    const indices: number[] = [];
    for (const v of this.origin) {
      if (v === removed) continue;
      let number = numbers.get(v);
      if (number === undefined) {
        number = numbers.size;
        numbers.set(v, number);
        positions.push(this.x[v]!, this.y[v]!, this.z[v]!);
      }
      indices.push(number);
    }
    return { positions, indices };
  }

  private pair(h: number, t: number): void {
    this.twin[h] = t;
    this.twin[t] = h;
  }
}
