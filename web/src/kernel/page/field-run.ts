// One computation of a field, independent of the engine: it collects finished values and reports them at
// intervals.

import type { FieldRequest, FoundRefined, RefinedRequest, Report } from '../types/protocol.js';
import type { SurfaceSource } from './surface-source.js';
import type { FieldOptions, PartialField } from '../types/types.js';

/** Reports that would follow each other faster than this are joined: the page draws each of them. */
const reportMilliseconds = 40;

/** Computes whole fields, one at a time. */
export interface FieldEngine {
  /**
   * Calls `run.add` with new values until all are there. Stops when `signal` fires; another call goes on from there.
   * The promise settles when the workers are free again, which may be later.
   */
  compute(
    surface: SurfaceSource,
    field: FieldRequest,
    run: FieldRun,
    signal: AbortSignal,
  ): Promise<void>;
  /** The refined girth by all workers, until `signal` fires; undefined where they cannot share one call. */
  refined?(
    surface: SurfaceSource,
    request: RefinedRequest,
    onReport: (report: Report) => void,
    signal: AbortSignal,
  ): Promise<FoundRefined>;
}

export class FieldRun {
  readonly values: Float64Array<ArrayBuffer>;
  /** Empty where the field has no kinds. */
  readonly kinds: Uint8Array<ArrayBuffer>;
  readonly #options: FieldOptions;
  readonly #now: () => number;
  /** 1 at vertices whose values have been added. */
  readonly #added: Uint8Array<ArrayBuffer>;
  #done = 0;
  #progress = 0;
  #unreported: PartialField[] = [];
  #reportedAt = -Infinity;

  constructor(
    vertexCount: number,
    hasKinds: boolean,
    options: FieldOptions,
    now = () => performance.now(),
  ) {
    this.values = new Float64Array(vertexCount).fill(NaN);
    this.kinds = new Uint8Array(hasKinds ? vertexCount : 0);
    this.#added = new Uint8Array(vertexCount);
    this.#options = options;
    this.#now = now;
  }

  get complete(): boolean {
    return this.#done === this.values.length;
  }

  /** 1 at vertices whose values have been added, one element a vertex; empty before the first. */
  get known(): Uint8Array<ArrayBuffer> {
    return this.#done > 0 ? this.#added.slice() : new Uint8Array(0);
  }

  /** Adds finished values. No vertex comes twice. */
  add(partial: PartialField): void {
    partial.vertices.forEach((vertex, i) => {
      this.values[vertex] = partial.values[i]!;
      this.#added[vertex] = 1;
    });
    partial.kinds.forEach((kind, i) => (this.kinds[partial.vertices[i]!] = kind));
    this.#done += partial.vertices.length;
    this.#unreported.push(partial);
    if (this.complete || this.#now() - this.#reportedAt >= reportMilliseconds) this.flush();
  }

  /** Reports the values that have not been reported. */
  flush(): void {
    if (this.#unreported.length === 0) return;
    const partials = this.#unreported;
    this.#unreported = [];
    this.#reportedAt = this.#now();
    this.#options.onPartial?.(partials.length === 1 ? partials[0]! : joined(partials));
    const progress = this.#done / this.values.length;
    if (progress > this.#progress) {
      this.#progress = progress;
      this.#options.onProgress?.(progress);
    }
  }
}

/** The smallest and the largest value (NaN twice where there is none), and how many are missing. */
export function summaryOf(values: Float64Array): { range: [number, number]; withoutValue: number } {
  let [low, high] = [Infinity, -Infinity];
  let withoutValue = 0;
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
    if (Number.isNaN(value)) ++withoutValue;
  }
  return { range: low <= high ? [low, high] : [NaN, NaN], withoutValue };
}

function joined(partials: PartialField[]): PartialField {
  const count = partials.reduce((sum, { vertices }) => sum + vertices.length, 0);
  const whole = {
    vertices: new Uint32Array(count),
    values: new Float64Array(count),
    kinds: new Uint8Array(partials[0]!.kinds.length > 0 ? count : 0),
  };
  let at = 0;
  for (const { vertices, values, kinds } of partials) {
    whole.vertices.set(vertices, at);
    whole.values.set(values, at);
    if (whole.kinds.length > 0) whole.kinds.set(kinds, at);
    at += vertices.length;
  }
  return whole;
}
