// What only the kernel can answer of a mesh, refused: for surfaces that are shown with what is known of them already.

import { analysisNames } from '../kernel/types/operations/analysis.js';
import type { Mesh } from '../kernel/types/types.js';

/** What is known of every mesh. */
type Known = 'info' | 'geometry' | 'vertexOfInput' | 'vertexAreas' | 'dispose';

/** Calls that are no operations of the module for analysis. */
const others = [
  ...(['field', 'loop', 'barcode', 'barcodes', 'heatMaxima'] as const),
  ...([
    'write',
    'exportField',
    'exportFields',
    'exportLoops',
    'exportProfile',
    'exportCut',
  ] as const),
  ...(['exportTips', 'exportLimbs', 'exportParts', 'exportSegments', 'exportWeakPlaces'] as const),
] satisfies (keyof Mesh)[];

/** All calls that compute, each answered by `refuse`. */
export function refusedCalls(refuse: () => Promise<never>): Omit<Mesh, Known> {
  const names = [...analysisNames, ...others];
  const calls = Object.fromEntries(names.map((name) => [name, refuse]));
  return calls as Record<(typeof names)[number], typeof refuse>;
}
