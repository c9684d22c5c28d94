// How the tables beside this file are written: what workers are asked by the functions of their modules, each with its
// arguments, in the module's order, and what it gives. The messages, the workers' dispatch, the types of the modules and the
// calls that a mesh without a kernel refuses are made of them.

import type {
  FileContent,
  GirthAndDiameter,
  PlacedStation,
  PrintArrays,
  RefinedRequest,
  SegmentRequest,
  SpectralRequest,
  StudyFields,
  WrittenFound,
  WrittenModel,
} from '../protocol.js';
import type {
  GirthErrorFields,
  NamedField,
  PartOptions,
  PrintLimits,
  SurfacePoint,
} from '../types.js';

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
  analysis: string;
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
  found: WrittenFound;
  from: SurfacePoint;
  girth: Float64Array;
  group: string;
  kinds: Uint8Array;
  length: number;
  level: number;
  limits: Required<PrintLimits>;
  minima: boolean;
  minProminence: number;
  model: WrittenModel;
  models: readonly (readonly StudyFields[])[];
  named: readonly NamedField[];
  normal: Float64Array;
  offsets: Float64Array;
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
  wanted: object;
}

/** The last argument of what takes long. It receives the finished share. */
type OnProgress = (fraction: number) => void;

type ArgumentName = keyof SurfaceNumbers | keyof Inputs | 'onProgress';

/** The arguments of an operation, in their order; its type has what the operation gives. */
export interface Operation<Names extends readonly ArgumentName[], Found> {
  takes: Names;
  readonly gives?: Found;
}

/** A table of operations. */
export type OperationTable = Readonly<Record<string, Operation<readonly ArgumentName[], unknown>>>;

/** A row of a table: names what an operation takes; then `gives` states what it gives. */
export const takes = <const Names extends readonly ArgumentName[]>(...names: Names) => ({
  gives: <Found extends object>(): Operation<Names, Found> => ({ takes: names }),
});

/** The result of an operation. */
export type GivenBy<O> = O extends { readonly gives?: infer Found extends object } ? Found : never;
type Everything = SurfaceNumbers & Inputs;

/** The content of an operation's message: all that it takes, by name. */
export type Sent<O extends OperationTable[string]> = Pick<
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
