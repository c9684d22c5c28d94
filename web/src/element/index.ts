/**
 * `<girth-viewer>`, defined as soon as this module is imported, and what a page around it needs.
 * @module girth/element
 */

import { GirthViewer } from './viewer-element.js';

// Nothing is defined on a server, which renders pages but has no elements.
const registry = globalThis.customElements as CustomElementRegistry | undefined;
if (registry && !registry.get('girth-viewer')) registry.define('girth-viewer', GirthViewer);

declare global {
  interface HTMLElementTagNameMap {
    'girth-viewer': GirthViewer;
  }
}

export { GirthViewer };
export type {
  ErrorDetail,
  FieldChangeDetail,
  FieldDetail,
  GirthViewerEventMap,
  GirthViewerEvents,
  GirthViewerListener,
  HoverDetail,
  LoadDetail,
  ProgressDetail,
} from './events.js';
export type { PickDetail, PinnedLoop } from './surface/loops-on-surface.js';
export type { PartsWish, PlaceOnSurface, PlacePicture } from './presented.js';
export type { ShownField, ShownPlaces } from './surface/shading.js';
export type { DrawingOptions } from './figure/drawing.js';
export type { FigureOptions } from './figure/snapshot.js';
export type { PlaceNumber } from './surface/numbers-on-surface.js';
export type { StrokeOptions } from './surface/stroke.js';
export type { TipsChoice } from './surface/tips-on-surface.js';
export type {
  GirthMethod,
  GirthViewerAttributes,
  ViewerState,
} from './attributes/attribute-types.js';
export { make } from './controls/dom.js';
export {
  readCamera,
  readCount,
  readNumber,
  readPoint,
  writeCamera,
  writePoint,
} from './attributes/place-words.js';
export { type SectionWish, parseSection } from './attributes/section-words.js';
export { sentence } from './controls/sentence.js';
export { mostPathPoints, parsePath, parseTwoPoints, writePath } from './attributes/wish-words.js';
export { useKernel } from './model/shared-kernel.js';
export type { CameraView, ScreenPoint } from '../view/index.js';
export { type Category, girthKinds, girthStates, partKinds } from '../view/categories.js';
export {
  type ColormapName,
  colormapNames,
  isColormapName,
  isForAllEyes,
} from '../view/colormap-names.js';
export {
  type Combination,
  type CombinedName,
  type GivenName,
  type ShownName,
  type ValuesName,
  combinationOf,
  derivedNames,
  fieldNames,
  fieldTitle,
  inSentence,
  isFieldName,
  isGivenName,
  isShownName,
} from '../view/field-words.js';
export { type LengthUnit, findLengthUnit, lengthUnits } from '../kernel/types/length-units.js';
export { type ReadLength, readLength, readLengthOrShare, typedUnit } from '../view/length-text.js';
export { type Look, lookNames } from '../view/look.js';
export {
  type LengthFormat,
  formatCount,
  formatLength,
  formatNumber,
  lengthFormat,
  placeIn,
} from '../view/numbers.js';
export {
  type Rotation,
  type UpAxis,
  type UpName,
  isUpName,
  rotationUp,
  upAxisOf,
  upNames,
  uprightPositions,
} from '../view/up-axis.js';
