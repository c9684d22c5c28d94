// Areas as people read them: three significant digits without an exponent, in a square of the unit of the
// lengths beside them, or of a larger or smaller one of its family.

import { type LengthFormat, findLengthUnit, writtenOut } from '../src/element/plots.js';

/** Units whose squares areas are written in, small ones first. */
const families = [
  ['mm', 'cm', 'm', 'km'],
  ['in', 'ft'],
] as const;
/** Areas of more, in a unit's square, are written in a larger unit, … */
const most = 10_000;
/** … and those of less in a smaller one. */
const leastOf = (unit: string): number => (unit === 'cm' ? 1 : 0.1);

function threeDigits(value: number): string {
  if (value === 0) return '0.00';
  const power = Math.floor(Math.log10(Math.abs(value)));
  const rounded = Number(value.toPrecision(3));
  const text = writtenOut(rounded, Math.max(0, 2 - power));
  return text.includes('.') ? text : text.replace(/(?<=\d)(?=(\d{3})+$)/g, ',');
}

/** An area in squared model units. */
export function formatArea(area: number, { unit, scale }: LengthFormat): string {
  let value = area * scale * scale;
  let written = unit;
  const family: readonly string[] = families.find((one) => one.includes(unit as never)) ?? [];
  const change = (step: 1 | -1): boolean => {
    const [from, to] = [written, family[family.indexOf(written) + step] ?? ''].map(findLengthUnit);
    if (!from || !to) return false;
    value *= (from.metres / to.metres) ** 2;
    written = to.symbol;
    return true;
  };
  while (value >= most && change(1));
  while (value > 0 && value < leastOf(written) && change(-1));
  const number = threeDigits(value);
  return written ? `${number}\u202f${written}²` : number;
}
