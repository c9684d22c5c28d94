// `<girth-viewer>`: a surface, its girth as colours, and the loop under the pointer.

import type {
  Field,
  FieldFormat,
  FieldName,
  Loop,
  LoopFormat,
  Maximum,
  MeshInfo,
  NamedField,
  PartOptions,
  Parts,
  PartThresholds,
  PrintLimits,
  SpectralOptions,
  SurfacePoint,
  Tips,
  WeakPlace,
} from '../kernel/types.js';
import {
  type CameraView,
  type LengthFormat,
  type ScreenPoint,
  type ShownName,
  isFieldName,
  lengthFormat,
} from '../view/index.js';
import type { PinnedLoop } from './loops-on-surface.js';
import type { PartsWish, PlaceOnSurface, PlacePicture } from './presented.js';
import type { ShownField } from './shading.js';
import { withLegend } from './snapshot.js';
import type { TipsChoice } from './tips-on-surface.js';
import { ViewerBase } from './viewer-base.js';

/**
 * `<girth-viewer src="model.glb"></girth-viewer>`
 *
 * Attributes:
 * - `src`: address of a model: GLB, glTF with its buffers beside it, OBJ, PLY, STL, OFF, or a zip.
 * - `unit`: the unit of lengths where the file does not say it, for example `mm`.
 * - `field`: what colours the surface: `igf` (the girth, default), `sdf` (the shape diameter), `geoaverage`
 *   and `geofarthest` (mean and greatest geodesic distance), `angle` (of the loop at its base), `hks`, `wks`
 *   and `sihks` (one number of the heat, wave and scale-invariant heat kernel signatures), `kind` (of the
 *   loop), `tips` (how far the girth rises at the tip that a place is in), `parts` (tubes, plates and
 *   body) or `none`.
 * - `colormap`: `viridis` (default), `cividis`, `plasma`, `magma`, `turbo`, or `rdbu`, which diverges and is
 *   the default where values have both signs.
 * - `range`: `auto` (default); two numbers, the values at the ends of the colour map; or two percentages as
 *   in `5% 95%`, the shares of the surface's area that lie below them.
 * - `isolines`: so many lines of equal value between the ends of the range; none by default.
 * - `time`: of `hks`, as a share of the surface's area, `0.002` by default; small times see small details.
 * - `energy`: of `wks`, from `1` (low: the whole shape) to `100` (details); `20` by default.
 * - `component`: of `sihks`, the frequency, from `1` (default) to `19`. Numbers that there are not are an
 *   `error` with the code INVALID_OPTION; what is no number is as if it were not said. Changed while its
 *   field is shown, each of these three computes it anew.
 * - `loop`: `hover` (default), `none`, or vertices whose loops are pinned once the model is there,
 *   as in `loop="12 4031"`.
 * - `edges`: draws the mesh's edges.
 * - `turn`: turns slowly once it is computed and until touched, unless the system asks for reduced motion.
 *
 * Events: `load` (`LoadDetail`), `progress` (`ProgressDetail`), `field` (`FieldDetail`: one is computed, or
 * was cancelled), `fieldchange` (`FieldChangeDetail`: the surface is coloured otherwise), `hover`
 * (`HoverDetail`), `pick` (`PickDetail`), `error` (`GirthErrorFields`), `touch` (no detail: the surface no
 * longer turns), `unit` (no detail: lengths are written in another unit), `camera` (no detail: it was moved,
 * and is at rest again). None bubbles.
 *
 * Keyboard, while the surface has the focus: arrows turn, + and − zoom, 0 resets; Shift with an
 * arrow moves a probe over the surface, Enter pins its loop, Escape hides it, Delete removes the
 * last pinned loop.
 *
 * Nothing is fetched for `src` or computed before the element is in view, and no field before it is asked
 * for, by the attribute or by a method. All elements of a page share one kernel.
 */
export class GirthViewer extends ViewerBase {
  #tipsTurn = 0;

  /** The vertex of the surface for each vertex of the file; 0xFFFFFFFF where no face uses it. */
  get vertexOfInput(): Uint32Array {
    return this.require().model.mesh.vertexOfInput;
  }

  /** How the element writes lengths: those of loops, and the girth. */
  get lengthFormat(): LengthFormat {
    return this.presented?.lengthFormat ?? lengthFormat(1, this.unit);
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
   * Shows a surface of about `faces` faces in place of the present one; of a remeshed surface, in
   * place of that which it was made of.
   */
  async remesh(faces: number): Promise<MeshInfo> {
    const { mesh, fields } = this.require().model;
    const from = this.madeFrom ?? { mesh, field: fields.get('igf')?.field };
    const { name } = from.mesh.info;
    const words = `Remeshing ${name || 'the model'} …`;
    return this.bring(words, name, (watched) => from.mesh.remesh(faces, watched), from);
  }

  /** What the surface was remeshed from; undefined where it was not. */
  get original(): MeshInfo | undefined {
    return this.madeFrom?.mesh.info;
  }

  /**
   * How far the field of a remeshed surface is from that of the original: equation (1) of the paper;
   * undefined where one of the two is not computed.
   */
  async differenceToOriginal(): Promise<number | undefined> {
    const { madeFrom: before } = this;
    const { mesh, fields, life } = this.require().model;
    const field = fields.get('igf')?.field;
    if (!before?.field || !field) return undefined;
    return mesh.difference(field, before.mesh, before.field, { signal: life.signal });
  }

  // ---- fields, tips and parts

  /** A copy of a field's values, one per vertex of the surface; NaN where not (yet) computed. */
  values(name: FieldName): Float64Array {
    const { fields } = this.require().model;
    if (!isFieldName(name)) throw new RangeError(`no field is called ${String(name)}`);
    return fields.valuesOf(name).slice();
  }

  /** A whole field; computed now, in view of the user, unless it is there. Cancelling rejects. */
  async fieldOf(name: FieldName): Promise<Field> {
    if (!isFieldName(name)) throw new RangeError(`no field is called ${String(name)}`);
    return this.require().model.fields.compute(name);
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
    return this.require().model.tips();
  }

  /** Draws the tips' contours and apexes and tints their regions, or no longer. */
  async showTips(choice: TipsChoice): Promise<void> {
    const presented = this.require();
    const turn = ++this.#tipsTurn;
    if (!choice.shown) {
      presented.tips.clear();
      return;
    }
    const tips = await presented.model.tips();
    if (this.presented === presented && turn === this.#tipsTurn) presented.tips.show(tips, choice);
  }

  /** Where a field is greatest, or least, among its surroundings; most persistent first. */
  async maxima(name: FieldName, options: { minima?: boolean } = {}): Promise<Maximum[]> {
    return this.require().model.maxima(name, options.minima ?? false);
  }

  /** Where heat stays longest, most persistent first: the paper's comparison with the tips. */
  async heatMaxima(options: SpectralOptions = {}): Promise<Maximum[]> {
    return this.require().model.heatMaxima(options);
  }

  /** Marks vertices with diamonds, to be compared with the tips; nothing said: none. */
  showPoints(vertices: ArrayLike<number> = []): void {
    this.require().showPoints(vertices);
  }

  /** Thresholds to start from; girth and shape diameter are computed first. */
  async suggestedThresholds(): Promise<PartThresholds> {
    return this.require().model.suggestedThresholds();
  }

  /** Tubes, plates and body as connected parts; girth and shape diameter are computed first. */
  async parts(options: PartOptions): Promise<Parts> {
    return this.require().model.parts(options);
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

  /** Places that are too thin to print, thinnest first. */
  async weakPlaces(limits: PrintLimits): Promise<WeakPlace[]> {
    return this.require().model.weakPlaces(limits);
  }

  /** Shows these vertices as they are and fades the others; nothing said: all as they are. */
  mark(vertices?: ArrayLike<number>): void {
    this.require().mark(vertices);
  }

  // ---- loops

  /** The exact loop at a vertex of the surface, or at a point of one of its faces. */
  async loop(point: SurfacePoint): Promise<Loop> {
    const { mesh, life } = this.require().model;
    return mesh.loop(point, { signal: life.signal });
  }

  /** Computes the loop at a vertex or at a point of a face, and keeps it on the surface. */
  async pin(point: SurfacePoint): Promise<PinnedLoop> {
    return this.require().loops.pin(point);
  }

  /** Removes a pinned loop; nothing happens where there is none of that id. */
  unpin(id: number): void {
    this.presented?.loops.unpin(id);
  }

  // ---- where one looks, and pictures of it

  /** Back to the first view of the model. */
  resetView(): void {
    this.stage?.resetView();
  }

  /** From where the surface is seen; undefined before the first model. */
  get camera(): CameraView | undefined {
    return this.stage?.view;
  }

  /** Looks from there at once; what lies beyond the limits of moving by hand is brought within. */
  set camera(view: CameraView) {
    this.stage?.lookFrom(view);
  }

  /** Moves the camera to where a place is seen well: smoothly, unless the system asks for less motion. */
  flyTo(place: PlaceOnSurface): void {
    const atOnce = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.require().flyTo(place, atOnce);
  }

  /** Where a point of the surface is on the element, in CSS pixels from its top left corner. */
  screenPosition(point: SurfacePoint): ScreenPoint {
    const { surface } = this.require().model;
    return this.stage!.project(surface.positionOf(point));
  }

  /**
   * The picture as it is now, as a PNG: with a transparent background; or with the legend, on the
   * element's paper.
   */
  async snapshot(options: { legend?: boolean } = {}): Promise<Blob> {
    if (!this.stage) throw new Error('the element is not on a page');
    const picture = this.stage.picture();
    const content = options.legend ? this.presented?.shading.legend : undefined;
    return blobOf(options.legend ? withLegend(picture, content, this) : picture);
  }

  /**
   * A picture of one place as a PNG with a transparent background: the camera looks at it from where it
   * is seen best, its loop is drawn if it is given, and the rest of the surface is faded. What is on the
   * element stays as it is.
   */
  async snapshotOf(picture: PlacePicture): Promise<Blob> {
    return blobOf(this.require().pictureOf(picture));
  }

  // ---- files, in the element's unit

  /** A field as a file's content; computed first unless it is there. */
  async exportField(format: FieldFormat, name: FieldName = 'igf'): Promise<Uint8Array> {
    const { mesh, life } = this.require().model;
    const { unit } = this;
    return mesh.exportField(await this.fieldOf(name), format, { signal: life.signal, unit });
  }

  /** Several fields in one file, also such as were not computed here; NPY takes only one. */
  async exportFields(
    fields: readonly (FieldName | NamedField)[],
    format: FieldFormat,
  ): Promise<Uint8Array> {
    const { mesh, life } = this.require().model;
    const { unit } = this;
    const whole = await Promise.all(
      fields.map(async (field) => (typeof field === 'string' ? this.fieldOf(field) : field)),
    );
    return mesh.exportFields(whole, format, { signal: life.signal, unit });
  }

  /** The tips as a file's content. */
  async exportTips(format: 'json' | 'obj'): Promise<Uint8Array> {
    const { mesh, life } = this.require().model;
    const { unit } = this;
    return mesh.exportTips(await this.fieldOf('igf'), format, { signal: life.signal, unit });
  }

  /** The parts as a file's content. */
  async exportParts(options: PartOptions, format: 'json'): Promise<Uint8Array> {
    const { model } = this.require();
    const { igf, sdf } = await model.girthAndDiameter();
    const { signal } = model.life;
    return model.mesh.exportParts(igf, sdf, options, format, { signal, unit: this.unit });
  }

  /** The places that are too thin to print as a file's content. */
  async exportWeakPlaces(limits: PrintLimits, format: 'json'): Promise<Uint8Array> {
    const { model } = this.require();
    const { igf, sdf } = await model.girthAndDiameter();
    const { signal } = model.life;
    return model.mesh.exportWeakPlaces(igf, sdf, limits, format, { signal, unit: this.unit });
  }

  /** The pinned loops, oldest first, a file's content for each. */
  async exportLoops(format: LoopFormat): Promise<Uint8Array[]> {
    const { mesh, life } = this.require().model;
    const points = this.pinned.map(({ loop }) => loop.base);
    return mesh.exportLoops(points, format, { signal: life.signal, unit: this.unit });
  }
}

function blobOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error('the picture is empty'))),
      'image/png',
    );
  });
}
