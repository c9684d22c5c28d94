// The kernel's public types: what the page, the element and users of the package see of the computation.
// No three.js and no DOM. Names are those of the C++ core. Lengths are in the model's own units.

import type { Analyses, FoundByAnalysis } from './analyses.js';
import type { CallOptions, WatchedOptions } from './call-options.js';
import type { FieldName, FieldParameters } from './fields.js';
import type { SurfacePoint } from './points.js';
import type {
  AxisLoop,
  Bottleneck,
  GirthAudit,
  HandleRemoval,
  Handles,
  Limb,
  Limbs,
  Maximum,
  MeasuredBarcode,
  MeasuredLoop,
  MeasuredPath,
  MeasuredSegment,
  MeasuredStation,
  Necks,
  Part,
  PartMeasures,
  PartThresholds,
  PreparationReport,
  PrintCheck,
  Sections,
  Tips,
} from './results.js';

export type * from './analyses.js';
export type * from './call-options.js';
export type {
  FieldName,
  DistanceFieldOptions,
  FieldParameters,
  ShapeDiameterOptions,
  SpectralFieldName,
  ThicknessOptions,
  VertexFieldName,
} from './fields.js';
export type * from './points.js';
export type * from './results.js';

/** The fields of a failure, as plain data. */
export interface GirthErrorFields {
  /** A stable code, one of those in `error_codes.def`: 'OPEN_EDGE'. */
  code: string;
  /** The first offending vertex, face, line or byte, as the message states; -1 where there is none. */
  element: number;
  /** The fault in words, for people. */
  message: string;
  /** The remedy in words, for people. */
  hint: string;
}

/** How many workers a kernel has, and of which sort. */
export interface KernelOptions {
  /** Parallel workers or threads, from 1 to 64. Default: 'auto', one per core and at most 8. */
  threads?: number | 'auto';
  /**
   * 'threads': the threads of one module, in Node.js and on pages that are cross-origin isolated; on other
   * pages the kernel warns once and takes 'pool'. 'pool': workers with a module each. Default: 'auto',
   * threads where they can be had and a pool elsewhere. Both give the same values, bit for bit.
   */
  mode?: 'auto' | 'threads' | 'pool';
  /**
   * On pages, the address of a copy of the package's folder `dist`, whose workers and WebAssembly modules are used;
   * relative to the page. For bundlers that do not carry workers along, such as esbuild, and for hosts that keep them
   * elsewhere. They must be of this version. Default: where the kernel's own script names them. Node.js has no use for it.
   */
  base?: string | URL;
}

/** A mesh as plain arrays. They are copied. */
export interface MeshArrays {
  /** x, y, z of each vertex, in model units; finite where a face has the vertex. */
  positions: Float64Array | Float32Array;
  /** Three vertices of each triangle, counted from 0, counter-clockwise seen from outside. */
  indices: Uint32Array | Uint16Array;
}

/** A file's content with its name. */
export interface NamedBytes {
  /** The file's bytes. They are copied. */
  bytes: ArrayBuffer | Uint8Array;
  /** The file's name: 'model.glb'. The format is recognised by the content. */
  name: string;
}

/** A file among several. */
export interface FileWithPath {
  /** Its path, with '/' between folders: 'scene/model.gltf'. */
  path: string;
  /** Its content. */
  content: Blob;
}

/**
 * Where a model comes from: a file or zip; an address, in Node.js also a path; bytes with a name; the files
 * of a folder, one of which is the model; or arrays. The buffers of a glTF are found among the files or beside
 * its address; those of a path in its folder and below.
 */
export type MeshSource =
  | Blob
  | string
  | URL
  | NamedBytes
  | readonly (File | FileWithPath)[]
  | MeshArrays;

/** How a surface is prepared (`prepare_surface.h`). */
export interface PrepareOptions {
  /**
   * Makes the model so many times as large before anything else: all lengths below, and all that come out,
   * are those of the scaled model. Above 0. Default: 1.
   */
  scale?: number;
  /**
   * Vertices at most this far apart become one, in model units, at least 0, and open edges are divided where a neighbour has a vertex
   * within them. Default: 0, only vertices at exactly equal positions, but where the numbers of the file close the surface.
   */
  weldDistance?: number;
  /** Closes cracks, and fills the holes that are left, but over faces. Default: false. */
  closeHoles?: boolean;
  /** Keeps only these components, numbered as in {@link MeshInfo.parts}. Default: all. */
  components?: readonly number[];
  /**
   * Leaves out components whose area is less than this share of the largest one's, from 0 to 1, as in 1e-6.
   * Default: 0, none.
   */
  minComponent?: number;
}

/** Options of calls that write a file. */
export interface ExportOptions extends CallOptions {
  /** The unit of lengths, where the file that was read does not state it: 'mm' or 'millimetre'. Default: the mesh's unit. */
  unit?: string;
}

/** Options of {@link Mesh.write}. */
export interface WriteOptions extends ExportOptions {
  /** CSV of limbs has a row for each station of each limb, instead of one for each limb. Default: false. */
  profiles?: boolean;
}

/** Formats that a result is written in. */
export type FormatOf<Found> = Found extends
  | Omit<Necks, 'suggestedProminence'>
  | Handles
  | LimbAxis
  | Sections
  ? 'csv' | 'json' | 'obj' | 'glb'
  : Found extends Segments
    ? 'csv' | 'json' | 'glb'
    : Found extends Bottleneck
      ? 'json' | 'obj' | 'glb'
      : Found extends Limbs | Profile | FoundByAnalysis
        ? 'csv' | 'json'
        : Found extends Tips
          ? 'json' | 'obj'
          : Found extends Parts | PrintCheck
            ? 'json'
            : never;

/** Options of {@link Mesh.remesh}. */
export interface RemeshOptions extends WatchedOptions {
  /**
   * Whether triangles are of even size and good shape; otherwise they keep the shape best, longer where
   * the surface is bent one way only. Default: false.
   */
  even?: boolean;
}

/** Which model is loaded, and how it is prepared. */
export interface LoadOptions extends WatchedOptions {
  /** Which of several models, one of {@link MeshInfo.models}. Default: the first that can be read. */
  model?: string;
  /** How the surface is prepared. */
  prepare?: PrepareOptions;
}

/** Values that were finished since the last report. */
export interface PartialField {
  /** The vertices. The other arrays follow their order. */
  vertices: Uint32Array;
  /** Their values; NaN where there is none. */
  values: Float64Array;
  /** Kinds of the girth, 0: loop, 1: antipodal, 2: unresolved. Empty for other fields. */
  kinds: Uint8Array;
}

/** How a field is computed and reported. Each field reads only the options that concern it. */
export interface FieldOptions extends WatchedOptions, FieldParameters {
  /** Receives new values, coarse to fine: each batch is spread over the whole surface. */
  onPartial?: (partial: PartialField) => void;
  /** Options of 'hks', 'wks' and 'sihks'. */
  spectral?: SpectralOptions;
  /**
   * Whether the field is computed before all that are not urgent: one that is being computed pauses. No effect on 'hks',
   * 'wks' and 'sihks', which have a worker of their own. Default: false.
   * @experimental
   */
  urgent?: boolean;
}

/**
 * How fields are computed from the spectrum.
 * @experimental
 */
export interface SpectralOptions {
  /** Number of eigenfunctions, at least 1. Default: 300. */
  pairs?: number;
  /** The time of 'hks' and of heat maxima, as a share of the surface's area, at least 0. Default: 0.002. */
  time?: number;
  /**
   * Which number of the signature, counted from 1: for 'wks' one of 100 energies (default: 20), for 'sihks'
   * one of 19 frequencies (default: 1).
   */
  component?: number;
}

/** A field with one value for each vertex of the surface. */
export interface Field {
  /** Which field it is. */
  name: FieldName;
  /** One value per vertex of the surface, in its order; NaN where there is none. */
  values: Float64Array;
  /** Kinds of the girth, 0: loop, 1: antipodal, 2: unresolved; one per vertex. Empty for other fields. */
  kinds: Uint8Array;
  /** The smallest and the largest value; NaN twice where no vertex has one. */
  range: [number, number];
  /**
   * The unit of the values. For lengths it is the model's: 'metre' for glTF, '' where the file does not state
   * it. For angles it is 'radian'. For heat and wave kernels it is 'metre^-2', or '' where the model's is not known.
   */
  unit: string;
  /** How it was computed: 'exact', '30 rays', 'fast marching', '300 eigenpairs'. */
  method: string;
  /** Number of vertices that have no value. */
  withoutValue: number;
  /** Remarks on the values, in sentences: 'the surface is inside out: ...'; or ''. */
  note: string;
  /** The persistence of 'igf' and 'angle', in model units, where it is not 0. */
  persistence?: number;
}

/**
 * How the girth of a large surface is computed (`refined_girth.h`).
 * @experimental
 */
export interface RefinedOptions extends WatchedOptions {
  /**
   * Triangles of the coarse surface on which the girth is computed exactly first, from 4 on; never more than a quarter
   * of the surface's. Default: 10,000.
   */
  coarseFaces?: number;
  /** Vertices, drawn at random, that are computed exactly at the end and compared, from 0 on. Default: 200. */
  audit?: number;
  /** Which ones: the same whole number, from 0 on, draws the same. Default: 1. */
  seed?: number;
}

/**
 * The girth of a large surface at all its vertices. Each value is the length of a geodesic loop; NaN where none was
 * found. Wherever a field 'igf' is asked for, it serves.
 * @experimental
 */
export interface RefinedGirth extends Field {
  /**
   * How sure each value is, 0: proved, it is exact; 1: consistent with all neighbours; 2: suspect, since a neighbour
   * contradicts it or no loop was found. One per vertex.
   */
  states: Uint8Array;
  /** How the values compare with exact ones. The vertices of the audit are proved by it. */
  audit: GirthAudit;
  /** Triangles of the coarse surface; 0 where the surface is so small that everything was computed exactly. */
  coarseFaces: number;
  /** Triangles of the surface without its flat vertices, on which loops were looked for; 0: on all triangles. */
  leanFaces: number;
}

/** A field to write or to analyse. It need not have been computed by the kernel. */
export interface NamedField {
  /** A small letter, then letters, digits and underscores: 'part'. */
  name: string;
  /** One value per vertex of the surface; NaN where there is none. */
  values: Float64Array;
  /** As of {@link Field}: one per vertex, or empty. Default: empty. */
  kinds?: Uint8Array;
  /** As of {@link RefinedGirth}: one per vertex, or empty. Files but NPY have them as the column `state`. Default: empty. */
  states?: Uint8Array;
  /** As of {@link Field}; '' for plain numbers. */
  unit: string;
  /** How it was computed. Default: ''. */
  method?: string;
}

/** How limbs are measured. */
export interface LimbOptions extends WatchedOptions {
  /** Stations of a profile, 1 to 10,000. Default: 64. */
  stations?: number;
}

/** Where a field has one value (`level_curves.h`). */
export interface LevelCurve {
  /** Whether the last point equals the first. Otherwise it ends at the boundary, or where values are missing. */
  closed: boolean;
  /** Vertices and points of edges in order; it is straight between them. Lower values lie on the left. */
  points: SurfacePoint[];
  /** x, y, z of these points, relative to {@link MeshGeometry.origin}. */
  polyline: Float32Array;
}

/** Which necks are wanted. */
export interface NeckOptions extends WatchedOptions {
  /** The least prominence of a neck, in model units, from 0 on. Default: 0. */
  minProminence?: number;
}

/** The girth at one place of a path. */
export interface PathStation extends MeasuredStation {
  /** Another name of `point`. */
  place: SurfacePoint;
}

/** The girth along a path. */
export interface Profile {
  /** The length of the path, in model units. */
  length: number;
  /** In the order of their distances. */
  stations: PathStation[];
  /** x, y, z of the path's points, relative to {@link MeshGeometry.origin}. */
  polyline: Float32Array;
  /** The model's unit: 'metre' for glTF, '' where the file does not state it. */
  unit: string;
}

/** The axis of a limb or another tube: the line through the middles of the loops that are swept along it. */
export interface LimbAxis {
  /** The length of the axis, in model units. */
  length: number;
  /** In the order of their distances; none where no loop goes round. */
  loops: AxisLoop[];
  /** x, y, z of their middles, relative to {@link MeshGeometry.origin}: the axis, to draw. */
  polyline: Float32Array;
  /** The model's unit: 'metre' for glTF, '' where the file does not state it. */
  unit: string;
}

/** Where along a path the girth is wanted. */
export interface ProfileOptions extends WatchedOptions {
  /** At so many equal distances, both ends among them; 0: none, otherwise at least 2. Default: 100. */
  samples?: number;
  /** Also where the path crosses edges and passes vertices. Default: true. */
  crossings?: boolean;
}

/** How handles are searched for. */
export interface HandleOptions extends WatchedOptions {
  /**
   * Points of each component whose loops are compared at first, at least 1. Then loops are proven shortest, for about five
   * seconds (`Handle.mayBeShorterBy`). As many as it has vertices, or more: all of them, which proves all. Default: 32.
   */
  basePoints?: number;
}

/** A part of a surface that was cut. */
export interface CutPart extends PartMeasures {
  /** x, y, z of each vertex, in model units. */
  positions: Float64Array<ArrayBuffer>;
  /** Three vertices for each face. */
  indices: Uint32Array<ArrayBuffer>;
  /** For each vertex the vertex of the uncut surface that it is; 2³² − 1 for those that cutting has made. */
  vertices: Uint32Array<ArrayBuffer>;
  /** For each face the face of the uncut surface that it is a piece of; 2³² − 1 for those of caps. */
  faces: Uint32Array<ArrayBuffer>;
  /**
   * The older name of `boundaries`, until 2.0.
   * @deprecated
   */
  boundaryCount: number;
}

/** The parts of a surface that was cut. */
export interface Cut {
  /** The largest area first; one where the curves divide nothing. */
  parts: CutPart[];
}

/** How surfaces are cut. */
export interface CutOptions extends CallOptions {
  /** Closes the rims that cutting makes, with triangles of least area. Default: false. */
  cap?: boolean;
}

/**
 * Parts as files: GLB with a node for each, OBJ with an object for each, STL or PLY files, what they measure as JSON,
 * or as CSV the part of each face of the model's file.
 */
export type CutFormat = 'glb' | 'obj' | 'stl' | 'ply' | 'json' | 'csv';

/** Thresholds, and whether parts are smoothed. */
export interface PartOptions extends PartThresholds {
  /**
   * How much a vertex's neighbourhood weighs against its own values, at least 0. Default: 0, the plain
   * thresholds.
   */
  smoothing?: number;
}

/** The parts of a surface. */
export interface Parts {
  /** The kind of each vertex; 0: body, 1: tube, 2: plate, 3: unknown. */
  kinds: Uint8Array;
  /** The index into `parts` for each vertex. */
  partOf: Uint32Array;
  /** The parts, largest area first. */
  parts: Part[];
}

/** A part that a surface falls into at its necks, and what it is (`segments.h`). */
export interface Segment extends CutPart, MeasuredSegment {
  /** The tips whose apexes lie on it, by their numbers in {@link Tips.tips}, in rising order. */
  tips: number[];
}

/** A surface as divided at its necks. */
export interface Segments {
  /** The largest area first; one for each component where there are no necks. */
  segments: Segment[];
  /** For each face of the surface the index into `segments` of the one that has most of its area. */
  labels: Uint32Array;
  /** By which the kinds were told apart. */
  thresholds: PartThresholds;
  /** Indices into {@link Necks.necks} of those that were passed over, in rising order: they cross more prominent ones. */
  crossing: number[];
}

/** At which necks a surface is divided, and by what its segments are told apart. */
export interface SegmentOptions extends NeckOptions, Partial<PartOptions> {}

/** The least measures that a printer can make, in model units. */
export interface PrintLimits {
  /** The least diameter of a tube; 0: any. */
  tubeDiameter: number;
  /** The least thickness of a wall; 0: any. */
  wallThickness: number;
  /** The least distance of surfaces that face each other across empty space; 0: any. Default: 0. */
  gap?: number;
}

/** The fields that a check needs: `igf` where tubes are limited, `thickness` where walls are. */
export interface PrintFields {
  /** The girth. */
  igf?: Field;
  /** The medial thickness, by default options. */
  thickness?: Field;
}

/** The shortest loop at a point of the surface. */
export interface Loop extends MeasuredLoop {
  /** The model's unit: 'metre' for glTF, '' where the file does not state it. */
  unit: string;
}

/** Options of {@link Mesh.loop}. */
export interface LoopOptions extends CallOptions {
  /** As of {@link FieldOptions}: the first loop whose saddle lasts longer, in model units. Default: 0. */
  persistence?: number;
}

/** The saddles of the distance from a point. */
export interface Barcode extends MeasuredBarcode {
  /** The loop of each bar, where they were asked for; otherwise empty. */
  loops: Loop[];
  /** The model's unit: 'metre' for glTF, '' where the file does not state it. */
  unit: string;
}

/**
 * How far a barcode is computed.
 * @experimental
 */
export interface BarcodeOptions extends CallOptions {
  /** Up to which persistence it is wanted, in model units. Default: infinite. The less, the sooner. */
  maxPersistence?: number;
  /** No more bars than these, the first ones. Default: all. */
  maxSaddles?: number;
  /** With the loop of each. Default: false. */
  loops?: boolean;
}

/**
 * How far the barcodes of all vertices are computed.
 * @experimental
 */
export interface BarcodesOptions extends WatchedOptions {
  /** Up to which persistence they are wanted, in model units; finite. */
  maxPersistence: number;
}

/**
 * The saddles at all vertices, from which the persistent girth is read for any persistence up to
 * `maxPersistence`.
 * @experimental
 */
export interface Barcodes {
  /** In model units. */
  maxPersistence: number;
  /** The bars of vertex v are those from `offsets[v]` to before `offsets[v + 1]`. */
  offsets: Uint32Array;
  /** Birth and death of each bar in turn, in model units. */
  bars: Float64Array;
  /** One per vertex: the girth where no bar is long enough, in model units. */
  rest: Float64Array;
  /** One per vertex, as `kinds` of {@link Field}: 1: `rest` is that, 2: a lower bound. */
  restKinds: Uint8Array;
  /** The model's unit. */
  unit: string;
  /**
   * The field 'igf' with this persistence, the same bits as {@link Mesh.field}; linear in the vertices. Throws
   * USAGE unless it is above 0 and at most `maxPersistence`.
   */
  girth(persistence: number): Field;
}

/** A shortest path between two points of a surface, and how far they are apart in space. */
export interface SurfacePath extends MeasuredPath {
  /** Through space, as the crow flies. */
  straight: number;
  /** The model's unit: 'metre' for glTF, '' where the file does not state it. */
  unit: string;
}

/** A connected component of what was read, kept or not. */
export interface MeshPart {
  /** Number of its faces. */
  faceCount: number;
  /** Its area, in squared model units. */
  area: number;
}

/** A model that was passed over. */
export interface UnreadableModel {
  /** One of {@link MeshInfo.models}. */
  model: string;
  /** Why it cannot be read. */
  error: GirthErrorFields;
}

/** Facts about a mesh and the file that it comes from. */
export interface MeshInfo {
  /** The file's name without folders; '' for arrays. */
  name: string;
  /** Paths of all models among the files that were given, including this one. */
  models: string[];
  /** Entries of `models` that were tried before this one and cannot be read. */
  unreadable: UnreadableModel[];
  /** The file's format. */
  format: 'GLB' | 'glTF' | 'OBJ' | 'PLY' | 'STL' | 'OFF' | 'arrays';
  /** Vertices of the surface. */
  vertexCount: number;
  /** Faces of the surface. */
  faceCount: number;
  /** Edges of the surface. */
  edgeCount: number;
  /** Connected components of the surface. */
  components: number;
  /** Genus of each component. */
  genus: number[];
  /** Number of boundary curves of each component. */
  boundaries: number[];
  /** Area of the surface, in squared model units. */
  area: number;
  /** Extent along x, y and z, in model units. */
  size: [number, number, number];
  /**
   * The model's unit: 'metre' for glTF, what a comment states, such as 'millimetre', in other files of Girth, '' where the file does
   * not state it, as a GLB of Girth may.
   */
  unit: string;
  /** The changes that were made to the input. */
  report: PreparationReport;
  /** Remarks on the file, a sentence each: 'skinned: shown in its bind pose'. */
  notes: string[];
  /** All components, kept or not, numbered by their first face of the input. */
  parts: MeshPart[];
}

/**
 * The surface to draw and pick on. Do not modify the arrays.
 *
 * Positions, and the points of loops and contours, are relative to `origin`. It is 0, 0, 0, except for
 * surfaces that lie more than 64 times their size away from the origin of their coordinates, where 32-bit
 * numbers would draw steps. Add it to obtain the file's coordinates.
 */
export interface MeshGeometry {
  /** x, y, z of each vertex, relative to `origin`, in model units. */
  positions: Float32Array;
  /** Three vertices of each face. */
  indices: Uint32Array;
  /** Two vertices of each edge of the boundary; empty where the surface is closed. */
  boundary: Uint32Array;
  /** The point that positions are relative to, in the file's coordinates. */
  origin: readonly [number, number, number];
}

/** Files that a surface can be written as. */
export type ModelFormat = 'obj' | 'ply' | 'stl' | 'off' | 'glb';

/** Files that a field can be written as. */
export type FieldFormat = 'csv' | 'json' | 'npy' | 'ply' | 'glb';

/** Files that loops can be written as. */
export type LoopFormat = 'obj' | 'glb' | 'json';

/** Options of {@link Mesh.maxima}. */
export interface MaximaOptions extends CallOptions {
  /** Finds the minima instead. Default: false. */
  minima?: boolean;
}

/**
 * A prepared surface, and what can be asked of it.
 *
 * Every promise is rejected with a {@link GirthError}: CANCELLED when its signal fires, when the mesh or the
 * kernel is disposed of; OUT_OF_MEMORY; INTERNAL for faults of the package; and the codes that are named
 * with each method. A field that is handed over must be of this mesh: otherwise the code is USAGE.
 */
export interface Mesh extends Analyses {
  /** Facts about it. */
  readonly info: MeshInfo;
  /** The surface to draw and pick on. */
  readonly geometry: MeshGeometry;
  /** The surface's vertex for each vertex of the input; 0xFFFFFFFF where there is none. */
  readonly vertexOfInput: Uint32Array;
  /**
   * Computes a field. Fields are computed one after the other, each by all workers. Errors: USAGE for a
   * name that no field has; INVALID_OPTION for an option that is out of its range.
   */
  field(name: FieldName, options?: FieldOptions): Promise<Field>;
  /**
   * Computes the girth at all vertices of a large surface, from some 20,000 triangles on, in a fraction of the time that
   * `field('igf')` takes: nearly all values are the same, and it says how sure each of them is (`refined_girth.h`). There
   * are no partial values. It waits for its turn among the fields; by a pool of workers it takes one of them, beside the
   * fields. Memory: 4 bytes for each edge that the loop of a vertex crosses, some 800 bytes for each vertex, and 15 to 60 MB for each thread. Errors:
   * INVALID_OPTION for an option that is out of its range; OUT_OF_MEMORY.
   * @experimental
   */
  refinedGirth(options?: RefinedOptions): Promise<RefinedGirth>;
  /**
   * Finds the loop at a vertex or at a point of a face. It is answered at once, also while a field is
   * computed; of several requests the latest goes first. Errors: VERTEX_OUT_OF_RANGE, INVALID_POINT,
   * INVALID_OPTION.
   */
  loop(point: SurfacePoint, options?: LoopOptions): Promise<Loop>;
  /**
   * Finds the saddles of the distance from a point, and how long each lasts; answered as {@link Mesh.loop} is.
   * Errors: VERTEX_OUT_OF_RANGE, INVALID_POINT; INVALID_OPTION where `maxPersistence` is negative or NaN.
   * @experimental
   */
  barcode(point: SurfacePoint, options?: BarcodeOptions): Promise<Barcode>;
  /**
   * Finds the saddles at all vertices, in the order of fields and by all workers. Errors: INVALID_OPTION where
   * `maxPersistence` is negative or not finite.
   * @experimental
   */
  barcodes(options: BarcodesOptions): Promise<Barcodes>;
  /**
   * Finds a shortest path from one point to another (`geodesic_solver.h`). Errors: VERTEX_OUT_OF_RANGE,
   * INVALID_POINT; LIMIT_EXCEEDED where it would take more than 67 million windows, or n^1.5 of n faces, which is more
   * from 165,000 on.
   */
  path(from: SurfacePoint, to: SurfacePoint, options?: CallOptions): Promise<SurfacePath>;
  /**
   * Writes the surface as it was prepared, without values (`write_mesh.h`): OBJ, OFF and PLY with all digits, STL and
   * GLB with positions rounded to 32 bits. Errors: USAGE for another format; LIMIT_EXCEEDED where a GLB would pass 4 GB.
   */
  exportModel(format: ModelFormat, options?: ExportOptions): Promise<Uint8Array>;
  /**
   * Writes a field as a file: CSV, JSON and NPY in the order of the input's vertices, PLY and GLB as the
   * surface with its values (`write_field.h`). Lengths are labelled with `unit`; by default with the
   * field's unit where it is a length, and with the model's otherwise. Errors: LIMIT_EXCEEDED where a GLB
   * would pass 4 GB.
   */
  exportField(field: Field, format: FieldFormat, options?: ExportOptions): Promise<Uint8Array>;
  /**
   * Writes several fields as one file, columns in their order. Errors: USAGE for a name that no column can
   * have, and for several fields in NPY, which holds one; LIMIT_EXCEEDED as above.
   */
  exportFields(
    fields: readonly NamedField[],
    format: FieldFormat,
    options?: ExportOptions,
  ): Promise<Uint8Array>;
  /**
   * Writes the loops at some points, a file for each (`write_loop.h`). Errors: VERTEX_OUT_OF_RANGE,
   * INVALID_POINT; EMPTY_MESH where a loop is unresolved and the format is GLB.
   */
  exportLoops(
    points: readonly SurfacePoint[],
    format: LoopFormat,
    options?: ExportOptions & LoopOptions,
  ): Promise<Uint8Array[]>;
  /**
   * Computes the area that each vertex stands for, in squared model units; distributions are weighted by
   * it (`vertex_areas.h`). The areas add up to `info.area`.
   */
  vertexAreas(options?: CallOptions): Promise<Float64Array>;
  /** Finds the tips by the girth. `igf` is the field of that name. */
  tips(igf: Field, options?: CallOptions): Promise<Tips>;
  /**
   * Finds the limbs that the tips end, and how thick they are all along. `igf` is the field of that name.
   * Errors: INVALID_OPTION; LIMIT_EXCEEDED where distances take too many windows.
   */
  limbs(igf: Field, options?: LimbOptions): Promise<Limbs>;
  /**
   * Finds the places that are narrower than all around them (`findNecks`). `igf` is the field of that name.
   * Errors: INVALID_OPTION.
   *
   * @experimental
   */
  necks(igf: Field, options?: NeckOptions): Promise<Necks>;
  /**
   * Finds the narrowest place on the widest way from one point to another (`findBottleneck`). `igf` is the field of
   * that name, without persistence. Errors: VERTEX_OUT_OF_RANGE; INVALID_POINT, also where no way leads from one to the
   * other.
   *
   * @experimental
   */
  bottleneck(
    igf: Field,
    from: SurfacePoint,
    to: SurfacePoint,
    options?: WatchedOptions,
  ): Promise<Bottleneck>;
  /**
   * Measures the girth along the shortest path between two points, or along a drawn path: more points in order, each
   * joined to the next by a shortest path (`girthAlong`). Nothing is interpolated. Errors: USAGE for fewer points;
   * VERTEX_OUT_OF_RANGE; INVALID_POINT, also where they lie in different components; INVALID_OPTION; LIMIT_EXCEEDED as
   * of {@link Mesh.path}.
   *
   * @experimental
   */
  profile(points: readonly SurfacePoint[], options?: ProfileOptions): Promise<Profile>;
  /**
   * Measures the girth along the axis of a limb of this mesh (of {@link Mesh.limbs}), or of another tube (`limbAxis`):
   * by as many loops as loops go round at its stations. Stations as `girth profile --limb` gives them without
   * `--samples` need limbs of 100 stations. Errors: VERTEX_OUT_OF_RANGE and INVALID_POINT where its stations are not of
   * this mesh.
   *
   * @experimental
   */
  axis(limb: Pick<Limb, 'profile'>, options?: WatchedOptions): Promise<LimbAxis>;
  /**
   * Writes a profile or an axis as a file, as `girth profile` does: a row for each place, or everything; the loops of an
   * axis also as lines. Points are measured first, as by {@link Mesh.profile}, with the same errors; what has been
   * measured is written as it is. Errors: USAGE for OBJ and GLB unless it is an axis; VERTEX_OUT_OF_RANGE and
   * INVALID_POINT where it is not of this mesh; LIMIT_EXCEEDED where a GLB would pass 4 GB.
   *
   * @experimental
   */
  exportProfile(
    points: readonly SurfacePoint[],
    format: 'csv' | 'json',
    options?: ExportOptions & ProfileOptions,
  ): Promise<Uint8Array>;
  /**
   * Writes a profile that has been measured, as it is.
   *
   * @experimental
   */
  exportProfile(
    profile: Profile,
    format: 'csv' | 'json',
    options?: ExportOptions,
  ): Promise<Uint8Array>;
  /**
   * Writes an axis that has been measured, as it is.
   *
   * @experimental
   */
  exportProfile(
    axis: LimbAxis,
    format: 'csv' | 'json' | 'obj' | 'glb',
    options?: ExportOptions,
  ): Promise<Uint8Array>;
  /**
   * Finds short loops round the surface's handles and through its holes (`findHandles`). Errors: INVALID_OPTION.
   *
   * @experimental
   */
  handles(options?: HandleOptions): Promise<Handles>;
  /**
   * Makes a surface without the handles and tunnels whose loops are shorter than a length, in model units: each is cut,
   * and both rims are closed (`removeHandles`). Its input, as files and `vertexOfInput` count it, are its own vertices.
   * Errors: INVALID_OPTION where the length is negative or NaN.
   *
   * @experimental
   */
  removeHandles(length: number, options?: HandleOptions): Promise<RepairedMesh>;
  /**
   * Finds the curves where a field has one value, linear between vertices (`levelCurves`); those that end at the boundary
   * come first. None where the field does not pass the value. Errors: USAGE where the field has not one value for each
   * vertex; INVALID_OPTION where the value is not finite.
   *
   * @experimental
   */
  levelCurves(field: NamedField, value: number, options?: CallOptions): Promise<LevelCurve[]>;
  /**
   * Cuts the surface exactly along curves: `points` of necks, handles, loops and level curves, or others whose neighbours
   * lie in one face, closed where the last one equals the first (`cutSurface`). The surface itself stays as it is. Errors:
   * VERTEX_OUT_OF_RANGE; INVALID_POINT where two neighbours lie in no common face; INVALID_OPTION where curves cross.
   *
   * @experimental
   */
  cut(curves: readonly (readonly SurfacePoint[])[], options?: CutOptions): Promise<Cut>;
  /**
   * Cuts the surface and writes the parts: one file, or one for each part where the format is 'stl' or 'ply'. GLB, OBJ
   * and PLY keep the colours and other values that the model's file gives its vertices, as `girth cut` does. Errors are
   * the same, and LIMIT_EXCEEDED where a GLB would pass 4 GB.
   *
   * @experimental
   */
  exportCut(
    curves: readonly (readonly SurfacePoint[])[],
    format: CutFormat,
    options?: ExportOptions & CutOptions,
  ): Promise<Uint8Array[]>;
  /**
   * Divides the surface at its necks (`cutAtNecks`), and says of each part what it is and which tips end on it
   * (`segmentsOf`). `igf` and `sdf` are the fields of these names. Where necks cross, the most prominent counts;
   * thresholds that are not given are the suggested ones. Errors: INVALID_OPTION for `minProminence`; USAGE where a
   * threshold or the smoothing is negative or NaN.
   *
   * @experimental
   */
  segments(igf: Field, sdf: Field, options?: SegmentOptions): Promise<Segments>;
  /**
   * Finds the same and writes it as a file, as `girth segments` does (`write_segments.h`): CSV and JSON have a label for
   * each face of the model's file, GLB a node for each segment. Errors are the same, and LIMIT_EXCEEDED where a GLB
   * would pass 4 GB.
   *
   * @experimental
   */
  exportSegments(
    igf: Field,
    sdf: Field,
    format: 'csv' | 'json' | 'glb',
    options?: ExportOptions & SegmentOptions,
  ): Promise<Uint8Array>;
  /**
   * Suggests thresholds to start from; both are 0 where no vertex has both values. `igf` and `sdf` are the
   * fields of these names, here and below.
   */
  suggestedThresholds(igf: Field, sdf: Field, options?: CallOptions): Promise<PartThresholds>;
  /** Finds tubes, plates and body. Errors: USAGE where a threshold or the smoothing is negative or NaN. */
  parts(igf: Field, sdf: Field, parts: PartOptions, options?: CallOptions): Promise<Parts>;
  /**
   * Finds what is too thin to print or too close together, and the scale from which on nothing is. Errors: USAGE
   * where a limit is negative or NaN, or a field that it needs is missing; NO_THICKNESS where walls are to be
   * checked but no vertex has a thickness, or walls or gaps and the surface is inside out.
   */
  printCheck(
    fields: PrintFields,
    limits: PrintLimits,
    options?: WatchedOptions,
  ): Promise<PrintCheck>;
  /** Finds the maxima of a field along the surface's edges, or its minima, most persistent first. */
  maxima(field: NamedField, options?: MaximaOptions): Promise<Maximum[]>;
  /**
   * Finds where heat stays longest, most persistent first (`heat_maxima.h`): what the paper compares tips
   * with. `component` has no effect. Errors: INVALID_OPTION.
   * @experimental
   */
  heatMaxima(options?: WatchedOptions & SpectralOptions): Promise<Maximum[]>;
  /**
   * Writes a result of this mesh as a file, as the command of its name does: `girth necks -o necks.glb`. Nothing is
   * searched for again. Tips, parts, print checks and segments are the very objects that this mesh gave; others may be
   * made of those, such as the necks of a list that matter. Errors: USAGE for an object that is no result, or not of
   * this mesh, and for another format; VERTEX_OUT_OF_RANGE and INVALID_POINT where it is not on this mesh;
   * LIMIT_EXCEEDED where a GLB would pass 4 GB.
   *
   * @experimental
   */
  write<Found extends object>(
    found: Found,
    format: FormatOf<Found>,
    options?: WriteOptions,
  ): Promise<Uint8Array>;
  /** Writes the tips as a file (`write_tips.h`): JSON, or the contours as lines of OBJ. */
  exportTips(igf: Field, format: 'json' | 'obj', options?: ExportOptions): Promise<Uint8Array>;
  /** Writes the limbs as a file (`write_limbs.h`). Errors: as of {@link Mesh.limbs}. */
  exportLimbs(
    igf: Field,
    format: 'json' | 'csv',
    options?: ExportOptions & LimbOptions,
  ): Promise<Uint8Array>;
  /** Writes the parts as a file (`write_parts.h`). Errors: as of {@link Mesh.parts}. */
  exportParts(
    igf: Field,
    sdf: Field,
    parts: PartOptions,
    format: 'json',
    options?: ExportOptions,
  ): Promise<Uint8Array>;
  /** Writes the weak places as a file (`write_parts.h`). Errors: as of {@link Mesh.printCheck}. */
  exportWeakPlaces(
    fields: PrintFields,
    limits: PrintLimits,
    format: 'json',
    options?: ExportOptions,
  ): Promise<Uint8Array>;
  /**
   * Makes a surface of about `faces` faces, from 4 to 100 million, with the same components, genus and
   * boundary curves (`remesh.h`). Its input, as files and `vertexOfInput` count it, are its own vertices.
   * Errors: INVALID_OPTION.
   */
  remesh(faces: number, options?: RemeshOptions): Promise<RemeshedMesh>;
  /**
   * Makes a surface with the same triangles whose vertices have moved, so that wrinkles about as long as an edge
   * are gone and limbs are as thick as before: rough scans are smoothed before they are compared. `steps`: 0 to
   * 100; three do for noise of half an edge (`smooth_surface.h`). Vertices and faces keep their numbers. Errors:
   * INVALID_OPTION; DEGENERATE_FACE where a face loses its area.
   */
  smooth(steps: number, options?: WatchedOptions): Promise<Mesh>;
  /**
   * Measures how far a field is from one on another mesh, whatever their sizes: equation (1) of the paper,
   * from 0 (`field_difference.h`). Each field is one of its mesh.
   * @experimental
   */
  difference(field: Field, other: Mesh, otherField: Field, options?: CallOptions): Promise<number>;
  /** Stops its work and frees its memory. Calls that are under way fail with CANCELLED. */
  dispose(): void;
  /** Disposes of it at the end of a block: `using mesh = await kernel.load(source)`. */
  [Symbol.dispose](): void;
}

/** A mesh that lies where another one does, with other faces. */
export interface RemeshedMesh extends Mesh {
  /**
   * Carries values at its vertices, one each, to the vertices of the mesh that it was made of. Errors:
   * USAGE where the values are not as many as its vertices; CANCELLED also when either mesh is disposed of.
   */
  carryBack(values: Float64Array, options?: CallOptions): Promise<Float64Array>;
  /**
   * Carries a field of its own, with its kinds, in the same way: what `girth igf --faces` does. Kinds are those of the
   * nearest vertices; the method says how many faces it was computed on (`exact on 2000 faces`). Errors are the same.
   */
  carryField(field: Field, options?: CallOptions): Promise<Field>;
}

/** A mesh without the small handles of the one that it was made of. */
export interface RepairedMesh extends Mesh {
  /** The account of the removal. */
  readonly removal: HandleRemoval;
}

/**
 * How shapes are compared.
 * @experimental
 */
export interface CompareOptions extends WatchedOptions {
  /**
   * The descriptors to compare by (`signatures.h`): 'igf', 'igf-ms', 'sdf', 'geoaverage', 'geofarthest' (each also
   * with 'log-' before it, for the logarithm), 'hks', 'sihks', 'wks', 'igf-sdf', and sums such as
   * '2*igf+sdf'.
   */
  descriptors: readonly string[];
  /** Surfaces of more faces are remeshed to about so many; 0: none is. Default: 10,000. */
  faces?: number;
  /** Steps of smoothing after that, 0 to 100, as of {@link Mesh.smooth}: three for rough scans. Default: 0. */
  smooth?: number;
}

/**
 * The distances between shapes by one descriptor.
 * @experimental
 */
export interface DistanceMatrix {
  /** The descriptor, as it was asked for. */
  descriptor: string;
  /**
   * The distance of shapes i and j, each scaled to area 1, is `distances[i * shapes + j]`; NaN where one
   * of them has no value or has failed.
   */
  distances: Float64Array;
}

/**
 * A shape that could not be compared.
 * @experimental
 */
export interface FailedShape {
  /** Its index among the meshes. */
  shape: number;
  /** Why its fields could not be computed. */
  error: GirthErrorFields;
}

/**
 * Shapes compared.
 * @experimental
 */
export interface Comparison {
  /** The distances, in the order of the descriptors. */
  matrices: DistanceMatrix[];
  /** The shapes whose fields could not be computed. */
  failed: FailedShape[];
}

/** Loads meshes and computes on them, in workers. */
export interface Kernel {
  /** Whether fields are computed by threads or by a pool of workers. */
  readonly mode: 'threads' | 'pool';
  /** Number of threads, or of workers of the pool. */
  readonly threads: number;
  /**
   * Measures how far shapes are apart. Results that were computed of a mesh are kept as long as the mesh. Errors: USAGE
   * for a descriptor that does not exist or a mesh of another package; where all meshes fail, the error of the first
   * one; CANCELLED also when one of the meshes is disposed of.
   * @experimental
   */
  compare(meshes: readonly Mesh[], options: CompareOptions): Promise<Comparison>;
  /**
   * Reads, prepares and checks a model, in a worker of its own. Errors: FILE_NOT_FOUND, FILE_UNREADABLE
   * and those of reading (`read_mesh.h`) and preparing (`prepare_surface.h`); CANCELLED.
   */
  load(source: MeshSource, options?: LoadOptions): Promise<Mesh>;
  /**
   * Ends all workers. Calls that are under way fail with CANCELLED. A process of Node.js ends without it too: a kernel
   * keeps it alive only while something that was asked for is not done.
   */
  dispose(): void;
  /** Disposes of it at the end of a block: `using kernel = await createKernel()`. */
  [Symbol.dispose](): void;
}
