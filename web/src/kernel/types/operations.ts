// What workers are asked by the functions of their modules: each with its arguments, in the module's order, and what it
// gives. The messages, the workers' dispatch, the types of the modules and the calls that a mesh without a kernel refuses
// are made of these tables.

import type { Described } from '../wasm/girth-files.mjs';
import type {
  CommonOperations,
  FileContent,
  FoundRefined,
  GirthAndDiameter,
  OpenedSurface,
  PlacedStation,
  PrintArrays,
  RefinedRequest,
  SegmentRequest,
  SpectralRequest,
  StudyFields,
  SurfaceArrays,
  SurfaceWithInput,
  WrittenLoop,
  WrittenModel,
} from './protocol.js';
import type {
  Bottleneck,
  Cut,
  FileWithPath,
  GirthErrorFields,
  HandleRemoval,
  Handles,
  LevelCurve,
  LimbAxis,
  Limbs,
  Maximum,
  Mesh,
  MeshInfo,
  NamedField,
  Necks,
  PartOptions,
  Parts,
  PartThresholds,
  PathStation,
  PrepareOptions,
  PrintCheck,
  PrintLimits,
  Profile,
  Segments,
  SurfacePoint,
  Tips,
} from './types.js';

/** The page's numbers of surfaces, which a worker must have adopted. */
interface SurfaceNumbers {
  surface: number;
  remeshed: number;
  other: number;
}

const surfaceNames: readonly string[] = [
  'surface',
  'remeshed',
  'other',
] satisfies (keyof SurfaceNumbers)[];

/** Whether an argument is a surface, which messages name by its number. */
export const isSurface = (argument: string): argument is keyof SurfaceNumbers =>
  surfaceNames.includes(argument);

/** All arguments that are no surface. */
interface Inputs {
  basePoints: number;
  cap: boolean;
  content: FileContent;
  crossings: boolean;
  curves: readonly SurfacePoint[][];
  descriptors: readonly string[];
  division: SegmentRequest;
  even: boolean;
  faces: number;
  fields: GirthAndDiameter;
  format: string;
  from: SurfacePoint;
  girth: Float64Array;
  group: string;
  kinds: Uint8Array;
  length: number;
  level: number;
  limits: Required<PrintLimits>;
  loops: readonly WrittenLoop[];
  measured: readonly PathStation[];
  minima: boolean;
  minProminence: number;
  model: WrittenModel;
  models: readonly (readonly StudyFields[])[];
  named: readonly NamedField[];
  options: Required<PartOptions>;
  otherValues: Float64Array;
  points: readonly SurfacePoint[];
  printed: PrintArrays;
  profile: readonly PlacedStation[];
  request: RefinedRequest;
  samples: number;
  signature: SpectralRequest;
  smooth: number;
  stations: number;
  steps: number;
  to: SurfacePoint;
  values: Float64Array;
}

/** The last argument of what takes long. It receives the finished share. */
type OnProgress = (fraction: number) => void;

type ArgumentName = keyof SurfaceNumbers | keyof Inputs | 'onProgress';

/** The arguments of an operation, in their order; its type has what the operation gives. */
interface Operation<Names extends readonly ArgumentName[], Found> {
  takes: Names;
  readonly gives?: Found;
}

/** A table of operations. */
export type OperationTable = Readonly<Record<string, Operation<readonly ArgumentName[], unknown>>>;

const takes = <const Names extends readonly ArgumentName[]>(...names: Names) => ({
  gives: <Found extends object>(): Operation<Names, Found> => ({ takes: names }),
});

interface Made {
  described: Described;
}
interface OneFile {
  bytes: Uint8Array<ArrayBuffer>;
}
interface Files {
  files: Uint8Array<ArrayBuffer>[];
}

/** What is made of a surface, by the module for analysis: other surfaces. */
export const makingSurfaces = {
  remesh: takes('surface', 'faces', 'even', 'onProgress').gives<Made>(),
  smooth: takes('surface', 'steps', 'onProgress').gives<Made>(),
  removeHandles: takes('surface', 'length', 'basePoints', 'onProgress').gives<
    Made & { removal: HandleRemoval }
  >(),
};

/** What is found on a surface, by the same module. Each has a call of a mesh that has its name, as those above have. */
export const analysing = {
  difference: takes('surface', 'values', 'other', 'otherValues').gives<{ difference: number }>(),
  refinedGirth: takes('surface', 'request', 'onProgress').gives<FoundRefined>(),
  vertexAreas: takes('surface').gives<{ areas: Float64Array<ArrayBuffer> }>(),
  path: takes('surface', 'from', 'to').gives<{
    length: number;
    straight: number;
    polyline: Float32Array<ArrayBuffer>;
  }>(),
  tips: takes('surface', 'girth').gives<Tips>(),
  limbs: takes('surface', 'girth', 'stations', 'onProgress').gives<Limbs>(),
  necks: takes('surface', 'girth', 'minProminence', 'onProgress').gives<Necks>(),
  bottleneck: takes('surface', 'girth', 'from', 'to', 'onProgress').gives<Bottleneck>(),
  profile: takes('surface', 'points', 'samples', 'crossings', 'onProgress').gives<
    Omit<Profile, 'unit'>
  >(),
  axis: takes('surface', 'profile', 'onProgress').gives<Omit<LimbAxis, 'unit'>>(),
  handles: takes('surface', 'basePoints', 'onProgress').gives<Handles>(),
  levelCurves: takes('surface', 'values', 'level').gives<{ curves: LevelCurve[] }>(),
  cut: takes('surface', 'curves', 'cap').gives<Cut>(),
  segments: takes('surface', 'fields', 'division', 'onProgress').gives<Segments>(),
  suggestedThresholds: takes('surface', 'fields').gives<PartThresholds>(),
  parts: takes('surface', 'fields', 'options').gives<Parts>(),
  maxima: takes('surface', 'values', 'minima').gives<{ maxima: Maximum[] }>(),
  printCheck: takes('surface', 'printed', 'limits', 'onProgress').gives<PrintCheck>(),
};

/** What other calls of a mesh take of that module. */
export const serving = {
  carryBack: takes('surface', 'remeshed', 'values', 'kinds').gives<{
    values: Float64Array<ArrayBuffer>;
    kinds: Uint8Array<ArrayBuffer>;
  }>(),
  writeFields: takes('surface', 'model', 'named', 'format').gives<OneFile>(),
  writeLoops: takes('surface', 'model', 'points', 'format').gives<Files>(),
  writeCut: takes('surface', 'model', 'content', 'curves', 'cap', 'format').gives<Files>(),
  writeProfile: takes(
    ...(['surface', 'model', 'points', 'samples', 'crossings', 'format', 'onProgress'] as const),
  ).gives<OneFile>(),
  writeStations: takes('surface', 'model', 'measured', 'format').gives<OneFile>(),
  writeAxis: takes('surface', 'model', 'loops', 'format').gives<OneFile>(),
  writeSegments: takes(
    ...(['surface', 'model', 'content', 'fields', 'division', 'format', 'onProgress'] as const),
  ).gives<OneFile>(),
  writeTips: takes('surface', 'model', 'girth', 'format').gives<OneFile>(),
  writeLimbs: takes(
    'surface',
    'model',
    'girth',
    'stations',
    'format',
    'onProgress',
  ).gives<OneFile>(),
  writeParts: takes('surface', 'model', 'fields', 'options', 'format').gives<OneFile>(),
  writeWeakPlaces: takes(
    ...(['surface', 'model', 'content', 'printed', 'limits', 'format', 'onProgress'] as const),
  ).gives<OneFile>(),
};

/** What the module for studies computes: spectra, and comparisons of shapes. */
export const studying = {
  /** Keeps the spectrum for the next request on the same surface. */
  spectralField: takes('surface', 'signature', 'onProgress').gives<{
    values: Float64Array<ArrayBuffer>;
    method: string;
  }>(),
  /** Persistent maxima of the heat kernel signature. */
  heatMaxima: takes('surface', 'signature', 'onProgress').gives<{ maxima: Maximum[] }>(),
  /** The names of the groups of fields that descriptors need. */
  fieldGroups: takes('descriptors').gives<{ groups: string[] }>(),
  /** One group of fields. The surface is remeshed to about so many faces where it has more, and then smoothed. */
  studyFields: takes('surface', 'group', 'faces', 'smooth', 'onProgress').gives<StudyFields>(),
  /** For each descriptor the distances between all models, row by row. */
  compare: takes('models', 'descriptors', 'onProgress').gives<{
    matrices: Float64Array<ArrayBuffer>[];
  }>(),
};

/** Calls of a mesh that are operations of their names. */
export const analysisNames = Object.keys({
  ...makingSurfaces,
  ...analysing,
}) as (keyof Mesh & (keyof typeof makingSurfaces | keyof typeof analysing))[];

type GivenBy<O> = O extends { readonly gives?: infer Found extends object } ? Found : never;
type Everything = SurfaceNumbers & Inputs;

/** What a message with an operation has: all that it takes, by name. */
type Sent<O extends OperationTable[string]> = Pick<
  Everything,
  Extract<O['takes'][number], keyof Everything>
>;

type TakenBy<Name, Surface> = Name extends keyof Inputs
  ? Inputs[Name]
  : Name extends 'onProgress'
    ? OnProgress
    : Surface;

type AllTakenBy<Names extends readonly ArgumentName[], Surface> = {
  [I in keyof Names]: TakenBy<Names[I], Surface>;
};

/** The functions of a module that has a table's operations on surfaces of its own. */
export type FunctionsOf<T extends OperationTable, Surface> = {
  [K in keyof T]: (...args: AllTakenBy<T[K]['takes'], Surface>) => GivenBy<T[K]> | GirthErrorFields;
};

/** The messages of a table: arguments and answer of each operation. */
export type MessagesOf<T extends OperationTable> = {
  [K in keyof T]: [Sent<T[K]>, GivenBy<T[K]>];
};

/** Those of the table of surfaces that are made. `info` is that of the original. */
type MakingMessages = {
  [K in keyof typeof makingSurfaces]: [
    Sent<(typeof makingSurfaces)[K]> & { info: MeshInfo },
    { opened: OpenedSurface } & Omit<GivenBy<(typeof makingSurfaces)[K]>, 'described'>,
  ];
};

/** A worker for jobs: it reads models, and analyses, remeshes and writes surfaces. */
export interface JobOperations
  extends CommonOperations, MakingMessages, MessagesOf<typeof analysing & typeof serving> {
  /** Builds a surface and keeps it under this number. */
  adopt: [{ surface: number; arrays: SurfaceWithInput }, object];
  /** Reads the model of the path `model`, or the first one, and prepares its surface. */
  read: [
    { files: FileWithPath[]; address?: string; model?: string; prepare: PrepareOptions },
    OpenedSurface,
  ];
  /** Prepares the caller's arrays. */
  take: [{ arrays: SurfaceArrays; prepare: PrepareOptions }, OpenedSurface];
}

/** A worker for jobs with the module that computes spectra and compares shapes. */
export interface StudiesOperations extends CommonOperations, MessagesOf<typeof studying> {}
