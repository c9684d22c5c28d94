// The search of the command palette.

import { expect, test } from 'vitest';
import { fuzzyScore } from '../../../web/app/commands/fuzzy.js';

test.each([
  ['mgm', 'magma'],
  ['exp csv', 'Export › Pinned loops CSV names and lengths'],
  ['csv exp', 'Export › Pinned loops CSV names and lengths'],
  ['MAGMA', 'magma'],
  ['emd', 'Émd'],
])('%s finds %s', (search, text) => {
  expect(fuzzyScore(search, text)).toBeGreaterThan(0);
});

test.each([
  ['mgx', 'magma'],
  ['amgam', 'magma'],
  ['csv png', 'Export CSV'],
])('%s does not find %s', (search, text) => {
  expect(fuzzyScore(search, text)).toBeUndefined();
});

test('no search answers everything alike', () => {
  expect(fuzzyScore(' ', 'magma')).toBe(0);
});

test('beginnings of words come before letters in a row, and those before scattered ones', () => {
  const texts = ['Front view', 'Refront', 'Xfar'];
  const scores = texts.map((text) => fuzzyScore('fr', text)!);
  expect(scores).toEqual([...new Set(scores)].sort((a, b) => b - a));
  // The best place counts, not the first.
  expect(fuzzyScore('top', 'to the Top')).toBe(fuzzyScore('top', 'Top')!);
});
