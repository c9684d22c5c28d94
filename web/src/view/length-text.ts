// Lengths as people type them: '3', '28 mm', '1.1in'. The command reads them in the same way
// (cpp/io/text/length_text.h); tests/data/lengths.json holds both to it.

/** A unit of length. */
export interface LengthUnit {
  /** 'mm' */
  readonly symbol: string;
  /** 'millimetre' */
  readonly name: string;
  /** In one of it: 0.001. */
  readonly metres: number;
}

/** Units of length, small ones first; as in `girth/io/length_unit.h`. */
export const lengthUnits: readonly LengthUnit[] = [
  { symbol: 'um', name: 'micrometre', metres: 1e-6 },
  { symbol: 'mm', name: 'millimetre', metres: 1e-3 },
  { symbol: 'cm', name: 'centimetre', metres: 1e-2 },
  { symbol: 'm', name: 'metre', metres: 1 },
  { symbol: 'km', name: 'kilometre', metres: 1e3 },
  { symbol: 'in', name: 'inch', metres: 0.0254 },
  { symbol: 'ft', name: 'foot', metres: 0.3048 },
];

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

/** The unit with that symbol or name; undefined where there is none. */
export function findLengthUnit(symbolOrName: string): LengthUnit | undefined {
  return lengthUnits.find(({ symbol, name }) => symbol === symbolOrName || name === symbolOrName);
}

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
  if (!from) return { fault: `“${text}” has an unknown unit: type um, mm, cm, m, km, in or ft` };
  const to = findLengthUnit(unit);
  if (!to) {
    return {
      fault: `“${text}” has a unit, but that of the file is not known: choose it, or leave the unit out`,
    };
  }
  return { length: (number * from.metres) / to.metres };
}

/** The same, or a share of `whole`, a length in that unit: '2%' is 0.02 times as long. */
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
