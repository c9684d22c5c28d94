// The section that uncovers a place of the surface.

import { expect, test } from 'vitest';
import { parseSection } from '../../../web/src/element/attributes/section-words.js';
import { sectionBefore } from '../../../web/app/panels/print/uncovered-place.js';

/** Eleven points on a line: z from 0 to 10. */
const line = Array.from({ length: 11 }, (_, z) => [0, 0, z]).flat();

test('a section lies just before the place, seen from the eye', () => {
  const above = parseSection(sectionBefore(line, [2, 4, 3], [0, 0, 1]))!;
  expect(above.direction).toEqual([0, 0, 1]);
  expect(above.share).toBeGreaterThan(0.4);
  expect(above.share).toBeLessThan(0.41);
  const below = parseSection(sectionBefore(line, [2, 4, 3], [0, 0, -1]))!;
  expect(below.share).toBeGreaterThan(0.8);
  expect(below.share).toBeLessThan(0.81);
});

test('at the end of the surface all of it stays', () => {
  expect(sectionBefore(line, [10], [0, 0, 1])).toBe('0,0,1 100%');
  expect(parseSection(sectionBefore(line, [0], [0.6, 0, 0.8]))!.share).toBeLessThan(0.01);
});
