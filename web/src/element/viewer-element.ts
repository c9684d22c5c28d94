// `<girth-viewer>`: a surface, its girth as colours, and the loop under the pointer.

import type {
  Barcode,
  BarcodeOptions,
  Bottleneck,
  CallOptions,
  Cut,
  CutFormat,
  CutOptions,
  Field,
  FieldFormat,
  FieldName,
  HandleOptions,
  HandleRemoval,
  Handles,
  Limb,
  LevelCurve,
  LimbAxis,
  Limbs,
  Loop,
  LoopFormat,
  Maximum,
  MeshGeometry,
  MeshInfo,
  NamedField,
  NeckOptions,
  Necks,
  PartOptions,
  Parts,
  PartThresholds,
  PrintCheck,
  PrintLimits,
  Profile,
  ProfileOptions,
  SegmentOptions,
  Segments,
  SpectralOptions,
  SurfacePath,
  SurfacePoint,
  Tips,
  WatchedOptions,
} from '../kernel/types/types.js';
import type {
  CameraView,
  CombinedName,
  LengthFormat,
  ScreenPoint,
  ShownName,
  UpAxis,
  ValuesName,
} from '../view/index.js';
import { combinationOf, isFieldName, isGivenName } from '../view/field-words.js';
import { lengthFormat } from '../view/numbers.js';
import type { GirthViewerEventMap, GirthViewerListener } from './events.js';
import type { PinnedLoop } from './loops-on-surface.js';
import type { PartsWish, PlaceOnSurface, PlacePicture, Presented } from './presented.js';
import type { ShownField, ShownPlaces } from './shading.js';
import type { DrawingOptions } from './drawing.js';
import type { FigureOptions } from './snapshot.js';
import type { StrokeOptions } from './stroke.js';
import { takeTexts } from './property-texts.js';
import type { TipsChoice } from './tips-on-surface.js';
import { ViewerShell } from './viewer-shell.js';

/**
 * `<girth-viewer src="model.glb"></girth-viewer>`
 *
 * Attributes; a value that is none of these counts as if the attribute were not there, is a warning on the
 * console and an `error` with the code INVALID_OPTION:
 * - `src`: address of a model: GLB, glTF with its buffers beside it, OBJ, PLY, STL, OFF, or a zip.
 * - `loading`: `lazy` fetches nothing but a small script before the element is near the view; by default,
 *   `eager`, the script that draws comes at once, and only the model waits for the view.
 * - `poster`: address of a picture that is shown until the surface is drawn, and where it cannot be drawn.
 *   An element in the slot `poster` serves as well. What is in the slot `caption` stands below the surface.
 * - `unit`: the unit of lengths where the file does not state it, for example `mm`.
 * - `shown-unit`: the unit that lengths are written in: `um`, `mm`, `cm`, `m`, `km`, `in` or `ft`; by
 *   default the model's own. Files that are exported keep the model's.
 * - `field`: what colours the surface: a field of the kernel (`FieldName`; `igf`, the girth, by default), `kind` (of the
 *   loop), `state` (how sure a refined girth is), `tips` (how far the girth rises at the tip that a place is in), `parts` (tubes, plates and
 *   body) or `none`; values of the file as in `_heat`; or two of these in one: their difference, `igf-sdf`, where they
 *   have the same unit, or their ratio, `igf/sdf`.
 * - `method`: how the girth is computed. `exact` (default); `coarse`, on about 10,000 triangles, whose values are carried
 *   back to all vertices; `refined`, at all vertices in a fraction of the time, with states and an audit (`RefinedGirth`), for
 *   surfaces of more than some 20,000 triangles. The colours are those of `coarse` until a refined girth is there; with
 *   a `persistence` it is `coarse`.
 * - `persistence`: passes over loops whose saddles last no longer than this, as noise makes them: a length in
 *   model units or with a unit, as in `0.5` or `3mm`, or a share of the square root of the area, as in `2%`.
 *   It holds for the girth, for what is made of it and for loops; pinned ones are computed anew.
 * - `field-title`: what the legend calls the field; by default its usual name.
 * - `colormap`: `viridis` (default), `cividis`, `plasma`, `magma`, `turbo`, or `rdbu`, which diverges and is
 *   the default for differences, round 0, and where values have both signs.
 * - `range`: `auto` (default), the body of the values, without what few places stretch it by; two numbers, the values at the ends of the colour map; or two percentages as
 *   in `5% 95%`, the shares of the surface's area that lie below them.
 * - `log`: the colour map is logarithmic, where all values in it are above 0.
 * - `isolines`: so many lines of equal value between the ends of the range; none by default.
 * - `time`: of `hks`, as a share of the surface's area, `0.002` by default; small times see small details.
 * - `energy`: of `wks`, from `1` (low: the whole shape) to `100` (details); `20` by default.
 * - `component`: of `sihks`, the frequency, from `1` (default) to `19`. Changed while its field is
 *   shown, each of these three computes it anew.
 * - `loop`: `hover` (default), `none`, or vertices whose loops are pinned once the model is there,
 *   as in `loop="12 4031"`.
 * - `pins`: the loops that are pinned, with commas between them, and with their names: `pins="12 waist, 4031"`. A
 *   point of a face is the face and two of its weights: `7:0.2:0.3`. `%2C` is a comma of a name. `none` pins none, not
 *   even those that the file has.
 * - `tips`: draws the tips: all; those that rise at least so much, as in `5mm`; and marks one, as in `#2` or `5mm #2`, the
 *   highest being 1. `none` draws none, not even those that the file has.
 * - `parts`: the girth and the thickness where tubes and plates begin, and the smoothing, as in
 *   `parts="200mm 50mm 0.1"`; by default as the model's own values suggest. `field="parts"` colours by them.
 * - `bottleneck`: two points, as in `bottleneck="12, 4031"`: they are marked, and the narrowest loop on the widest way between them
 *   is drawn.
 * - `profile`: two points or more, up to 200: the shortest path through them is drawn, and its points are marked; of more
 *   than twelve, its ends.
 * - `camera`: from where the surface is seen: `front`, `side`, `top`, or the six numbers of a `CameraView`: `polar`,
 *   `azimuth`, `distance` and the three of `target`; by default from where it is seen whole.
 * - `edges`: draws the mesh's edges.
 * - `shading`: `smooth` (default); `flat`, so that each face can be seen; or `transparent`.
 * - `section`: cuts away what lies beyond a plane across a direction of the file, `x`, `-y` or three numbers, and a share
 *   of the surface's extent along it: `x 40%` leaves the first 40% along x. The inside is drawn plainly; what is cut away is not
 *   picked.
 * - `up`: the direction of the file that is up: `y`, `z`, `-y`, `-z`, `x` or `-x`. Default: the format's
 *   convention (y of glTF and OBJ, z of STL), otherwise a guess from the shape; see `upAxis`.
 * - `keep-view`: the next model is seen from where this one is, in sizes of the models.
 * - `linked`: a name. Elements of a page that have the same one are seen from the same place, in radii of each surface: to move
 *   one moves all, within the frame. As at first, by `0` or `resetView`, all surfaces are seen whole.
 * - `one-scale`: a name. The colours of elements that have the same one, and show the same field, span one range: from the
 *   least to the greatest that each would show alone, whatever their units; or the two numbers of `range` of one of them.
 * - `controls`: what lies on the surface beside it: `none`; the `legend` (default); or `full`, and without a value, a small
 *   bar too: first view, axes and straight views, drawing, pause.
 * - `turn`: turns slowly once it is computed and until something is done on the page, unless the system asks
 *   for reduced motion; with a button that stops it.
 *
 * An attribute is followed when it is set, and when a model comes. In between, hands and methods go on from there, and
 * the attribute stays as it is written. `state` has what is shown now, in the words of the attributes.
 *
 * Events (`GirthViewerEvents` has them with their types): `load` (`LoadDetail`), `progress` (`ProgressDetail`), `field` (`FieldDetail`: one is computed, or
 * was cancelled), `fieldchange` (`FieldChangeDetail`: the surface is coloured otherwise), `hover`
 * (`HoverDetail`), `pick` (`PickDetail`), `error` (`ErrorDetail`), `touch` (no detail: the surface no
 * longer turns), `view` (no detail: something was chosen on the bar), `unit` (no detail: lengths are written in another unit), `cameramove` (no detail:
 * the surface is seen from elsewhere than in the last frame; sent before this one is drawn), `camera` (no detail: it was moved,
 * and is at rest again). None bubbles.
 *
 * Keyboard, while the surface has the focus, and by `press`: arrows turn, + and − zoom, 0 resets, 1, 2 and 3
 * look from the front, the side and the top; Shift with an arrow moves a probe over the surface, Enter pins
 * its loop, C turns about it, Escape hides it, Delete removes the last pinned loop. A double click, or a
 * double tap, turns about a point as C does.
 *
 * Nothing is fetched for `src` or computed before the element is in view, and no field before it is asked
 * for, by the attribute or by a method. All elements of a page share one kernel.
 */
export class GirthViewer extends ViewerShell {
  /** Calls a function or an object with each event of a name; see {@link GirthViewerEvents}. */
  override addEventListener<Name extends keyof GirthViewerEventMap>(
    type: Name,
    listener: GirthViewerListener<Name>,
    options?: boolean | AddEventListenerOptions,
  ): void;
  /** Any other event. */
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void {
    super.addEventListener(type, listener, options);
  }

  /** No longer calls a function or an object that was given to `addEventListener`. */
  override removeEventListener<Name extends keyof GirthViewerEventMap>(
    type: Name,
    listener: GirthViewerListener<Name>,
    options?: boolean | EventListenerOptions,
  ): void;
  /** Any other event. */
  override removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void;
  override removeEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | EventListenerOptions,
  ): void {
    super.removeEventListener(type, listener, options);
  }

  /** The vertex of the surface for each vertex of the file; 0xFFFFFFFF where no face uses it. */
  get vertexOfInput(): Uint32Array {
    return this.require().model.mesh.vertexOfInput;
  }

  /** The surface that is drawn: do not modify its arrays. */
  get geometry(): MeshGeometry {
    return this.require().model.mesh.geometry;
  }

  /** How the element writes lengths: those of loops, and the girth. */
  get lengthFormat(): LengthFormat {
    return this.core?.lengthFormat ?? lengthFormat(1, this.unit, this.shownUnit);
  }

  /** How the element writes the values of a field. */
  formatOf(name: ShownName): LengthFormat {
    return this.require().shading.formatOf(name);
  }

  /** What colours the surface, with its range; undefined as long as there is nothing to show. */
  get shown(): ShownField | undefined {
    return this.presented?.shading.shown;
  }

  /** The pinned loops, oldest first. */
  get pinned(): PinnedLoop[] {
    return this.presented?.loops.pinned ?? [];
  }

  /**
   * Shows a surface of about `faces` faces in place of the present one; where that was made of another one, in
   * place of that.
   */
  async remesh(faces: number): Promise<MeshInfo> {
    const { mesh, fields } = (await this.#whole()).model;
    const from = this.core?.madeFrom ?? { mesh, field: fields.get('igf')?.field };
    const { name } = from.mesh.info;
    const words = `Remeshing ${name || 'the model'} …`;
    const core = await this.needed();
    return core.bring(words, name, (watched) => from.mesh.remesh(faces, watched), from);
  }

  /**
   * Shows the surface without the handles and tunnels whose loops are shorter than a length, in model units, in place
   * of the present one, which `restore` shows again. Where there are none, what is shown stays.
   * @experimental
   */
  async removeHandles(
    length: number,
    options: Pick<HandleOptions, 'basePoints'> = {},
  ): Promise<HandleRemoval> {
    const core = await this.needed();
    return core.removeHandles(length, options);
  }

  /** Shows again what the surface was made of, with its girth. Rejected with USAGE where it was not made of another one. */
  async restore(): Promise<MeshInfo> {
    const core = await this.needed();
    return core.restore();
  }

  /** What the surface was made of by `remesh` or `removeHandles`; undefined where it was not. */
  get original(): MeshInfo | undefined {
    return this.core?.madeFrom?.mesh.info;
  }

  /** What `removeHandles` took away from the original; undefined where it was not made so. */
  get removal(): HandleRemoval | undefined {
    return this.core?.madeFrom?.removal;
  }

  /**
   * How far the field of a surface that was made of another is from that of the original: equation (1) of the paper;
   * undefined where one of the two is not computed.
   */
  async differenceToOriginal(): Promise<number | undefined> {
    const before = this.core?.madeFrom;
    const { mesh, fields, life } = this.require().model;
    const field = fields.get('igf')?.field;
    if (!before?.field || !field) return undefined;
    return mesh.difference(field, before.mesh, before.field, { signal: life.signal });
  }

  /** The model, read by the kernel, which can compute. */
  async #whole(): Promise<Presented> {
    this.require();
    return this.core!.whole();
  }

  // ---- fields, tips and parts

  /**
   * A copy of a field's values, one per vertex of the surface; NaN where not (yet) computed, and for two fields in one
   * as long as these do not colour the surface. While the refined girth is computed, those of the coarse surface.
   */
  values(name: ValuesName | CombinedName): Float64Array {
    const { fields } = this.require().model;
    if (!isFieldName(name) && !isGivenName(name) && !combinationOf(name)) {
      throw new RangeError(`no field is called ${String(name)}`);
    }
    return fields.valuesOf(name).slice();
  }

  /** The values at every vertex that the model's file has, in its order: `_heat`. */
  get given(): ValuesName[] {
    return this.presented?.model.fields.givenNames ?? [];
  }

  /** A whole field; computed now, in view of the user, unless it is there. Cancelling rejects. */
  async fieldOf(name: FieldName): Promise<Field> {
    if (!isFieldName(name)) throw new RangeError(`no field is called ${String(name)}`);
    const { fields, file } = this.require().model;
    const given = fields.givenOf(name);
    if (file.isAll && given) return { ...given, name };
    return (await this.#whole()).model.fields.compute(name);
  }

  /**
   * Takes a whole field that was computed before of the same surface, for example on an earlier visit, in place of computing
   * it; a girth, as long as `method` asks for what it was computed by. `options` are those of a signature that it was computed with. In a listener of `load`, before anything is
   * computed. Throws a RangeError where it does not fit the surface.
   * @experimental
   */
  adopt(field: Field, options?: SpectralOptions): void {
    const { fields, mesh } = this.require().model;
    const { name, values, kinds } = field;
    const { vertexCount } = mesh.info;
    const kindCount = name === 'igf' ? vertexCount : 0;
    if (!isFieldName(name) || values.length !== vertexCount || kinds.length !== kindCount) {
      throw new RangeError('the field is not one of this surface');
    }
    fields.adopt(field, options);
  }

  /** The computed share of a field's vertices. */
  shareOf(name: FieldName): number {
    return this.require().model.fields.shareOf(name);
  }

  /** The area that each vertex of the surface stands for. */
  async areas(): Promise<Float64Array> {
    return this.require().model.areas();
  }

  /** The tips; the girth is computed first unless it is there. */
  async tips(): Promise<Tips> {
    const { model } = this.require();
    return model.file.tips ? model.tips() : (await this.#whole()).model.tips();
  }

  /** Draws the tips' contours and apexes and tints their regions, or no longer. */
  async showTips(choice: TipsChoice): Promise<void> {
    this.require();
    await this.core!.showTips(choice);
  }

  /**
   * The limbs that the tips end, and how thick they are all along; the girth is computed first unless it is
   * there. Of several calls at a time, the first one has the progress and can stop it.
   */
  async limbs(options: WatchedOptions = {}): Promise<Limbs> {
    return (await this.#whole()).model.limbs(options);
  }

  /** Where a field is greatest, or least, among its surroundings; most persistent first. */
  async maxima(name: FieldName, options: { minima?: boolean } = {}): Promise<Maximum[]> {
    return (await this.#whole()).model.maxima(name, options.minima ?? false);
  }

  /** Where heat stays longest, most persistent first: the paper's comparison with the tips. */
  async heatMaxima(options: SpectralOptions = {}): Promise<Maximum[]> {
    return (await this.#whole()).model.heatMaxima(options);
  }

  /** Marks points of the surface with diamonds; without an argument none. */
  showPoints(points: ArrayLike<SurfacePoint> = []): void {
    this.require().showPoints(points);
  }

  /** Thresholds to start from; girth and shape diameter are computed first. */
  async suggestedThresholds(): Promise<PartThresholds> {
    return (await this.#whole()).model.suggestedThresholds();
  }

  /** Tubes, plates and body as connected parts; girth and shape diameter are computed first. */
  async parts(options: PartOptions): Promise<Parts> {
    return (await this.#whole()).model.parts(options);
  }

  /** The thresholds that colour the surface by parts; undefined until they were first chosen. */
  get thresholds(): Required<PartsWish> | undefined {
    return this.presented?.thresholds;
  }

  /**
   * Where tubes and plates begin, in model units: shown at once where `field` is `parts`; what is
   * smoothed follows when it is computed. Throws a RangeError for what is no number from 0 on.
   */
  setThresholds(wish: PartsWish): void {
    this.require().setThresholds(wish);
  }

  /**
   * What is too thin to print or too close together, and the scale from which on nothing is; the fields that the
   * limits need are computed first.
   */
  async printCheck(limits: PrintLimits): Promise<PrintCheck> {
    return (await this.#whole()).model.printCheck(limits);
  }

  /** Colours the surface by kinds of places, with a legend of their own, until the next call or until `field` changes. */
  showPlaces(places?: ShownPlaces): void {
    this.require().showPlaces(places);
  }

  /** Shows these vertices as they are and fades the others; without an argument all are as they are. */
  mark(vertices?: ArrayLike<number>): void {
    this.require().mark(vertices);
  }

  // ---- loops

  /** The exact loop at a vertex of the surface, or at a point of one of its faces. */
  async loop(point: SurfacePoint): Promise<Loop> {
    const { mesh, life, fields } = (await this.#whole()).model;
    return mesh.loop(point, { signal: life.signal, persistence: fields.persistence });
  }

  /** The saddles of the distance from a point, those that `persistence` passes over too. */
  async barcode(point: SurfacePoint, options: BarcodeOptions = {}): Promise<Barcode> {
    const { mesh, life } = (await this.#whole()).model;
    return mesh.barcode(point, { signal: life.signal, ...options });
  }

  /**
   * Computes the saddles of all vertices, with progress and until `cancel`, and keeps them for as long as the
   * model is shown: from then on another `persistence` up to `maxPersistence`, in model units, shows at once.
   * Takes several times as long as the girth.
   */
  async keepBarcodes(maxPersistence: number): Promise<void> {
    this.require();
    await this.core!.keepBarcodes(maxPersistence);
  }

  /** The shortest path between two points, and how far they are apart in space. */
  async path(from: SurfacePoint, to: SurfacePoint): Promise<SurfacePath> {
    const { mesh, life } = (await this.#whole()).model;
    return mesh.path(from, to, { signal: life.signal });
  }

  /**
   * The places that are narrower than all around them; the girth is computed first unless it is there.
   * @experimental
   */
  async necks(options: NeckOptions = {}): Promise<Necks> {
    const { mesh, life, fields } = (await this.#whole()).model;
    return mesh.necks(await fields.compute('igf'), { signal: life.signal, ...options });
  }

  /**
   * The narrowest place on the widest way from one point to another; the girth is computed first unless it is there.
   * @experimental
   */
  async bottleneck(
    from: SurfacePoint,
    to: SurfacePoint,
    options: WatchedOptions = {},
  ): Promise<Bottleneck> {
    const { mesh, life, fields } = (await this.#whole()).model;
    const { signal } = life;
    return mesh.bottleneck(await fields.girth(signal), from, to, { signal, ...options });
  }

  /**
   * The girth along the shortest path through two points or more.
   * @experimental
   */
  async profile(points: readonly SurfacePoint[], options: ProfileOptions = {}): Promise<Profile> {
    const { mesh, life } = (await this.#whole()).model;
    return mesh.profile(points, { signal: life.signal, ...options });
  }

  /**
   * The girth along the axis of a limb, with the loops that are swept along it.
   * @experimental
   */
  async axis(limb: Pick<Limb, 'profile'>, options: WatchedOptions = {}): Promise<LimbAxis> {
    const { mesh, life } = (await this.#whole()).model;
    return mesh.axis(limb, { signal: life.signal, ...options });
  }

  /**
   * The next point of the surface that is clicked, tapped, or chosen with Enter, which then pins no loop. Rejected with
   * CANCELLED after Escape, when the signal fires, and when another model comes or the method is called again.
   */
  async choosePoint({ signal }: CallOptions = {}): Promise<SurfacePoint> {
    return (await this.#whole()).loops.choosePoint(signal);
  }

  /**
   * The next points of a path that is drawn by hand: one that is clicked, tapped or chosen with Enter, or those along
   * the way of a pointer that is dragged over the surface, which does not turn meanwhile; beside it a drag turns
   * it. `drawn` has the points so far, while the pointer moves. Rejected as `choosePoint` is.
   * @experimental
   */
  async chooseStroke(options: StrokeOptions = {}): Promise<SurfacePoint[]> {
    const { loops } = await this.#whole();
    return loops.chooseStroke(options);
  }

  /**
   * Short loops round the surface's handles and through its holes.
   * @experimental
   */
  async handles(options: HandleOptions = {}): Promise<Handles> {
    const { mesh, life } = (await this.#whole()).model;
    return mesh.handles({ signal: life.signal, ...options });
  }

  /**
   * Where the girth has one value; it is computed first unless it is there.
   * @experimental
   */
  async levelCurves(girth: number, options: CallOptions = {}): Promise<LevelCurve[]> {
    const { mesh, life, fields } = (await this.#whole()).model;
    const igf = await fields.compute('igf');
    return mesh.levelCurves(igf, girth, { signal: life.signal, ...options });
  }

  /**
   * The parts of the surface, cut along curves; what is shown stays whole.
   * @experimental
   */
  async cut(curves: readonly (readonly SurfacePoint[])[], options: CutOptions = {}): Promise<Cut> {
    const { mesh, life } = (await this.#whole()).model;
    return mesh.cut(curves, { signal: life.signal, ...options });
  }

  /**
   * What the surface falls into at its necks, and what each part is; girth and shape diameter are computed first. What is
   * shown stays whole.
   * @experimental
   */
  async segments(options: SegmentOptions = {}): Promise<Segments> {
    const { model } = await this.#whole();
    const { igf, sdf } = await model.girthAndDiameter();
    return model.mesh.segments(igf, sdf, { signal: model.life.signal, ...options });
  }

  /** Draws lines on the surface, each given by x, y, z of its points; without an argument none. */
  showCurves(polylines: readonly Float32Array[] = []): void {
    this.require().showCurves(polylines);
  }

  /** Draws a path on the surface, or another line, with a dot at its end; without an argument none. */
  showPath(path?: Pick<SurfacePath, 'polyline'>): void {
    this.require().showPath(path?.polyline);
  }

  /**
   * Shows the loop at a vertex or at a point of a face, as if it were pointed at; without an argument none. It
   * follows at once, and of many points in quick succession the last one counts. `quiet`: screen readers do
   * not say it.
   */
  showLoop(point?: SurfacePoint, options: { quiet?: boolean } = {}): void {
    this.require().loops.lookAt(point, options.quiet);
  }

  /** Vertices along a way over the surface from end to end, to slide a loop along. */
  longWay(): number[] {
    return this.require().model.surface.longWay();
  }

  /** Computes the loop at a vertex or at a point of a face, and keeps it on the surface; one that is known is only kept. */
  async pin(point: SurfacePoint | Loop): Promise<PinnedLoop> {
    const { loops } = await this.#whole();
    return typeof point === 'object' && 'polyline' in point ? loops.keep(point) : loops.pin(point);
  }

  /** Calls a pinned loop by a name, '' for none; nothing happens where there is none of that id. */
  nameLoop(id: number, name: string): void {
    this.presented?.loops.rename(id, name);
  }

  /** Removes a pinned loop; nothing happens where there is none of that id. */
  unpin(id: number): void {
    this.presented?.loops.unpin(id);
  }

  // ---- where one looks, and pictures of it

  /** Back to the first view of the model. */
  resetView(): void {
    this.core?.stage?.resetView();
  }

  /** Which way is up, and how that is known; undefined before the first model. */
  get upAxis(): UpAxis | undefined {
    return this.presented?.standing.axis;
  }

  /** The model's extent upwards, in model units; 0 before the first model. */
  get height(): number {
    return this.presented?.standing.height ?? 0;
  }

  /** Whether the camera is where `resetView` puts it. */
  get isAtHome(): boolean {
    return this.core?.stage?.isHome ?? false;
  }

  /** Whether the surface turns slowly, or will once the work is done, and nothing else has moved it since `resetView`. */
  get isTurning(): boolean {
    return this.core?.stage?.isTurning ?? false;
  }

  /** From where the surface is seen; undefined before the first model. */
  get camera(): CameraView | undefined {
    return this.core?.stage?.view;
  }

  /**
   * Looks from there at once; what lies beyond the limits of moving by hand is brought within. Where it looks from there
   * already, nothing happens.
   */
  set camera(view: CameraView) {
    this.core?.stage?.lookFrom(view);
  }

  /** Moves the camera to where a place is seen well: smoothly, unless the system asks for less motion. */
  flyTo(place: PlaceOnSurface): void {
    const atOnce = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.require().flyTo(place, atOnce);
  }

  /** Where a point of the surface is on the element, in CSS pixels from its top left corner. */
  screenPosition(point: SurfacePoint): ScreenPoint {
    const { surface } = this.require().model;
    return this.core!.stage!.project(surface.positionOf(point));
  }

  /**
   * The picture as it is now, as a PNG: with a transparent background; or with the legend, on the element's
   * paper, unless that is to be transparent too; larger than on the screen, with a scale bar, for print.
   * Rejected with NO_WEBGL where there is no picture.
   */
  async snapshot(options: FigureOptions = {}): Promise<Blob> {
    const core = await this.needed();
    return core.snapshot(options);
  }

  /**
   * The outline of the surface, its sharp edges, and the loops and lines that are drawn on it, as SVG: what the surface
   * hides is left out, but for loops, which are dashed there; words are text. A section cuts, and has no line of its own.
   * @experimental
   */
  async drawing(options: DrawingOptions = {}): Promise<string> {
    this.require();
    const core = await this.needed();
    return core.drawing(options);
  }

  /**
   * A picture of one place as a PNG with a transparent background: the camera looks at it from where it
   * is seen best, its loop is drawn if it is given, and the rest of the surface is faded. What is on the
   * element stays as it is. Rejected with NO_WEBGL where there is no picture.
   */
  async snapshotOf(picture: PlacePicture): Promise<Blob> {
    const core = await this.needed();
    return core.snapshotOf(picture);
  }

  // ---- files, in the element's unit

  /** A field, or two in one, as a file's content; computed first unless it is there. */
  async exportField(
    format: FieldFormat,
    name: FieldName | CombinedName = 'igf',
  ): Promise<Uint8Array> {
    return this.exportFields([name], format);
  }

  /** Several fields in one file, also such as were not computed here; NPY takes only one. */
  async exportFields(
    fields: readonly (FieldName | CombinedName | NamedField)[],
    format: FieldFormat,
  ): Promise<Uint8Array> {
    const { mesh, life, fields: known } = (await this.#whole()).model;
    const { unit } = this;
    const whole = await Promise.all(
      fields.map(async (field) => {
        if (typeof field !== 'string') return field;
        if (isFieldName(field)) return this.fieldOf(field);
        return known.combinedToWrite(field, unit);
      }),
    );
    return mesh.exportFields(whole, format, { signal: life.signal, unit });
  }

  /** The tips as a file's content. */
  async exportTips(format: 'json' | 'obj'): Promise<Uint8Array> {
    const { mesh, life } = (await this.#whole()).model;
    const { unit } = this;
    return mesh.exportTips(await this.fieldOf('igf'), format, { signal: life.signal, unit });
  }

  /** The limbs as a file's content: everything, or a row for each. */
  async exportLimbs(format: 'json' | 'csv'): Promise<Uint8Array> {
    const { mesh, life } = (await this.#whole()).model;
    const { unit } = this;
    return mesh.exportLimbs(await this.fieldOf('igf'), format, { signal: life.signal, unit });
  }

  /** The parts as a file's content. */
  async exportParts(options: PartOptions, format: 'json'): Promise<Uint8Array> {
    const { model } = await this.#whole();
    const { igf, sdf } = await model.girthAndDiameter();
    const { signal } = model.life;
    return model.mesh.exportParts(igf, sdf, options, format, { signal, unit: this.unit });
  }

  /** The answer of the print check as a file's content. */
  async exportWeakPlaces(limits: PrintLimits, format: 'json'): Promise<Uint8Array> {
    const { model } = await this.#whole();
    const fields = await model.printFields(limits);
    const { signal } = model.life;
    return model.mesh.exportWeakPlaces(fields, limits, format, { signal, unit: this.unit });
  }

  /**
   * The parts of the surface, cut along curves, as files: one, or with 'stl' and 'ply' one for each part.
   * @experimental
   */
  async exportCut(
    curves: readonly (readonly SurfacePoint[])[],
    format: CutFormat,
    options: CutOptions = {},
  ): Promise<Uint8Array[]> {
    const { mesh, life } = (await this.#whole()).model;
    return mesh.exportCut(curves, format, { signal: life.signal, unit: this.unit, ...options });
  }

  /**
   * The segments as a file's content: a label for each face, everything, or a node for each segment.
   * @experimental
   */
  async exportSegments(
    format: 'csv' | 'json' | 'glb',
    options: SegmentOptions = {},
  ): Promise<Uint8Array> {
    const { model } = await this.#whole();
    const { igf, sdf } = await model.girthAndDiameter();
    const { signal } = model.life;
    const { unit } = this;
    return model.mesh.exportSegments(igf, sdf, format, { signal, unit, ...options });
  }

  /**
   * The girth along the shortest path through points, or what was measured along a path or an axis, as a file's content: a
   * row for each place, or everything; the loops of an axis also as lines.
   * @experimental
   */
  async exportProfile<Along extends readonly SurfacePoint[] | Profile | LimbAxis>(
    along: Along,
    format: 'csv' | 'json' | (Along extends LimbAxis ? 'obj' | 'glb' : never),
    options: ProfileOptions = {},
  ): Promise<Uint8Array> {
    const { mesh, life } = (await this.#whole()).model;
    const { signal } = life;
    return mesh.exportProfile(along as LimbAxis, format, { signal, unit: this.unit, ...options });
  }

  /** The pinned loops, oldest first, a file's content for each. */
  async exportLoops(format: LoopFormat): Promise<Uint8Array[]> {
    const { mesh, life, fields } = (await this.#whole()).model;
    const points = this.pinned.map(({ loop }) => loop.base);
    const { persistence } = fields;
    return mesh.exportLoops(points, format, { signal: life.signal, unit: this.unit, persistence });
  }
}

takeTexts(GirthViewer.prototype);
