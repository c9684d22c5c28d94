// Units by their names, as results and files have them, and by their symbols, as pages write them.

import { type FieldName, fieldUnits } from './fields.js';
import { findLengthUnit } from './length-units.js';

/** The unit of a field where that of lengths is `unit`: 'millimetre', 'radian', 'millimetre^-2', or ''. */
export function unitOf(name: FieldName, unit: string): string {
  const kind = fieldUnits[name];
  if (kind === 'Radian') return 'radian';
  if (kind === 'Number' || unit === '') return '';
  return kind === 'PerArea' ? `${unitName(unit)}^-2` : unitName(unit);
}

/** The name of a unit that is given by its symbol or name; other words stay. */
export function unitName(unit: string): string {
  const ofDensity = /^1\/(.+)²$/.exec(unit)?.[1];
  if (ofDensity !== undefined) return `${unitName(ofDensity)}^-2`;
  return unit === 'rad' ? 'radian' : (findLengthUnit(unit)?.name ?? unit);
}

/** The symbol of a unit that is given by its name or symbol: 'mm', 'rad', '1/mm²'; other words stay. */
export function unitSymbol(unit: string): string {
  const ofDensity = /^(.+)\^-2$/.exec(unit)?.[1];
  if (ofDensity !== undefined) return `1/${unitSymbol(ofDensity)}²`;
  return unit === 'radian' ? 'rad' : (findLengthUnit(unit)?.symbol ?? unit);
}
