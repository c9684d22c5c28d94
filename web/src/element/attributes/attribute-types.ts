// The element's attributes with their types: for templates, and for the element's state. The comments of the attributes are
// made of those in attributes.ts by `npm run build:tables`: not to be edited here.

import type { ColormapName } from '../../view/colormap-names.js';
import type { ShownName } from '../../view/field-words.js';
import type { Look } from '../../view/look.js';
import type { UpName } from '../../view/up-axis.js';

/** How the girth is computed; {@link GirthViewerAttributes} says what the words mean. */
export type GirthMethod = 'exact' | 'coarse' | 'refined';

/**
 * The attributes, with their effects and values. For an attribute without a value, `''` and `true` mean that it is there,
 * `false` that it is not.
 */
export interface GirthViewerAttributes {
  /** Address of a model: GLB, glTF with its buffers beside it, OBJ, PLY, STL, OFF, or a zip. */
  src?: string;
  /**
   * `lazy` fetches nothing but a small script before the element is near the view; by default,
   * `eager`, the script that draws comes at once, and only the model waits for the view.
   */
  loading?: 'eager' | 'lazy';
  /**
   * Address of a picture that is shown until the surface is drawn, and where it cannot be drawn.
   * An element in the slot `poster` serves as well.
   */
  poster?: string;
  /** The unit of lengths where the file does not state it, for example `mm`. */
  unit?: string;
  /**
   * The unit that lengths are written in: `um`, `mm`, `cm`, `m`, `km`, `in` or `ft`; by default
   * the model's own. Files that are exported keep the model's.
   */
  'shown-unit'?: string;
  /**
   * The field that colours the surface: one of the kernel (`FieldName`; `igf`, the girth, by
   * default), `kind` (of the loop), `state` (how sure a refined girth is), `tips` (how far the
   * girth rises at the tip that a place is in), `parts` (tubes, plates and body) or `none`;
   * values of the file as in `_heat`; or two of these in one: their difference, `igf-sdf`, where
   * they have the same unit, or their ratio, `igf/sdf`.
   */
  field?: ShownName;
  /** The field's name in the legend; by default its usual name. */
  'field-title'?: string;
  /**
   * `viridis` (default), `cividis`, `plasma`, `magma`, `turbo`, or `rdbu`, which diverges and is
   * the default for differences, round 0, and where values have both signs.
   */
  colormap?: ColormapName;
  /**
   * `auto` (default), the body of the values, without what few places stretch it by; two numbers,
   * the values at the ends of the colour map; or two percentages as in `5% 95%`, the shares of
   * the surface's area that lie below them.
   */
  range?: string;
  /** So many lines of equal value between the ends of the range; none by default. */
  isolines?: number | string;
  /** The colour map is logarithmic, where all values in it are above 0. */
  log?: boolean | '';
  /**
   * How the girth is computed. `exact` (default); `coarse`, on about 10,000 triangles, whose
   * values are carried back to all vertices; `refined`, at all vertices in a fraction of the
   * time, with states and an audit (`RefinedGirth`), for surfaces of more than some 20,000
   * triangles. The colours are those of `coarse` until a refined girth is there; with a
   * `persistence` it is `coarse`.
   */
  method?: GirthMethod;
  /**
   * Passes over loops whose saddles last no longer than this, as noise makes them: a length in
   * model units or with a unit, as in `0.5` or `3mm`, or a share of the square root of the area,
   * as in `2%`. It holds for the girth, for what is made of it and for loops; pinned ones are
   * computed anew.
   */
  persistence?: number | string;
  /**
   * The time of `hks`, as a share of the surface's area, `0.002` by default; small times see
   * small details.
   */
  time?: number | string;
  /** The energy of `wks`, from `1` (low: the whole shape) to `100` (details); `20` by default. */
  energy?: number | string;
  /**
   * The frequency of `sihks`, from `1` (default) to `19`. Changed while its field is shown, each
   * of these three computes it anew.
   */
  component?: number | string;
  /**
   * `hover` (default), `none`, or vertices whose loops are pinned once the model is there, as in
   * `loop="12 4031"`.
   */
  loop?: string;
  /**
   * The loops that are pinned, with commas between them, and with their names: `pins="12 waist,
   * 4031"`. A point of a face is the face and two of its weights: `7:0.2:0.3`. `%2C` is a comma
   * of a name. `none` pins none, not even those that the file has.
   */
  pins?: string;
  /**
   * Draws the tips: all; those that rise at least so much, as in `5mm`; and marks one, as in `#2`
   * or `5mm #2`, the highest being 1. `none` draws none, not even those that the file has.
   */
  tips?: boolean | string;
  /**
   * The girth and the shape diameter where tubes and plates begin, and the smoothing, as in
   * `parts="200mm 50mm 0.1"`; by default as the model's own values suggest. `field="parts"`
   * colours by them.
   */
  parts?: string;
  /**
   * Two points, as in `bottleneck="12, 4031"`: they are marked, and the narrowest loop on the
   * widest way between them is drawn.
   */
  bottleneck?: string;
  /**
   * Two points or more, up to 200: the shortest path through them is drawn, and its points are
   * marked; of more than twelve, its ends.
   */
  profile?: string;
  /**
   * From where the surface is seen: `front`, `side`, `top`, or the six numbers of a `CameraView`:
   * `polar`, `azimuth`, `distance` and the three of `target`; by default from where it is seen
   * whole.
   */
  camera?: string;
  /** Draws the mesh's edges. */
  edges?: boolean | '';
  /** `smooth` (default); `flat`, so that each face can be seen; or `transparent`. */
  shading?: Look;
  /**
   * Cuts away what lies beyond a plane across a direction of the file, `x`, `-y` or three
   * numbers, and a share of the surface's extent along it: `x 40%` leaves the first 40% along x.
   * The inside is drawn plainly; what is cut away is not picked.
   */
  section?: string;
  /**
   * The direction of the file that is up: `y`, `z`, `-y`, `-z`, `x` or `-x`. Default: the
   * format's convention (y of glTF and OBJ, z of STL), otherwise a guess from the shape; see
   * `upAxis`.
   */
  up?: UpName;
  /** The next model is seen from where this one is, in sizes of the models. */
  'keep-view'?: boolean | '';
  /**
   * A name. Elements of a page that have the same one are seen from the same place, in radii of
   * each surface: to move one moves all, within the frame. As at first, by `0` or `resetView`,
   * all surfaces are seen whole.
   */
  linked?: string;
  /**
   * A name. The colours of elements that have the same one, and show the same field, span one
   * range: from the least to the greatest that each would show alone, whatever their units; or
   * the two numbers of `range` of one of them.
   */
  'one-scale'?: string;
  /**
   * Controls beside the surface: `none`; the `legend` (default); or `full`, and without a value,
   * a small bar too: first view, axes and straight views, drawing, pause.
   */
  controls?: boolean | '' | 'none' | 'legend' | 'full';
  /**
   * Turns slowly once it is computed and until something is done on the page, unless the system
   * asks for reduced motion; with a button that stops it.
   */
  turn?: boolean | '';
}

/**
 * The state of the element, in the words of its attributes: as JSON it can be kept. Attributes
 * without a value are `true`.
 */
export type ViewerState = {
  [Name in keyof Omit<GirthViewerAttributes, 'loading' | 'poster' | 'linked' | 'one-scale'>]?:
    | string
    | number
    | true;
};
