import { expect, test } from 'vitest';
import {
  cumulative,
  extent,
  histogram,
  placesWithin,
  quantile,
  quantiles,
  shareWithin,
} from '../../../web/src/view/plots/distribution.js';

/** Repeatable numbers in [0, 1). */
function* randoms(seed: number): Generator<number> {
  for (let state = seed; ;) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    yield state / 2 ** 32;
  }
}

test('extent leaves out what is not computed', () => {
  expect(extent([NaN, 2, 1, NaN, 5])).toEqual([1, 5]);
  expect(extent([NaN, Infinity])).toBeUndefined();
});

test('a histogram counts areas: every finite value once, the largest in the last bin', () => {
  const { shares, peak } = histogram([0, 0.5, 1, 1.5, 2, NaN], [1, 1, 2, 3, 1, 100], 4, [0, 2]);
  expect([...shares]).toEqual([1 / 8, 1 / 8, 2 / 8, 4 / 8]);
  expect(peak).toBe(0.5);
});

test('what lies outside of the range counts towards the whole, not towards a bin', () => {
  expect([...histogram([0, 1, 2, 3], undefined, 2, [1, 2]).shares]).toEqual([0.25, 0.25]);
});

test('a constant field is one bar; no field is none', () => {
  expect([...histogram([3, 3, 3], undefined, 5, [3, 3]).shares]).toEqual([1, 0, 0, 0, 0]);
  expect(histogram([NaN], undefined, 3, [0, 1]).peak).toBe(0);
});

test('the cumulative distribution is exact at each of its values', () => {
  const values = [0.1, 0.1, 0.3, 0.7, 1, NaN];
  const weights = [1, 1, 2, 3, 3, 50];
  const { at, shares } = cumulative(values, weights, 10, [0, 1]);
  at.forEach((value, i) => {
    const expected = weights.filter((_, k) => values[k]! <= value).reduce((a, b) => a + b, 0) / 10;
    expect(shares[i]).toBeCloseTo(expected, 12);
  });
  expect(shares[10]).toBe(1);
});

test('cumulative: values beyond the range count below it, or not yet', () => {
  expect([...cumulative([-1, 0.5, 9, 9], undefined, 1, [0, 1]).shares]).toEqual([0.25, 0.5]);
});

test('quantiles are those of the sorted values, whatever their weights and spread', () => {
  const random = randoms(7);
  const next = (): number => random.next().value as number;
  const spreads: ((u: number) => number)[] = [
    (u) => u,
    (u) => Math.exp(40 * u),
    (u) => Math.round(5 * u),
    (u) => -(u ** 9) * 1e-30,
    () => 4,
  ];
  for (const spread of spreads) {
    const values = Array.from({ length: 5000 }, () => spread(next()));
    const weights = values.map(() => 1 + Math.floor(9 * next()));
    values[17] = NaN;
    const sorted = values.map((value, i) => [value, weights[i]!] as const).filter(([v]) => v === v);
    sorted.sort((a, b) => a[0] - b[0]);
    const total = sorted.reduce((sum, [, weight]) => sum + weight, 0);
    const shares = [0, 0.95, 0.05, 0.5, 0.5001, 1];
    const expected = shares.map((share) => {
      let sum = 0;
      return sorted.find(([, weight]) => (sum += weight) >= share * total)![0];
    });
    expect(quantiles(values, weights, shares)).toEqual(expected);
    expect(shares.map((share) => quantile(values, weights, share))).toEqual(expected);
  }
});

test('quantiles of nothing, of few, and of extreme values', () => {
  expect(quantile([NaN], undefined, 0.5)).toBeNaN();
  expect(quantiles([NaN, Infinity], undefined, [0.1, 0.9])).toEqual([NaN, NaN]);
  expect(quantile([NaN, 2, 1, NaN, 5], undefined, 0.5)).toBe(2);
  const wide = Array.from({ length: 1000 }, (_, i) => (i < 500 ? -1.7e308 : 1.7e308));
  expect(quantile(wide, undefined, 0.25)).toBe(-1.7e308);
  expect(quantile(wide, undefined, 0.75)).toBe(1.7e308);
  const tiny = Array.from({ length: 1000 }, (_, i) => (i < 500 ? 0 : 5e-324));
  expect(quantile(tiny, undefined, 0.75)).toBe(5e-324);
});

test('brushing: the places and the share of a range', () => {
  const values = [3, 1, NaN, 2, 5];
  expect([...placesWithin(values, [2, 3])]).toEqual([0, 3]);
  expect(shareWithin(values, [1, 1, 9, 1, 1], [2, 3])).toBe(0.5);
  expect(shareWithin([NaN], undefined, [0, 1])).toBe(0);
});
