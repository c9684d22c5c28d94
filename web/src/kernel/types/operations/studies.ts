// Operations of the module for studies: spectra, and comparisons of shapes.

import type { CommonOperations, StudyFields } from '../protocol.js';
import type { Maximum } from '../types.js';
import { type MessagesOf, takes } from './table.js';

/** Operations on spectra, and comparisons of shapes. */
export const studying = {
  /** Keeps the spectrum for the next request on the same surface. */
  spectralField: takes('surface', 'signature', 'onProgress').gives<{
    values: Float64Array<ArrayBuffer>;
    method: string;
  }>(),
  /** Persistent maxima of the heat kernel signature. */
  heatMaxima: takes('surface', 'signature', 'onProgress').gives<{ maxima: Maximum[] }>(),
  /** The names of the groups of fields that descriptors need. */
  fieldGroups: takes('descriptors').gives<{ groups: string[] }>(),
  /** One group of fields. The surface is remeshed to about so many faces where it has more, and then smoothed. */
  studyFields: takes('surface', 'group', 'faces', 'smooth', 'onProgress').gives<StudyFields>(),
  /** For each descriptor the distances between all models, row by row. */
  compare: takes('models', 'descriptors', 'onProgress').gives<{
    matrices: Float64Array<ArrayBuffer>[];
  }>(),
};

/** A worker for jobs with the module that computes spectra and compares shapes. */
export interface StudiesOperations extends CommonOperations, MessagesOf<typeof studying> {}
