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
export {
  type DistributionContent,
  type DistributionKind,
  type DistributionSeries,
  DistributionPlot,
} from './distribution-plot.js';
export { type RegionColours, type Thresholds, ScatterPlot } from './scatter-plot.js';
export {
  type LengthFormat,
  formatCount,
  formatLength,
  formatNumber,
  withPower,
} from '../numbers.js';
