// By which method a girth was computed, as its field has it in words.

import type { Field } from '../kernel/types.js';
import type { GirthMethod } from './attribute-types.js';

/** What the method of a girth on fewer triangles begins with, before their number. */
export const onFewer = 'exact on ';

export function methodOf({ method }: Field): GirthMethod {
  if (method === 'refined') return 'refined';
  return method.startsWith(onFewer) ? 'coarse' : 'exact';
}
