import { expect, test } from 'vitest';
import { shareBeside, shareWords } from '../../../web/app/widgets/share-beside.js';

const along = (...girths: number[]) =>
  girths.map(
    (girth) => ({ girth: Math.abs(girth), kind: girth < 0 ? 'antipodal' : 'loop' }) as const,
  );

test('a narrow place is compared with the lesser of the two sides', () => {
  expect(shareBeside(along(10, 5, 8, 20))).toBe(0.5);
  expect(shareBeside(along(20, 8, 5, 10))).toBe(0.5);
  expect(shareWords(0.5)).toBe('50% of the girth beside it');
});

test('places without a loop do not count, and an end is no narrow place', () => {
  expect(shareBeside(along(10, -1, 5, -90, 10))).toBe(0.5);
  expect(shareBeside(along(5, 8, 10))).toBeUndefined();
  expect(shareBeside(along(10, 10, 9.95, 10))).toBeUndefined();
  expect(shareBeside(along(-1, -2))).toBeUndefined();
  expect(shareBeside([])).toBeUndefined();
});
