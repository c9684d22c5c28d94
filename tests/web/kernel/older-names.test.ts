// Older names of members in what is given to a call.

import { expect, test, vi } from 'vitest';
import { withPresentName } from '../../../web/src/kernel/types/older-names.js';

test('a member by its older name has the present one, with a warning', () => {
  const warned = vi.spyOn(console, 'warn').mockImplementation(() => undefined);
  const given = { girth: 3, breadth: 2 } as unknown as { girth: number; width: number };
  const taken = withPresentName(given, 'breadth', 'width');
  expect(taken).toMatchObject({ girth: 3, width: 2 });
  expect(given).toEqual({ girth: 3, breadth: 2 });
  withPresentName(given, 'breadth', 'width');
  expect(warned.mock.calls).toEqual([['breadth is the older name of width, until 2.0']]);
});

test('the present name goes before the older one', () => {
  const given = { breadth: 2, width: 5 };
  expect(withPresentName(given, 'breadth', 'width')).toBe(given);
  const present = { width: 5 };
  expect(withPresentName(present, 'breadth', 'width')).toBe(present);
});
