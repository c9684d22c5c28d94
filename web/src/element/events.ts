// The element's events, and what they carry.

import type { FieldName, GirthErrorFields, MeshInfo } from '../kernel/types/types.js';
import type { ShownName } from '../view/index.js';
import type { PickDetail } from './surface/loops-on-surface.js';
import type { ShownField } from './surface/shading.js';

/** Details of `load`: a model is shown. */
export interface LoadDetail {
  /** The facts of the model. */
  info: MeshInfo;
}
/** Details of `progress`: a field is being computed. */
export interface ProgressDetail {
  /** Which field. */
  name: FieldName;
  /** The finished share in [0, 1]. */
  fraction: number;
  /** An estimate; undefined while it is too early for one. */
  secondsLeft: number | undefined;
}
/** Details of `field`: a field has been computed, or its work was cancelled. */
export interface FieldDetail {
  /** Which field. */
  name: FieldName;
  /** Smallest and largest value; NaN twice where there is no value. */
  range: [number, number];
  /** The symbol of the unit of the values; for lengths the element's. */
  unit: string;
  /** 1, or the computed share of the vertices where the work was cancelled. */
  share: number;
}
/** Details of `fieldchange`: something else colours the surface, or in another way. */
export interface FieldChangeDetail {
  /** The name of the field or categories that colour the surface. */
  name: ShownName;
  /** Undefined as long as there is nothing to show. */
  shown: ShownField | undefined;
}
/** Details of `hover`: another vertex is pointed at, or none. */
export interface HoverDetail {
  /** The vertex nearest to what is pointed at; undefined beside the surface. */
  vertex: number | undefined;
  /** The values there of every field that is computed there. */
  values: Partial<Record<FieldName, number>>;
}
/** Details of `error`: something has failed, or was asked for wrongly. */
export interface ErrorDetail extends GirthErrorFields {
  /** The attribute whose value is wrong; undefined for all other errors. */
  attribute?: string | undefined;
}

/** The events that the element itself sends, by their names. None bubbles. */
export interface GirthViewerEvents {
  /** A model is shown. */
  load: CustomEvent<LoadDetail>;
  /** A field is being computed. */
  progress: CustomEvent<ProgressDetail>;
  /** A field has been computed, or its work was cancelled. */
  field: CustomEvent<FieldDetail>;
  /** Something else colours the surface, or in another way. */
  fieldchange: CustomEvent<FieldChangeDetail>;
  /** Another vertex is pointed at, or none. */
  hover: CustomEvent<HoverDetail>;
  /** A loop was shown, pinned, named or unpinned. */
  pick: CustomEvent<PickDetail>;
  /** Something has failed, or an attribute is wrong. */
  error: CustomEvent<ErrorDetail>;
  /** The surface no longer turns. */
  touch: CustomEvent<null>;
  /** Something was chosen on the bar. */
  view: CustomEvent<null>;
  /** Lengths are written in another unit. */
  unit: CustomEvent<null>;
  /**
   * The surface is seen from elsewhere than in the last frame. Sent before this frame is drawn, once in it: what a listener
   * changes in other elements is drawn in the same frame.
   */
  cameramove: CustomEvent<null>;
  /** The camera was moved, and is at rest again. */
  camera: CustomEvent<null>;
}

/** All events of the element by their names, those that every element has included. */
export interface GirthViewerEventMap
  extends Omit<HTMLElementEventMap, keyof GirthViewerEvents>, GirthViewerEvents {}

/** A listener of an event of the element. */
export type GirthViewerListener<Name extends keyof GirthViewerEventMap> =
  | ((event: GirthViewerEventMap[Name]) => unknown)
  | {
      /** Called with each event. */
      handleEvent(event: GirthViewerEventMap[Name]): unknown;
    };
