import { expect, test } from 'vitest';
import {
  combinationOf,
  combinedUnit,
  fieldTitle,
  isShownName,
} from '../../../web/src/view/field-words.js';

test('two fields make one: a difference of like quantities, a ratio of any', () => {
  expect(combinationOf('igf-sdf')).toEqual({ first: 'igf', by: 'difference', second: 'sdf' });
  expect(combinationOf('igf/angle')).toEqual({ first: 'igf', by: 'ratio', second: 'angle' });
  expect(combinationOf('igf-_heat_2')).toEqual({
    first: 'igf',
    by: 'difference',
    second: '_heat_2',
  });
  const refused = [
    'igf',
    'igf-igf',
    'igf-angle',
    'hks-sihks',
    'igf-',
    '-sdf',
    'igf/none',
    'igf-tips',
  ];
  for (const name of [...refused, 'igf-sdf-sdf', 'igf - sdf', 'IGF-sdf', 'igf+sdf']) {
    expect(combinationOf(name), name).toBeUndefined();
    if (name !== 'igf') expect(isShownName(name), name).toBe(false);
  }
  expect(isShownName('hks-wks')).toBe(true);
});

test('their titles have the sign in them, and their units are those of the quantity', () => {
  expect(fieldTitle('igf-sdf')).toBe('Girth \u2212 shape diameter');
  expect(fieldTitle('igf/_wall_heat')).toBe('Girth ÷ wall heat');
  expect(combinedUnit('difference', 'mm', 'mm')).toBe('mm');
  // Where the unit of one field is unknown, so is that of both.
  expect(combinedUnit('difference', 'mm', '')).toBe('');
  expect(combinedUnit('ratio', 'mm', 'mm')).toBe('');
  expect(combinedUnit('ratio', 'mm', 'rad')).toBe('mm/rad');
  expect(combinedUnit('ratio', 'mm', '')).toBe('mm');
  expect(combinedUnit('ratio', '', 'mm')).toBe('1/mm');
});
