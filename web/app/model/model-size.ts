// How large a model is, and whether such a thing is usual in its unit.

import {
  type LengthFormat,
  findLengthUnit,
  formatCount,
  formatLength,
} from '../../src/element/plots.js';

/** How tall things are that are given in a unit, in that unit: a screw to a car, a toy to a mountain. */
const usualHeights: Record<string, readonly [number, number]> = {
  um: [1, 100_000],
  mm: [2, 5_000],
  cm: [1, 2_000],
  m: [0.02, 10_000],
  km: [0.1, 10_000],
  in: [0.1, 400],
  ft: [0.2, 10_000],
};

/** '1.00 mm tall': with three digits, whatever the format of other lengths is. */
export function tallWords(height: number, format: LengthFormat): string {
  const value = height * format.scale;
  const decimals = value > 0 ? Math.max(0, 2 - Math.floor(Math.log10(value))) : 0;
  return `${formatLength(height, { ...format, decimals })} tall`;
}

/** Whether something so tall, in the unit `unit`, is hardly what is meant. */
export function isUnusual(height: number, unit: string): boolean {
  const symbol = findLengthUnit(unit)?.symbol;
  const usual = symbol === undefined ? undefined : usualHeights[symbol];
  return usual !== undefined && !(height >= usual[0] && height <= usual[1]);
}

/** A scale in words: '90%', '112%', '12.5 times'; rounded up, so that what holds from there on holds. */
export function scaleWords(scale: number): string {
  return scale < 10 ? `${wholePercent(scale)}%` : `${grouped(upwards(scale))} times`;
}

/** '50% of the file’s size', '12.5 times the file’s size'. */
export function ofSize(scale: number, size: string): string {
  return scale < 10 ? `${scaleWords(scale)} of ${size}` : `${scaleWords(scale)} ${size}`;
}

/** The scale that `scaleWords` names. */
export function namedScale(scale: number): number {
  return scale < 10 ? wholePercent(scale) / 100 : upwards(scale);
}

/** The number with commas between thousands. */
function grouped(scale: number): string {
  return scale < 1000 ? String(scale) : formatCount(Math.round(scale));
}

// A number that is whole but for rounding counts as whole.
const nearly = 1e-9;

function wholePercent(scale: number): number {
  return Math.max(1, Math.ceil(100 * scale * (1 - nearly)));
}

function upwards(scale: number): number {
  const step = 10 ** (Math.floor(Math.log10(scale)) - 2);
  return Number((Math.ceil((scale / step) * (1 - nearly)) * step).toPrecision(12));
}
