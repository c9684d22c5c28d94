// Copies of large arrays, made piece by piece: a page answers in between.

/** Bytes that are copied in one task. */
const piece = 1 << 20;

type Numbers = Float64Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;

/** A copy of each array. */
export async function copiedInPieces<A extends object>(arrays: A): Promise<A> {
  const copies: Record<string, Numbers> = {};
  for (const [name, array] of Object.entries(arrays) as [string, Numbers][]) {
    const copy =
      array instanceof Float64Array
        ? new Float64Array(array.length)
        : new Uint32Array(array.length);
    const step = piece / array.BYTES_PER_ELEMENT;
    for (let i = 0; i < array.length; i += step) {
      copy.set(array.subarray(i, i + step), i);
      await new Promise((done) => setTimeout(done));
    }
    copies[name] = copy;
  }
  return copies as A;
}
