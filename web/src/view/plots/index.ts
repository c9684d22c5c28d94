// Plots of fields: what a page puts beside the surface.

export {
  type Cumulative,
  type Histogram,
  type Weights,
  cumulative,
  extent,
  histogram,
  placesWithin,
  quantile,
  shareWithin,
} from './distribution.js';
export { type ColormapName } from '../colormap-names.js';
export { colourAt } from '../colormaps.js';
export type { ValueRange } from './brush-range.js';
export {
  type AxisWords,
  type BarColour,
  type DistributionAxes,
  type DistributionContent,
  type DistributionEvents,
  type DistributionKind,
  type DistributionSeries,
  DistributionPlot,
} from './distribution-plot.js';
export type { PlotLine } from './plot-frame.js';
export { type ProfileContent, type ProfileEvents, ProfilePlot } from './profile-plot.js';
export {
  type RegionColours,
  type ScatterContent,
  type ScatterEvents,
  type ScatterLabels,
  type Thresholds,
  ScatterPlot,
} from './scatter-plot.js';
export {
  type LengthFormat,
  formatCount,
  formatLength,
  formatNumber,
  writtenOut,
} from '../numbers.js';
export { type LengthUnit, findLengthUnit } from '../../kernel/types/length-units.js';
