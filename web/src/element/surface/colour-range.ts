// Which values the ends of the colour map are.
//
// Where nothing is wished for, the colours follow the body of the values: where few places stretch the range,
// the map ends where the body does, and the legend shows what lies beyond.

import { quantiles } from '../../view/index.js';

/** Shares of the surface that may lie below and above the body. */
const tail = 0.02;
/** A tail is cut where it is longer than this share of the body's width. */
const stretch = 0.6;
/** While values arrive, the body is looked at again after so many times as many of them. */
const growth = 1.25;

export type Ends = readonly [number, number];

/** Values of a field, as far as they are there. */
export interface Values {
  values: Float64Array;
  /** So many of them are there. */
  count: number;
  /** The areas that they count by; undefined: all alike. */
  weights: Float64Array | undefined;
  /** The smallest and the largest. */
  extent: Ends;
}

export class ColourRange {
  #body: { of: Values; ends: Ends } | undefined;
  #shares: { key: unknown; shares: string; ends: Ends } | undefined;

  /** The extent, without the tails that stretch it. */
  bodyOf(of: Values): Ends {
    const known = this.#body;
    const isSame =
      known?.of.values === of.values &&
      known.of.weights === of.weights &&
      (known.of.count === of.count ||
        (of.count < of.values.length && of.count < growth * known.of.count));
    if (!isSame) {
      this.#body = { of, ends: withoutTails(of.values, of.weights, of.extent) };
      return this.#body.ends;
    }
    // More values have come in: an end that was the extent's is so still.
    const { ends } = known;
    const [low, high] = known.of.extent;
    return [ends[0] === low ? of.extent[0] : ends[0], ends[1] === high ? of.extent[1] : ends[1]];
  }

  /** The values below which two shares of the surface lie. */
  sharesOf(values: Float64Array, weights: Float64Array, shares: Ends): Ends {
    const words = shares.join();
    if (this.#shares?.key !== values || this.#shares.shares !== words) {
      const [low, high] = quantiles(values, weights, shares);
      this.#shares = { key: values, shares: words, ends: [low!, high!] };
    }
    return this.#shares.ends;
  }
}

/** The ends of the body of some values. */
export function withoutTails(
  values: Float64Array,
  weights: Float64Array | undefined,
  [low, high]: Ends,
): Ends {
  const [first, last] = quantiles(values, weights, [tail, 1 - tail]);
  const width = last! - first!;
  if (!(width > 0)) return [low, high];
  return [
    first! - low > stretch * width ? first! : low,
    high - last! > stretch * width ? last! : high,
  ];
}
