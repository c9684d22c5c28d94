// Made of cpp/include/girth/analyses.def by `npm run build:tables`: not to be edited.

import type { WatchedOptions } from './call-options.js';
import type { SurfacePoint } from './points.js';
import type { Distances } from './results.js';

/** Two points of a surface. */
export interface PointPair {
  /** The first point. */
  start: SurfacePoint;
  /** The second point. */
  end: SurfacePoint;
}

/** Which distances are wanted. */
export interface DistancesOptions extends WatchedOptions {
  /** The points: two for each distance. */
  pairs: readonly PointPair[];
  /** Whether each distance has its shortest path too. Default: false. */
  paths?: boolean;
}

/** Calls of a mesh, one for each analysis. */
export interface Analyses {
  /**
   * Measures the distances between pairs of points along the surface, exact to rounding
   * (`GeodesicSolver.path`). On all threads, the same bits for any number of them. Errors:
   * VERTEX_OUT_OF_RANGE, INVALID_POINT; LIMIT_EXCEEDED where a path takes too many windows; CANCELLED.
   *
   * @experimental
   */
  distances(options: DistancesOptions): Promise<Distances>;
}

/** The results of analyses. */
export type FoundByAnalysis = Distances;

/** The analyses: the list that only their results have, by their names. */
export const analysisLists: Readonly<Record<keyof Analyses, string>> = { distances: 'distances' };
