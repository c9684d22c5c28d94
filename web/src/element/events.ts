// The element's events, and what they carry.

import type { FieldName, GirthErrorFields, MeshInfo } from '../kernel/types/types.js';
import type { ShownName } from '../view/index.js';
import type { PickDetail } from './surface/loops-on-surface.js';
import type { ShownField } from './surface/shading.js';

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
/** Of `error`: something has failed, or was asked for wrongly. */
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
  /** What is pointed at has changed. */
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

/** What hears an event of the element. */
export type GirthViewerListener<Name extends keyof GirthViewerEventMap> =
  | ((event: GirthViewerEventMap[Name]) => unknown)
  | {
      /** Called with each event. */
      handleEvent(event: GirthViewerEventMap[Name]): unknown;
    };
