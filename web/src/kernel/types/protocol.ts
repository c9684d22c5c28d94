// The messages between the page and its workers. The page sends requests, and each is answered once. While
// it computes, a worker may send reports. All content is copied or transferred, never shared, except the
// flag that cancels the threads.

import type { parameterPaths } from './fields.js';
import type {
  Field,
  GirthErrorFields,
  GirthStation,
  LoopKind,
  MeasuredLoop,
  MeshInfo,
  PartialField,
  PartOptions,
  PrintLimits,
  RefinedGirth,
  RefinedOptions,
  SegmentOptions,
  Segments,
  SpectralFieldName,
  SpectralOptions,
  SurfacePoint,
  Tips,
  VertexFieldName,
} from './types.js';

/** A surface's exact arrays: every worker that gets them makes the same surface, bit for bit. */
export interface SurfaceArrays {
  positions: Float64Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
}

/** The content of a model's file besides its surface, for the files of parts of it. */
export interface FileContent {
  /** Faces of the file. */
  faceCount: number;
  /** For each face of the surface that of the file; 0xFFFFFFFF for those that were made. */
  inputOfFace: Uint32Array<ArrayBuffer>;
  /** Colours and other values of vertices (`girth/io/attributes.h`): rows of so many numbers. */
  attributes: { name: string; width: number; isLinear: boolean }[];
  /** For each corner of the surface's faces its row; empty where there are no attributes. */
  rowOfCorner: Uint32Array<ArrayBuffer>;
  /** The rows. */
  values: Float64Array<ArrayBuffer>;
}

/** A surface that a worker has made, as the page receives it. */
export interface OpenedSurface {
  info: MeshInfo;
  arrays: SurfaceArrays;
  /** `drawn` and the points of loops and contours are relative to it. */
  origin: [number, number, number];
  /** The positions rounded to 32 bits, for drawing. */
  drawn: Float32Array<ArrayBuffer>;
  /** Two vertices for each edge of the boundary. */
  boundary: Uint32Array<ArrayBuffer>;
  vertexOfInput: Uint32Array<ArrayBuffer>;
  inputOfVertex: Uint32Array<ArrayBuffer>;
  content: FileContent;
}

/** A surface's arrays with the numbers that its vertices have in the input, for files in its order. */
export interface SurfaceWithInput extends SurfaceArrays {
  vertexOfInput: Uint32Array;
  inputOfVertex: Uint32Array;
}

/** Facts about a model that files state besides its surface and fields. */
export interface WrittenModel {
  name: string;
  /** By its name, for example 'metre'; or ''. */
  unit: string;
  /** The persistence of the girth by which a result was found. */
  persistence: number;
}

/**
 * A vertex field, with what its values depend on besides the surface: `FieldParameters`, each by its path. A parameter
 * that is left out has the default of C++.
 */
export type FieldRequest = { name: VertexFieldName | 'barcode' } & {
  [Path in (typeof parameterPaths)[number]]?: number | string | readonly SurfacePoint[] | undefined;
};

/** How a refined girth is computed. */
export type RefinedRequest = Required<Pick<RefinedOptions, 'coarseFaces' | 'audit' | 'seed'>>;

/** A refined girth as a worker finds it. */
export type FoundRefined = Pick<
  RefinedGirth,
  'values' | 'kinds' | 'states' | 'audit' | 'coarseFaces' | 'leanFaces' | 'note'
>;

/** One number of a signature. A number that is left out has the default of C++. */
export type SpectralRequest = { name: SpectralFieldName } & {
  [Option in keyof SpectralOptions]: number | undefined;
};

/** At which necks a surface is divided; thresholds that are missing are suggested ones. */
export type SegmentRequest = Pick<SegmentOptions, 'girth' | 'shapeDiameter'> &
  Required<Pick<SegmentOptions, 'minProminence' | 'smoothing'>>;

/** The two fields that parts are divided by, one value per vertex. */
export interface GirthAndDiameter {
  girth: Float64Array;
  diameter: Float64Array;
}

/** Values by which limits are checked, one per vertex; empty where a limit does not need them. */
export interface PrintArrays {
  girth: Float64Array;
  thickness: Float64Array;
}

/** A loop as a worker finds it. */
export interface FoundLoop extends Omit<MeasuredLoop, 'points'> {
  /** Packed: `unpackedPoints`. */
  points: Float64Array;
}

/** A barcode as a worker finds it. */
export interface FoundBarcode {
  /** Births and deaths in turn. */
  bars: Float64Array<ArrayBuffer>;
  /** The loop of each bar, where loops were asked for. */
  loops: FoundLoop[];
  rest: number;
  restKind: LoopKind;
}

/** Finished values, of barcodes with their bars. */
export interface FinishedValues extends PartialField {
  /** How many bars each has. */
  counts?: Uint32Array;
  /** Births and deaths in turn. */
  bars?: Float64Array;
}

/** Values of some vertices, in the order of the request. */
export interface Values extends Omit<FinishedValues, 'vertices'> {
  values: Float64Array<ArrayBuffer>;
  /** The kind of each value of the girth. Empty for other fields. */
  kinds: Uint8Array<ArrayBuffer>;
  /** Milliseconds that the worker took. */
  milliseconds: number;
}

/** One byte of shared memory: 1 stops the field that the threads are computing. */
export interface CancelFlag {
  buffer: SharedArrayBuffer;
  byteOffset: number;
}

/**
 * The operations of every worker: for each its arguments and its answer. `surface` and `remeshed` are the
 * page's numbers of surfaces, which the worker must have adopted.
 */
export interface CommonOperations {
  /** Loads the module. Must be the first request. */
  start: [{ threads: number }, { cancelFlag?: CancelFlag }];
  /** Builds a surface and keeps it under this number. */
  adopt: [{ surface: number; arrays: SurfaceArrays }, object];
  /** Frees a surface. An unknown number is no error. */
  drop: [{ surface: number }, object];
}

/** A worker that computes with the module without threads. */
export interface SingleOperations extends CommonOperations {
  /** All vertices, coarse to fine. */
  order: [{ surface: number }, { order: Uint32Array<ArrayBuffer> }];
  /** A field at some vertices. */
  values: [{ surface: number; field: FieldRequest; vertices: Uint32Array<ArrayBuffer> }, Values];
  /** Method and note of a field, of which so many vertices have no value. */
  about: [
    { surface: number; field: FieldRequest; withoutValue: number },
    Pick<Field, 'method' | 'note'>,
  ];
  /** The loop at a point. */
  loop: [{ surface: number; point: SurfacePoint; persistence: number }, FoundLoop];
  /** The saddles of the distance from a point. */
  barcode: [
    {
      surface: number;
      point: SurfacePoint;
      maxPersistence: number;
      maxSaddles: number;
      loops: boolean;
    },
    FoundBarcode,
  ];
}

/** The members of a limb's stations that an axis needs. */
export type PlacedStation = Pick<GirthStation, 'distance' | 'least' | 'place'>;

/** Tips as a worker finds them. */
export interface FoundTips extends Tips {
  /** The exact points of their lines, packed, in their order: contours first, then arcs. */
  linePoints: Float64Array<ArrayBuffer>;
}

/** Segments as a worker finds them. */
export interface FoundSegments extends Segments {
  /** Tips, necks and kinds that their files need, so that nothing is searched for again. */
  by: object;
}

/** Data besides the result that its file states or is written by. */
export interface FoundBesides {
  /** The persistence of the girth that it was found by. Default: 0. */
  persistence?: number | undefined;
  /** For tips: {@link FoundTips.linePoints}. */
  linePoints?: Float64Array;
  /** For parts: the thresholds that they were divided by. */
  options?: Required<PartOptions>;
  /** For a print check: its limits. */
  limits?: Required<PrintLimits>;
  /** For segments: {@link FoundSegments.by}. */
  by?: object;
}

/** A result to be written. */
export interface WrittenFound extends FoundBesides {
  kind: string;
  result: object;
  /** CSV of limbs has a row for each station. */
  profiles: boolean;
  /** Where files have faces by their numbers in the model's file. */
  content?: FileContent;
}

/** Fields that shapes are compared by (`study_fields.h`). */
export interface StudyFields {
  /** Weight of each vertex: its share of the area. */
  weights: Float64Array<ArrayBuffer>;
  /** `dimensions` numbers per vertex. */
  fields: { name: string; dimensions: number; values: Float64Array<ArrayBuffer> }[];
}

/** The worker that hosts the module with threads. */
export interface ThreadsOperations extends CommonOperations {
  /**
   * A field at all vertices but those with a 1 in `known`; empty: none is known. Reports each value once; answers
   * early when the flag is set.
   */
  field: [
    { surface: number; field: FieldRequest; known: Uint8Array; threads: number },
    { complete: boolean },
  ];
  /** Fails with CANCELLED when the flag is set. */
  refinedGirth: [{ surface: number; request: RefinedRequest; threads: number }, FoundRefined];
}

/** The arguments of an operation of one of the tables above. */
export type Arguments<T, K extends keyof T> = T[K] extends [infer A extends object, object]
  ? A
  : never;
/** The answer of an operation. */
export type Answer<T, K extends keyof T> = T[K] extends [object, infer R extends object]
  ? R
  : never;

/** The arrays that a worker is given of a surface. */
export type AdoptedArrays<T> = T extends {
  adopt: [{ arrays: infer A extends SurfaceArrays }, object];
}
  ? A
  : never;

/** Page to worker. `id` counts from 1. */
export interface Request {
  id: number;
  operation: string;
  arguments: object;
}

/** A worker's report on its present request. */
export type Report = { partial: FinishedValues } | { progress: number };

/** Worker to page. After a `fatal` error the worker must be ended. */
export type Reply =
  | { id: number; report: Report }
  | { id: number; answer: object }
  | { id: number; error: GirthErrorFields; fatal: boolean };
