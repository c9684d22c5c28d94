import { expect, test } from 'vitest';
import {
  density,
  densityImage,
  logTicks,
  placeOn,
  scaleFor,
  valueAt,
} from '../../../web/src/view/plots/density.js';

test('places on linear and logarithmic axes, and back', () => {
  const linear = { low: 2, high: 6, log: false };
  expect(placeOn(linear, 3)).toBe(0.25);
  const log = { low: 0.01, high: 100, log: true };
  expect(placeOn(log, 1)).toBeCloseTo(0.5, 12);
  expect(placeOn(log, 0)).toBeNaN();
  for (const scale of [linear, log]) {
    for (const place of [0, 0.3, 1])
      expect(placeOn(scale, valueAt(scale, place))).toBeCloseTo(place, 12);
  }
});

test('an axis has room for all that it can show', () => {
  for (const log of [true, false]) {
    const scale = scaleFor([NaN, 0, 0.2, 5, Infinity], log)!;
    expect(scale.low).toBeLessThanOrEqual(log ? 0.2 : 0);
    expect(scale.high).toBeGreaterThan(5);
    // A constant field has an axis too.
    const constant = scaleFor([3, 3], log)!;
    expect(constant.low).toBeLessThan(3);
    expect(constant.high).toBeGreaterThan(3);
  }
  expect(scaleFor([0, -1, NaN], true)).toBeUndefined();
  expect(scaleFor([0, 0], false)!.high).toBeGreaterThan(0);
});

test('ticks of a logarithmic axis: 1, 2, 5 where there is room', () => {
  expect(logTicks({ low: 0.04, high: 1.2, log: true }, 6)).toEqual([0.05, 0.1, 0.2, 0.5, 1]);
  expect(logTicks({ low: 0.04, high: 1.2, log: true }, 3)).toEqual([0.1, 0.3, 1]);
  expect(logTicks({ low: 1e-9, high: 1e9, log: true }, 4).length).toBeLessThanOrEqual(4);
});

test('points are counted by weight in the cell they lie in, rows from the top', () => {
  const axes = { x: { low: 0, high: 2, log: false }, y: { low: 0, high: 2, log: false } };
  const counted = density([0, 0.5, 2, 3, NaN], [0, 0.9, 2, 1, 1], [1, 2, 4, 8, 8], axes, 2, 2);
  expect([...counted.cells]).toEqual([0, 4, 3, 0]);
  expect(counted.peak).toBe(4);
  const pixels = densityImage(counted, [10, 20, 30]);
  expect([...pixels.subarray(0, 4)]).toEqual([0, 0, 0, 0]);
  expect([...pixels.subarray(4, 8)]).toEqual([10, 20, 30, 255]);
  expect(pixels[11]).toBeGreaterThan(60);
  expect(pixels[11]).toBeLessThan(255);
});
