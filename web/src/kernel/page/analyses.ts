// Made of cpp/include/girth/analyses.def by `npm run build:tables`: not to be edited.

import type { Analyses, DistancesOptions } from '../types/analyses.js';
import type { Distances, WatchedOptions } from '../types/types.js';

/** A mesh that hands analyses on. */
export abstract class MeshWithAnalyses implements Analyses {
  protected abstract analyse<Found extends object>(
    name: keyof Analyses,
    options: WatchedOptions,
  ): Promise<Found>;

  distances(options: DistancesOptions): Promise<Distances> {
    return this.analyse('distances', options);
  }
}
