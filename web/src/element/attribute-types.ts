// The element's attributes with their types: for templates, and for the element's state.

import type { ColormapName } from '../view/colormap-names.js';
import type { ShownName } from '../view/field-words.js';
import type { Look } from '../view/look.js';
import type { UpName } from '../view/up-axis.js';

/** How the girth is computed; {@link GirthViewer} says what the words mean. */
export type GirthMethod = 'exact' | 'coarse' | 'refined';

/**
 * What the attributes can be; {@link GirthViewer} says what they do. Of those without a value `''` and `true` mean that
 * they are there, `false` that they are not.
 */
export interface GirthViewerAttributes {
  /** The address of a model. */
  src?: string;
  /** When it is fetched. */
  loading?: 'eager' | 'lazy';
  /** The address of a picture that stands in for the surface. */
  poster?: string;
  /** The unit of lengths where the file does not state it. */
  unit?: string;
  /** The unit that lengths are written in. */
  'shown-unit'?: string;
  /** What colours the surface. */
  field?: ShownName;
  /** What the legend calls it. */
  'field-title'?: string;
  /** The colours. */
  colormap?: ColormapName;
  /** The values at the ends of the colours. */
  range?: string;
  /** So many lines of equal value. */
  isolines?: number | string;
  /** Whether the colours are logarithmic. */
  log?: boolean | '';
  /** How the girth is computed. */
  method?: GirthMethod;
  /** Passes over loops whose saddles last no longer. */
  persistence?: number | string;
  /** Of the heat kernel signature. */
  time?: number | string;
  /** Of the wave kernel signature. */
  energy?: number | string;
  /** Of the scale-invariant heat kernel signature. */
  component?: number | string;
  /** `hover`, `none`, or vertices. */
  loop?: string;
  /** Pinned loops, with their names. */
  pins?: string;
  /** Which tips are drawn. */
  tips?: boolean | string;
  /** Where tubes and plates begin. */
  parts?: string;
  /** Two points whose bottleneck is drawn. */
  bottleneck?: string;
  /** Two points or more: the shortest path through them is drawn. */
  profile?: string;
  /** From where the surface is seen. */
  camera?: string;
  /** Whether the mesh's edges are drawn. */
  edges?: boolean | '';
  /** How the surface is drawn. */
  shading?: Look;
  /** Where a plane cuts it. */
  section?: string;
  /** Which way is up. */
  up?: UpName;
  /** Whether the next model is seen from where this one is. */
  'keep-view'?: boolean | '';
  /** Elements of the same name are seen from the same place. */
  linked?: string;
  /** The colours of elements of the same name span one range. */
  'one-scale'?: string;
  /** What lies on the surface beside it. */
  controls?: boolean | '' | 'none' | 'legend' | 'full';
  /** Whether it turns slowly until something is done. */
  turn?: boolean | '';
}

/**
 * What the element shows, in the words of its attributes: as JSON it can be kept. Attributes without a value are
 * `true`.
 */
export type ViewerState = {
  [Name in keyof Omit<GirthViewerAttributes, 'loading' | 'poster' | 'linked' | 'one-scale'>]?:
    | string
    | number
    | true;
};
