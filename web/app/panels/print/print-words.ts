// The print check in words.

import type { PrintCheck, PrintLimits } from '../../../src/kernel/index.js';
import { type LengthFormat, formatCount, formatLength } from '../../../src/element/plots.js';
import { ofSize } from '../../model/model-size.js';

/** The name of the least length of a place, for each kind. */
export const measureNames = { tube: 'diameter', wall: 'thickness', gap: 'clearance' } as const;

/** The kinds of creases in words. */
export const creaseWords = {
  crease: 'sharp edge',
  rounding: 'faces that touch, but for rounding',
  sliver: 'sliver of the triangulation',
} as const;

/** 'tubes from a diameter of 3.00 mm, walls from a thickness of 1.00 mm, gaps from 0.50 mm'. */
export function limitWords(limits: PrintLimits, format: LengthFormat): string {
  const words: string[] = [];
  if (limits.tubeDiameter > 0)
    words.push(`tubes from a diameter of ${formatLength(limits.tubeDiameter, format)}`);
  if (limits.wallThickness > 0)
    words.push(`walls from a thickness of ${formatLength(limits.wallThickness, format)}`);
  if (limits.gap) words.push(`gaps from ${formatLength(limits.gap, format)}`);
  return words.join(', ');
}

/** 'tubes and gaps': what no limit is given for; '' where there is one for everything. */
export function uncheckedWords({ tubeDiameter, wallThickness, gap = 0 }: PrintLimits): string {
  const words = [
    ...(tubeDiameter > 0 ? [] : ['tubes']),
    ...(wallThickness > 0 ? [] : ['walls']),
    ...(gap > 0 ? [] : ['gaps']),
  ];
  return words.length < 3 ? words.join(' and ') : '';
}

/** A share in words: '<1%', '12%'. */
function shareWords(share: number): string {
  const percent = Math.round(100 * share);
  return percent < 1 ? '<1%' : `${percent}%`;
}

/**
 * 'Fails: 3 places are too thin, 12% of the surface. Passes from 112% of this size.', 'Passes: nothing is
 * too thin, down to 62% of this size.'; or too close, where gaps are limited. Creases are counted behind.
 */
export function answerWords(
  { places, creases, failingShare, passingScale }: PrintCheck,
  { gap = 0 }: Pick<PrintLimits, 'gap'> = {},
): string {
  const fault = gap > 0 ? 'too thin or too close' : 'too thin';
  const creased = creases.length > 0 ? ` Creases: ${formatCount(creases.length)}.` : '';
  if (places.length === 0) {
    return `Passes: nothing is ${fault}, down to ${ofSize(passingScale, 'this size')}.${creased}`;
  }
  const count = places.length === 1 ? 'one place is' : `${formatCount(places.length)} places are`;
  const bare = places.filter(({ least }) => least === 0).length;
  const remedy = Number.isFinite(passingScale)
    ? `Passes from ${ofSize(passingScale, 'this size')}.`
    : `It passes at no size: ${bare === 1 ? 'at one place' : `at ${formatCount(bare)} places`} faces meet in a sharp edge or lie on each other.`;
  return `Fails: ${count} ${fault}, ${shareWords(failingShare)} of the surface. ${remedy}${creased}`;
}
