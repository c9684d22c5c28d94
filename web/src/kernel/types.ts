// The kernel's public API: everything that the page, the element and npm users see of the computation.
// No three.js, no DOM. Names are those of the C++ core. Lengths are in the model's own units.

/**
 * How the shortest loop came about: round the surface; out and back to the farthest point; or not at
 * all, because it took too long: then the length is a lower bound, and there is nothing to draw.
 */
export type LoopKind = 'loop' | 'antipodal' | 'unresolved';

/** A failure: the code of the table in `error_codes.def`, the element, the words and the remedy. */
export interface GirthErrorFields {
  /** Stable: 'OPEN_EDGE'. */
  code: string;
  /** The first offending vertex, face, line or byte, as the message states; -1 where there is none. */
  element: number;
  /** What is wrong and where, for people. */
  message: string;
  /** What to do about it, for people. */
  hint: string;
}

/** How a kernel computes. */
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
  /** x, y, z per vertex, in model units. */
  positions: Float64Array | Float32Array;
  /** Three vertices per triangle, counter-clockwise seen from outside. */
  indices: Uint32Array | Uint16Array;
}

/** A file among several. */
export interface FileWithPath {
  /** With '/' between folders: 'scene/model.gltf'. */
  path: string;
  /** Its bytes. */
  content: Blob;
}

/** Bytes of a file. */
export interface NamedBytes {
  /** The whole content. */
  bytes: ArrayBuffer;
  /** For messages, and for formats that the content alone does not decide. */
  name: string;
}

/**
 * A file, also a zip; an address; raw bytes with a name; several files or those of a folder, one of
 * which is the model; or arrays. A glTF's buffers are found among the files, or beside its address.
 */
export type MeshSource =
  Blob | string | URL | NamedBytes | readonly (File | FileWithPath)[] | MeshArrays;

/** How the surface is prepared (`prepare_surface.h`). Default: repaired, with all components. */
export interface PrepareOptions {
  /** Vertices up to this far apart become one, in model units; 0 (default): exactly equal ones. */
  weldDistance?: number;
  /** Fills the holes that are left. */
  closeHoles?: boolean;
  /** Keeps only these components, by their place in `MeshInfo.parts`; empty or absent: all. */
  components?: readonly number[];
}

/** For every call. */
export interface CallOptions {
  /** Aborting really stops the work; the promise is rejected with a GirthError of code CANCELLED. */
  signal?: AbortSignal;
}

/** For calls that write files. */
export interface ExportOptions extends CallOptions {
  /** The unit of lengths, where the file does not state it: 'mm'. */
  unit?: string;
}

/** For calls that take long. */
export interface WatchedOptions extends CallOptions {
  /** The finished share in [0, 1]; never falls; ends with 1. */
  onProgress?: (fraction: number) => void;
}

/** For loading a model. */
export interface LoadOptions extends WatchedOptions {
  /** Which of several models, one of `MeshInfo.models`; absent: the first that can be read. */
  model?: string;
  /** How its surface is prepared. */
  prepare?: PrepareOptions;
}

/**
 * Functions of the surface that are computed vertex by vertex. In model units: the girth; the shape
 * diameter, which is the thickness (`shape_diameter.h`); the mean and the greatest geodesic distance
 * (`geodesic_extent.h`). In radians: the angle between the two ends of the loop at its base.
 */
export type VertexFieldName = 'igf' | 'sdf' | 'geoaverage' | 'geofarthest' | 'angle';

/**
 * Functions made of the surface's vibrations, one number of each signature: the heat kernel and wave
 * kernel signatures, in 1 / squared model units, and the scale-invariant heat kernel signature
 * (`heat_kernel.h`, `wave_kernel.h`). They are there all at once, and without partial values.
 */
export type SpectralFieldName = 'hks' | 'wks' | 'sihks';

/** All fields. */
export type FieldName = VertexFieldName | SpectralFieldName;

/** Values finished since the last report; values[i] and kinds[i] belong to vertex vertices[i]. */
export interface PartialField {
  /** Vertices of the surface, each reported once. */
  vertices: Uint32Array;
  /** NaN where there is no value. */
  values: Float64Array;
  /** Of the girth, 0: loop, 1: antipodal, 2: unresolved; of other fields empty. */
  kinds: Uint8Array;
}

/** For computing a field. */
export interface FieldOptions extends WatchedOptions {
  /** New values, coarse to fine: each batch is spread over the whole surface. */
  onPartial?: (partial: PartialField) => void;
  /** Of 'sdf'. */
  sdf?: ShapeDiameterOptions;
  /** Of 'geoaverage' and 'geofarthest': how distances are computed; fast marching by default. */
  distances?: 'fast-marching' | 'exact';
  /** Of 'hks', 'wks' and 'sihks'. */
  spectral?: SpectralOptions;
}

/** Of the shape diameter (`shape_diameter.h`). */
export interface ShapeDiameterOptions {
  /** The cone's full opening, in radians. Default: 120°. */
  coneAngle?: number;
  /** Rays sent from each vertex. Default: 30. */
  rays?: number;
}

/** Of signatures made of the surface's vibrations. */
export interface SpectralOptions {
  /** Pairs of eigenvalues and eigenfunctions. Default: 300. */
  pairs?: number;
  /** Of 'hks' and heat maxima: the time, as a share of the surface's area. Default: 0.002. */
  time?: number;
  /** Which number, from 1: of 'wks' one of 100 energies (default: 20), of 'sihks' one of 19 frequencies (1). */
  component?: number;
}

/** A maximum of a field, and how far it rises above its surroundings (`persistent_maxima.h`). */
export interface Maximum {
  /** Where it is. */
  vertex: number;
  /** The field there. */
  value: number;
  /** How far one must go down from it to reach a higher maximum, in the field's unit. */
  persistence: number;
  /** Where its surroundings meet those of a higher maximum; -1 for the highest of a component. */
  saddle: number;
}

/** A value for every vertex. */
export interface Field {
  /** Which function it is. */
  name: FieldName;
  /** One per vertex of the surface, in its order; NaN where there is no value. */
  values: Float64Array;
  /** Of the girth, 0: loop, 1: antipodal, 2: unresolved; one per vertex. Of other fields empty. */
  kinds: Uint8Array;
  /** Smallest and largest value; NaN twice where no vertex has one. */
  range: [number, number];
  /**
   * For lengths that of the model: 'm' for glTF, '' where the file does not state it. 'rad' for angles;
   * '1/m²' for heat and wave kernels, '' where the model's is not known.
   */
  unit: string;
  /** How it was computed: 'exact', '30 rays', 'fast marching', '300 eigenpairs'. */
  method: string;
  /** Vertices that have no value. */
  withoutValue: number;
  /** What users should know of the values, in sentences: 'the surface is inside out: ...'; or ''. */
  note: string;
}

/** A field to write, also one that was not computed here. */
export interface NamedField {
  /** A small letter, then small letters, digits and underscores: 'part'. */
  name: string;
  /** One per vertex of the surface; NaN where there is no value. */
  values: Float64Array;
  /** As of `Field`; absent: none. */
  kinds?: Uint8Array;
  /** As of `Field`; '' for plain numbers. */
  unit: string;
  /** As of `Field`; absent: not stated. */
  method?: string;
}

/** A line across edges of the surface. */
export interface ContourLine {
  /** It returns to its first point, which is not repeated. Otherwise it ends at a boundary or in faces. */
  closed: boolean;
  /** x, y, z per point, from `Mesh.geometry.origin`. */
  polyline: Float32Array;
}

/** Where the shape ends (`tips.h`): a region that the discontinuity contour of the girth cuts off. */
export interface Tip {
  /** In rising order. */
  vertices: Uint32Array;
  /** What cuts it off: usually one closed line. */
  contour: ContourLine[];
  /** Area inside the contour, in squared model units. */
  area: number;
  /** Length of the contour, in model units. */
  boundaryLength: number;
  /** The vertex of the region that is farthest from the contour, along the surface. */
  apex: number;
  /** How far that is, in model units. */
  apexDistance: number;
  /** How far the girth rises from outside to inside, in model units. */
  jump: number;
}

/** A part of the contour that cuts no tip off. */
export interface OpenArc {
  /** Where it runs. */
  line: ContourLine;
  /** In model units. */
  length: number;
  /** How far the girth jumps along it, in model units. */
  jump: number;
}

/** The tips of a shape. */
export interface Tips {
  /** Largest jump first. */
  tips: Tip[];
  /** Parts of the contour that cut no tip off; longest first. */
  arcs: OpenArc[];
  /** Edges of the surface that the contour crosses. */
  crossedEdges: number;
}

/** What a place of a shape is; 'unknown' where its girth or its thickness has no value. */
export type PartKind = 'body' | 'tube' | 'plate' | 'unknown';

/** Where tubes, plates and body are divided; in model units, from 0 to Infinity. */
export interface PartThresholds {
  /** τ1 of the paper: tubes have a girth below it, plates one above. */
  girth: number;
  /** τ2 of the paper: tubes and plates are thinner than this. */
  diameter: number;
}

/** How parts are found. */
export interface PartOptions extends PartThresholds {
  /** 0 (default): plain thresholds; above: what a vertex's neighbourhood weighs against it. */
  smoothing?: number;
}

/** A connected region of one kind (`parts.h`). */
export interface Part {
  /** Of all its vertices. */
  kind: PartKind;
  /** In rising order. */
  vertices: Uint32Array;
  /** Sum of the vertices' areas, in squared model units. */
  area: number;
  /** Median girth, in model units; NaN where it is unknown. */
  medianGirth: number;
  /** Median thickness, in model units; NaN where it is unknown. */
  medianDiameter: number;
  /** The vertex of the least girth (tubes) or diameter (others); -1 where it is unknown. */
  thinnest: number;
  /** Radius of the round tube of the same girth, I / 2π, in model units. */
  equivalentRadius: number;
}

/** The parts of a shape. */
export interface Parts {
  /** Of the vertices; 0: body, 1: tube, 2: plate, 3: unknown. */
  kinds: Uint8Array;
  /** Of the vertices: the number of their part. */
  partOf: Uint32Array;
  /** Largest area first. */
  parts: Part[];
}

/** What can still be printed, in model units; 0: everything. */
export interface PrintLimits {
  /** The least diameter of a tube. */
  tubeDiameter: number;
  /** The least thickness of a wall. */
  wallThickness: number;
}

/** A connected place that is too thin to print (`parts.h`). */
export interface WeakPlace {
  /** 'plate': a thin wall. */
  kind: 'tube' | 'plate';
  /** In rising order. */
  vertices: Uint32Array;
  /** In squared model units. */
  area: number;
  /** The least diameter I / π of the tube, or thickness of the wall, in model units. */
  least: number;
  /** The vertex where that is. */
  thinnest: number;
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

/** The shortest loop based at a point. */
export interface Loop {
  /** The girth I(p), in model units. */
  length: number;
  /** How it came about. */
  kind: LoopKind;
  /** The point p, as it was asked for. */
  base: SurfacePoint;
  /** x, y, z per point, from p round to p; empty where unresolved. From `Mesh.geometry.origin`. */
  polyline: Float32Array;
  /** x, y, z of the point of the loop farthest from p, from `Mesh.geometry.origin`. */
  midpoint: [number, number, number];
  /** Angle at p between the loop's ends, in radians. */
  angle: number;
  /** Of the length: 'm' for glTF, '' where the file does not state it. */
  unit: string;
}

/** What was done to the input, each step counted, in this order (`prepare_surface.h`). */
export interface PreparationReport {
  /** Vertices of the input. */
  inputVertices: number;
  /** Triangles of the input. */
  inputFaces: number;
  /** Vertices that became one with an earlier one. */
  weldedVertices: number;
  /** Faces without area, dropped. */
  degenerateFaces: number;
  /** Faces without area whose longest side was flipped, since dropping them would open the surface. */
  flippedFaces: number;
  /** Faces that another one repeats, dropped. */
  duplicateFaces: number;
  /** Vertices that no face uses, dropped. */
  unreferencedVertices: number;
  /** Faces turned over, so that neighbours agree. */
  reorientedFaces: number;
  /** Edges cut because the surface has one side only. */
  oneSidedEdges: number;
  /** Edges with more than two faces, cut apart. */
  nonManifoldEdges: number;
  /** Vertices at which parts only touched, cut apart. */
  nonManifoldVertices: number;
  /** Copies of vertices made by cutting. */
  addedVertices: number;
  /** Connected components of the result. */
  components: number;
  /** How many of them are kept. */
  keptComponents: number;
  /** Boundary curves of the kept components, after holes were closed. */
  boundaryCurves: number;
  /** Edges of these curves. */
  boundaryEdges: number;
  /** Boundary curves that were filled. */
  closedHoles: number;
  /** Which these were. */
  holes: ClosedHole[];
}

/** A hole that was filled. */
export interface ClosedHole {
  /** Edges on its rim. */
  edges: number;
  /** Length of its rim, in model units. */
  perimeter: number;
  /** Area of the faces that fill it, in squared model units. */
  area: number;
  /** A vertex of the input on its rim. */
  vertex: number;
}

/** A connected component of what was read, kept or not. */
export interface MeshPart {
  /** Its faces. */
  faceCount: number;
  /** In squared model units. */
  area: number;
}

/** A model that was passed over, and why. */
export interface UnreadableModel {
  /** One of `MeshInfo.models`. */
  model: string;
  /** Why it cannot be read. */
  error: GirthErrorFields;
}

/** What a model is. */
export interface MeshInfo {
  /** Of the file, without folders; '' for arrays. */
  name: string;
  /** All models among the files that were given, the one that is shown included; paths. */
  models: string[];
  /** Of these, those that were tried before this one and cannot be read. */
  unreadable: UnreadableModel[];
  /** What the content was recognised as. */
  format: 'GLB' | 'glTF' | 'OBJ' | 'PLY' | 'STL' | 'OFF' | 'arrays';
  /** Vertices of the surface. */
  vertexCount: number;
  /** Faces of the surface. */
  faceCount: number;
  /** Edges of the surface. */
  edgeCount: number;
  /** Connected components of the surface. */
  components: number;
  /** Number of handles, one per component. */
  genus: number[];
  /** Number of boundary curves, one per component. */
  boundaries: number[];
  /** In squared model units. */
  area: number;
  /** Extent along x, y and z, in model units. */
  size: [number, number, number];
  /** 'm' for glTF, '' where the file does not state it. */
  unit: string;
  /** What was done to make a surface of the file. */
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

/** A surface to draw. Do not modify. */
export interface MeshGeometry {
  /** x, y, z per vertex, from `origin`. */
  positions: Float32Array;
  /** Three vertices per face. */
  indices: Uint32Array;
  /** Two vertices for each edge of the boundary. */
  boundary: Uint32Array;
  /**
   * What positions, and the points of loops and contours, are relative to; add it for the file's
   * coordinates. 0, 0, 0, but for surfaces that lie more than 64 times their size away from the
   * coordinates' origin, where 32-bit numbers would draw steps.
   */
  origin: readonly [number, number, number];
}

/** A model that was loaded, and everything that can be computed of it. Made by `Kernel.load`. */
export interface Mesh {
  /** What the model is. */
  readonly info: MeshInfo;
  /** The surface to draw and pick on. */
  readonly geometry: MeshGeometry;
  /** The surface's vertex for each vertex of the input; 0xFFFFFFFF where there is none. */
  readonly vertexOfInput: Uint32Array;
  /** Computes a field. Codes of failure: USAGE and INVALID_OPTION for options out of range, CANCELLED. */
  field(name: FieldName, options?: FieldOptions): Promise<Field>;
  /**
   * The loop at a vertex or at a point of a face. Served at once, also while a field is being
   * computed. Codes of failure: VERTEX_OUT_OF_RANGE, INVALID_POINT, CANCELLED.
   */
  loop(point: SurfacePoint, options?: CallOptions): Promise<Loop>;
  /**
   * The field as a file's content: CSV, JSON and NPY in the order of the input's vertices, PLY and
   * GLB as the surface with its values (`write_field.h`). Lengths and the model are written in the
   * unit `unit`. Default: that of the field if it is a length, otherwise the model's.
   */
  exportField(field: Field, format: FieldFormat, options?: ExportOptions): Promise<Uint8Array>;
  /** Several fields in one file, columns in their order; NPY takes only one. */
  exportFields(
    fields: readonly NamedField[],
    format: FieldFormat,
    options?: ExportOptions,
  ): Promise<Uint8Array>;
  /** The loops at some points, a file's content for each (`write_loop.h`), in the unit `unit`. */
  exportLoops(
    points: readonly SurfacePoint[],
    format: LoopFormat,
    options?: ExportOptions,
  ): Promise<Uint8Array[]>;
  /**
   * The area that each vertex stands for, which weighs it in distributions (`vertex_areas.h`); they
   * add up to `info.area`.
   */
  vertexAreas(options?: CallOptions): Promise<Float64Array>;
  /**
   * The tips by the girth. Of this and the next: USAGE where a field is not one of this mesh or not
   * the one that is asked for.
   */
  tips(igf: Field, options?: CallOptions): Promise<Tips>;
  /** Thresholds to start from; both 0 where no vertex has both values. */
  suggestedThresholds(igf: Field, sdf: Field, options?: CallOptions): Promise<PartThresholds>;
  /** Tubes, plates and body. USAGE where a threshold or the smoothing is negative or no number. */
  parts(igf: Field, sdf: Field, parts: PartOptions, options?: CallOptions): Promise<Parts>;
  /**
   * Places too thin to print, thinnest first. USAGE where a limit is negative or no number;
   * NO_THICKNESS where walls are to be checked and no vertex has a thickness, or the surface is inside out.
   */
  weakPlaces(
    igf: Field,
    sdf: Field,
    limits: PrintLimits,
    options?: CallOptions,
  ): Promise<WeakPlace[]>;
  /** The maxima of a field along the surface's edges, or its minima; most persistent first. */
  maxima(field: NamedField, options?: CallOptions & { minima?: boolean }): Promise<Maximum[]>;
  /**
   * Where heat stays longest (`heat_maxima.h`), most persistent first: the paper's comparison with
   * the girth's tips. Of the options, `component` does not matter.
   */
  heatMaxima(options?: WatchedOptions & SpectralOptions): Promise<Maximum[]>;
  /** The tips as a file's content (`write_tips.h`): JSON, or the contours as OBJ lines. */
  exportTips(igf: Field, format: 'json' | 'obj', options?: ExportOptions): Promise<Uint8Array>;
  /** The parts as a file's content (`write_parts.h`). */
  exportParts(
    igf: Field,
    sdf: Field,
    parts: PartOptions,
    format: 'json',
    options?: ExportOptions,
  ): Promise<Uint8Array>;
  /** The weak places as a file's content (`write_parts.h`). */
  exportWeakPlaces(
    igf: Field,
    sdf: Field,
    limits: PrintLimits,
    format: 'json',
    options?: ExportOptions,
  ): Promise<Uint8Array>;
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
  /** Frees the surface in all workers. What is still being computed of it is cancelled. */
  dispose(): void;
}

/** A surface of other faces that lies where the one before did. */
export interface RemeshedMesh extends Mesh {
  /** Values at its vertices, one each, carried to the vertices of the mesh that it was made of. */
  carryBack(values: Float64Array, options?: CallOptions): Promise<Float64Array>;
}

/** How shapes are compared. */
export interface CompareOptions extends WatchedOptions {
  /**
   * What to compare by (`study/signatures.h`): 'igf', 'igf-ms', 'sdf', 'geoaverage',
   * 'geofarthest' (with 'log-' before: their logarithms), 'hks', 'sihks', 'wks', 'igf-sdf', and sums
   * such as '2*igf+sdf'.
   */
  descriptors: readonly string[];
  /** Surfaces of more faces are remeshed to this number. Default: 10,000. 0: none is. */
  faces?: number;
}

/** Distances between all shapes by one descriptor. */
export interface DistanceMatrix {
  /** As it was given. */
  descriptor: string;
  /** That of i and j is `distances[i * shapes + j]`; NaN where one of them has no value or has failed. */
  distances: Float64Array;
}

/** A shape that could not be compared. */
export interface FailedShape {
  /** Its place among the shapes. */
  shape: number;
  /** Why its fields could not be computed. */
  error: GirthErrorFields;
}

/** How far shapes are apart, each scaled to area 1. */
export interface Comparison {
  /** One for each descriptor, in their order. */
  matrices: DistanceMatrix[];
  /** Shapes whose fields could not be computed. */
  failed: FailedShape[];
}

/** Workers that compute. Made by `createKernel`. */
export interface Kernel {
  /** Threads of one module, or a pool of workers with one module each. */
  readonly mode: 'threads' | 'pool';
  /** How many of them. */
  readonly threads: number;
  /**
   * How far shapes are apart, two at a time in workers of their own; what was computed of a mesh is
   * kept as long as the mesh. USAGE for descriptors that there are not; where all meshes fail, the
   * first one's error.
   */
  compare(meshes: readonly Mesh[], options: CompareOptions): Promise<Comparison>;
  /** Reads, prepares and checks a model, in a worker of its own. */
  load(source: MeshSource, options?: LoadOptions): Promise<Mesh>;
  /** Ends all workers. What is still being computed is cancelled, and no mesh can be used any more. */
  dispose(): void;
}
