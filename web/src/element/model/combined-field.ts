// Two fields in one: their difference or their ratio at each vertex. It is fetched when that is first asked for, and uses what
// is handed to it, as `section-tool.ts` does.

import type { failure } from '../../kernel/types/errors.js';
import type { summaryOf } from '../../kernel/page/field-run.js';
import type { Field, FieldName, NamedField } from '../../kernel/types/types.js';
import type {
  Combination,
  GivenName,
  ValuesName,
  combinedUnit,
  isFieldName,
} from '../../view/index.js';
import type { GivenField } from './given-fields.js';

/** An operand of a combined field. */
export type Operand = Field | GivenField;

/** The functions that combining uses. */
export interface CombiningKit {
  failure: typeof failure;
  summaryOf: typeof summaryOf;
  isFieldName: typeof isFieldName;
  combinedUnit: typeof combinedUnit;
}

/** Values of two fields in one. */
export interface CombinedField {
  readonly first: Operand;
  readonly second: Operand;
  /** NaN where one of the two has no value, and where something is divided by 0. */
  readonly values: Float64Array;
  readonly range: [number, number];
  readonly withoutValue: number;
  readonly note: string;
}

/** The source of fields to combine. */
export interface FieldSource {
  /** A whole field; undefined where it is not there yet, or not at all. */
  wholeOf(name: ValuesName): Operand | undefined;
  compute(name: FieldName): Promise<Field>;
  /** Fails as a wish for values does that a file has not. */
  notGiven(name: GivenName): Promise<never>;
}

/** The first field less the second, or divided by it. Errors: USAGE for a difference of what has different units. */
export function combine(
  by: Combination['by'],
  first: Operand,
  second: Operand,
  { failure, summaryOf }: Pick<CombiningKit, 'failure' | 'summaryOf'>,
): CombinedField {
  const units = [first.unit, second.unit];
  if (by === 'difference' && units[0] !== units[1] && !units.includes('')) {
    throw failure('USAGE', `values in ${units.join(' and in ')} have no difference`, {
      hint: 'show their ratio',
    });
  }
  const values = first.values.map((value, vertex) => {
    const other = second.values[vertex]!;
    if (by === 'difference') return value - other;
    return other === 0 ? NaN : value / other;
  });
  return { first, second, values, ...summaryOf(values), note: '' };
}

/** One field of two, each of which is computed unless it is there. Errors: USAGE where there are none such. */
export async function combined(
  fields: FieldSource,
  { first, by, second }: Combination,
  kit: CombiningKit,
): Promise<CombinedField> {
  const operand = async (name: ValuesName): Promise<Operand> => {
    const whole = fields.wholeOf(name);
    if (whole) return whole;
    if (kit.isFieldName(name)) return fields.compute(name);
    return fields.notGiven(name);
  };
  const [one, other] = await Promise.all([first, second].map(operand));
  return combine(by, one!, other!, kit);
}

/** The combined field for a file, with its name and unit. */
export function combinedToWrite(
  { first, by, second }: Combination,
  { values }: CombinedField,
  unitOf: (name: ValuesName) => string,
  { combinedUnit }: CombiningKit,
): NamedField {
  const words = `${first}_${by === 'ratio' ? 'over' : 'minus'}_${second}`;
  return {
    name: words.replace(/^_+/, '').replace(/__+/g, '_'),
    values,
    unit: combinedUnit(by, unitOf(first), unitOf(second)),
  };
}
