// Areas as people read them: three significant digits, in the unit of the lengths beside them.

import { type LengthFormat, withPower } from '../src/element/plots.js';

function threeDigits(value: number): string {
  const text = value.toPrecision(3);
  return text.includes('e') || (value !== 0 && value < 1e-4) ? withPower(value, 2) : text;
}

/** An area in squared model units. Square metres become square centimetres or millimetres. */
export function formatArea(area: number, { unit, scale }: LengthFormat): string {
  let value = area * scale * scale;
  let written = unit;
  if (unit === 'm' && value < 1e-4) [value, written] = [1e6 * value, 'mm'];
  else if (unit === 'm' && value < 0.1) [value, written] = [1e4 * value, 'cm'];
  const number = threeDigits(value);
  return written ? `${number}\u202f${written}²` : number;
}
