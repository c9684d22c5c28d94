// What the element's events carry.

import type { FieldName, MeshInfo } from '../kernel/types.js';
import type { ShownName } from '../view/index.js';
import type { ShownField } from './shading.js';

/** Of `load`: a model is shown. */
export interface LoadDetail {
  /** What the model is. */
  info: MeshInfo;
}
/** Of `progress`: a field is being computed. */
export interface ProgressDetail {
  /** Which field. */
  name: FieldName;
  /** The finished share in [0, 1]. */
  fraction: number;
  /** An estimate; undefined while it is too early for one. */
  secondsLeft: number | undefined;
}
/** Of `field`: a field has been computed, or its work was cancelled. */
export interface FieldDetail {
  /** Which field. */
  name: FieldName;
  /** Smallest and largest value; NaN twice where there is no value. */
  range: [number, number];
  /** Of the values; lengths in the element's unit. */
  unit: string;
  /** 1, or the computed share of the vertices where the work was cancelled. */
  share: number;
}
/** Of `fieldchange`: something else colours the surface, or in another way. */
export interface FieldChangeDetail {
  /** What colours it. */
  name: ShownName;
  /** Undefined as long as there is nothing to show. */
  shown: ShownField | undefined;
}
/** Of `hover`: what is pointed at has changed. */
export interface HoverDetail {
  /** The vertex nearest to what is pointed at; undefined beside the surface. */
  vertex: number | undefined;
  /** The values there of every field that is computed there. */
  values: Partial<Record<FieldName, number>>;
}
