// The WebAssembly modules as `cpp/bind` makes them; the build writes them into the folder `wasm`.

/* oxlint-disable typescript/consistent-type-imports --
   an ambient module has no other way to name the types beside it */

/** A failure, which functions return instead of their result. */
interface Failed {
  code: string;
  element: number;
  message: string;
  hint: string;
}

declare module '*/girth.mjs' {
  type Point = import('../types/types.js').SurfacePoint;

  /** A surface with the fields 'igf' and 'angle', without persistence. */
  export interface Surface {
    /** The arrays that it was made from. */
    arrays(): { positions: Float64Array; indices: Uint32Array } | Failed;
    values(
      field: import('../types/protocol.js').FieldRequest,
      vertices: Uint32Array,
    ): Omit<import('../types/protocol.js').Values, 'milliseconds'> | Failed;
    about(
      field: import('../types/protocol.js').FieldRequest,
      withoutValue: number,
    ): { method: string; note: string } | Failed;
    loop(point: Point): import('../types/protocol.js').FoundLoop | Failed;
    order(): Uint32Array<ArrayBuffer> | Failed;
    delete(): void;
  }

  export interface GirthModule {
    /** The surface of a prepared surface's arrays. */
    exactSurface(positions: Float64Array, indices: Uint32Array): { surface: Surface } | Failed;
  }

  export default function createModule(): Promise<GirthModule>;
}

declare module '*/girth-fields.mjs' {
  type Point = import('../types/types.js').SurfacePoint;

  type PlainSurface = import('../wasm/girth.mjs').Surface;

  /** It has all fields. */
  export interface FieldsSurface extends PlainSurface {
    persistentLoop(
      point: Point,
      persistence: number,
    ): import('../types/protocol.js').FoundLoop | Failed;
    barcode(
      point: Point,
      maxPersistence: number,
      maxSaddles: number,
      withLoops: boolean,
    ): import('../types/protocol.js').FoundBarcode | Failed;
  }

  export interface FieldsModule {
    /** The surface of a prepared surface's arrays. */
    exactSurface(
      positions: Float64Array,
      indices: Uint32Array,
    ): { surface: FieldsSurface } | Failed;
  }

  export default function createModule(): Promise<FieldsModule>;
}

declare module '*/girth-files.mjs' {
  /** A prepared surface as arrays, with a report of what was done to its input. */
  export interface Prepared extends Described {
    vertexOfInput: Uint32Array<ArrayBuffer>;
    inputOfVertex: Uint32Array<ArrayBuffer>;
    content: import('../types/protocol.js').FileContent;
    parts: import('../types/types.js').MeshPart[];
    report: import('../types/types.js').PreparationReport;
    format: import('../types/types.js').MeshInfo['format'];
    /** Its name, such as 'metre', or ''. */
    unit: string;
    notes: string[];
  }

  export interface ModuleOptions {
    scale: number;
    weldDistance: number;
    closeHoles: boolean;
    components: Uint32Array;
    minComponent: number;
  }

  type OnProgress = (fraction: number) => void;

  interface Arrays {
    positions: Float64Array<ArrayBuffer>;
    indices: Uint32Array<ArrayBuffer>;
  }

  /** A surface's arrays, and what follows from them. */
  export interface Described extends Arrays {
    /** The point that drawn points are relative to. */
    origin: [number, number, number];
    /** Two vertices for each edge of the boundary. */
    boundary: Uint32Array<ArrayBuffer>;
    /** One per component. */
    genus: number[];
    boundaries: number[];
    area: number;
  }

  export interface FilesModule {
    /** Reads and prepares a model. `resource` returns a file that the model refers to. */
    readSurface(
      bytes: Uint8Array,
      name: string,
      resource: (name: string) => Uint8Array | undefined,
      options: ModuleOptions,
      onProgress: OnProgress,
    ): Prepared | Failed;
    /** Prepares arrays. */
    surfaceFromArrays(
      positions: Float64Array,
      indices: Uint32Array,
      options: ModuleOptions,
      onProgress: OnProgress,
    ): Prepared | Failed;
  }

  export default function createModule(): Promise<FilesModule>;
}

declare module '*/girth-analysis.mjs' {
  type Analysis = typeof import('../types/operations/analysis.js');
  type Serving = typeof import('../types/operations/serving.js');

  /** A surface that a worker keeps from one job to the next. */
  export interface JobSurface {
    delete(): void;
  }

  type Functions = import('../types/operations/table.js').FunctionsOf<
    Analysis['makingSurfaces'] & Analysis['analysing'] & Serving['serving'],
    JobSurface
  >;

  export interface AnalysisModule extends Functions {
    /** The surface of a prepared surface's arrays, with the numbers that its vertices have in the input. */
    jobSurface(
      positions: Float64Array,
      indices: Uint32Array,
      vertexOfInput: Uint32Array,
      inputOfVertex: Uint32Array,
    ): { surface: JobSurface } | Failed;
  }

  export default function createModule(): Promise<AnalysisModule>;
}

declare module '*/girth-threads.mjs' {
  export interface Surface {
    field(
      field: import('../types/protocol.js').FieldRequest,
      known: Uint8Array,
      threads: number,
      onPartial: (partial: import('../types/protocol.js').FinishedValues) => void,
    ): { complete: boolean } | Failed;
    refinedGirth(
      request: import('../types/protocol.js').RefinedRequest,
      threads: number,
      onProgress: (fraction: number) => void,
    ): import('../types/protocol.js').FoundRefined | Failed;
    delete(): void;
  }

  export interface GirthThreadsModule {
    exactSurface(positions: Float64Array, indices: Uint32Array): { surface: Surface } | Failed;
    /** A view of one byte of the shared memory. */
    cancelFlag(): Uint8Array<SharedArrayBuffer>;
  }

  export default function createModule(options: {
    girthThreads: number;
    wasmMemory: WebAssembly.Memory;
  }): Promise<GirthThreadsModule>;
}

declare module '*/girth-studies.mjs' {
  type Studies = typeof import('../types/operations/studies.js');

  /** A surface, with its spectrum and the remeshed surface that comparisons use. */
  export interface Surface {
    delete(): void;
  }

  type Functions = import('../types/operations/table.js').FunctionsOf<Studies['studying'], Surface>;

  export interface GirthStudiesModule extends Functions {
    exactSurface(positions: Float64Array, indices: Uint32Array): { surface: Surface } | Failed;
  }

  export default function createModule(): Promise<GirthStudiesModule>;
}
