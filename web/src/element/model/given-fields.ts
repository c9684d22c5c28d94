// Fields that a file has for its vertices: those that the kernel computes, and any others under their names.

import { summaryOf } from '../../kernel/page/field-run.js';
import type { Field, FieldName } from '../../kernel/types/types.js';
import { type GivenName, isFieldName, isGivenName } from '../../view/field-words.js';
import type { FigureValues } from './figure-file.js';

/** Values that a file has. */
export interface GivenField extends Omit<Field, 'name'> {
  name: FieldName | GivenName;
}

/** The fields of a file, in its order. Values that are no field's are left out. */
export function givenFields(all: readonly FigureValues[]): GivenField[] {
  const fields: GivenField[] = [];
  for (const { attribute, values, kinds, unit, method } of all) {
    const own = attribute.toLowerCase();
    const name = isFieldName(own.slice(1)) ? (own.slice(1) as FieldName) : own;
    if (!isFieldName(name) && !isGivenName(name)) continue;
    if (fields.some((field) => field.name === name)) continue;
    fields.push({ name, values, kinds, unit, method, note: '', ...summaryOf(values) });
  }
  return fields;
}

/** Fields of a file at the vertices of a surface made of its own, as far as they cover it. */
export function carriedTo(
  fields: readonly GivenField[],
  vertexOfInput: Uint32Array,
  vertexCount: number,
): GivenField[] {
  const input = new Int32Array(vertexCount).fill(-1);
  vertexOfInput.forEach((vertex, i) => {
    if (vertex < vertexCount) input[vertex] = i;
  });
  if (input.includes(-1)) return [];
  return fields
    .filter(({ values }) => values.length === vertexOfInput.length)
    .map((field) => ({
      ...field,
      values: Float64Array.from(input, (i) => field.values[i]!),
      kinds: field.kinds.length > 0 ? Uint8Array.from(input, (i) => field.kinds[i]!) : field.kinds,
    }));
}
