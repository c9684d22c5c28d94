import { expect, test } from 'vitest';
import {
  formatCount,
  formatLength,
  formatNumber,
  lengthFormat,
  roundTicks,
} from '../../../web/src/view/numbers.js';

test('one format for a field: four significant digits at its largest length', () => {
  const format = lengthFormat(1.9, 'm');
  expect(formatLength(1.9, format)).toBe('1.900\u202fm');
  expect(formatLength(0.1234, format)).toBe('0.123\u202fm');
});

test('small models in metres are written in millimetres', () => {
  expect(formatLength(0.0342, lengthFormat(0.09, 'm'))).toBe('34.20\u202fmm');
});

test('angles are written in degrees', () => {
  expect(formatLength(Math.PI, lengthFormat(3, 'rad'))).toBe('180.0°');
});

test('without a unit there is none', () => {
  expect(formatLength(120, lengthFormat(340, ''))).toBe('120.0');
});

test('lengths of any size, and fields without any, are written', () => {
  expect(formatNumber(5e6, lengthFormat(5e6, ''))).toBe('5000000');
  expect(formatNumber(2e-7, lengthFormat(2e-7, ''))).toBe('0.0000002000');
  expect(formatNumber(0, lengthFormat(0, 'm'))).toBe('0.000');
  expect(formatNumber(0, lengthFormat(NaN, ''))).toBe('0.000');
  // Written out, however many zeros there are.
  expect(formatNumber(2.19e-20, lengthFormat(2.19e-20, ''))).toBe('0.00000000000000000002190');
  expect(formatLength(-2.19e25, lengthFormat(2.19e25, 'mm'))).toBe(
    '−21900000000000000000000000\u202fmm',
  );
  expect(formatNumber(Infinity, lengthFormat(1, ''))).toBe('Infinity');
});

test.each([
  [0.12, 1.9, 4],
  [0, 1, 5],
  [3.14159, 3.1416, 4],
  [-20, 1e6, 4],
])('round ticks between %d and %d', (low, high, wanted) => {
  const ticks = roundTicks(low, high, wanted);
  expect(ticks.length).toBeGreaterThanOrEqual(wanted / 2 - 1);
  expect(ticks.length).toBeLessThanOrEqual(2 * wanted);
  for (const tick of ticks) {
    expect(tick).toBeGreaterThanOrEqual(low - 1e-9 * (high - low));
    expect(tick).toBeLessThanOrEqual(high + 1e-9 * (high - low));
  }
});

test('no ticks where there is no range', () => {
  expect(roundTicks(1, 1, 4)).toEqual([]);
  expect(roundTicks(NaN, 1, 4)).toEqual([]);
  expect(roundTicks(2, 1, 4)).toEqual([]);
  // All values the same, but for rounding.
  expect(roundTicks(6.265257226562474, 6.265257226562475, 4)).toEqual([]);
});

test('whole numbers have commas between thousands', () => {
  expect([0, 999, 1000, 12345, 1234567].map(formatCount)).toEqual([
    '0',
    '999',
    '1,000',
    '12,345',
    '1,234,567',
  ]);
});
