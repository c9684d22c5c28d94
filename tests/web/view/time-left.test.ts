import { expect, test } from 'vitest';
import { TimeLeft, formatSeconds } from '../../../web/src/view/time-left.js';

test('says nothing at first, then converges on a steady pace', () => {
  const timeLeft = new TimeLeft(0);
  expect(timeLeft.update(0.001, 100)).toBeUndefined();
  let left: number | undefined;
  for (let t = 1; t <= 5; ++t) left = timeLeft.update(t / 10, 1000 * t);
  expect(left).toBeGreaterThan(4.9);
  expect(left).toBeLessThan(7);
  expect(timeLeft.update(1, 10_000)).toBe(0);
});

test('seconds and minutes in words', () => {
  expect(formatSeconds(0.3)).toBe('under 1\u202fs');
  expect(formatSeconds(12.4)).toBe('12\u202fs');
  expect(formatSeconds(200)).toBe('3\u202fmin');
});
