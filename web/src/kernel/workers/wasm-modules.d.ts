// The WebAssembly modules as `cpp/bind` makes them; the build writes them into the folder `wasm`.

/* oxlint-disable typescript/consistent-type-imports --
   an ambient module has no other way to name the types beside it */

/** What functions return instead of their result when they fail. */
interface Failed {
  code: string;
  element: number;
  message: string;
  hint: string;
}

declare module '*/girth.mjs' {
  type Point = import('../types/types.js').SurfacePoint;

  /** Of the fields it has 'igf' and 'angle', without persistence. */
  export interface Surface {
    /** What it was made from. */
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
    /** Its symbol, such as 'm', or ''. */
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
    /** What drawn points are relative to. */
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
  type Point = import('../types/types.js').SurfacePoint;
  type Described = import('../wasm/girth-files.mjs').Described;
  type OnProgress = (fraction: number) => void;

  /** A surface that a worker keeps from one job to the next. */
  export interface JobSurface {
    delete(): void;
  }

  type WrittenModel = import('../types/protocol.js').WrittenModel;
  type GirthAndDiameter = import('../types/protocol.js').GirthAndDiameter;
  type PrintArrays = import('../types/protocol.js').PrintArrays;

  interface Bytes {
    bytes: Uint8Array<ArrayBuffer>;
  }

  export interface AnalysisModule {
    /** The surface of a prepared surface's arrays, with the numbers that its vertices have in the input. */
    jobSurface(
      positions: Float64Array,
      indices: Uint32Array,
      vertexOfInput: Uint32Array,
      inputOfVertex: Uint32Array,
    ): { surface: JobSurface } | Failed;
    /** A surface of about so many faces, of even size or as fits the shape. */
    remesh(
      surface: JobSurface,
      faces: number,
      even: boolean,
      onProgress: OnProgress,
    ): Described | Failed;
    /** The surface with its vertices moved. */
    smooth(surface: JobSurface, steps: number, onProgress: OnProgress): Described | Failed;
    /** Values of a remeshed surface at the vertices of the original one. */
    carryBack(
      original: JobSurface,
      remeshed: JobSurface,
      values: Float64Array,
      kinds: Uint8Array,
    ): { values: Float64Array<ArrayBuffer>; kinds: Uint8Array<ArrayBuffer> } | Failed;
    refinedGirth(
      surface: JobSurface,
      request: import('../types/protocol.js').RefinedRequest,
      onProgress: OnProgress,
    ): import('../types/protocol.js').FoundRefined | Failed;
    /** Equation (1) of the paper. */
    difference(
      one: JobSurface,
      values: Float64Array,
      other: JobSurface,
      otherValues: Float64Array,
    ): { difference: number } | Failed;
    vertexAreas(surface: JobSurface): { areas: Float64Array<ArrayBuffer> } | Failed;
    tips(surface: JobSurface, girth: Float64Array): import('../types/types.js').Tips | Failed;
    limbs(
      surface: JobSurface,
      girth: Float64Array,
      stations: number,
      onProgress: OnProgress,
    ): import('../types/types.js').Limbs | Failed;
    necks(
      surface: JobSurface,
      girth: Float64Array,
      minProminence: number,
      onProgress: OnProgress,
    ): import('../types/types.js').Necks | Failed;
    bottleneck(
      surface: JobSurface,
      girth: Float64Array,
      from: Point,
      to: Point,
      onProgress: OnProgress,
    ): import('../types/types.js').Bottleneck | Failed;
    /** The girth along the shortest path through points. */
    profile(
      surface: JobSurface,
      points: readonly Point[],
      samples: number,
      crossings: boolean,
      onProgress: OnProgress,
    ): Omit<import('../types/types.js').Profile, 'unit'> | Failed;
    /** The loops along a limb, by its stations. */
    axis(
      surface: JobSurface,
      profile: readonly import('../types/protocol.js').PlacedStation[],
      onProgress: OnProgress,
    ): Omit<import('../types/types.js').LimbAxis, 'unit'> | Failed;
    handles(
      surface: JobSurface,
      basePoints: number,
      onProgress: OnProgress,
    ): import('../types/types.js').Handles | Failed;
    removeHandles(
      surface: JobSurface,
      length: number,
      basePoints: number,
      onProgress: OnProgress,
    ): { described: Described; removal: import('../types/types.js').HandleRemoval } | Failed;
    levelCurves(
      surface: JobSurface,
      values: Float64Array,
      level: number,
    ): { curves: import('../types/types.js').LevelCurve[] } | Failed;
    cut(
      surface: JobSurface,
      curves: readonly (readonly Point[])[],
      cap: boolean,
    ): import('../types/types.js').Cut | Failed;
    writeProfile(
      surface: JobSurface,
      model: WrittenModel,
      points: readonly Point[],
      samples: number,
      crossings: boolean,
      format: string,
      onProgress: OnProgress,
    ): Bytes | Failed;
    writeStations(
      surface: JobSurface,
      model: WrittenModel,
      stations: readonly import('../types/types.js').PathStation[],
      format: string,
    ): Bytes | Failed;
    writeAxis(
      surface: JobSurface,
      model: WrittenModel,
      loops: readonly import('../types/protocol.js').WrittenLoop[],
      format: string,
    ): Bytes | Failed;
    writeCut(
      surface: JobSurface,
      model: import('../types/protocol.js').WrittenModel,
      content: import('../types/protocol.js').FileContent,
      curves: readonly (readonly Point[])[],
      cap: boolean,
      format: string,
    ): { files: Uint8Array<ArrayBuffer>[] } | Failed;
    segments(
      surface: JobSurface,
      fields: GirthAndDiameter,
      options: import('../types/protocol.js').SegmentRequest,
      onProgress: OnProgress,
    ): import('../types/types.js').Segments | Failed;
    writeSegments(
      surface: JobSurface,
      model: WrittenModel,
      content: import('../types/protocol.js').FileContent,
      fields: GirthAndDiameter,
      options: import('../types/protocol.js').SegmentRequest,
      format: string,
      onProgress: OnProgress,
    ): Bytes | Failed;
    suggestedThresholds(
      surface: JobSurface,
      fields: GirthAndDiameter,
    ): import('../types/types.js').PartThresholds | Failed;
    parts(
      surface: JobSurface,
      fields: GirthAndDiameter,
      options: Required<import('../types/types.js').PartOptions>,
    ): import('../types/types.js').Parts | Failed;
    maxima(
      surface: JobSurface,
      values: Float64Array,
      minima: boolean,
    ): { maxima: import('../types/types.js').Maximum[] } | Failed;
    path(
      surface: JobSurface,
      from: import('../types/types.js').SurfacePoint,
      to: import('../types/types.js').SurfacePoint,
    ): { length: number; straight: number; polyline: Float32Array<ArrayBuffer> } | Failed;
    printCheck(
      surface: JobSurface,
      fields: PrintArrays,
      limits: Required<import('../types/types.js').PrintLimits>,
      onProgress: OnProgress,
    ): import('../types/types.js').PrintCheck | Failed;
    writeFields(
      surface: JobSurface,
      model: WrittenModel,
      fields: readonly import('../types/types.js').NamedField[],
      format: string,
    ): Bytes | Failed;
    writeLimbs(
      surface: JobSurface,
      model: WrittenModel,
      girth: Float64Array,
      stations: number,
      format: string,
      onProgress: OnProgress,
    ): { bytes: Uint8Array<ArrayBuffer> } | Failed;
    writeTips(
      surface: JobSurface,
      model: WrittenModel,
      girth: Float64Array,
      format: string,
    ): Bytes | Failed;
    writeParts(
      surface: JobSurface,
      model: WrittenModel,
      fields: GirthAndDiameter,
      options: Required<import('../types/types.js').PartOptions>,
      format: string,
    ): Bytes | Failed;
    writeWeakPlaces(
      surface: JobSurface,
      model: WrittenModel,
      fields: PrintArrays,
      limits: Required<import('../types/types.js').PrintLimits>,
      format: string,
      onProgress: OnProgress,
    ): Bytes | Failed;
    /** A file for each loop. */
    writeLoops(
      surface: JobSurface,
      model: WrittenModel,
      points: readonly import('../types/types.js').SurfacePoint[],
      format: string,
    ): { files: Uint8Array<ArrayBuffer>[] } | Failed;
  }

  export default function createModule(): Promise<AnalysisModule>;
}

declare module '*/girth-threads.mjs' {
  export interface Surface {
    field(
      field: import('../types/protocol.js').FieldRequest,
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
  type OnProgress = (fraction: number) => void;

  /** A surface, with its spectrum and the remeshed surface that comparisons use. */
  export interface Surface {
    delete(): void;
  }

  export interface GirthStudiesModule {
    exactSurface(positions: Float64Array, indices: Uint32Array): { surface: Surface } | Failed;
    spectralField(
      surface: Surface,
      request: import('../types/protocol.js').SpectralRequest,
      onProgress: OnProgress,
    ): { values: Float64Array<ArrayBuffer>; method: string } | Failed;
    heatMaxima(
      surface: Surface,
      request: import('../types/protocol.js').SpectralRequest,
      onProgress: OnProgress,
    ): { maxima: import('../types/types.js').Maximum[] } | Failed;
    fieldGroups(descriptors: readonly string[]): { groups: string[] } | Failed;
    studyFields(
      surface: Surface,
      group: string,
      faces: number,
      smooth: number,
      onProgress: OnProgress,
    ): import('../types/protocol.js').StudyFields | Failed;
    compare(
      models: readonly (readonly import('../types/protocol.js').StudyFields[])[],
      descriptors: readonly string[],
      onProgress: OnProgress,
    ): { matrices: Float64Array<ArrayBuffer>[] } | Failed;
  }

  export default function createModule(): Promise<GirthStudiesModule>;
}
