// The kernel's public API: everything that the page, the element and npm users see of the computation.
// No three.js, no DOM. Names are those of the C++ core. Lengths are in the model's own units.

/**
 * How the shortest loop came about: round the surface; out and back to the farthest point; or not at
 * all, because it took too long: then the length is a lower bound, and there is nothing to draw.
 */
export type LoopKind = 'loop' | 'antipodal' | 'unresolved';

/** A failure: the code of the table in `error_codes.def`, the element, the words and the remedy. */
export interface GirthErrorFields {
  code: string;
  /** The first offending vertex, face, line or byte, as the message says; -1 where there is none. */
  element: number;
  message: string;
  hint: string;
}

export interface KernelOptions {
  /** Parallel workers or threads; 'auto' is one per core, at most 8. */
  threads?: number | 'auto';
  /**
   * 'auto': threads of one module where the page is cross-origin isolated, otherwise a pool of
   * single-threaded workers. Both give the same bits. Asking for 'threads' where the page is not
   * isolated falls back to the pool with one warning.
   */
  mode?: 'auto' | 'threads' | 'pool';
}

/** Plain arrays as a mesh: x, y, z per vertex and three vertices per triangle. */
export interface MeshArrays {
  positions: Float64Array | Float32Array;
  indices: Uint32Array | Uint16Array;
}

/** A file among several; `path` has '/' between folders, as in 'scene/model.gltf'. */
export interface FileWithPath {
  path: string;
  content: Blob;
}

/**
 * A file, also a zip; an address; raw bytes with a name; several files or those of a folder, one of
 * which is the model; or arrays. A glTF's buffers are found among the files, or beside its address.
 */
export type MeshSource =
  | Blob
  | string
  | URL
  | { bytes: ArrayBuffer; name: string }
  | readonly (File | FileWithPath)[]
  | MeshArrays;

/** How the surface is prepared (`prepare_surface.h`); nothing said: repaired, and whole. */
export interface PrepareOptions {
  /** Vertices up to this far apart become one, in model units; 0 (default): exactly equal ones. */
  weldDistance?: number;
  /** Fills the holes that are left. */
  closeHoles?: boolean;
  /** Keeps only these components, by their place in `MeshInfo.parts`; empty or absent: all. */
  components?: readonly number[];
}

export interface CallOptions {
  /** Aborting really stops the work; the promise is rejected with a GirthError of code CANCELLED. */
  signal?: AbortSignal;
}

export interface WatchedOptions extends CallOptions {
  /** The finished share in [0, 1]; never falls; ends with 1. */
  onProgress?: (fraction: number) => void;
}

export interface LoadOptions extends WatchedOptions {
  /** Which of several models, one of `MeshInfo.models`; absent: the first. */
  model?: string;
  prepare?: PrepareOptions;
}

/** Values finished since the last report; values[i] and kinds[i] belong to vertex vertices[i]. */
export interface PartialField {
  vertices: Uint32Array;
  values: Float64Array;
  /** 0: loop, 1: antipodal, 2: unresolved. */
  kinds: Uint8Array;
}

export interface FieldOptions extends WatchedOptions {
  /** New values, coarse to fine: each batch is spread over the whole surface. */
  onPartial?: (partial: PartialField) => void;
}

export interface Field {
  name: 'igf';
  /** One per vertex of the surface, in its order. */
  values: Float64Array;
  /** 0: loop, 1: antipodal, 2: unresolved; one per vertex. */
  kinds: Uint8Array;
  /** Smallest and largest value. */
  range: [number, number];
  /** 'm' for glTF, '' where the file does not say. */
  unit: string;
}

/** A point of a face. */
export interface FacePoint {
  /** From 0 to the face count minus one; face f has the vertices `indices[3 * f]` and the next two. */
  face: number;
  /** Shares of the face's three vertices, in their order: none below 0, the sum 1. */
  weights: readonly [number, number, number];
}

/** A vertex, or a point of a face: of its inside, of an edge (one share is 0) or a corner. */
export type SurfacePoint = number | FacePoint;

export interface Loop {
  /** The girth I(p). */
  length: number;
  kind: LoopKind;
  /** The point p, as it was asked for. */
  base: SurfacePoint;
  /** x, y, z per point, from p round to p; empty where unresolved. */
  polyline: Float32Array;
  /** x, y, z of the point of the loop farthest from p. */
  midpoint: [number, number, number];
  /** Angle at p between the loop's ends, in radians. */
  angle: number;
  unit: string;
}

/** What was done to the input, each step counted, in this order (`prepare_surface.h`). */
export interface PreparationReport {
  inputVertices: number;
  inputFaces: number;
  weldedVertices: number;
  degenerateFaces: number;
  flippedFaces: number;
  duplicateFaces: number;
  unreferencedVertices: number;
  reorientedFaces: number;
  oneSidedEdges: number;
  nonManifoldEdges: number;
  nonManifoldVertices: number;
  addedVertices: number;
  components: number;
  keptComponents: number;
  boundaryCurves: number;
  boundaryEdges: number;
  closedHoles: number;
  holes: ClosedHole[];
}

/** A hole that was filled; lengths in model units. */
export interface ClosedHole {
  edges: number;
  perimeter: number;
  area: number;
  /** A vertex of the input on its rim. */
  vertex: number;
}

/** A connected component of what was read, kept or not. */
export interface MeshPart {
  faceCount: number;
  /** In squared model units. */
  area: number;
}

export interface MeshInfo {
  name: string;
  /** All models among the files that were given, the one that is shown included; paths. */
  models: string[];
  format: 'GLB' | 'glTF' | 'OBJ' | 'PLY' | 'STL' | 'OFF' | 'arrays';
  vertexCount: number;
  faceCount: number;
  edgeCount: number;
  components: number;
  /** One per component. */
  genus: number[];
  /** Boundary curves, one number per component; they are walls. */
  boundaries: number[];
  area: number;
  /** Extent along x, y and z, in model units. */
  size: [number, number, number];
  /** 'm' for glTF, '' where the file does not say. */
  unit: string;
  report: PreparationReport;
  /** What else there is to know, a sentence each: 'skinned: shown in its bind pose'. */
  notes: string[];
  /** All components, numbered by their first face of the input; see `PrepareOptions.components`. */
  parts: MeshPart[];
}

/** Files that a field can be written as. */
export type FieldFormat = 'csv' | 'json' | 'npy' | 'ply' | 'glb';
/** Files that loops can be written as. */
export type LoopFormat = 'obj' | 'glb' | 'json';

export interface Mesh {
  readonly info: MeshInfo;
  /**
   * The surface to draw and pick on: positions are x, y, z per vertex; `walls` has two vertices for
   * each edge of the boundary. Do not modify.
   */
  readonly geometry: { positions: Float32Array; indices: Uint32Array; walls: Uint32Array };
  /** The surface's vertex for each vertex of the input; 0xFFFFFFFF where there is none. */
  readonly vertexOfInput: Uint32Array;
  field(name: 'igf', options?: FieldOptions): Promise<Field>;
  /**
   * The loop at a vertex or at a point of a face. Served at once, also while a field is being
   * computed. Codes of failure: VERTEX_OUT_OF_RANGE, INVALID_POINT, CANCELLED.
   */
  loop(point: SurfacePoint, options?: CallOptions): Promise<Loop>;
  /**
   * The field as a file's content: CSV, JSON and NPY in the order of the input's vertices, PLY and
   * GLB as the surface with its values (`write_field.h`). The unit written is `field.unit`.
   */
  exportField(field: Field, format: FieldFormat, options?: CallOptions): Promise<Uint8Array>;
  /** The loops at some points, a file's content for each (`write_loop.h`), in the unit `unit`. */
  exportLoops(
    points: readonly SurfacePoint[],
    format: LoopFormat,
    options?: CallOptions & { unit?: string },
  ): Promise<Uint8Array[]>;
  /**
   * A surface of about `faces` faces, closed where this one is and of its genus (`remesh.h`). Its
   * input, as files and `vertexOfInput` count it, are its own vertices.
   */
  remesh(faces: number, options?: WatchedOptions): Promise<RemeshedMesh>;
  /**
   * How far a field is from one on another mesh, whatever their sizes: equation (1) of the paper
   * (`field_difference.h`).
   */
  difference(field: Field, other: Mesh, otherField: Field, options?: CallOptions): Promise<number>;
  dispose(): void;
}

/** A surface of other faces that lies where the one before did. */
export interface RemeshedMesh extends Mesh {
  /** Values at its vertices, one each, carried to the vertices of the mesh that it was made of. */
  carryBack(values: Float64Array, options?: CallOptions): Promise<Float64Array>;
}

export interface Kernel {
  readonly mode: 'threads' | 'pool';
  readonly threads: number;
  /** Reads, prepares and checks a model, in a worker of its own. */
  load(source: MeshSource, options?: LoadOptions): Promise<Mesh>;
  dispose(): void;
}
