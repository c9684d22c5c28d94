// Units as pages write them, and as files name them.

import { expect, test } from 'vitest';
import { lengthUnits } from '../../../web/src/kernel/types/length-units.js';
import { unitName, unitOf } from '../../../web/src/kernel/types/units.js';

test('every unit of length has its name in files, and so has its density', () => {
  for (const { symbol, name } of lengthUnits) {
    expect(unitName(symbol)).toBe(name);
    expect(unitName(name)).toBe(name);
    expect(unitName(unitOf('hks', symbol))).toBe(`${name}^-2`);
  }
  expect(unitName('um')).toBe('micrometre');
  expect(unitName('km')).toBe('kilometre');
});

test('units follow what a field is', () => {
  expect(['igf', 'angle', 'wks', 'sihks'].map((name) => unitOf(name as 'igf', 'um'))).toEqual([
    'um',
    'rad',
    '1/um²',
    '',
  ]);
  expect(['igf', 'angle', 'wks', 'sihks'].map((name) => unitOf(name as 'igf', ''))).toEqual([
    '',
    'rad',
    '',
    '',
  ]);
  expect(['rad', 'pixel', ''].map(unitName)).toEqual(['radian', 'pixel', '']);
});
