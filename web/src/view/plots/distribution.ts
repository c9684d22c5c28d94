// The distribution of a field's values over a surface: each value counts by its weight, which is the
// area of its vertex. Values that are no numbers do not count. Everything is O(n).

/** One number for each value, not negative; undefined: every value counts 1. */
export type Weights = ArrayLike<number> | undefined;

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

/** Calls `act` with each finite value and its weight; the sum of their weights. */
function forEachFinite(
  values: ArrayLike<number>,
  weights: Weights,
  act: (value: number, weight: number) => void,
): number {
  let total = 0;
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!;
    if (!Number.isFinite(value)) continue;
    const weight = weights ? weights[i]! : 1;
    total += weight;
    act(value, weight);
  }
  return total;
}

/** Shares of values in bins. */
export interface Histogram {
  /** Weight in each bin as a share of the weight of all finite values; the bins are equally wide. */
  shares: Float64Array;
  /** Where the first bin begins. */
  low: number;
  /** Where the last bin ends. */
  high: number;
  /** The largest share. */
  peak: number;
}

/** Sorts the values into `bins` bins over [low, high]; the last bin includes `high`. */
export function histogram(
  values: ArrayLike<number>,
  weights: Weights,
  bins: number,
  [low, high]: readonly [number, number],
): Histogram {
  const shares = new Float64Array(bins);
  const scale = high > low ? bins / (high - low) : 0;
  const total = forEachFinite(values, weights, (value, weight) => {
    if (value < low || value > high) return;
    const bin = Math.min(bins - 1, Math.floor((value - low) * scale));
    shares[bin] = shares[bin]! + weight;
  });
  if (total > 0) for (let bin = 0; bin < bins; ++bin) shares[bin] = shares[bin]! / total;
  return { shares, low, high, peak: shares.reduce((a, b) => Math.max(a, b), 0) };
}

/** The share of the weight that has values in [low, high]. */
export function shareWithin(
  values: ArrayLike<number>,
  weights: Weights,
  [low, high]: readonly [number, number],
): number {
  let within = 0;
  const total = forEachFinite(values, weights, (value, weight) => {
    if (value >= low && value <= high) within += weight;
  });
  return total > 0 ? within / total : 0;
}

/** The places of the values in [low, high], ascending. */
export function placesWithin(
  values: ArrayLike<number>,
  [low, high]: readonly [number, number],
): Uint32Array {
  const places = new Uint32Array(values.length);
  let count = 0;
  for (let i = 0; i < values.length; ++i) {
    if (values[i]! >= low && values[i]! <= high) places[count++] = i;
  }
  return places.slice(0, count);
}

/** The cumulative distribution at equally distant values: `shares[i]` of the weight is at most `at[i]`. */
export interface Cumulative {
  /** Rising values. */
  at: Float64Array;
  /** In [0, 1]. */
  shares: Float64Array;
}

/** The distribution at `steps` + 1 values from low to high; exact at each of them. */
export function cumulative(
  values: ArrayLike<number>,
  weights: Weights,
  steps: number,
  [low, high]: readonly [number, number],
): Cumulative {
  const at = Float64Array.from({ length: steps + 1 }, (_, i) => low + ((high - low) * i) / steps);
  at[steps] = high;
  const shares = new Float64Array(steps + 1);
  const scale = high > low ? steps / (high - low) : 0;
  const total = forEachFinite(values, weights, (value, weight) => {
    if (value > high) return;
    // The first of the values that is not below this one; rounding may have missed it by one.
    let step = Math.min(steps, Math.max(0, Math.ceil((value - low) * scale)));
    if (step > 0 && at[step - 1]! >= value) --step;
    else if (step < steps && at[step]! < value) ++step;
    shares[step] = shares[step]! + weight;
  });
  let sum = 0;
  for (let step = 0; step <= steps; ++step) {
    sum += shares[step]!;
    shares[step] = total > 0 ? sum / total : 0;
  }
  return { at, shares };
}

/** So many values are sorted rather than divided further. */
const fewValues = 256;
const divisions = 1024;

/**
 * The least value for each share such that at least this share of the weight is at most this value; NaN where
 * there is none. By counting in ever narrower intervals, since sorting would hold up the page.
 */
export function quantiles(
  values: ArrayLike<number>,
  weights: Weights,
  shares: readonly number[],
): number[] {
  let [low, high] = [Infinity, -Infinity];
  let total = 0;
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!;
    if (!Number.isFinite(value)) continue;
    total += weights ? weights[i]! : 1;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (!(low <= high)) return shares.map(() => NaN);
  const wanted = shares.map((share, index) => ({
    weight: Math.min(1, Math.max(0, share)) * total,
    index,
  }));
  const result = new Array<number>(shares.length);
  findReached(values, weights, [low, high], wanted, result);
  return result;
}

/** `quantiles` of one share. */
export function quantile(values: ArrayLike<number>, weights: Weights, share: number): number {
  return quantiles(values, weights, [share])[0]!;
}

/** Looked for: the value at which the weights, by rising values, sum up to `weight`. */
interface Wanted {
  weight: number;
  /** Where the value goes in the result. */
  index: number;
}

/** Finds the values at which weights are reached; the finite values lie from low to high, and some are there. */
function findReached(
  values: ArrayLike<number>,
  weights: Weights,
  [low, high]: readonly [number, number],
  wanted: readonly Wanted[],
  result: number[],
): void {
  const scale = divisions / (high - low);
  const isNarrow = !(high - low > 1e-12 * Math.max(Math.abs(low), Math.abs(high)));
  if (values.length <= fewValues || isNarrow || !(scale > 0) || !Number.isFinite(scale)) {
    const rising = risingPlaces(values);
    for (const { weight, index } of wanted) {
      result[index] = reachedAmong(values, weights, rising, weight);
    }
    return;
  }
  const sums = new Float64Array(divisions);
  const counts = new Uint32Array(divisions);
  for (let i = 0; i < values.length; ++i) {
    const value = values[i]!;
    if (!(value >= low && value <= high)) continue;
    const bin = Math.min(divisions - 1, Math.floor((value - low) * scale));
    sums[bin] = sums[bin]! + (weights ? weights[i]! : 1);
    counts[bin] = counts[bin]! + 1;
  }
  const chosen = new Map<number, Wanted[]>();
  for (const { weight, index } of wanted) {
    let [bin, rest] = [0, weight];
    while (bin < divisions - 1 && sums[bin]! < rest) rest -= sums[bin++]!;
    // Rounding in the sums may have run past the last bin that holds anything.
    while (bin > 0 && sums[bin] === 0) rest += sums[--bin]!;
    chosen.set(bin, [...(chosen.get(bin) ?? []), { weight: rest, index }]);
  }
  for (const [bin, inside] of chosen) {
    const kept = new Float64Array(counts[bin]!);
    const keptWeights = weights && new Float64Array(kept.length);
    let [least, most] = [Infinity, -Infinity];
    for (let i = 0, n = 0; n < kept.length; ++i) {
      const value = values[i]!;
      if (!(value >= low && value <= high)) continue;
      if (Math.min(divisions - 1, Math.floor((value - low) * scale)) !== bin) continue;
      if (keptWeights) keptWeights[n] = weights[i]!;
      kept[n++] = value;
      if (value < least) least = value;
      if (value > most) most = value;
    }
    findReached(kept, keptWeights, [least, most], inside, result);
  }
}

/** The places of finite values, by rising values. */
function risingPlaces(values: ArrayLike<number>): Uint32Array {
  const places = new Uint32Array(values.length);
  let count = 0;
  for (let i = 0; i < values.length; ++i) if (Number.isFinite(values[i])) places[count++] = i;
  return places.subarray(0, count).sort((a, b) => values[a]! - values[b]!);
}

/** The value at which the weights sum up to `wanted`; `rising` are places of rising values, one at least. */
function reachedAmong(
  values: ArrayLike<number>,
  weights: Weights,
  rising: Uint32Array,
  wanted: number,
): number {
  let sum = 0;
  for (const i of rising) {
    sum += weights ? weights[i]! : 1;
    if (sum >= wanted * (1 - 1e-12)) return values[i]!;
  }
  return values[rising.at(-1)!]!;
}
