// Areas and volumes as people read them: three significant digits without an exponent, in a power of the unit
// of the lengths beside them, or of a larger or smaller one of its family.

import { type LengthFormat, findLengthUnit, writtenOut } from '../../src/element/plots.js';

/** Units whose powers are written in, small ones first. */
const families = [
  ['mm', 'cm', 'm', 'km'],
  ['in', 'ft'],
] as const;
/** More than these of a unit are written in a larger one, … */
const most = 10_000;
/** … and less than these in a smaller one. */
const leastOf = (unit: string, power: 2 | 3): number => (unit === 'cm' && power === 2 ? 1 : 0.1);

function threeDigits(value: number): string {
  if (value === 0) return '0.00';
  const power = Math.floor(Math.log10(Math.abs(value)));
  const rounded = Number(value.toPrecision(3));
  const text = writtenOut(rounded, Math.max(0, 2 - power));
  return text.includes('.') ? text : text.replace(/(?<=\d)(?=(\d{3})+$)/g, ',');
}

function format(amount: number, power: 2 | 3, { unit, scale }: LengthFormat): string {
  let value = amount * scale ** power;
  let written = unit;
  const family: readonly string[] = families.find((one) => one.includes(unit as never)) ?? [];
  const change = (step: 1 | -1): boolean => {
    const [from, to] = [written, family[family.indexOf(written) + step] ?? ''].map(findLengthUnit);
    if (!from || !to) return false;
    value *= (from.metres / to.metres) ** power;
    written = to.symbol;
    return true;
  };
  while (Math.abs(value) >= most && change(1));
  while (value !== 0 && Math.abs(value) < leastOf(written, power) && change(-1));
  const number = threeDigits(value);
  return written ? `${number}\u202f${written}${power === 2 ? '²' : '³'}` : number;
}

/** An area in squared model units. */
export const formatArea = (area: number, lengths: LengthFormat): string => format(area, 2, lengths);

/** A volume in cubed model units. */
export const formatVolume = (volume: number, lengths: LengthFormat): string =>
  format(volume, 3, lengths);
