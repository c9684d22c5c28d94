// The method by which a girth was computed, from the words of its field.

import type { Field } from '../../kernel/types/types.js';
import type { GirthMethod } from '../attributes/attribute-types.js';

export function methodOf({ method }: Field): GirthMethod {
  if (method === 'refined') return 'refined';
  return method.startsWith('exact on ') ? 'coarse' : 'exact';
}
