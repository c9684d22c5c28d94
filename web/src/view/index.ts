// Exports that the element uses to show fields and loops.

export { type Adjacency, buildAdjacency } from './adjacency.js';
export { type Category, girthKinds, girthStates, partKinds } from './categories.js';
export {
  type ColormapName,
  colormapNames,
  isColormapName,
  isForAllEyes,
} from './colormap-names.js';
export { colourAt } from './colormaps.js';
export { type CameraView, isSameView } from './camera-view.js';
export { splitCreases } from './creases.js';
export {
  type Combination,
  type CombinedName,
  type GivenName,
  type ShownName,
  type ValuesName,
  combinationOf,
  combinedUnit,
  derivedNames,
  fieldNames,
  fieldTitle,
  fieldUnit,
  inSentence,
  isFieldName,
  isGivenName,
  isShownName,
} from './field-words.js';
export { FieldPreview } from './field-preview.js';
export { GroundShadow, splatShadow } from './ground-shadow.js';
export { Latest } from './latest.js';
export { type ReadLength, readLength, readLengthOrShare, typedUnit } from './length-text.js';
export { Legend, type LegendContent, type ScaleContent } from './legend.js';
export { type LegendInk, drawLegend } from './legend-picture.js';
export { LoopBand } from './loop-band.js';
export {
  type LengthFormat,
  formatCount,
  formatLength,
  formatNumber,
  lengthFormat,
  placeIn,
  roundTicks,
} from './numbers.js';
export type { ScreenPoint } from './picker.js';
export type { Place } from './place-view.js';
export { PointMarks } from './point-marks.js';
export { quantile, quantiles, shareWithin } from './plots/distribution.js';
export { type Box, Silhouette } from './silhouette.js';
export { type Graphics } from './renderer.js';
export { Stage } from './stage.js';
export { type StraightName, straightNames } from './straight-names.js';
export { Surface, borrowedWeight, computedWeight } from './surface.js';
export { type Look, lookNames } from './look.js';
export { TimeLeft, formatSeconds } from './time-left.js';
export { inSlices, nextTask } from './time-slices.js';
export { TipMarks } from './tip-marks.js';
export {
  type Rotation,
  type UpAxis,
  type UpName,
  isUpName,
  rotationUp,
  upAxisOf,
  upNames,
  uprightPositions,
} from './up-axis.js';
