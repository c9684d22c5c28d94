// Made of cpp/include/girth/analyses.def by `npm run build:tables`: not to be edited.

import type {
  Analyses,
  DistancesOptions,
  SectionsOptions,
  SectionsThroughOptions,
  ExtremeSectionOptions,
  LandmarksOptions,
} from '../types/analyses.js';
import type {
  Distances,
  Sections,
  Section,
  NamedMeasures,
  WatchedOptions,
} from '../types/types.js';

/** A mesh that hands analyses on. */
export abstract class MeshWithAnalyses implements Analyses {
  protected abstract analyse<Found extends object>(
    name: keyof Analyses,
    options: WatchedOptions,
  ): Promise<Found>;

  distances(options: DistancesOptions): Promise<Distances> {
    return this.analyse('distances', options);
  }

  sections(options: SectionsOptions): Promise<Sections> {
    return this.analyse('sections', options);
  }

  sectionsThrough(options: SectionsThroughOptions): Promise<Sections> {
    return this.analyse('sectionsThrough', options);
  }

  extremeSection(options: ExtremeSectionOptions): Promise<Section> {
    return this.analyse('extremeSection', options);
  }

  measureLandmarks(options: LandmarksOptions): Promise<NamedMeasures> {
    return this.analyse('measureLandmarks', options);
  }
}
