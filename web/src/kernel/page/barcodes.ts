// The barcodes of all vertices, from which the persistent girth is read without computing again.

import { failure } from '../types/errors.js';
import { FieldRun, summaryOf } from './field-run.js';
import type { FinishedValues } from '../types/protocol.js';
import type { Barcodes, Field, WatchedOptions } from '../types/types.js';

/** Kinds as fields have them. */
const [loop, unresolved] = [0, 2];

/** Collects the barcodes that the workers have finished. */
export class BarcodeRun extends FieldRun {
  readonly #bars: Float64Array[];

  constructor(vertexCount: number, { onProgress, signal }: WatchedOptions) {
    super(vertexCount, true, { ...(onProgress && { onProgress }), ...(signal && { signal }) });
    this.#bars = Array.from({ length: vertexCount }, () => new Float64Array(0));
  }

  override add(finished: FinishedValues): void {
    const { vertices, counts, bars } = finished;
    let at = 0;
    vertices.forEach((vertex, i) => {
      const end = at + 2 * (counts?.[i] ?? 0);
      if (bars && end > at) this.#bars[vertex] = bars.slice(at, end);
      at = end;
    });
    super.add(finished);
  }

  /** All of them, once they are complete. */
  barcodes(maxPersistence: number, unit: string): Barcodes {
    const offsets = new Uint32Array(this.#bars.length + 1);
    this.#bars.forEach((bars, v) => (offsets[v + 1] = offsets[v]! + bars.length / 2));
    const bars = new Float64Array(2 * offsets[this.#bars.length]!);
    this.#bars.forEach((some, v) => bars.set(some, 2 * offsets[v]!));
    const whole = { maxPersistence, offsets, bars, rest: this.values, restKinds: this.kinds, unit };
    return { ...whole, girth: (persistence) => girthOf(whole, persistence) };
  }
}

/** I_tau of every vertex, as `Barcode::girth` in barcode.h. */
function girthOf(barcodes: Omit<Barcodes, 'girth'>, persistence: number): Field {
  const { maxPersistence, offsets, bars, rest, restKinds, unit } = barcodes;
  if (!(persistence > 0 && persistence <= maxPersistence)) {
    throw failure('USAGE', `the persistence ${persistence} cannot be read off`, {
      hint: `choose one above 0 and up to ${maxPersistence}`,
    });
  }
  const values = rest.slice();
  const kinds = restKinds.slice();
  for (let v = 0; v < rest.length; ++v) {
    for (let bar = offsets[v]!; bar < offsets[v + 1]!; ++bar) {
      const [birth, death] = [bars[2 * bar]!, bars[2 * bar + 1]!];
      if (!(death - birth > persistence)) continue;
      values[v] = 2 * birth;
      kinds[v] = loop;
      break;
    }
  }
  const isUnresolved = kinds.includes(unresolved);
  return {
    name: 'igf',
    values,
    kinds,
    ...summaryOf(values),
    unit,
    method: `exact, persistence ${persistence}`,
    persistence,
    note: isUnresolved ? 'some values are lower bounds: the search was given up there' : '',
  };
}
