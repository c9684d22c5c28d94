// Recent files: which are kept, and which go.

import { expect, test } from 'vitest';
import { beyondBounds } from '../../../web/app/model/recent-store.js';

const copies = (...sizes: number[]) => sizes.map((bytes, id) => ({ id, bytes, copy: [] }));
const bounds = { bytes: 100, files: 3 };

test('the newest copies that fit together stay', () => {
  expect(beyondBounds(copies(40, 60, 1), bounds)).toEqual([2]);
  expect(beyondBounds(copies(40, 70, 60), bounds)).toEqual([1]);
  expect(beyondBounds(copies(101), bounds)).toEqual([0]);
  expect(beyondBounds(copies(), bounds)).toEqual([]);
});

test('files that are read again take no room, and there are not too many', () => {
  const handles = [0, 1, 2, 3].map((id) => ({ id, bytes: 1000 }));
  expect(beyondBounds(handles, bounds)).toEqual([3]);
});
