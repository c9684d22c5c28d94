// What the element uses to show fields and loops.

export { type Adjacency, buildAdjacency } from './adjacency.js';
export { type Category, girthKinds, partKinds } from './categories.js';
export { type ColormapName, colormapNames, colourAt, isColormapName } from './colormaps.js';
export type { CameraView } from './camera-view.js';
export { splitCreases } from './creases.js';
export {
  type ShownName,
  derivedNames,
  fieldNames,
  fieldTitle,
  fieldUnit,
  isFieldName,
  isShownName,
} from './field-words.js';
export { FieldPreview } from './field-preview.js';
export { GroundShadow, splatShadow } from './ground-shadow.js';
export { Latest } from './latest.js';
export { Legend, type LegendContent, type ScaleContent } from './legend.js';
export { type LegendInk, drawLegend } from './legend-picture.js';
export { LoopBand } from './loop-band.js';
export {
  type LengthFormat,
  formatCount,
  formatLength,
  formatNumber,
  lengthFormat,
  roundTicks,
} from './numbers.js';
export type { ScreenPoint } from './picker.js';
export type { Place } from './place-view.js';
export { PointMarks } from './point-marks.js';
export { quantile } from './plots/distribution.js';
export { Stage } from './stage.js';
export { Surface, borrowedWeight, computedWeight } from './surface.js';
export { TimeLeft, formatSeconds } from './time-left.js';
export { inSlices } from './time-slices.js';
export { TipMarks } from './tip-marks.js';
