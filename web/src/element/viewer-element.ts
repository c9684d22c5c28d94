// `<girth-viewer>`: a surface, its girth as colours, and the loop under the pointer.

import { withPresentName } from '../kernel/types/older-names.js';
import type {
  CallOptions,
  Field,
  FieldName,
  HandleOptions,
  HandleRemoval,
  Loop,
  MeshInfo,
  SpectralOptions,
  SurfacePath,
  SurfacePoint,
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
import type { PinnedLoop } from './surface/loops-on-surface.js';
import { MeshCalls } from './mesh-calls.js';
import type { PartsWish, PlaceOnSurface, PlacePicture } from './presented.js';
import type { PlaceNumber } from './surface/numbers-on-surface.js';
import type { ShownField, ShownPlaces } from './surface/shading.js';
import type { DrawingOptions } from './figure/drawing.js';
import type { FigureOptions } from './figure/snapshot.js';
import type { StrokeOptions } from './surface/stroke.js';
import { takeTexts } from './attributes/property-texts.js';
import type { TipsChoice } from './surface/tips-on-surface.js';

/**
 * `<girth-viewer src="model.glb"></girth-viewer>`
 *
 * Attributes, which `GirthViewerAttributes` describes; a value that is none of theirs counts as if the attribute were
 * not there, is a warning on the console and an `error` with the code INVALID_OPTION. The content of the slot `caption`
 * stands below the surface.
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
export class GirthViewer extends MeshCalls {
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

  /** How the element writes lengths: those of loops, and the girth. */
  get lengthFormat(): LengthFormat {
    return this.core?.lengthFormat ?? lengthFormat(1, this.unit, this.shownUnit);
  }

  /** How the element writes the values of a field. */
  formatOf(name: ShownName): LengthFormat {
    return this.require().shading.formatOf(name);
  }

  /**
   * The field or categories that colour the surface, with their range; undefined as long as there
   * is nothing to show.
   */
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
    const { mesh, fields } = (await this.whole()).model;
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

  /**
   * The original that `remesh` or `removeHandles` made the surface of; undefined where neither did.
   */
  get original(): MeshInfo | undefined {
    return this.core?.madeFrom?.mesh.info;
  }

  /**
   * The handles that `removeHandles` took away from the original; undefined where the surface was
   * not made so.
   */
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

  /** Draws the tips' contours and apexes and tints their regions, or no longer. */
  async showTips(choice: TipsChoice): Promise<void> {
    this.require();
    await this.core!.showTips(choice);
  }

  /** Marks points of the surface with diamonds; without an argument none. */
  showPoints(points: ArrayLike<SurfacePoint> = []): void {
    this.require().showPoints(points);
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
    this.require().setThresholds(withPresentName(wish, 'thickness', 'shapeDiameter'));
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

  /**
   * Computes the saddles of all vertices, with progress and until `cancel`, and keeps them for as long as the
   * model is shown: from then on another `persistence` up to `maxPersistence`, in model units, shows at once.
   * Takes several times as long as the girth.
   */
  async keepBarcodes(maxPersistence: number): Promise<void> {
    this.require();
    await this.core!.keepBarcodes(maxPersistence);
  }

  /**
   * The next point of the surface that is clicked, tapped, or chosen with Enter, which then pins no loop. Rejected with
   * CANCELLED after Escape, when the signal fires, and when another model comes or the method is called again.
   */
  async choosePoint({ signal }: CallOptions = {}): Promise<SurfacePoint> {
    return (await this.whole()).loops.choosePoint(signal);
  }

  /**
   * The next points of a path that is drawn by hand: one that is clicked, tapped or chosen with Enter, or those along
   * the way of a pointer that is dragged over the surface, which does not turn meanwhile; beside it a drag turns
   * it. `drawn` has the points so far, while the pointer moves. Rejected as `choosePoint` is.
   * @experimental
   */
  async chooseStroke(options: StrokeOptions = {}): Promise<SurfacePoint[]> {
    const { loops } = await this.whole();
    return loops.chooseStroke(options);
  }

  /** Shows short words at places of the surface, in place of those before; without an argument none. */
  showNumbers(numbers: readonly PlaceNumber[] = []): void {
    this.require().numbers.show(numbers);
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
    const { loops } = await this.whole();
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

  /** Towards the camera, of length 1, in the coordinates of the positions; undefined before the first model. */
  get towardsEye(): [number, number, number] | undefined {
    return this.core?.stage?.towardsEye;
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
   * is seen best, its loop is drawn if it is given, and the rest of the surface is faded. The element itself stays as
   * it is. Rejected with NO_WEBGL where there is no picture.
   */
  async snapshotOf(picture: PlacePicture): Promise<Blob> {
    const core = await this.needed();
    return core.snapshotOf(picture);
  }
}

takeTexts(GirthViewer.prototype);
