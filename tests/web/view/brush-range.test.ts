import { expect, test } from 'vitest';
import { dragged, movedByKey } from '../../../web/src/view/plots/brush-range.js';

test('a drag marks what lies between, in both directions, within the axis', () => {
  expect(dragged(0.2, 0.6)).toEqual([0.2, 0.6]);
  expect(dragged(0.6, -0.3)).toEqual([0, 0.6]);
  expect(dragged(0.9, 1.4)).toEqual([0.9, 1]);
});

test('arrows begin, move and widen a range; it never leaves the axis', () => {
  expect(movedByKey(undefined, 'ArrowRight', false, 48)).toEqual([0, 0]);
  expect(movedByKey(undefined, 'ArrowLeft', false, 48)).toEqual([47, 47]);
  expect(movedByKey([3, 5], 'ArrowRight', false, 48)).toEqual([4, 6]);
  expect(movedByKey([3, 5], 'ArrowRight', true, 48)).toEqual([3, 6]);
  expect(movedByKey([3, 3], 'ArrowLeft', true, 48)).toEqual([3, 3]);
  expect(movedByKey([0, 2], 'ArrowLeft', false, 48)).toEqual([0, 2]);
  expect(movedByKey([45, 47], 'ArrowRight', false, 48)).toEqual([45, 47]);
  expect(movedByKey([3, 5], 'Home', false, 48)).toEqual([0, 2]);
  expect(movedByKey([3, 5], 'End', false, 48)).toEqual([45, 47]);
});

test('Escape removes it; other keys mean nothing', () => {
  expect(movedByKey([3, 5], 'Escape', false, 48)).toBe('none');
  expect(movedByKey(undefined, 'Escape', false, 48)).toBeUndefined();
  expect(movedByKey([3, 5], 'a', false, 48)).toBeUndefined();
});
