// The account of a surface that is shown as it is: nothing was done to it.

import type { PreparationReport } from '../../kernel/types/types.js';

export const nothingPrepared: PreparationReport = {
  ...{
    inputVertices: 0,
    inputFaces: 0,
    weldedVertices: 0,
    degenerateFaces: 0,
    flippedFaces: 0,
    addedFaces: 0,
  },
  ...{ duplicateFaces: 0, unreferencedVertices: 0, reorientedFaces: 0, oneSidedEdges: 0 },
  ...{ nonManifoldEdges: 0, nonManifoldVertices: 0, addedVertices: 0, components: 0 },
  ...{ sliverComponents: 0, doubledComponents: 0 },
  ...{ keptComponents: 0, boundaryCurves: 0, boundaryEdges: 0, closedHoles: 0, holes: [] },
  ...{ crackVertices: 0, tJunctions: 0, crackWidth: 0 },
};
