/**
 * `<girth-viewer>`, defined as soon as this module is imported, and what a page around it needs.
 * @module girth/element
 */

import { GirthViewer } from './viewer-element.js';

// On a server, which renders pages but has no elements, nothing happens.
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
export type { PickDetail, PinnedLoop } from './loops-on-surface.js';
export type { PartsWish, PlaceOnSurface, PlacePicture } from './presented.js';
export type { ShownField, ShownPlaces } from './shading.js';
export type { FigureOptions } from './snapshot.js';
export type { TipsChoice } from './tips-on-surface.js';
export { make } from './dom.js';
export { sentence } from './sentence.js';
export { useKernel } from './shared-kernel.js';
export {
  type CameraView,
  type Category,
  type ColormapName,
  type LengthFormat,
  type LengthUnit,
  type ReadLength,
  type Rotation,
  type ScreenPoint,
  type Look,
  type ShownName,
  type UpAxis,
  type UpName,
  colormapNames,
  colourAt,
  derivedNames,
  fieldNames,
  fieldTitle,
  findLengthUnit,
  formatCount,
  formatLength,
  formatNumber,
  girthKinds,
  isColormapName,
  isFieldName,
  isForAllEyes,
  isShownName,
  isUpName,
  lengthFormat,
  lengthUnits,
  lookNames,
  partKinds,
  placeIn,
  readLength,
  rotationUp,
  typedUnit,
  upAxisOf,
  upNames,
  uprightPositions,
} from '../view/index.js';
