// Made of cpp/include/girth/fields.def by `npm run build:tables`: not to be edited.

import type { SurfacePoint } from './points.js';

/**
 * Fields that are computed vertex by vertex.
 *
 * - `'igf'`: the length of the shortest loop round the surface, like a rubber band that holds tight; in model units.
 * - `'sdf'`: how thick the shape is on average, measured through its inside; in model units.
 * - `'thickness'`: the width of the largest ball inside that touches the surface there; in model units.
 * - `'geoaverage'`: the mean distance to all other places, along the surface; in model units.
 * - `'geofarthest'`: the distance to the farthest place, along the surface; in model units.
 * - `'angle'`: the angle at which the shortest loop meets itself; in radians.
 * - `'distance'`: the distance to the nearest of some points, along the surface; in model units.
 */
export type VertexFieldName =
  | 'igf'
  | 'sdf'
  | 'thickness'
  | 'geoaverage'
  | 'geofarthest'
  | 'angle'
  | 'distance';

/**
 * Fields that are computed from the surface's spectrum. They come all at once, without partial values. Each value is one
 * number of the vertex's signature.
 *
 * - `'hks'`: how much heat stays in a place; in 1 / squared model units.
 * - `'wks'`: how likely a wave of this energy is met in a place; in 1 / squared model units.
 * - `'sihks'`: how heat leaves a place, whatever the size of the shape; without a unit.
 */
export type SpectralFieldName = 'hks' | 'wks' | 'sihks';

/** All fields that the kernel computes. */
export type FieldName = VertexFieldName | SpectralFieldName;

/** Which rays are sent. */
export interface ShapeDiameterOptions {
  /** Rays sent from each vertex, 1 to 10,000. Default: 30. */
  rays?: number;
  /**
   * The full opening of the cone of rays, in radians, in (0, π). Default: 2.0943951023931953, 120°.
   */
  coneRadians?: number;
}

/** Options of the thickness: which faces count as facing a point. */
export interface ThicknessOptions {
  /**
   * In radians, in (0, π/2). Where two faces meet at a sharper angle, measured within the body, they
   * face each other, and the thickness falls to 0 at their edge. Faces that lie at a blunter angle to
   * each other do not: a cube is as thick at its edges as in the middle. Every convex body has faces
   * that meet at 70.6° or less, if they meet. Default: 1.3089969389957472, 75°.
   */
  sharpRadians?: number;
}

/** The points that distances are measured from, and how far. */
export interface DistanceFieldOptions {
  /**
   * Where distances are measured from: each is that from the nearest of these points. Default: the first
   * vertex.
   */
  from?: readonly SurfacePoint[];
  /**
   * Vertices farther away than this, in model units, have an infinite distance. Default: Infinity.
   */
  radius?: number;
}

/** Parameters of single fields. Each field reads its own. */
export interface FieldParameters {
  /**
   * Tau of 'igf' and 'angle', in model units, at least 0 and finite. Loops whose saddles last no longer
   * are passed over, as noise makes them (girth/barcode.h). Default: 0.
   */
  persistence?: number;
  /** How 'geoaverage' and 'geofarthest' measure distances. Default: 'fast-marching'. */
  distances?: 'fast-marching' | 'exact';
  /** Options of 'sdf'. */
  sdf?: ShapeDiameterOptions;
  /** Options of 'thickness'. */
  thickness?: ThicknessOptions;
  /** Options of 'distance'. */
  distance?: DistanceFieldOptions;
}

/** Where these are in `FieldParameters`. */
export const parameterPaths = [
  'persistence',
  'sdf.rays',
  'sdf.coneRadians',
  'thickness.sharpRadians',
  'distances',
  'distance.from',
  'distance.radius',
] as const;

/** The kind of unit of each field. */
export const fieldUnits: Readonly<Record<FieldName, 'Length' | 'Radian' | 'PerArea' | 'Number'>> = {
  igf: 'Length',
  sdf: 'Length',
  thickness: 'Length',
  geoaverage: 'Length',
  geofarthest: 'Length',
  angle: 'Radian',
  distance: 'Length',
  hks: 'PerArea',
  wks: 'PerArea',
  sihks: 'Number',
};

/** Names in words, for a legend. */
export const fieldTitles: Readonly<Record<FieldName, string>> = {
  igf: 'Girth',
  sdf: 'Shape diameter',
  thickness: 'Thickness',
  geoaverage: 'Mean distance',
  geofarthest: 'Greatest distance',
  angle: 'Angle of the loop',
  distance: 'Distance',
  hks: 'Heat kernel signature',
  wks: 'Wave kernel signature',
  sihks: 'Scale-invariant heat kernel',
};

/** Names in a list, with what papers call them. */
export const fieldListTitles: Readonly<Record<FieldName, string>> = {
  igf: 'Girth (IGF)',
  sdf: 'Shape diameter (SDF)',
  thickness: 'Thickness (balls)',
  geoaverage: 'GeoAverage (mean)',
  geofarthest: 'GeoFarthest (largest)',
  angle: 'Angle of the loop',
  distance: 'Distance from points',
  hks: 'Heat kernel (HKS)',
  wks: 'Wave kernel (WKS)',
  sihks: 'SIHKS (scale-free)',
};

/** The meaning of a value, as the middle of a sentence. */
export const fieldMeanings: Readonly<Record<FieldName, string>> = {
  igf: 'the length of the shortest loop round the surface, like a rubber band that holds tight',
  sdf: 'how thick the shape is on average, measured through its inside',
  thickness: 'the width of the largest ball inside that touches the surface there',
  geoaverage: 'the mean distance to all other places, along the surface',
  geofarthest: 'the distance to the farthest place, along the surface',
  angle: 'the angle at which the shortest loop meets itself',
  distance: 'the distance to the nearest of some points, along the surface',
  hks: 'how much heat stays in a place',
  wks: 'how likely a wave of this energy is met in a place',
  sihks: 'how heat leaves a place, whatever the size of the shape',
};

/** Fields that the small module has where their persistence is 0. */
export const girthModuleFields: readonly string[] = ['igf', 'angle'];

/** Fields that depend on how long saddles must last. */
export const persistentFields: readonly FieldName[] = ['igf', 'angle'];

/** The time of heat by default, as a share of the area. */
export const usualTime = 0.002;

/** The numbers of a signature, of which a field is one. */
export interface SignatureNumbers {
  /** How many there are. */
  readonly count: number;
  /** Which one is taken by default, counted from 1. */
  readonly usual: number;
}

/** The numbers of each signature. */
export const signatureNumbers: Readonly<Record<SpectralFieldName, SignatureNumbers>> = {
  hks: { count: 1, usual: 1 },
  wks: { count: 100, usual: 20 },
  sihks: { count: 19, usual: 1 },
};
