// Steps of undo in words.

import { expect, test } from 'vitest';
import { stepWords } from '../../../web/app/state/step-words.js';

test.each([
  ['model=chair', 'model=chair&colormap=magma', 'colour map'],
  [
    'model=chair&colormap=magma&log=1',
    'model=chair&isolines=4',
    'isolines, colour map, logarithmic colours',
  ],
  ['model=chair&girth=1&diameter=2', 'model=chair', 'thresholds of parts'],
  ['model=chair&scale=2&weld=0.5', 'model=chair&scale=4&weld=1', 'weld distance, size'],
  // Other parts go with a model, and the view and the panel go with other parts.
  ['model=chair&tip=3', 'model=octopus', 'model'],
  ['model=chair&panel=tips&tip=3', 'model=chair', 'chosen tip'],
  ['model=chair&panel=tips', 'model=chair', 'panel'],
  ['model=chair', 'model=chair', ''],
])('from %s to %s', (one, other, words) => {
  expect(stepWords(one, other).split(', ').sort()).toEqual(words.split(', ').sort());
});
