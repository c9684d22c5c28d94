// Lengths and other values as people read them: one unit and one number of decimals for a whole field,
// so that numbers keep their width while they change.

import { findLengthUnit } from '../kernel/types/length-units.js';
import { unitSymbol } from '../kernel/types/units.js';

/** How the values of one field are written: lengths, angles or plain numbers. */
export interface LengthFormat {
  /** Written after the number; '' where the file does not state its unit. */
  unit: string;
  /** Multiplies a value in the field's own unit. */
  scale: number;
  /** Digits after the point. */
  decimals: number;
}

const minus = '\u2212';
const thinSpace = '\u202f';
/** JavaScript writes no more decimals, … */
const mostDecimals = 100;
/** … and numbers from here on with an exponent. */
const huge = 1e21;

/**
 * The format for values up to `largest`, of the unit `given` by its name or symbol: four significant digits at that value. Lengths
 * are written in the unit `shown`, where both are units of length; otherwise metres become millimetres
 * below 10 cm, and kilometres from 1 km; radians become degrees with one decimal.
 */
export function lengthFormat(largest: number, given: string, shown = ''): LengthFormat {
  const unit = unitSymbol(given);
  if (unit === 'rad') return { unit: '°', scale: 180 / Math.PI, decimals: 1 };
  const size = Number.isFinite(largest) && largest > 0 ? largest : 1;
  const [from, to] = [findLengthUnit(unit), findLengthUnit(shown)];
  let scale = 1;
  let written = unit;
  if (from && to) [scale, written] = [from.metres / to.metres, to.symbol];
  else if (unit === 'm' && size < 0.1) [scale, written] = [1000, 'mm'];
  else if (unit === 'm' && size >= 1000) [scale, written] = [0.001, 'km'];
  const decimals = Math.max(0, 3 - Math.floor(Math.log10(size * scale)));
  return { unit: written, scale, decimals };
}

/** The number alone, in the format's unit. */
export function formatNumber(length: number, { scale, decimals }: LengthFormat): string {
  return writtenOut(length * scale, decimals).replace('-', minus);
}

/** A number with so many decimals, as of `toFixed`, and never an exponent. */
export function writtenOut(value: number, decimals: number): string {
  if (!(Math.abs(value) >= huge) || !Number.isFinite(value)) {
    return value.toFixed(Math.min(decimals, mostDecimals));
  }
  const [digits = '', power] = String(value).split('e');
  const [whole = '', part = ''] = digits.split('.');
  return `${whole}${part}${'0'.repeat(Number(power) - part.length)}`;
}

/** The number with its unit. */
export function formatLength(length: number, format: LengthFormat): string {
  const number = formatNumber(length, format);
  if (format.unit === '') return number;
  return `${number}${format.unit === '°' ? '' : thinSpace}${format.unit}`;
}

/** A whole number with commas between thousands. */
export function formatCount(count: number): string {
  // Not toLocaleString: its first call takes 20 ms and more.
  return String(count).replace(/(?<=\d)(?=(\d{3})+$)/g, ',');
}

/**
 * Round numbers inside [low, high], ascending, at steps of 1, 2 or 5 times a power of ten; about
 * `wanted` of them, never more than twice as many.
 */
export function roundTicks(low: number, high: number, wanted: number): number[] {
  const width = high - low;
  // Ends that differ by no more than rounding have no numbers between them that could be written.
  const least = 1e-9 * Math.max(Math.abs(low), Math.abs(high));
  if (!(width > least) || !Number.isFinite(width)) return [];
  const raw = width / Math.max(1, wanted);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw * 0.999) ?? raw;
  const ticks: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + width * 1e-9; ++i) {
    ticks.push(i * step);
  }
  return ticks;
}

/** Where a value lies between two ends: 0 at the first, 1 at the second; with `log` by equal factors. */
export function placeIn(
  [low, high]: readonly [number, number],
  log: boolean,
  value: number,
): number {
  return log ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
}
