// Which fields can be shown, and what they are called.

import type { FieldName } from '../kernel/types.js';

/** Fields of numbers that the kernel computes, the default first. */
export const fieldNames: readonly FieldName[] = [
  'igf',
  'sdf',
  'thickness',
  'geoaverage',
  'geofarthest',
  'angle',
  'hks',
  'wks',
  'sihks',
];

/** What is made of fields: the girth's kinds, the rise at the tip that a place is in, tubes and plates. */
export const derivedNames = ['kind', 'tips', 'parts'] as const;

/** Values that only the model's file has: their attribute's name, in small letters. */
export type GivenName = `_${string}`;

/** What can colour a surface. */
export type ShownName = FieldName | (typeof derivedNames)[number] | GivenName | 'none';

const words: Record<Exclude<ShownName, GivenName>, string> = {
  igf: 'Girth',
  sdf: 'Shape diameter',
  thickness: 'Thickness',
  geoaverage: 'Mean distance',
  geofarthest: 'Greatest distance',
  angle: 'Angle of the loop',
  hks: 'Heat kernel signature',
  wks: 'Wave kernel signature',
  sihks: 'Scale-invariant heat kernel',
  kind: 'Kind of loop',
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

/** Whether something of that name can colour a surface. */
export function isShownName(name: string | null): name is ShownName {
  return name !== null && (Object.hasOwn(words, name) || isGivenName(name));
}

/** A field's name in words, for a legend; that of values of a file as it is there: 'Wall temperature'. */
export function fieldTitle(name: ShownName): string {
  if (!isGivenName(name)) return words[name];
  const text = name.replaceAll('_', ' ').trim() || name;
  return text[0]!.toUpperCase() + text.slice(1);
}

/** The unit of a field's values, where that of lengths is `unit`. */
export function fieldUnit(name: ShownName, unit: string): string {
  switch (name) {
    case 'angle':
      return 'rad';
    case 'hks':
    case 'wks':
      return unit && `1/${unit}²`;
    case 'sihks':
    case 'kind':
    case 'parts':
    case 'none':
      return '';
    default:
      return unit;
  }
}
