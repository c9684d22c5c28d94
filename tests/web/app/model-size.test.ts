import { expect, test } from 'vitest';
import { isUnusual, namedScale, scaleWords, tallWords } from '../../../web/app/model/model-size.js';

test.each([
  [1.12, '112%'],
  [1.1200000000000001, '112%'],
  [1.1201, '113%'],
  [0.6149, '62%'],
  [900, '900 times'],
  [12.345, '12.4 times'],
  [1234, '1,240 times'],
])('a scale of %d is %s, never less', (scale, words) => {
  expect(scaleWords(scale)).toBe(words);
  expect(namedScale(scale)).toBeGreaterThan(scale * (1 - 1e-8));
  expect(scaleWords(namedScale(scale))).toBe(words);
});

test('a height has three digits, in the unit that is shown', () => {
  expect(tallWords(1, { unit: 'mm', scale: 1, decimals: 4 })).toBe('1.00\u202fmm tall');
  expect(tallWords(0.9, { unit: 'mm', scale: 1000, decimals: 1 })).toBe('900\u202fmm tall');
  expect(tallWords(0, { unit: '', scale: 1, decimals: 1 })).toBe('0 tall');
});

test('what is far from usual in its unit is questioned', () => {
  const asked: [number, string, boolean][] = [
    [1, 'mm', true],
    [1, 'm', false],
    [900, 'mm', false],
    [60_000, 'mm', true],
    [0.001, 'm', true],
    [1, '', false],
    [1, 'parsec', false],
  ];
  for (const [height, unit, isOdd] of asked) expect(isUnusual(height, unit)).toBe(isOdd);
});
