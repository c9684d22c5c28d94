import { expect, test } from 'vitest';
import { repairs } from '../../../web/app/model/model-words.js';
import { nothingPrepared } from '../../../web/src/element/model/nothing-prepared.js';
import { lengthFormat } from '../../../web/src/view/numbers.js';

test('cracks are counted, and the distance that closes them is named in the unit shown', () => {
  expect(repairs(nothingPrepared, lengthFormat(1, ''))).toEqual([]);
  const cracked = { ...nothingPrepared, crackVertices: 3, tJunctions: 1 };
  const lines = (crackWidth: number, unit: string) =>
    repairs({ ...cracked, crackWidth }, lengthFormat(0.3, unit, 'mm'));
  expect(lines(0.0042, 'm')).toEqual([
    '3 vertices at cracks, next to another one on the boundary',
    '1 vertex at cracks, within the edge of a neighbour',
    'a weld distance of 4.2\u202fmm closes the cracks',
  ]);
  expect(lines(2 ** -54, '').at(-1)).toBe(
    'a weld distance of 0.000000000000000056 closes the cracks',
  );
  expect(lines(25, '').at(-1)).toBe('a weld distance of 25 closes the cracks');
});
