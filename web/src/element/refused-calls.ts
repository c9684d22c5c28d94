// What only the kernel can answer of a mesh, refused: for surfaces that are shown with what is known of them already.

import type { Mesh } from '../kernel/types/types.js';

/** What is known of every mesh. */
type Known = 'info' | 'geometry' | 'vertexOfInput' | 'vertexAreas' | 'dispose';

/** All calls that compute, each answered by `refuse`. */
export const refusedCalls = (refuse: () => Promise<never>): Omit<Mesh, Known> => ({
  ...{
    field: refuse,
    refinedGirth: refuse,
    loop: refuse,
    path: refuse,
    barcode: refuse,
    barcodes: refuse,
  },
  ...{ tips: refuse, limbs: refuse, necks: refuse, handles: refuse },
  ...{ bottleneck: refuse, profile: refuse, axis: refuse, exportProfile: refuse },
  ...{ removeHandles: refuse, levelCurves: refuse, cut: refuse, exportCut: refuse },
  ...{ parts: refuse, suggestedThresholds: refuse, segments: refuse, exportSegments: refuse },
  ...{ printCheck: refuse, maxima: refuse, heatMaxima: refuse, difference: refuse },
  ...{ exportField: refuse, exportFields: refuse, exportLoops: refuse, exportTips: refuse },
  ...{
    exportLimbs: refuse,
    exportParts: refuse,
    exportWeakPlaces: refuse,
    remesh: refuse,
    smooth: refuse,
  },
});
