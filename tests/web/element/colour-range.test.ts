// The ends of the colour map: the body of the values.

import { expect, test } from 'vitest';
import { ColourRange, withoutTails } from '../../../web/src/element/surface/colour-range.js';

/** 1000 values evenly from 0 to 1, and some others. */
const body = (...others: number[]) =>
  Float64Array.from([...Array.from({ length: 1000 }, (_, i) => i / 999), ...others]);
const extentOf = (values: Float64Array) => [Math.min(...values), Math.max(...values)] as const;

test('few places that stretch the range are left out', () => {
  const values = body(40, 50, 60);
  const [low, high] = withoutTails(values, undefined, extentOf(values));
  expect(low).toBe(0);
  expect(high).toBeGreaterThan(0.96);
  expect(high).toBeLessThanOrEqual(1);
});

test('what reaches only a little further is not, nor what is much of the surface', () => {
  for (const values of [body(1.2, 1.3), body(...Array.from({ length: 30 }, () => 50)), body()]) {
    expect(withoutTails(values, undefined, extentOf(values))).toEqual(extentOf(values));
  }
});

test('places count by their areas', () => {
  const values = body(50);
  const areas = values.map((value) => (value === 50 ? 40 : 1));
  expect(withoutTails(values, areas, extentOf(values))[1]).toBe(50);
});

test('one value for all has no tails', () => {
  const values = new Float64Array(9).fill(3);
  expect(withoutTails(values, undefined, [3, 3])).toEqual([3, 3]);
});

test('while values arrive an end that was the extent’s grows with it', () => {
  const range = new ColourRange();
  const values = new Float64Array(1003).fill(NaN);
  values.set(body());
  const at = (count: number, extent: readonly [number, number]) =>
    range.bodyOf({ values, count, weights: undefined, extent });
  expect(at(900, [0, 1])).toEqual([0, 1]);
  expect(at(950, [-0.1, 1.1])).toEqual([-0.1, 1.1]);
  values.set([70, 80, 90], 1000);
  const [low, high] = at(1003, [0, 90]);
  expect(low).toBe(0);
  expect(high).toBeLessThanOrEqual(1);
});
