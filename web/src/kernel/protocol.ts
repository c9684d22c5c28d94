// What page and workers say to each other. The page asks and each request is answered once; while it
// computes, a worker may report. All content is copied or transferred, never shared, with one
// exception: the flag that cancels the threads.

import type {
  Field,
  FieldFormat,
  FileWithPath,
  GirthErrorFields,
  Loop,
  LoopFormat,
  Maximum,
  MeshInfo,
  NamedField,
  PartialField,
  PartOptions,
  Parts,
  PartThresholds,
  PrepareOptions,
  PrintLimits,
  SpectralFieldName,
  SpectralOptions,
  SurfacePoint,
  Tips,
  VertexFieldName,
  WeakPlace,
} from './types.js';

/** A surface's exact arrays: every worker that gets them makes the same surface, bit for bit. */
export interface SurfaceArrays {
  positions: Float64Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
}

/** A surface that a worker has made, with what the page needs of it. */
export interface OpenedSurface {
  info: MeshInfo;
  arrays: SurfaceArrays;
  /** What `drawn` and the points of loops and contours count from. */
  origin: [number, number, number];
  /** The positions once more, for drawing. */
  drawn: Float32Array<ArrayBuffer>;
  /** Two vertices for each edge of the boundary. */
  boundary: Uint32Array<ArrayBuffer>;
  vertexOfInput: Uint32Array<ArrayBuffer>;
  inputOfVertex: Uint32Array<ArrayBuffer>;
}

/** A surface's arrays with the numbers that its vertices have in the input, for files in its order. */
export interface SurfaceWithInput extends SurfaceArrays {
  vertexOfInput: Uint32Array;
  inputOfVertex: Uint32Array;
}

/** What files state of a model besides its surface and fields. */
export interface WrittenModel {
  name: string;
  /** By its name, for example 'metre'; or ''. */
  unit: string;
}

/** A field with everything that it depends on besides the surface. */
export interface FieldRequest {
  name: VertexFieldName;
  /** Of 'sdf'. */
  coneAngle: number;
  rays: number;
  /** Of 'geoaverage' and 'geofarthest'. */
  distances: 'fast-marching' | 'exact';
}

/** One number of a signature made of the surface's vibrations. */
export interface SpectralRequest extends Required<SpectralOptions> {
  name: SpectralFieldName;
}

/** The two fields that tell parts, one value for each vertex. */
export interface GirthAndDiameter {
  girth: Float64Array;
  diameter: Float64Array;
}

/** Values of some vertices, in the order in which they were asked for. */
export interface Values {
  values: Float64Array<ArrayBuffer>;
  /** Empty but for the girth. */
  kinds: Uint8Array<ArrayBuffer>;
  /** How long the worker took, in milliseconds. */
  milliseconds: number;
}

/** One byte of shared memory: 1 stops the field that the threads are computing. */
export interface CancelFlag {
  buffer: SharedArrayBuffer;
  byteOffset: number;
}

/** What every worker can be asked: its arguments and its answer. `surface` is the page's number. */
export interface CommonOperations {
  /** Loads the module; must be the first request. */
  start: [{ threads: number }, { cancelFlag?: CancelFlag }];
  /** Makes a surface of the arrays of another worker. */
  adopt: [{ surface: number; arrays: SurfaceArrays }, object];
  /** Frees a surface; an unknown one is no error. */
  drop: [{ surface: number }, object];
}

/** A worker that computes with the module without threads. */
export interface SingleOperations extends CommonOperations {
  order: [{ surface: number }, { order: Uint32Array<ArrayBuffer> }];
  values: [{ surface: number; field: FieldRequest; vertices: Uint32Array<ArrayBuffer> }, Values];
  /** What is to be said of a field, of which so many vertices have no value. */
  about: [
    { surface: number; field: FieldRequest; withoutValue: number },
    Pick<Field, 'method' | 'note'>,
  ];
  loop: [{ surface: number; point: SurfacePoint }, Omit<Loop, 'base' | 'unit'>];
}

/** A worker that makes surfaces and files; it is ended where its work is no longer wanted. */
export interface JobOperations extends CommonOperations {
  /** Reads the model of the path `model`, or the first one, and prepares its surface. */
  read: [
    { files: FileWithPath[]; address?: string; model?: string; prepare: PrepareOptions },
    OpenedSurface,
  ];
  /** Prepares a surface of the caller's arrays. */
  take: [{ arrays: SurfaceArrays; prepare: PrepareOptions }, OpenedSurface];
  /** Makes a surface of the arrays of another worker. */
  adopt: [{ surface: number; arrays: SurfaceWithInput }, object];
  /** A surface of about so many faces. */
  remesh: [{ surface: number; faces: number; info: MeshInfo }, OpenedSurface];
  /** Values at the vertices of the surface `remeshed` as values at those of `surface`. */
  carryBack: [
    { surface: number; remeshed: number; values: Float64Array },
    { values: Float64Array<ArrayBuffer> },
  ];
  /** The difference of two fields, each on its surface. */
  difference: [
    { surface: number; values: Float64Array; other: number; otherValues: Float64Array },
    { difference: number },
  ];
  vertexAreas: [{ surface: number }, { areas: Float64Array<ArrayBuffer> }];
  tips: [{ surface: number; girth: Float64Array }, Tips];
  thresholds: [{ surface: number; fields: GirthAndDiameter }, PartThresholds];
  parts: [{ surface: number; fields: GirthAndDiameter; options: Required<PartOptions> }, Parts];
  /** The maxima of values; of their negatives where `minima` are wanted. */
  maxima: [{ surface: number; values: Float64Array; minima: boolean }, { maxima: Maximum[] }];
  weakPlaces: [
    { surface: number; fields: GirthAndDiameter; limits: PrintLimits },
    { places: WeakPlace[] },
  ];
  writeFields: [
    { surface: number; model: WrittenModel; fields: readonly NamedField[]; format: FieldFormat },
    { bytes: Uint8Array<ArrayBuffer> },
  ];
  writeTips: [
    { surface: number; model: WrittenModel; girth: Float64Array; format: string },
    { bytes: Uint8Array<ArrayBuffer> },
  ];
  writeParts: [
    {
      surface: number;
      model: WrittenModel;
      fields: GirthAndDiameter;
      options: Required<PartOptions>;
      format: string;
    },
    { bytes: Uint8Array<ArrayBuffer> },
  ];
  writeWeakPlaces: [
    {
      surface: number;
      model: WrittenModel;
      fields: GirthAndDiameter;
      limits: PrintLimits;
      format: string;
    },
    { bytes: Uint8Array<ArrayBuffer> },
  ];
  writeLoops: [
    {
      surface: number;
      model: WrittenModel;
      points: readonly SurfacePoint[];
      format: LoopFormat;
    },
    { files: Uint8Array<ArrayBuffer>[] },
  ];
}

/** Fields that shapes are compared by, and the weight of each vertex (`study_fields.h`). */
export interface StudyFields {
  weights: Float64Array<ArrayBuffer>;
  /** `dimensions` numbers for each vertex. */
  fields: { name: string; dimensions: number; values: Float64Array<ArrayBuffer> }[];
}

/**
 * A worker with the module that knows spectra and compares shapes; it is ended where its work is no
 * longer wanted.
 */
export interface StudiesOperations extends CommonOperations {
  /** Keeps the spectrum for the next request about the same surface. */
  spectralField: [
    { surface: number; field: SpectralRequest },
    { values: Float64Array<ArrayBuffer>; method: string },
  ];
  heatMaxima: [{ surface: number; field: SpectralRequest }, { maxima: Maximum[] }];
  /** The groups of fields that descriptors need. */
  fieldGroups: [{ descriptors: readonly string[] }, { groups: string[] }];
  /** One group of a surface, made anew of about so many faces where it has more. */
  studyFields: [{ surface: number; group: string; faces: number }, StudyFields];
  /** For each descriptor the distances between all models, row after row. */
  compare: [
    { models: readonly (readonly StudyFields[])[]; descriptors: readonly string[] },
    { matrices: Float64Array<ArrayBuffer>[] },
  ];
}

/** The worker that hosts the module with threads. */
export interface ThreadsOperations extends CommonOperations {
  /** Reports all values while it runs, each once; answers early once the flag is set. */
  field: [{ surface: number; field: FieldRequest; threads: number }, { complete: boolean }];
}

/** The arguments and the answer of an operation of a table like those above. */
export type Arguments<T, K extends keyof T> = T[K] extends [infer A extends object, object]
  ? A
  : never;
export type Answer<T, K extends keyof T> = T[K] extends [object, infer R extends object]
  ? R
  : never;

/** The arrays that a worker is given of a surface. */
export type AdoptedArrays<T> = T extends {
  adopt: [{ arrays: infer A extends SurfaceArrays }, object];
}
  ? A
  : never;

/** Page to worker. `id` counts up from 1. */
export interface Request {
  id: number;
  operation: string;
  arguments: object;
}

/** A worker's report on the request that it is working on. */
export type Report = { partial: PartialField } | { progress: number };

/** Worker to page. After a `fatal` error the worker is of no more use. */
export type Reply =
  | { id: number; report: Report }
  | { id: number; answer: object }
  | { id: number; error: GirthErrorFields; fatal: boolean };
