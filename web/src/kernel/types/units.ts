// Units as pages write them and as files name them.

import { type FieldName, fieldUnits } from './fields.js';
import { findLengthUnit } from './length-units.js';

/** The unit of a field where that of lengths is `unit`, as pages write it: 'mm', 'rad', '1/mm²', or ''. */
export function unitOf(name: FieldName, unit: string): string {
  const kind = fieldUnits[name];
  if (kind === 'Radian') return 'rad';
  if (kind === 'Number' || unit === '') return '';
  return kind === 'PerArea' ? `1/${unit}²` : unit;
}

/** A unit that pages write, as files name it: 'millimetre', 'radian', 'millimetre^-2'. */
export function unitName(unit: string): string {
  const ofDensity = /^1\/(.+)²$/.exec(unit)?.[1];
  if (ofDensity !== undefined) return `${unitName(ofDensity)}^-2`;
  return unit === 'rad' ? 'radian' : (findLengthUnit(unit)?.name ?? unit);
}
