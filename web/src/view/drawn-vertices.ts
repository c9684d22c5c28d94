// Values per vertex of a mesh, handed to a surface that draws some vertices several times.

import { BufferAttribute, DynamicDrawUsage } from 'three';

/**
 * The vertices of a mesh as they are drawn: first each of them, then their copies at creases. An array that `attribute`
 * makes has an entry for all; write those of the mesh, then `upload`.
 */
export class DrawnVertices {
  readonly #firstCopy: Int32Array;
  readonly #nextCopy: Int32Array;
  readonly count: number;
  readonly #copyOf: Uint32Array;

  /** Copy i, which is drawn vertex `count + i`, is one of vertex `copyOf[i]`. */
  constructor(count: number, copyOf: Uint32Array) {
    this.count = count;
    this.#copyOf = copyOf;
    this.#firstCopy = new Int32Array(count).fill(-1);
    this.#nextCopy = new Int32Array(copyOf.length).fill(-1);
    copyOf.forEach((vertex, copy) => {
      this.#nextCopy[copy] = this.#firstCopy[vertex]!;
      this.#firstCopy[vertex] = copy;
    });
  }

  /** `size` numbers a vertex, all 0: floats, or bytes that mean shares from 0 to 1. */
  attribute(size: number, kind: 'floats' | 'shares'): BufferAttribute {
    const length = size * (this.count + this.#copyOf.length);
    const attribute =
      kind === 'floats'
        ? new BufferAttribute(new Float32Array(length), size)
        : new BufferAttribute(new Uint8Array(length), size, true);
    attribute.setUsage(DynamicDrawUsage);
    return attribute;
  }

  /** Sets what one vertex and its copies have. */
  set(attribute: BufferAttribute, vertex: number, x: number, y: number): void {
    const data = attribute.array;
    data[2 * vertex] = x;
    data[2 * vertex + 1] = y;
    for (let copy = this.#firstCopy[vertex]!; copy >= 0; copy = this.#nextCopy[copy]!) {
      data[2 * (this.count + copy)] = x;
      data[2 * (this.count + copy) + 1] = y;
    }
  }

  /** Gives the copies what the vertices have, and sends all with the next frame. */
  upload(attribute: BufferAttribute): void {
    const { array: data, itemSize: size } = attribute;
    for (let copy = 0; copy < this.#copyOf.length; ++copy) {
      const from = size * this.#copyOf[copy]!;
      const to = size * (this.count + copy);
      for (let k = 0; k < size; ++k) data[to + k] = data[from + k]!;
    }
    attribute.needsUpdate = true;
  }
}
