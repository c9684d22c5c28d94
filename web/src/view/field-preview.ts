// A field while it is being computed: the values so far, and for every other vertex the value of
// the nearest vertex that has one.

import type { PartialField } from '../kernel/types/types.js';
import type { Adjacency } from './adjacency.js';

/** Hops of a vertex that no value has reached. */
const unreached = 0xffff;

/**
 * Keeps for every vertex the value of the computed vertex that is fewest edges away. Values come in
 * batches spread over the whole surface, so each new one claims an ever smaller neighbourhood and
 * the whole costs little more than touching every vertex a few times.
 */
export class FieldPreview {
  /** One per vertex: computed, or borrowed from the nearest computed one; NaN where there is none. */
  readonly shown: Float32Array;
  /** One per vertex: the computed value, or a lent one; NaN where there is none, or none yet. */
  readonly values: Float64Array;
  /** Vertices computed so far. */
  computed = 0;
  /** Smallest and largest value so far; undefined before the first. */
  range: [number, number] | undefined;

  #isLent = false;
  readonly #hops: Uint16Array;
  readonly #queue: number[] = [];
  #head = 0;
  readonly #adjacency: Adjacency;

  constructor(adjacency: Adjacency) {
    this.#adjacency = adjacency;
    const vertexCount = adjacency.first.length - 1;
    this.values = new Float64Array(vertexCount).fill(NaN);
    this.shown = new Float32Array(vertexCount).fill(NaN);
    this.#hops = new Uint16Array(vertexCount).fill(unreached);
  }

  /** Whether no value is left to spread: `spread` would change nothing. */
  get isSpread(): boolean {
    return this.#head === this.#queue.length;
  }

  /** True where the vertex's own value has been computed. */
  isComputed(vertex: number): boolean {
    return this.#hops[vertex] === 0;
  }

  /** Whether the values are those of fewer triangles. */
  get isLent(): boolean {
    return this.#isLent;
  }

  /** Takes values of elsewhere, one per vertex, in place of what there is: none of them counts as computed. */
  lend(values: Float64Array, range: readonly [number, number]): void {
    this.#isLent = true;
    this.values.set(values);
    this.shown.set(values);
    this.#hops.fill(unreached);
    this.#queue.length = this.#head = this.computed = 0;
    if (!Number.isNaN(range[0])) this.range = [...range];
  }

  /** Takes new values; `changed` is called for each of their vertices. */
  receive({ vertices, values }: PartialField, changed: (vertex: number) => void): void {
    for (let i = 0; i < vertices.length; ++i) {
      const vertex = vertices[i]!;
      const value = values[i]!;
      if (this.#hops[vertex] !== 0) ++this.computed;
      this.values[vertex] = value;
      this.shown[vertex] = value;
      this.#hops[vertex] = 0;
      changed(vertex);
      // A place without a value has none to lend.
      if (Number.isNaN(value)) continue;
      this.range = this.range
        ? [Math.min(this.range[0], value), Math.max(this.range[1], value)]
        : [value, value];
      this.#queue.push(vertex);
    }
  }

  /**
   * Spreads values to vertices without one until nothing is left or `now()` reaches `deadline`;
   * `changed` is called for each vertex that takes a new value. Returns whether nothing is left.
   */
  spread(changed: (vertex: number) => void, deadline = Infinity, now = () => 0): boolean {
    const { first, neighbours } = this.#adjacency;
    while (this.#head < this.#queue.length) {
      if (this.#head % 256 === 0 && now() >= deadline) return false;
      const vertex = this.#queue[this.#head++]!;
      const hops = this.#hops[vertex]! + 1;
      for (let k = first[vertex]!; k < first[vertex + 1]!; ++k) {
        const neighbour = neighbours[k]!;
        if (this.#hops[neighbour]! <= hops) continue;
        this.#hops[neighbour] = hops;
        this.shown[neighbour] = this.shown[vertex]!;
        this.#queue.push(neighbour);
        changed(neighbour);
      }
    }
    this.#queue.length = 0;
    this.#head = 0;
    return true;
  }
}
