// Refusals of the calls that only the kernel can answer, for surfaces that are shown without it.

import { analysisNames } from '../../kernel/types/operations/analysis.js';
import type { Mesh } from '../../kernel/types/types.js';

/** Members that every mesh answers without the kernel. */
const known = ['info', 'geometry', 'vertexOfInput', 'vertexAreas', 'dispose'] as const;
type Known = (typeof known)[number] | typeof Symbol.dispose;

/** Calls that are no operations of the module for analysis. */
const others = [
  ...(['field', 'loop', 'barcode', 'barcodes', 'heatMaxima'] as const),
  ...(['write', 'exportModel', 'exportField', 'exportFields', 'exportLoops'] as const),
  ...(['exportProfile', 'exportCut'] as const),
  ...(['exportTips', 'exportLimbs', 'exportParts', 'exportSegments', 'exportWeakPlaces'] as const),
] satisfies (keyof Mesh)[];

/** All calls that compute, each answered by `refuse`. */
export function refusedCalls(refuse: () => Promise<never>): Omit<Mesh, Known> {
  const isKnown = (name: keyof Mesh): name is (typeof known)[number] =>
    known.some((one) => one === name);
  const names = [...analysisNames, ...others].filter((name) => !isKnown(name));
  const calls = Object.fromEntries(names.map((name) => [name, refuse]));
  return calls as Record<Exclude<(typeof names)[number], Known>, typeof refuse>;
}
