// Made of the headers in cpp/include/girth by `npm run build:tables`: not to be edited.

import type { SurfacePoint } from './points.js';

/**
 * The kind of the narrowest place of the widest way (web/docs/definitions.md, section 5).
 *
 * - `'neck'`: A neck between the points: its loop is a closed geodesic, shorter than every other closed curve near it.
 * - `'pass'`: A place between them whose loop can be made shorter by moving it to one side.
 * - `'end'`: One of the two points: there is no neck between them.
 */
export type BottleneckKind = 'neck' | 'pass' | 'end';

/**
 * How the shortest loop came about (paper, section 3.1, figure 1).
 *
 * - `'loop'`: The frontier of the growing geodesic disk touched itself head-on: a loop around the surface.
 * - `'antipodal'`: The frontier vanished at one farthest point without a loop before: the "loop" is out and back again.
 * - `'unresolved'`: The budget was met first. The length is a lower bound, and `atMost` one from above.
 */
export type LoopKind = 'loop' | 'antipodal' | 'unresolved';

/**
 * On which side of its component a loop bounds a surface (web/docs/definitions.md, section 5).
 *
 * - `'handle'`: inside: it goes round the material
 * - `'tunnel'`: outside: it goes round a hole
 * - `'unknown'`: the component has no inside: it, or what closes its holes, crosses it
 */
export type HandleKind = 'handle' | 'tunnel' | 'unknown';

/**
 * How a landmark is measured.
 *
 * - `'girth'`: the length of the girth loop
 * - `'section'`: the perimeter of the curve of a plane through the point
 * - `'tape'`: the tape of that curve
 * - `'distance'`: the distance to another point, along the surface
 */
export type MeasureKind = 'girth' | 'section' | 'tape' | 'distance';

/**
 * Why a limb ends where it does (web/docs/definitions.md, section 5).
 *
 * - `'spreads'`: It spreads into a thicker part: beyond, the ring grows by more than π times the distance.
 * - `'slips'`: Beyond, the loops at half of the ring's points have slipped off: they go round other parts.
 * - `'splits'`: The ring falls apart into two, each round a part that is deeper than the limb is thick; or the loops slip over the place, less than half a loop beyond, where it does.
 * - `'handle'`: The ring meets itself round a handle, or the loops slip over the place where it does.
 * - `'boundary'`: The ring reaches the boundary of the surface.
 * - `'whole'`: Never: the limb is its whole component, as of a spindle.
 */
export type LimbEnd = 'spreads' | 'slips' | 'splits' | 'handle' | 'boundary' | 'whole';

/**
 * The kind of a place of a shape (paper, section 6.3).
 *
 * - `'body'`: thick
 * - `'tube'`: thin, and a short loop goes round it
 * - `'plate'`: thin, but no short loop goes round it
 * - `'unknown'`: its girth or its shape diameter has no value
 */
export type PartKind = 'body' | 'tube' | 'plate' | 'unknown';

/**
 * The fault of a place.
 *
 * - `'tube'`: a tube's diameter
 * - `'wall'`: a wall's thickness
 * - `'gap'`: the clearance
 */
export type WeakKind = 'tube' | 'wall' | 'gap';

/**
 * Why a measure below a limit belongs to no wall and no gap.
 *
 * - `'crease'`: faces run into each other, or end in a lip of an eighth of the limit
 * - `'rounding'`: faces touch, to the rounding of coordinates in single precision
 * - `'sliver'`: a triangle is so low that rounding alone decides where it faces
 */
export type CreaseKind = 'crease' | 'rounding' | 'sliver';

/**
 * The curves than which none is shorter (web/docs/definitions.md, section 5).
 *
 * - `'shortest'`: all curves of the homotopy class, with the same ends
 * - `'local'`: all curves that it can be moved to without passing over a convex vertex
 * - `'shorter'`: unknown: it was given up after too many steps, and is only no longer
 */
export type TightPromise = 'shortest' | 'local' | 'shorter';

/**
 * The shape of a curve that is drawn tight.
 *
 * - `'path'`: it joins two ends, which stay
 * - `'loop'`: it is closed
 * - `'point'`: it contracts to a point: it bounds a disk that it slips off
 */
export type TightKind = 'path' | 'loop' | 'point';

/**
 * Whether a tube is narrow or wide at a place.
 *
 * - `'narrowing'`: narrower than on both sides: a stenosis
 * - `'widening'`: wider than on both sides: a bulge, an aneurysm
 */
export type TubeChange = 'narrowing' | 'widening';

/**
 * Why a component is no tube.
 *
 * - `'handle'`: it has a handle: centrelines would run in a circle
 * - `'blunt'`: it is less than 2.5 times as long as wide, as a ball is
 * - `'flat'`: it is more than four times as wide as thick, as a plate is
 * - `'coarse'`: no section perpendicular to its line is closed
 */
export type NoTube = 'handle' | 'blunt' | 'flat' | 'coarse';

/**
 * A saddle of the distance from p: where the growing disk touches itself, and what it cuts off begins
 * to be filled.
 *
 * @experimental
 */
export interface SaddleBar {
  /** Its distance from p, in model units: half the length of its loop. */
  birth: number;
  /**
   * The distance at which one of the two parts that the loop cuts off is filled, in model units, by the
   * elder rule; infinite where the loop cuts nothing off, or neither part is filled up to `birth +
   * maxPersistence`.
   */
  death: number;
}

/**
 * The saddles of the distance from a point, by their distance.
 *
 * @experimental
 */
export interface MeasuredBarcode {
  /** Persistence is known up to this, in model units. */
  maxPersistence: number;
  /**
   * I_tau where no bar lasts longer than tau: twice the greatest distance, antipodal, if all saddles are
   * listed; otherwise unresolved, and no I_tau of that kind is less than its length.
   */
  rest: GirthValue;
  /**
   * In the order of their births. The last one may last longer than `maxPersistence`: then it is the
   * first that does, and none beyond it is listed. Saddles that last no longer than rounding can tell, a
   * share of 4e-9, are left out.
   */
  bars: SaddleBar[];
  /** The loop of each bar, where loops were asked for; otherwise empty. */
  loops: MeasuredLoop[];
}

/**
 * The bottleneck between two points.
 *
 * @experimental
 */
export interface Bottleneck {
  /** A neck, a pass, or an end. */
  kind: BottleneckKind;
  /** The least girth on the widest way, in model units: the length of its loop. */
  girth: number;
  /** Where on the way the girth is least. */
  place: SurfacePoint;
  /**
   * Mean of the loop's points, each part counted by its length, in model units; zero where there is no
   * loop.
   */
  centre: [number, number, number];
  /** The area that the loop encloses in its mean plane, in squared model units. */
  area: number;
  /** The sides of a neck, as `Neck.sides`; empty for other kinds. */
  sides: LoopSide[];
  /**
   * The loop: of a neck the closed geodesic itself (of a band of parallel ones that in the middle),
   * otherwise the loop of the girth at `place`, empty where that is unresolved. As `Loop.points`; the
   * last point equals the first.
   */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
  /**
   * The way that was found, from the first point to the second, along the pieces of the mesh's edges: it
   * is a witness of the girth, and not short.
   */
  way: SurfacePoint[];
}

/** One of the pieces into which a closed curve separates a component. */
export interface LoopSide {
  /** In squared model units. */
  area: number;
  /**
   * Enclosed by this side and the cone over the curve from the mean of its points, in cubed model units:
   * negative where the surface faces inwards. NaN where the side has a boundary.
   */
  volume: number;
}

/** Measures of a part of a surface. */
export interface PartMeasures {
  /** In squared model units. */
  area: number;
  /** Enclosed, in cubed model units; NaN where the part has a boundary. */
  volume: number;
  /** Handles, those of its cavities among them. */
  genus: number;
  /** Boundary curves. */
  boundaries: number;
}

/**
 * The distance between two points.
 *
 * @experimental
 */
export interface Distance {
  /** The first point. */
  start: SurfacePoint;
  /** The second point. */
  end: SurfacePoint;
  /**
   * Length of a shortest path along the surface, in model units; infinite where the points lie in
   * different components.
   */
  length: number;
  /** Length of the straight line between them, in model units. */
  straight: number;
  /**
   * The path: the edges crossed and vertices passed in order. Between neighbours it is straight inside
   * one face or along one edge. Empty where paths were not asked for, or there is none.
   */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * Distances between pairs of points.
 *
 * @experimental
 */
export interface Distances {
  /** In the order of the pairs. */
  distances: Distance[];
}

/** A shortest path between two points of a surface. */
export interface MeasuredPath {
  /** In model units; infinite where the points lie in different components. */
  length: number;
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * The girth at one distance: along a ring, a closed curve that goes round the surface there.
 */
export interface GirthStation {
  /** How far along, in model units. */
  distance: number;
  /** Length of the ring itself, in model units. */
  ring: number;
  /**
   * The median of the girth over the ring, each part of it counted by its length, in model units; NaN
   * where no part has a value.
   */
  median: number;
  /**
   * The least girth on the ring among loops that go round here, in model units; NaN where none does.
   */
  least: number;
  /**
   * Where it is: a point of an edge. `Mesh.loop` gives the loop there. Only where `least` is a number.
   */
  place?: SurfacePoint;
}

/** The girth at a point. */
export interface GirthValue {
  /** I(p), in model units; where unresolved, no more than I(p). */
  length: number;
  /** How it came about. */
  kind: LoopKind;
}

/** The shortest geodesic loop based at a point. */
export interface MeasuredLoop {
  /** The point p where the loop starts and ends. */
  base: SurfacePoint;
  /** I(p), in model units; where unresolved, no more than I(p). */
  length: number;
  /** How it came about. */
  kind: LoopKind;
  /**
   * Angle at p between the loop's two ends, inside the surface, on the smaller side, in radians. At
   * least π: the loop is a closed geodesic. 0: antipodal.
   */
  angle: number;
  /**
   * The loop's point farthest from p: length / 2 from p both ways, and both are shortest. x, y, z,
   * relative to `MeshGeometry.origin`.
   */
  midpoint: [number, number, number];
  /**
   * The loop from p round to p: p, the edges it crosses and vertices it passes in order, p. Between
   * neighbours it is straight inside one face or along one edge. An antipodal loop runs to `midpoint`
   * and back the same way, and there the midpoint is one of the points. Empty where unresolved. Surfaces
   * are cut along those of the kind Loop.
   */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * A closed geodesic round a handle or a tunnel.
 *
 * @experimental
 */
export interface Handle {
  /** In model units. */
  length: number;
  /** Round the material, or round a hole. */
  kind: HandleKind;
  /**
   * How much shorter a loop in its place may be, at most, in model units: one of its kind and component
   * that is no sum of the shorter ones listed. 0: none is, which is proven to a share of 1e-9.
   */
  mayBeShorterBy: number;
  /** The number of its component of the surface, from 0. */
  component: number;
  /** The area that the loop encloses in its mean plane, in squared model units. */
  area: number;
  /** Mean of the loop's points, each part counted by its length, in model units. */
  centre: [number, number, number];
  /**
   * The edges it crosses and the vertices it passes in order; the last point equals the first. Between
   * neighbours it is straight inside one face or along one edge. Among parallel loops in a band, it is
   * the one in the middle.
   */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * The handles of a surface.
 *
 * @experimental
 */
export interface Handles {
  /** Handles and tunnels that the genus promises and that were not found. */
  unresolved: number;
  /** The shortest first. */
  handles: Handle[];
}

/**
 * A measure at a landmark.
 *
 * @experimental
 */
export interface NamedMeasure {
  /** The name of the landmark. */
  name: string;
  /** How it was measured. */
  how: MeasureKind;
  /** The point of the landmark. */
  point: SurfacePoint;
  /** The measure, in model units; infinite for a distance that has no path. */
  length: number;
  /** The curve that was measured; of all curves of a plane none. */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * Measures at landmarks.
 *
 * @experimental
 */
export interface NamedMeasures {
  /** In the order of the landmarks. */
  measures: NamedMeasure[];
}

/**
 * One of the loops that are swept along a tube.
 *
 * @experimental
 */
export interface AxisLoop {
  /** Along the axis from its first point, in model units. */
  distance: number;
  /**
   * Over the surface: how far along the first station is, and on along the path, in model units.
   */
  along: number;
  /** The loop's length, in model units. */
  girth: number;
  /** The area that the loop encloses in its mean plane, in squared model units. */
  area: number;
  /** A point of the axis: the mean of the loop's points, each part counted by its length. */
  centre: [number, number, number];
  /** The loop, as `Loop.points`; the last point equals the first. */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * A finger, an arm, a leg: what lies between a tip's apex and the ring of points at `length` from it.
 */
export interface Limb {
  /** Distance from the apex to the ring at its base, along the surface, in model units. */
  length: number;
  /**
   * The least girth of loops round the limb, from the end of its cap to the base, in model units: of the
   * shortest neck, otherwise on the ring at one of these ends, or where loops slip off between them. The
   * cap ends at `middle` / π from the apex, as far as the limb is thick, or where the tip's contour is,
   * if that is farther. Exact, but not proven to be least between two stations. NaN where there is none.
   */
  narrowest: number;
  /**
   * How far from the apex it is, in model units: its ring, of equal ones the nearest, or the mean
   * distance of the neck; NaN where there is none.
   */
  narrowestDistance: number;
  /**
   * The middle one of the stations' medians, of those where a loop goes round the limb, in model units:
   * along half of the limb the girth is less.
   */
  median: number;
  /**
   * The least girth on the ring at half of `length`, in model units; NaN where no loop goes round the
   * limb there.
   */
  middle: number;
  /** The least girth at the base, in model units; NaN for a limb that is its whole component. */
  base: number;
  /** Why it ends there. */
  end: LimbEnd;
  /**
   * The tips that it ends in, by their numbers in the list that was handed over; the first is the one
   * with this apex. Several where the distances from each of their apexes give the same limb.
   */
  tips: number[];
  /** Where it begins: the apex of a tip. */
  apex: number;
  /** The vertices that the ring at the base cuts off, in rising order. */
  vertices: Uint32Array;
  /** Their distances from the apex, in model units. */
  distances: Float64Array;
  /** From near the apex to the base, at equal distances; the last station is the base. */
  profile: GirthStation[];
}

/** The limbs of a surface. */
export interface Limbs {
  /** Longest first. */
  limbs: Limb[];
  /**
   * Numbers of the tips that end no limb, in rising order: what they end is nowhere longer than it is
   * thick, no loop goes round it, or it is a whole component beside a limb that has a base.
   */
  tipsWithoutLimb: number[];
}

/**
 * A closed geodesic that is shorter than every other closed curve near it (web/docs/definitions.md,
 * section 5).
 */
export interface Neck {
  /** In model units. */
  length: number;
  /**
   * How far the girth must rise, at least, on the way over the surface from here to a narrower neck, in
   * model units; infinite where no narrower one can be reached. See findNecks for what it is measured
   * on.
   */
  prominence: number;
  /**
   * Width of the band of parallel loops of the same length, in model units: 0 for a single one.
   */
  width: number;
  /** The area that the loop encloses in its mean plane, in squared model units. */
  area: number;
  /** Mean distance of the loop from its centre, within the mean plane, in model units. */
  radius: number;
  /** Mean of the loop's points, each part counted by its length, in model units. */
  centre: [number, number, number];
  /**
   * Unit normal of the loop's mean plane: of all planes the one onto which it casts the largest area.
   * Seen from its tip the loop runs counter-clockwise. Zero where there is none.
   */
  normal: [number, number, number];
  /**
   * The sides that it separates its component into, the larger area first; one where it separates
   * nothing, as round a handle. Empty where the surface cannot be cut along it.
   */
  sides: LoopSide[];
  /**
   * Whether the girth is this neck's length at all of its vertices. Otherwise a shorter loop goes
   * through one of them, as beside a thinner part.
   */
  measuresGirth: boolean;
  /** Whether it touches the surface's boundary. */
  touchesBoundary: boolean;
  /**
   * The vertices that the loop passes; of a band, that its two outermost loops pass. In rising order, at
   * least one.
   */
  vertices: Uint32Array;
  /**
   * The loop: the edges it crosses and the vertices it passes in order; the last point equals the first.
   * Between neighbours it is straight inside one face or along one edge. Among parallel loops in a band,
   * it is the one in the middle.
   */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/** The necks of a surface. */
export interface Necks {
  /**
   * Vertices whose loops could not be followed: their girth is unresolved, or drawing them tight took
   * more steps than their size explains.
   */
  unresolved: number;
  /**
   * A least prominence for the clear ones, in model units: a twentieth of the narrowest neck's length,
   * whatever `minProminence` leaves out. Necks of noise and most of bands of parallel loops are below
   * it. 0 without necks.
   */
  suggestedProminence: number;
  /** Most prominent first, of equal ones the shortest. */
  necks: Neck[];
}

/**
 * The paper's τ1 and τ2, in model units: plate = {I > girth, SDF < shapeDiameter}, tube = {I < girth,
 * SDF < shapeDiameter}, body the rest.
 */
export interface PartThresholds {
  /** Τ1: tubes have a smaller girth, in model units. */
  girth: number;
  /** Τ2: tubes and plates have a smaller shape diameter, in model units. */
  shapeDiameter: number;
}

/** A connected region of one kind. */
export interface Part {
  /** The kind of all its vertices. */
  kind: PartKind;
  /** Sum of the vertices' areas, in squared model units. */
  area: number;
  /** Median of the girth over the region, in model units; NaN where it is unknown. */
  medianGirth: number;
  /** Median of the shape diameter over the region, in model units; NaN where it is unknown. */
  medianShapeDiameter: number;
  /** Radius of the round tube with the same girth, I / 2π, in model units. */
  equivalentRadius: number;
  /**
   * Its thinnest place: the vertex with the least girth (tube), otherwise the least SDF; none where it
   * is unknown. `Mesh.loop` gives the loop there. None is -1.
   */
  thinnest: number;
  /** Its vertices, in rising order. */
  vertices: Uint32Array;
}

/**
 * The girth at one place of a path.
 *
 * @experimental
 */
export interface MeasuredStation {
  /** Along the path from its first point, in model units. */
  distance: number;
  /** There, in model units. */
  girth: number;
  /** How it came about. */
  kind: LoopKind;
  /** Where: `Mesh.loop` gives the loop. */
  point: SurfacePoint;
}

/** A maximum of a field. */
export interface Maximum {
  /** Where it is. */
  vertex: number;
  /** The field there, in its unit. */
  value: number;
  /**
   * How far one must go down from it, at least, to reach a higher maximum: 0 or more, in the field's
   * unit. For the highest of a component: how far down to its least value.
   */
  persistence: number;
  /**
   * The vertex where its surroundings meet those of a higher maximum; none for the highest. None is -1.
   */
  saddle: number;
}

/** A boundary curve that was filled. */
export interface ClosedHole {
  /** Its number of edges. */
  edges: number;
  /** Its length, in model units. */
  perimeter: number;
  /** Area of the faces that fill it, in squared model units. */
  area: number;
  /** A vertex of the input on it. */
  vertex: number;
}

/**
 * Account of what was done, step by step, in this order. All numbers but crackWidth are counts; an
 * unspoilt closed surface has zeros from weldedVertices to addedVertices. inputVertices −
 * weldedVertices − unreferencedVertices + addedVertices: the vertices, and inputFaces + addedFaces −
 * degenerateFaces − duplicateFaces: the faces, before components are chosen and holes are closed.
 */
export interface PreparationReport {
  /** Vertices of the input. */
  inputVertices: number;
  /** Triangles of the input. */
  inputFaces: number;
  /**
   * Vertices that became one with an earlier one: at the same position, within the distance asked for,
   * or so near that a face between them has no area (1e-12 of its longest side).
   */
  weldedVertices: number;
  /**
   * Faces without area, dropped: they repeat a vertex, or their smallest height is below 1e-12 of their
   * longest side.
   */
  degenerateFaces: number;
  /**
   * Faces made by dividing others, whose open edges had vertices of neighbours within them
   * (`PrepareOptions.weldDistance`, closeHoles).
   */
  addedFaces: number;
  /**
   * Faces without area whose middle vertex lies on their longest side, and whose loss would open the
   * surface: that side was flipped, so that the neighbour's area is shared by two faces.
   */
  flippedFaces: number;
  /**
   * Faces that have the three vertices of another one, dropped. Two copies are kept only as a partition
   * between two solids: where all edges of the doubled patch's rim that have other faces have an even
   * number of them.
   */
  duplicateFaces: number;
  /** Vertices that no face is left to use, dropped. */
  unreferencedVertices: number;
  /**
   * Faces turned over, so that neighbours agree. The greater part of each piece (pieces: connected by
   * edges of two faces) keeps its side.
   */
  reorientedFaces: number;
  /** Edges cut because the surface has one side only there, as a Möbius strip has. */
  oneSidedEdges: number;
  /**
   * Edges with more than two faces, cut apart. Pieces that have two faces there keep them joined; of the
   * rest, those that bound wedges of solid in turn (facing away and towards each other alternately) are
   * joined in pairs. Where solids cross that are open nowhere, what lies inside of more of them is
   * joined first: they stay closed. All others have their boundary there.
   */
  nonManifoldEdges: number;
  /** Vertices cut apart, apart from the ends of cut edges: parts touched only there. */
  nonManifoldVertices: number;
  /** Copies of vertices made by all cutting. */
  addedVertices: number;
  /** Connected components of what came out. */
  components: number;
  /** How many of them are slivers: of less than a millionth of the largest one's area. */
  sliverComponents: number;
  /**
   * How many of them are closed and hold nothing: two sheets on each other, such as cutting edges of
   * many faces leaves behind. The volume inside, divided by half the area, is below a millionth of the
   * component's extent.
   */
  doubledComponents: number;
  /** How many are kept. */
  keptComponents: number;
  /**
   * Boundary curves of the kept components (web/docs/definitions.md, section 2), counted after holes
   * were closed.
   */
  boundaryCurves: number;
  /** The edges of these curves. */
  boundaryEdges: number;
  /**
   * Boundary vertices that nearly coincide with another one, as where two sides of a crack differ by a
   * rounding: by less than a hundred thousandth of the extent and a tenth of the edges there.
   */
  crackVertices: number;
  /**
   * Boundary vertices that lie as near to the inside of a boundary edge: a neighbour has no vertex
   * there.
   */
  tJunctions: number;
  /** Boundary curves that were filled. */
  closedHoles: number;
  /** A weldDistance, in model units, that joins both; 0 where there are none. */
  crackWidth: number;
  /** Each of these. */
  holes: ClosedHole[];
}

/** A connected place that does not meet a limit. */
export interface WeakPlace {
  /** Which limit it does not meet. */
  kind: WeakKind;
  /** The measure that is too small: "diameter", "thickness" or "clearance". */
  measure: string;
  /** The least diameter, thickness or clearance there, in model units. */
  least: number;
  /** In squared model units; of faces that meet the limit in part, by samples. */
  area: number;
  /** The point that has it. */
  thinnest: SurfacePoint;
  /** The point of the surface across from it, in model units; of walls and gaps only. */
  opposite?: [number, number, number];
  /**
   * Vertices that do not meet the limit, in rising order; where only the inside of faces does not, the
   * corners of these.
   */
  vertices: Uint32Array;
  /** Faces that somewhere do not meet the limit, of walls and gaps, in rising order. */
  faces: Uint32Array;
}

/**
 * A connected place where measures are below a limit, but where no wall and no gap is. It does not
 * fail.
 */
export interface Crease {
  /** The kind of its thinnest point. */
  kind: CreaseKind;
  /** The sharp edges in it together, in model units; 0 where faces only touch. */
  length: number;
  /** In squared model units. */
  area: number;
  /** The least measure there, in model units: no thickness of anything. */
  least: number;
  /** The point that has it. */
  thinnest: SurfacePoint;
  /** The point of the surface across from it, in model units. */
  opposite: [number, number, number];
  /** Its vertices, in rising order, as of a weak place. */
  vertices: Uint32Array;
  /** Its faces, in rising order. */
  faces: Uint32Array;
}

/** The answer to a check. */
export interface PrintCheck {
  /** Whether nothing fails; creases do not. */
  passes: boolean;
  /** The share of the surface's area, in [0, 1], that is in places. */
  failingShare: number;
  /**
   * At this scale of the shape nothing fails, and all measures grow with it. 1.12: it passes at 112% of
   * its size; at most 1 where it passes as it is, and so far at least it may shrink (1 where there are
   * creases). 0 where nothing is limited; infinite where no scale was found, as of a blade.
   */
  passingScale: number;
  /** The worst first, in shares of their limits. */
  places: WeakPlace[];
  /** The places that are thin, but fail by no wall and no gap: the longest first. */
  creases: Crease[];
}

/**
 * How values that were found in bands compare with exact ones, at vertices drawn at random.
 *
 * @experimental
 */
export interface GirthAudit {
  /** Vertices that were compared. */
  vertices: number;
  /** Vertices at which the two are equal to one part in a million. */
  equal: number;
  /**
   * The share of equal ones among all vertices lies between this and `atMost` with a probability of 95 %
   * (Wilson 1927).
   */
  atLeast: number;
  /** The upper end of that share. */
  atMost: number;
  /**
   * The median of the differences, as shares of the exact value. Where no value was found, it is off by
   * 1.
   */
  median: number;
  /** The difference that one in twenty exceeds, as a share. */
  percentile95: number;
  /** The largest difference, as a share. */
  greatest: number;
}

/**
 * A handle or tunnel that was taken away.
 *
 * @experimental
 */
export interface RemovedHandle {
  /** Which of the two it was. */
  kind: HandleKind;
  /** The length of its loop, in model units. */
  length: number;
  /** Mean of the loop's points, in model units. */
  centre: [number, number, number];
  /**
   * Area of its tube, which was dropped, in squared model units; 0 where the surface was cut along the
   * loop and closed.
   */
  droppedArea: number;
}

/**
 * A surface with fewer handles, and the account of what was done.
 *
 * @experimental
 */
export interface HandleRemoval {
  /** Genus of all components together. */
  genusBefore: number;
  /** Genus of the surface that is left. */
  genusAfter: number;
  /**
   * Faces that were made or moved and cross others, since there was no room for them; those of the
   * surface that crossed each other before do not count.
   */
  crossingFaces: number;
  /**
   * No loop is left that is shorter than this, in model units, but those that touch the boundary: the
   * length that was asked for, or less where the budget did not suffice to prove it.
   */
  provenLength: number;
  /** The removed handles without their loops, in the order of the cuts. */
  removed: RemovedHandle[];
}

/**
 * A curve in which a plane cuts a surface (web/docs/definitions.md, section 5).
 *
 * @experimental
 */
export interface SectionCurve {
  /** Its length, in model units; of an open curve without the gap. */
  perimeter: number;
  /**
   * The perimeter of its convex hull in the plane, in model units: what a tape shows, which spans
   * hollows.
   */
  tape: number;
  /**
   * The area that it encloses, those of the holes in it taken away, in squared model units; 0 where it
   * is open.
   */
  area: number;
  /** The diameter of a circle of that area, in model units. */
  equivalentDiameter: number;
  /**
   * The least distance of two parallel lines in the plane that hold it between them, in model units.
   */
  leastWidth: number;
  /** The greatest one, in model units: that of its two points that are farthest apart. */
  greatestWidth: number;
  /** The centroid of its area; of an open curve, of its length. */
  centre: [number, number, number];
  /**
   * The diameter of the largest circle in the plane that it encloses and none of its holes meets, in
   * model units; 0 where it is open. NaN where circles were not asked for.
   */
  inscribedDiameter: number;
  /**
   * The centre of that circle, of several equal ones of any; `centre` where there is none. NaN where
   * circles were not asked for.
   */
  inscribedCentre: [number, number, number];
  /** False where it ends at the surface's boundary. */
  closed: boolean;
  /** Whether it bounds a hole in another curve: what the surface encloses lies round it. */
  hole: boolean;
  /** The component of the surface that it lies on. */
  component: number;
  /**
   * The number of the limb that it lies on, where limbs were asked for: more than half of its length
   * does.
   */
  limb?: number;
  /**
   * The edges that it crosses and the vertices that it passes, in order; straight between neighbours.
   * Seen from the tip of the plane's normal, what the surface encloses lies on the left. The last point
   * of a closed curve equals the first.
   */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * The curves that one plane cuts.
 *
 * @experimental
 */
export interface Section {
  /** The plane's normal, of length 1. */
  normal: [number, number, number];
  /** Normal · x of all points of the plane, in model units. */
  offset: number;
  /** The sum of the curves' lengths, in model units. */
  perimeter: number;
  /** The perimeter of the convex hull of all curves, in model units: one tape round them. */
  tape: number;
  /** The sum of the areas of the curves that are no holes, in squared model units. */
  area: number;
  /**
   * In the order of the first face that each runs through. Empty where the plane misses the surface.
   */
  curves: SectionCurve[];
}

/**
 * The curves that several planes cut.
 *
 * @experimental
 */
export interface Sections {
  /** In the order in which the planes were given. */
  sections: Section[];
}

/** Shares of a segment's area, from 0 to 1, by kind; they add up to 1. */
export interface KindShares {
  /** The share of the body. */
  body: number;
  /** The share of tubes. */
  tube: number;
  /** The share of plates. */
  plate: number;
  /** The share without a kind. */
  unknown: number;
}

/** One segment of a body. */
export interface MeasuredSegment {
  /** The kind that has the largest area in it; of equal ones the first. */
  kind: PartKind;
  /** Shares of its area by kind. */
  shares: KindShares;
}

/**
 * A piece of a curve between two points that stay; of a closed curve without any, all of it.
 *
 * @experimental
 */
export interface TightPiece {
  /** The length before, in model units. */
  lengthBefore: number;
  /** The length when it is tight, in model units. */
  length: number;
  /** The curves that it is shorter than. */
  promise: TightPromise;
  /** Where it begins. */
  start: SurfacePoint;
  /** Where it ends. */
  end: SurfacePoint;
}

/**
 * A curve drawn tight.
 *
 * @experimental
 */
export interface TightCurve {
  /** Whether it is open or closed, or only a point. */
  kind: TightKind;
  /** The weakest promise of its pieces. */
  promise: TightPromise;
  /** The component that it lies on. */
  component: number;
  /** The length of the curve through the points that were given, in model units. */
  lengthBefore: number;
  /** The length of the tight one, in model units. */
  length: number;
  /** Its pieces, in order: one, but where all points stay. */
  pieces: TightPiece[];
  /**
   * The edges that it crosses and the vertices that it passes, in order; straight between neighbours.
   * The last point of a closed curve equals the first. Empty where it is a point.
   */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/** A line across edges of the surface: a point in the middle of each, in order. */
export interface ContourLine {
  /**
   * Whether it comes back to its first point, which is not repeated. Otherwise it ends at the boundary,
   * or, an arc, inside faces.
   */
  closed: boolean;
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/** A region that the discontinuity contour cuts off. */
export interface Tip {
  /** Area inside the contour, in squared model units. */
  area: number;
  /** Length of the contour, in model units. */
  boundaryLength: number;
  /**
   * How far the girth rises from outside to inside, in model units: the median over the edges that the
   * contour crosses. Tips that noise makes rise little.
   */
  jump: number;
  /** The vertex of the region that is farthest from the contour, along the surface. */
  apex: number;
  /** How far, in model units. */
  apexDistance: number;
  /** Its vertices, in rising order. */
  vertices: Uint32Array;
  /** The line that cuts it off: usually one closed line. */
  contour: ContourLine[];
}

/**
 * A part of the discontinuity contour that is no tip's: it ends somewhere, or where it meets the
 * contour of a tip, which it follows closely.
 */
export interface OpenArc {
  /** Its length, in model units. */
  length: number;
  /** How far the girth rises across it, in model units: as of a tip. */
  jump: number;
  /** Where it runs; never closed. */
  line: ContourLine;
}

/** The tips of a surface, and what else the girth jumps along. */
export interface Tips {
  /** Edges that the contour crosses. */
  crossedEdges: number;
  /** Largest jump first. */
  tips: Tip[];
  /** Longest first. */
  arcs: OpenArc[];
}

/**
 * The measures of a tube at one place of its centreline (web/docs/definitions.md, section 5).
 *
 * @experimental
 */
export interface TubeStation {
  /** The number of the branch. */
  branch: number;
  /** How far along the centrelines it is from where the first branch begins, in model units. */
  distance: number;
  /** The diameter of a circle with the section's area, in model units. */
  equivalentDiameter: number;
  /** The area of the section perpendicular to the centreline, in squared model units. */
  area: number;
  /** The length of its outline, in model units. */
  perimeter: number;
  /** The diameter of the largest circle within it, in model units. */
  inscribedDiameter: number;
  /** The least distance of two parallel lines that hold it between them, in model units. */
  leastWidth: number;
  /** The greatest such distance, in model units. */
  greatestWidth: number;
  /**
   * The exact girth at `place`, in model units; NaN where no loop goes round, as in caps (where it is
   * longer than the outline), or where it was not asked for.
   */
  girth: number;
  /** The curvature of the centreline, in 1 / model units: one over the radius of its circle. */
  curvature: number;
  /**
   * How fast the centreline leaves the plane of that circle, in radians per model unit; positive where
   * it is screwed to the right. NaN where it is straight: a curvature below 0.001 divided by the
   * equivalent diameter.
   */
  torsion: number;
  /** A point of the centreline: the centroid of the section. */
  centre: [number, number, number];
  /** Along the centreline, of length 1, away from the first end. */
  direction: [number, number, number];
  /** The point of the outline that is nearest to the centre. */
  place: SurfacePoint;
  /** The outline: the edges that it crosses in order; the last point equals the first. */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * A place where a tube is narrower or wider than on both sides.
 *
 * @experimental
 */
export interface TubePlace {
  /** Which of the two it is. */
  change: TubeChange;
  /** The number of the branch. */
  branch: number;
  /** Where its section is least, or greatest, in model units, as `TubeStation.distance`. */
  distance: number;
  /**
   * The side before: the nearest place from which the tube is no wider (no narrower) towards its
   * beginning, in model units, as `TubeStation.distance`.
   */
  beforeDistance: number;
  /** The side beyond, in model units: the same towards its end. */
  beyondDistance: number;
  /**
   * How long it is: the part along which the diameter differs from the taper between both sides by more
   * than half as much as at the place itself, in model units.
   */
  length: number;
  /** The equivalent diameter at the place, in model units. */
  equivalentDiameter: number;
  /** The equivalent diameter that it is compared with, in model units. */
  reference: number;
  /** How much less (more) the equivalent diameter is, as a share of the reference. */
  degreeByDiameter: number;
  /** How much less (more) the area is, as a share of the area of the reference's circle. */
  degreeByArea: number;
  /** The equivalent diameter at `beforeDistance`, in model units. */
  beforeDiameter: number;
  /** The equivalent diameter at `beyondDistance`, in model units. */
  beyondDiameter: number;
  /** The area of the section there, in squared model units. */
  area: number;
  /** The length of its outline, in model units. */
  perimeter: number;
  /** The diameter of the largest circle within it, in model units. */
  inscribedDiameter: number;
  /** The least distance of two parallel lines that hold it between them, in model units. */
  leastWidth: number;
  /**
   * The length of the neck that a narrowing's outline is drawn tight to (girth/necks.h); of a widening
   * the exact girth at the point of the outline nearest to the centre. In model units; NaN where there
   * is none, or where it was not asked for.
   */
  girth: number;
  /** The centroid of the section. */
  centre: [number, number, number];
  /** The outline, as `TubeStation.points`. */
  points: SurfacePoint[];
  /** x, y, z of its points, relative to `MeshGeometry.origin`. */
  polyline: Float32Array;
}

/**
 * A tube between two ends or branchings.
 *
 * @experimental
 */
export interface TubeBranch {
  /** The component of the surface that it lies on. */
  component: number;
  /** The number of the branch that it leaves; none where it begins at an end. */
  parent?: number;
  /** Whether it leads to an end, and not to a branching. */
  ends: boolean;
  /** Whether that end is open: a boundary curve of the surface. */
  open: boolean;
  /** A vertex of that end; none where it leads to a branching. None is -1. */
  end?: number;
  /** The distance of its first station, in model units, as `TubeStation.distance`. */
  firstDistance: number;
  /** The distance of its last station, in model units. */
  lastDistance: number;
  /** The median of the equivalent diameters of its stations, in model units. */
  median: number;
  /** The numbers of its stations in the result, the first and the one behind the last. */
  firstStation: number;
  /** See firstStation. */
  endStation: number;
}

/**
 * A component that is no tube.
 *
 * @experimental
 */
export interface NoTubeComponent {
  /** Its number. */
  component: number;
  /** The reason for it. */
  reason: NoTube;
}

/**
 * The tubes of a surface.
 *
 * @experimental
 */
export interface Tubes {
  /** Each behind the one that it leaves. */
  branches: TubeBranch[];
  /** Components that are no tubes, in rising order. */
  others: NoTubeComponent[];
  /** Narrowings and widenings, by branch and by distance. */
  places: TubePlace[];
  /** The stations of all branches, by branch and by distance. */
  stations: TubeStation[];
}
