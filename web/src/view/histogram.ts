// The distribution of a field's values.

export interface Histogram {
  /** Values per bin, of equal width between `low` and `high`. */
  counts: Uint32Array;
  low: number;
  high: number;
  /** The finite values counted. */
  total: number;
  /** The largest count. */
  peak: number;
}

/** Smallest and largest finite value; undefined where there is none. */
export function extent(values: ArrayLike<number>): [number, number] | undefined {
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!;
    if (!Number.isFinite(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : undefined;
}

/** Counts the finite values in `bins` bins over [low, high]; the last bin includes `high`. */
export function histogram(
  values: ArrayLike<number>,
  bins: number,
  [low, high]: readonly [number, number],
): Histogram {
  const counts = new Uint32Array(bins);
  const scale = high > low ? bins / (high - low) : 0;
  let total = 0;
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!;
    if (!(value >= low && value <= high)) continue;
    counts[Math.min(bins - 1, Math.floor((value - low) * scale))]!++;
    ++total;
  }
  return { counts, low, high, total, peak: counts.reduce((a, b) => Math.max(a, b), 0) };
}

/** The middle value of the finite ones; NaN where there is none. */
export function median(values: ArrayLike<number>): number {
  const sorted = Float64Array.from(values).filter(Number.isFinite).sort();
  const half = sorted.length >> 1;
  if (sorted.length === 0) return NaN;
  return sorted.length % 2 ? sorted[half]! : (sorted[half - 1]! + sorted[half]!) / 2;
}
