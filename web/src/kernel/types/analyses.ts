// Made of cpp/include/girth/analyses.def by `npm run build:tables`: not to be edited.

import type { WatchedOptions } from './call-options.js';
import type { SurfacePoint } from './points.js';
import type {
  Distances,
  Sections,
  Section,
  NamedMeasures,
  TightCurve,
  Tubes,
  MeasureKind,
} from './results.js';

/**
 * Where a surface has the most or the least of a measure.
 *
 * - `'widest'`: most
 * - `'narrowest'`: least, of planes that meet the surface
 */
export type SectionExtreme = 'widest' | 'narrowest';

/**
 * A measure of a section.
 *
 * - `'perimeter'`: the sum of the curves' lengths
 * - `'tape'`: one tape round all curves
 */
export type SectionMeasure = 'perimeter' | 'tape';

/**
 * The diameter that a narrowing or widening is compared with.
 *
 * - `'taper'`: the diameter between both sides, in proportion to the distances
 * - `'mean'`: the mean diameter of both sides
 * - `'beyond'`: the diameter of the side that is farther along
 * - `'before'`: the diameter of the side that is less far along
 */
export type TubeReference = 'taper' | 'mean' | 'beyond' | 'before';

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

/** A point, and what is measured there. */
export interface Landmark {
  /** The name of the measure. */
  name: string;
  /** Where it is measured, or begins. */
  point: SurfacePoint;
  /** How it is measured. */
  how: MeasureKind;
  /** The other end of a distance. */
  to?: SurfacePoint;
  /**
   * Whether the plane of a section or tape is perpendicular to the limb or tube at the point. Default:
   * false.
   */
  across?: boolean;
  /**
   * Whether a section or tape takes all curves of its plane, not the one through the point. Default:
   * false.
   */
  all?: boolean;
}

/** Which measures are wanted. */
export interface LandmarksOptions extends WatchedOptions {
  /** The landmarks: one for each measure. */
  landmarks: readonly Landmark[];
  /** The normal of planes that are not across limbs, of any length but 0. Default: [0, 0, 1]. */
  normal?: readonly [number, number, number];
}

/** Which planes cut a surface. */
export interface SectionsOptions extends WatchedOptions {
  /** The planes' normal, of any length but 0. */
  normal: readonly [number, number, number];
  /** Where each plane lies: normal · x in model units, where the normal has length 1. */
  offsets: readonly number[] | Float64Array;
  /** Whether each curve has its largest inscribed circle, which takes longer. Default: false. */
  inscribed?: boolean;
}

/** Which planes pass points of a surface. */
export interface SectionsThroughOptions extends WatchedOptions {
  /** The points: one for each plane. */
  points: readonly SurfacePoint[];
  /** The planes' normal, of any length but 0. Default: [0, 0, 1]. */
  normal?: readonly [number, number, number];
  /**
   * Whether each plane is perpendicular to the limb or tube at its point, instead of the normal.
   * Default: false.
   */
  across?: boolean;
  /** Whether each curve has its largest inscribed circle, which takes longer. Default: false. */
  inscribed?: boolean;
}

/** Which section is the widest or the narrowest. */
export interface ExtremeSectionOptions extends WatchedOptions {
  /** The planes' normal, of any length but 0. */
  normal: readonly [number, number, number];
  /** Which of the two is looked for. */
  extreme: SectionExtreme;
  /** The least offset of a plane, in model units. Default: -Infinity. */
  low?: number;
  /** The greatest one, in model units. Default: Infinity. */
  high?: number;
  /** The measure that is compared. Default: 'perimeter'. */
  measure?: SectionMeasure;
  /** Whether each curve has its largest inscribed circle, which takes longer. Default: false. */
  inscribed?: boolean;
}

/** Which curve is drawn tight. */
export interface TightenOptions extends WatchedOptions {
  /**
   * The curve, point by point. Neighbours that lie in one face are joined straight, others by a shortest
   * path.
   */
  points: readonly SurfacePoint[];
  /**
   * Whether it goes on from the last point to the first, and no point stays. Otherwise both ends stay,
   * also where they are one point. Default: false.
   */
  closed?: boolean;
  /**
   * Whether all its points stay: each piece between two is drawn tight by itself. Default: false.
   */
  fixed?: boolean;
}

/** How tubes are measured. */
export interface TubesOptions extends WatchedOptions {
  /**
   * Points at the ends: the vertex nearest to each lies on a boundary curve, or where a tube ends
   * closed; the first one of a component is where its centrelines begin. Where a component has fewer
   * than two, the others are found: boundary curves, but for holes shorter than a tenth of the longest,
   * and the places that are farthest away, where a closed branch is longer than a tenth of the whole.
   * Default: [].
   */
  ends?: readonly SurfacePoint[];
  /**
   * The distance of stations, in model units. 0: an eighth of the median diameter, but at most 1,000
   * stations a branch. Default: 0.
   */
  spacing?: number;
  /**
   * The least degree, by diameter, of narrowings and widenings that are listed, above 0. Default: 0.1.
   */
  leastDegree?: number;
  /** The diameter that each is compared with. Default: 'taper'. */
  reference?: TubeReference;
  /** Whether the exact girth is measured too, which takes longer. Default: true. */
  girth?: boolean;
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
  /**
   * Cuts a surface with planes of one normal, at several offsets, and measures the curves. *Planes
   * through vertices.* A vertex that lies in the plane (nearer to it than 1e-12 of the greatest
   * coordinate) counts as lying above it, on the side of the normal. So every curve runs through edges
   * that lead from below to above, curves never end inside the surface, and where the plane touches it
   * from above there is none. A face in the plane is part of the section by its outline, where the
   * surface goes on below it. *Holes* are found by the surface's orientation: a closed curve is a hole
   * where the enclosed side lies round it and another curve of the section lies round that. Curves of
   * bodies that overlap are measured one by one. On polyhedra the measures are exact to rounding.
   * Inscribed circles are the largest to 1e-12 of their diameter, proven by branch and bound; where that
   * takes more than 100,000 squares, as of curves 10,000 times as long as wide, the largest found. Time:
   * O(n log m + c log c) for n faces, m planes and c crossed edges, without the circles, on all threads;
   * the same result for any number of them. Errors: INVALID_OPTION (a normal without length, an offset
   * that is not finite), CANCELLED.
   *
   * @experimental
   */
  sections(options: SectionsOptions): Promise<Sections>;
  /**
   * Cuts a surface with a plane through each of some points. Errors: those of `findSections` and, across
   * limbs, of `directionAlong`; VERTEX_OUT_OF_RANGE, INVALID_POINT.
   *
   * @experimental
   */
  sectionsThrough(options: SectionsThroughOptions): Promise<Sections>;
  /**
   * Finds the section in which a measure is greatest or least, of all planes of one normal in a range of
   * offsets. Between the heights of two vertices the perimeter is linear in the offset, and the tape
   * convex: the greatest, and the least perimeter, are at such a height, just above one (by 2e-12 of the
   * greatest coordinate), or at an end of the range; the least tape is found between them, by parabolas
   * and golden sections (Brent 1973). Among equal ones, it is the lowest. Time: O(c log c) for the edges
   * that planes at all heights of vertices cross, on all threads; the same result for any number of
   * them. Errors: INVALID_OPTION (a normal without length, no range, or no plane of it that meets the
   * surface), CANCELLED.
   *
   * @experimental
   */
  extremeSection(options: ExtremeSectionOptions): Promise<Section>;
  /**
   * Measures at landmarks of a surface. Errors: those of the measures, with the name of the landmark
   * before the message; INVALID_OPTION (a normal without length), CANCELLED.
   *
   * @experimental
   */
  measureLandmarks(options: LandmarksOptions): Promise<NamedMeasures>;
  /**
   * Draws a curve tight: it is moved over the surface and only gets shorter, until it is straight in all
   * faces and across all edges, and has at least π on both sides of each vertex that it passes, on the
   * inner side alone at a boundary (Xin, He and Fu 2012). It stays in its homotopy class. No curve of
   * the class is shorter where the component has no convex vertex but at its boundary, where an open
   * curve is as long as the distance of its ends, or where it contracts; elsewhere none is that it can
   * be moved to without passing over a convex vertex. A closed curve with equally long ones beside it
   * stays among them. Lengths are exact to rounding; an angle that lacks 1e-8 of π counts as straight,
   * and a point with a share below 1e-10 lies on the edge or at the vertex beside it. Time: linear in
   * the curve for each vertex that it is moved over, and a shortest path between ends. Errors:
   * INVALID_OPTION (no points); VERTEX_OUT_OF_RANGE; INVALID_POINT (also of a curve over several
   * components); LIMIT_EXCEEDED where a shortest path takes too many windows; CANCELLED.
   *
   * @experimental
   */
  tighten(options: TightenOptions): Promise<TightCurve>;
  /**
   * Finds the centrelines of tubes, and measures what lies along them. The surface is divided into
   * branches by a harmonic function from one end to the others. The line through the middles of its
   * level curves is then moved until each of its points is the centroid of the section perpendicular to
   * it. Stations whose section is open, or runs over another branch, are left out. Sections are exact on
   * the surface; the line is exact where it is straight or a circle, to the square of the spacing. Where
   * a tube ends closed, the line goes on as it bends before. Time: O(n) for each station and step, on
   * all threads, and one loop for each station; the same result for any number of threads. Errors:
   * VERTEX_OUT_OF_RANGE; INVALID_POINT; INVALID_OPTION (a spacing or degree that is negative or not
   * finite, one that makes more than 100,000 stations); LIMIT_EXCEEDED; CANCELLED.
   *
   * @experimental
   */
  tubes(options: TubesOptions): Promise<Tubes>;
}

/** The results of analyses. */
export type FoundByAnalysis = Distances | Sections | Section | NamedMeasures | TightCurve | Tubes;

/** The analyses: the list that only their results have, by the names of analyses. */
export const analysisLists: Readonly<Record<keyof Analyses, string>> = {
  distances: 'distances',
  sections: 'sections',
  sectionsThrough: 'sections',
  extremeSection: 'curves',
  measureLandmarks: 'measures',
  tighten: 'pieces',
  tubes: 'branches',
};
