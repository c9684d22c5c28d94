// Units by their names, as results and files have them, and by their symbols, as pages write them.

import { expect, test } from 'vitest';
import { lengthUnits } from '../../../web/src/kernel/types/length-units.js';
import { unitName, unitOf, unitSymbol } from '../../../web/src/kernel/types/units.js';

test('every unit of length has a name and a symbol, and so has its density', () => {
  for (const { symbol, name } of lengthUnits) {
    for (const given of [symbol, name]) {
      expect(unitName(given)).toBe(name);
      expect(unitSymbol(given)).toBe(symbol);
      expect(unitOf('hks', given)).toBe(`${name}^-2`);
    }
    expect(unitSymbol(`${name}^-2`)).toBe(`1/${symbol}²`);
    expect(unitName(`1/${symbol}²`)).toBe(`${name}^-2`);
  }
  expect(unitName('um')).toBe('micrometre');
  expect(unitName('km')).toBe('kilometre');
});

test('units follow what a field is', () => {
  const names = ['igf', 'angle', 'wks', 'sihks'] as const;
  const inMicrometres = ['micrometre', 'radian', 'micrometre^-2', ''];
  expect(names.map((name) => unitOf(name, 'um'))).toEqual(inMicrometres);
  expect(names.map((name) => unitOf(name, ''))).toEqual(['', 'radian', '', '']);
  expect(['rad', 'pixel', ''].map(unitName)).toEqual(['radian', 'pixel', '']);
  expect(['radian', 'pixel', ''].map(unitSymbol)).toEqual(['rad', 'pixel', '']);
});
