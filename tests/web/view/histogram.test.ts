import { expect, test } from 'vitest';
import { extent, histogram, median } from '../../../web/src/view/histogram.js';

test('counts every finite value once, the largest in the last bin', () => {
  const { counts, total, peak } = histogram([0, 0.5, 1, 1.5, 2, NaN], 4, [0, 2]);
  expect([...counts]).toEqual([1, 1, 1, 2]);
  expect(total).toBe(5);
  expect(peak).toBe(2);
});

test('a constant field is one bar', () => {
  const { counts } = histogram([3, 3, 3], 5, [3, 3]);
  expect([...counts]).toEqual([3, 0, 0, 0, 0]);
});

test('extent and median leave out what is not computed', () => {
  expect(extent([NaN, 2, 1, NaN, 5])).toEqual([1, 5]);
  expect(extent([NaN])).toBeUndefined();
  expect(median([NaN, 2, 1, NaN, 5])).toBe(2);
  expect(median([4, 1, 2, 3])).toBe(2.5);
  expect(median([])).toBeNaN();
});
