// What the element's events tell.

import type { FieldName, MeshInfo } from '../kernel/types.js';
import type { ShownName } from '../view/index.js';
import type { ShownField } from './shading.js';

export interface LoadDetail {
  info: MeshInfo;
}
export interface ProgressDetail {
  name: FieldName;
  /** The finished share in [0, 1]. */
  fraction: number;
  /** Undefined while it is too early to tell. */
  secondsLeft: number | undefined;
}
export interface FieldDetail {
  name: FieldName;
  /** NaN twice where there is no value. */
  range: [number, number];
  /** Of the values; lengths in the element's unit. */
  unit: string;
  /** 1, or the computed share of the vertices where the work was cancelled. */
  share: number;
}
export interface FieldChangeDetail {
  name: ShownName;
  /** Undefined as long as there is nothing to show. */
  shown: ShownField | undefined;
}
export interface HoverDetail {
  /** The vertex nearest to what is pointed at; undefined beside the surface. */
  vertex: number | undefined;
  /** The values there of every field that is computed there. */
  values: Partial<Record<FieldName, number>>;
}
