// Lengths as people type them: '3', '28 mm', '1.1in'. The command reads them in the same way
// (cpp/io/text/length_text.h); tests/data/lengths.json holds both to it.

import { type LengthUnit, findLengthUnit, lengthUnits } from '../kernel/types/length-units.js';

/** A number of at least 0; a comma may stand for the point. NaN: it is none. */
function amountOf(digits: string): number {
  const plain = digits.replace(',', '.');
  const number = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
  return number >= 0 && number <= greatest ? number : NaN;
}

/** A length that was read, or why it could not be. */
export type ReadLength =
  | {
      /** In the unit that was asked for. */
      length: number;
    }
  | {
      /** A sentence without its full stop. */
      fault: string;
    };

const greatest = 1e300;

const symbols = lengthUnits.map(({ symbol }) => symbol);
/** 'um, mm or cm' */
const known = `${symbols.slice(0, -1).join(', ')} or ${symbols.at(-1)}`;

/** With plain spaces for the narrow and unbreakable ones that stand before units. */
const withPlainSpaces = (text: string): string => text.replace(/[\u202f\u2009\u00a0\t]/g, ' ');

/** The number and the unit of what was typed, as text. */
function taken(text: string): { digits: string; unit: string } {
  const [, digits = '', unit = ''] = /^ *(.*?) *([a-z]*) *$/is.exec(withPlainSpaces(text)) ?? [];
  return { digits, unit };
}

/** The unit behind a number; undefined where there is none, or none that is known. */
export function typedUnit(text: string): LengthUnit | undefined {
  return findLengthUnit(taken(text).unit);
}

/**
 * A typed length in the unit `unit` (a symbol or a name): a number of at least 0, with or without a unit
 * behind it, spaces around both; a comma may stand for the point. A bare number is in that unit already;
 * where `unit` is empty, because it is not known, none can be typed.
 */
export function readLength(text: string, unit: string): ReadLength {
  const { digits, unit: typed } = taken(text);
  const number = amountOf(digits);
  if (Number.isNaN(number)) {
    return { fault: `“${text}” is not a length: type a number from 0 on, such as 1.5 or 3 mm` };
  }
  if (typed === '') return { length: number };
  const from = findLengthUnit(typed);
  if (!from) return { fault: `“${text}” has an unknown unit: type ${known}` };
  const to = findLengthUnit(unit);
  if (!to) {
    return {
      fault: `“${text}” has a unit, but that of the file is not known: choose it, or leave the unit out`,
    };
  }
  return { length: (number * from.metres) / to.metres };
}

/** Reads a length, or a share of `whole`, a length in that unit: '2%' is 0.02 times as long. */
export function readLengthOrShare(text: string, unit: string, whole: number): ReadLength {
  const [, digits] = /^ *(.*?) *% *$/s.exec(withPlainSpaces(text)) ?? [];
  if (digits === undefined) return readLength(text, unit);
  const percent = amountOf(digits);
  if (Number.isNaN(percent)) {
    return { fault: `“${text}” is not a share: type a number before the sign, as in 2%` };
  }
  const length = (percent / 100) * whole;
  return length <= greatest ? { length } : { fault: `“${text}” is too long: type a smaller share` };
}
