// Areas as people read them: three significant digits, in the unit of the lengths beside them.

import type { LengthFormat } from '../src/element/plots.js';

const raised: Record<string, string> = { '-': '⁻' };
'⁰¹²³⁴⁵⁶⁷⁸⁹'.split('').forEach((digit, i) => (raised[String(i)] = digit));

function threeDigits(value: number): string {
  const text = value.toPrecision(3);
  const [digits = '', power] = text.split('e');
  if (power !== undefined || (value !== 0 && Math.abs(value) < 1e-4)) {
    const [mantissa = '', exponent = ''] = value.toExponential(2).split('e');
    const sup = [...exponent.replace('+', '')].map((letter) => raised[letter]).join('');
    return `${mantissa}\u202f×\u202f10${sup}`;
  }
  return digits;
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
