// Operations of the module for analysis: new surfaces, and results. A mesh has a call of the same name for each.

import type { Described } from '../../wasm/girth-files.mjs';
import { type Analyses, analysisLists } from '../analyses.js';
import type { FoundRefined, FoundSegments, FoundTips } from '../protocol.js';
import type {
  Bottleneck,
  Cut,
  HandleRemoval,
  Handles,
  LevelCurve,
  LimbAxis,
  Limbs,
  Maximum,
  Mesh,
  Necks,
  Parts,
  PartThresholds,
  PrintCheck,
  Profile,
  SurfacePath,
} from '../types.js';
import { takes } from './table.js';

interface Made {
  described: Described;
}

/** Operations that make another surface. */
export const makingSurfaces = {
  remesh: takes('surface', 'faces', 'even', 'onProgress').gives<Made>(),
  smooth: takes('surface', 'steps', 'onProgress').gives<Made>(),
  removeHandles: takes('surface', 'length', 'basePoints', 'onProgress').gives<
    Made & { removal: HandleRemoval }
  >(),
};

/** Operations that find something on a surface. */
export const analysing = {
  difference: takes('surface', 'values', 'other', 'otherValues').gives<{ difference: number }>(),
  refinedGirth: takes('surface', 'request', 'onProgress').gives<FoundRefined>(),
  vertexAreas: takes('surface').gives<{ areas: Float64Array<ArrayBuffer> }>(),
  path: takes('surface', 'from', 'to').gives<Omit<SurfacePath, 'unit'>>(),
  tips: takes('surface', 'girth').gives<FoundTips>(),
  limbs: takes('surface', 'girth', 'stations', 'onProgress').gives<Limbs>(),
  necks: takes('surface', 'girth', 'minProminence', 'onProgress').gives<Necks>(),
  bottleneck: takes('surface', 'girth', 'from', 'to', 'onProgress').gives<Bottleneck>(),
  profile: takes('surface', 'points', 'samples', 'crossings', 'onProgress').gives<
    Omit<Profile, 'unit'>
  >(),
  axis: takes('surface', 'profile', 'onProgress').gives<Omit<LimbAxis, 'unit'>>(),
  handles: takes('surface', 'basePoints', 'onProgress').gives<Handles>(),
  levelCurves: takes('surface', 'values', 'level').gives<{ curves: LevelCurve[] }>(),
  cut: takes('surface', 'curves', 'cap').gives<Cut>(),
  segments: takes('surface', 'fields', 'division', 'onProgress').gives<FoundSegments>(),
  suggestedThresholds: takes('surface', 'fields').gives<PartThresholds>(),
  parts: takes('surface', 'fields', 'options').gives<Parts>(),
  maxima: takes('surface', 'values', 'minima').gives<{ maxima: Maximum[] }>(),
  printCheck: takes('surface', 'printed', 'limits', 'onProgress').gives<PrintCheck>(),
};

/** Calls of a mesh that are operations of their names, and the analyses. */
export const analysisNames = Object.keys({
  ...makingSurfaces,
  ...analysing,
  ...analysisLists,
}) as (keyof Mesh & (keyof typeof makingSurfaces | keyof typeof analysing | keyof Analyses))[];
