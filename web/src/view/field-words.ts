// Which fields can be shown, and what they are called.

import { fieldTitles } from '../kernel/types/fields.js';
import type { FieldName } from '../kernel/types/types.js';
import { unitOf, unitSymbol } from '../kernel/types/units.js';

/** Fields of numbers that the kernel computes, the default first. */
export const fieldNames = Object.keys(fieldTitles) as readonly FieldName[];

/** Names of what is made of fields: the girth's kinds and states, the rise at the tip that a place is in, tubes and plates. */
export const derivedNames = ['kind', 'state', 'tips', 'parts'] as const;

/** Values that only the model's file has: their attribute's name, in small letters. */
export type GivenName = `_${string}`;

/** Numbers at every vertex: a field, or values of the file. */
export type ValuesName = FieldName | GivenName;

/** Two of them in one: the first less the second, or divided by it. */
export type CombinedName = `${ValuesName}${'-' | '/'}${ValuesName}`;

/** A name of something that can colour a surface. */
export type ShownName = ValuesName | (typeof derivedNames)[number] | CombinedName | 'none';

/** The meaning of a combined name. */
export interface Combination {
  /** The minuend, or the dividend. */
  first: ValuesName;
  /** How the second is taken with the first. */
  by: 'difference' | 'ratio';
  /** The subtrahend, or the divisor. */
  second: ValuesName;
}

const words: Record<Exclude<ShownName, GivenName | CombinedName>, string> = {
  ...fieldTitles,
  kind: 'Kind of loop',
  state: 'How sure the girth is',
  tips: 'Rise at the tip',
  parts: 'Parts',
  none: '',
};

/** Whether the kernel computes a field of that name. */
export function isFieldName(name: string): name is FieldName {
  return (fieldNames as readonly string[]).includes(name);
}

/** Whether a name is of values that only files have. */
export function isGivenName(name: string): name is GivenName {
  return /^_[a-z0-9_]{1,60}$/.test(name);
}

/** Whether a name is of numbers at every vertex. */
const isValuesName = (name: string): name is ValuesName => isFieldName(name) || isGivenName(name);

/** The combination that 'igf-sdf' or 'igf/sdf' stands for; undefined for all that is no difference of like quantities and no ratio. */
export function combinationOf(name: string): Combination | undefined {
  const [, first = '', sign, second = ''] = /^(\w+)([-/])(\w+)$/.exec(name) ?? [];
  if (!isValuesName(first) || !isValuesName(second) || first === second) return undefined;
  if (sign === '/') return { first, by: 'ratio', second };
  // The unit of a file's values is known when it is read.
  const isKnown = isFieldName(first) && isFieldName(second);
  const isLike = !isKnown || fieldUnit(first, 'm') === fieldUnit(second, 'm');
  return isLike ? { first, by: 'difference', second } : undefined;
}

/** Whether something of that name can colour a surface. */
export function isShownName(name: string | null): name is ShownName {
  return (
    name !== null &&
    (Object.hasOwn(words, name) || isGivenName(name) || combinationOf(name) !== undefined)
  );
}

/** A field's name in words, for a legend; that of values of a file as it is there: 'Wall temperature'. */
export function fieldTitle(name: ShownName): string {
  const combined = combinationOf(name);
  if (combined) {
    const sign = combined.by === 'ratio' ? '÷' : '\u2212';
    return `${fieldTitle(combined.first)} ${sign} ${inSentence(fieldTitle(combined.second))}`;
  }
  if (!isGivenName(name)) return words[name as keyof typeof words];
  const text = name.replaceAll('_', ' ').trim() || name;
  return text[0]!.toUpperCase() + text.slice(1);
}

/** A title after other words. */
export const inSentence = (title: string): string => title.charAt(0).toLowerCase() + title.slice(1);

/** The unit of a difference of values, or of a ratio. */
export function combinedUnit(by: Combination['by'], first: string, second: string): string {
  if (by === 'difference') return first && second && first;
  if (first === second || second === '') return first === second ? '' : first;
  return `${first || '1'}/${second}`;
}

/** The symbol of the unit of a field's values, where that of lengths is `unit`. */
export function fieldUnit(name: ShownName, unit: string): string {
  if (isFieldName(name)) return unitSymbol(unitOf(name, unit));
  return ['kind', 'state', 'parts', 'none'].includes(name) ? '' : unit;
}
