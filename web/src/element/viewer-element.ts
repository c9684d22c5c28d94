// `<girth-viewer>`: a surface, its girth as colours, and the loop under the pointer.

import type {
  Field,
  FieldFormat,
  FieldName,
  GirthErrorFields,
  LoadOptions,
  Loop,
  LoopFormat,
  Maximum,
  Mesh,
  MeshInfo,
  MeshSource,
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
  Legend,
  type LengthFormat,
  type ScreenPoint,
  type ShownName,
  Stage,
  fieldTitle,
  fieldUnit,
  isColormapName,
  isFieldName,
  isShownName,
  lengthFormat,
} from '../view/index.js';
import { make } from './dom.js';
import type { FieldState, FieldsHost } from './fields.js';
import { groundUnder } from './ground.js';
import type { PickDetail, PinnedLoop } from './loops-on-surface.js';
import { MessageBox } from './message-box.js';
import { Model } from './model.js';
import { fieldsOf, nameOf, parseCount, parseRange, parseVertices } from './parse.js';
import { type PartsWish, type PlaceOnSurface, type PlacePicture, Presented } from './presented.js';
import type { ShadingWishes, ShownField } from './shading.js';
import { sharedKernel } from './shared-kernel.js';
import { withLegend } from './snapshot.js';
import { StatusBar } from './status-bar.js';
import { style } from './style.js';
import type { TipsChoice } from './tips-on-surface.js';
import { Work, type Watched } from './work.js';

/** In an element up to this wide, as in the style, the legend lies at the bottom; CSS pixels. */
const narrow = 520;
const legendHeight = 92;
/** Shares of the time to show a model: until the kernel has it; the rest is spent on drawing. */
const kernelShare = 0.7;
/** More lines of equal value than this are no lines. */
const mostIsolines = 100;

/** The events' details; see `GirthViewer`. */
export interface LoadDetail {
  info: MeshInfo;
}
export interface ProgressDetail {
  name: FieldName;
  /** The finished share in [0, 1]. */
  fraction: number;
  /** Undefined while it is too early to tell. */
  secondsLeft: number | undefined;
}
export interface FieldDetail {
  name: FieldName;
  /** NaN twice where there is no value. */
  range: [number, number];
  /** Of the values; lengths in the element's unit. */
  unit: string;
  /** 1, or the computed share of the vertices where the work was cancelled. */
  share: number;
}
export interface FieldChangeDetail {
  name: ShownName;
  /** Undefined as long as there is nothing to show. */
  shown: ShownField | undefined;
}
export interface HoverDetail {
  /** The vertex nearest to what is pointed at; undefined beside the surface. */
  vertex: number | undefined;
  /** The values there of every field that is computed there. */
  values: Partial<Record<FieldName, number>>;
}

/** What a remeshed surface was made of. */
interface Original {
  mesh: Mesh;
  field: Field | undefined;
}

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
export class GirthViewer extends HTMLElement {
  static readonly observedAttributes = [
    'src',
    'unit',
    'field',
    'colormap',
    'range',
    'isolines',
    'loop',
    'edges',
    'turn',
  ];

  private canvas = make('canvas', {
    tabindex: '0',
    role: 'application',
    'aria-roledescription': '3D surface',
    'aria-label':
      'Surface. Arrows turn, plus and minus zoom, Shift with arrows moves a probe, Enter pins its loop.',
  });
  private readonly legend = new Legend();
  private readonly message = new MessageBox();
  private readonly live = make('div', { class: 'quiet-live', 'aria-live': 'polite' });
  private readonly status = new StatusBar({
    cancel: () => this.cancel(),
    cancelWork: () => this.work.cancel(),
    restart: () => void this.restart(),
  });
  private readonly work = new Work(this.status);

  private stage: Stage | undefined;
  private presented: Presented | undefined;
  private madeFrom: Original | undefined;
  /** The field whose computation was cancelled. */
  private halted: FieldName | undefined;
  private readonly said = new WeakSet<object>();

  private inView = false;
  /** Whether the surface was moved by hand, so that it no longer turns by itself. */
  private touched = false;
  private pointedVertex: number | undefined;
  private tipsTurn = 0;
  private whenInView: (() => void)[] = [];
  private readonly watchers: (() => void)[] = [];

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style);
    root.adoptedStyleSheets = [sheet];
    root.append(
      this.canvas,
      this.legend.element,
      this.status.element,
      this.message.element,
      this.live,
    );
  }

  connectedCallback(): void {
    try {
      this.stage = new Stage(this.canvas, {
        beforeFrame: () => this.presented?.spread() ?? false,
        afterFrame: () => this.presented?.loops.place(),
        touched: () => {
          if (this.touched) return;
          this.touched = true;
          this.dispatchEvent(new CustomEvent('touch'));
        },
        rested: () => this.dispatchEvent(new CustomEvent('camera')),
      });
    } catch {
      this.message.show(
        '',
        {
          code: 'NO_WEBGL',
          element: -1,
          message: 'this browser cannot draw surfaces: WebGL 2 is switched off or missing',
          hint: 'switch on hardware acceleration in its settings, or use another browser',
        },
        false,
      );
      return;
    }
    const { stage } = this;
    const resized = new ResizeObserver(() => {
      const { clientWidth, clientHeight } = this;
      const bottom = clientWidth <= narrow ? legendHeight : 0;
      stage.resize(clientWidth, clientHeight, bottom, window.devicePixelRatio);
    });
    resized.observe(this);
    const seen = new IntersectionObserver((entries) => {
      this.inView = entries.at(-1)!.isIntersecting;
      stage.rest(!this.inView);
      if (this.inView) for (const go of this.whenInView.splice(0)) go();
    });
    seen.observe(this);
    const motion = window.matchMedia('(prefers-reduced-motion: reduce)');
    const respectMotion = (): void => {
      stage.setDamping(!motion.matches);
      this.updateTurning();
    };
    motion.addEventListener('change', respectMotion);
    respectMotion();
    this.watchers.push(
      () => resized.disconnect(),
      () => seen.disconnect(),
      () => motion.removeEventListener('change', respectMotion),
    );
    if (this.hasAttribute('src')) void this.loadSrc();
  }

  disconnectedCallback(): void {
    for (const stop of this.watchers.splice(0)) stop();
    this.work.cancel();
    this.dropModel();
    this.stage?.dispose();
    this.stage = undefined;
    // A lost context cannot be had again from the same canvas.
    const fresh = this.canvas.cloneNode() as HTMLCanvasElement;
    this.canvas.replaceWith(fresh);
    this.canvas = fresh;
    this.inView = false;
    this.whenInView = [];
  }

  attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    if (before === value) return;
    switch (name) {
      case 'src':
        if (value !== null && this.stage) void this.loadSrc();
        break;
      case 'unit':
        this.restyle(false);
        if (this.presented) this.dispatchEvent(new CustomEvent('unit'));
        break;
      case 'field':
        if (value === 'none') this.cancel();
        this.restyle(true);
        void this.showField();
        break;
      case 'range':
        this.restyle(false);
        // Percentages ask for the vertices' areas.
        void this.showField();
        break;
      case 'colormap':
      case 'isolines':
        this.restyle(false);
        this.sendChange();
        break;
      case 'loop':
        if (value === 'none') this.presented?.loops.clear();
        break;
      case 'edges':
        this.presented?.model.surface.showEdges(value !== null);
        break;
      case 'turn':
        this.updateTurning();
        break;
    }
    this.stage?.invalidate();
  }

  /** The model that is shown; undefined before the first. */
  get info(): MeshInfo | undefined {
    return this.presented?.model.mesh.info;
  }

  /** The vertex of the surface for each vertex of the file; 0xFFFFFFFF where no face uses it. */
  get vertexOfInput(): Uint32Array {
    return this.require().model.mesh.vertexOfInput;
  }

  /** The unit of lengths: the file's, or where it does not say, the attribute's; '' for none. */
  get unit(): string {
    return this.info?.unit || (this.getAttribute('unit') ?? '');
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
   * Reads a model and shows it, grey at first; the field follows by itself. Where the file cannot
   * be used the model before stays, the element says why, `error` is sent and the promise rejected.
   * A newer call ends an older one.
   */
  async load(
    source: MeshSource,
    options: Pick<LoadOptions, 'model' | 'prepare'> = {},
  ): Promise<MeshInfo> {
    const name = nameOf(source);
    const address = typeof source === 'string' ? new URL(source, this.baseURI) : source;
    return this.bring(`Reading ${name || 'the model'} …`, name, async (watched) => {
      const kernel = await sharedKernel();
      return kernel.load(address, { ...options, ...watched });
    });
  }

  /** Makes another mesh ready to draw and shows it, with words and a cross meanwhile. */
  private bring(
    words: string,
    name: string,
    make: (watched: Watched) => Promise<Mesh>,
    before?: Original,
  ): Promise<MeshInfo> {
    return this.work.run(words, async ({ signal, onProgress }) => {
      try {
        const mesh = await make({
          signal,
          onProgress: (fraction) => onProgress(kernelShare * fraction),
        });
        try {
          onProgress(kernelShare);
          signal.throwIfAborted();
          const model = await Model.of(mesh, this.fieldsHost, signal);
          await this.stage?.prepare(model.surface.object);
          signal.throwIfAborted();
          this.show(model, before);
        } catch (error) {
          mesh.dispose();
          throw error;
        }
        return mesh.info;
      } catch (error) {
        if (!signal.aborted) this.fail(name, error);
        throw error;
      }
    });
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
    const turn = ++this.tipsTurn;
    if (!choice.shown) {
      presented.tips.clear();
      return;
    }
    const tips = await presented.model.tips();
    if (this.presented === presented && turn === this.tipsTurn) presented.tips.show(tips, choice);
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

  /** Stops computing fields; what there is stays. */
  cancel(): void {
    this.presented?.model.fields.cancel();
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

  // ---- loading and computing

  private async loadSrc(): Promise<void> {
    await this.untilInView();
    const src = this.getAttribute('src');
    // What went wrong has been said already.
    if (src) await this.load(src).catch(() => undefined);
  }

  private untilInView(): Promise<void> {
    return this.inView
      ? Promise.resolve()
      : new Promise((resolve) => this.whenInView.push(resolve));
  }

  private show(model: Model, before: Original | undefined): void {
    this.dropModel(before);
    if (!this.stage) throw new Error('the element is no longer on a page');
    this.madeFrom = before;
    this.message.clear();
    model.surface.showEdges(this.hasAttribute('edges'));
    // The unit of what is shown is the model's own, which is not there yet.
    const wishes = { ...this.wishes, unit: model.mesh.info.unit || this.wishes.unit };
    this.presented = new Presented(this.stage, this.canvas, model, wishes, {
      followsPointer: () => this.getAttribute('loop') !== 'none',
      pointed: (vertex) => this.pointed(vertex),
      picked: (detail) => this.send<PickDetail>('pick', detail),
      failed: (error) => this.fail('', error),
      relabelled: (legend) => this.legend.update(legend),
    });
    this.legend.element.after(this.presented.loops.element);
    this.send<LoadDetail>('load', { info: model.mesh.info });
    void this.afterShowing(this.presented);
    void this.showField();
  }

  /** What may come after the first picture. */
  private async afterShowing({ model, loops }: Presented): Promise<void> {
    const { signal } = model.life;
    try {
      await new Promise((resolve) => setTimeout(resolve));
      signal.throwIfAborted();
      await model.surface.prepareToPick();
      signal.throwIfAborted();
      const shadow = await groundUnder(model.mesh, model.surface, signal);
      await this.stage?.prepare(shadow.object);
      signal.throwIfAborted();
      this.stage?.setShadow(shadow);
      await loops.prepare();
      signal.throwIfAborted();
      for (const vertex of parseVertices(this.getAttribute('loop'))) await this.pin(vertex);
    } catch (error) {
      if (!signal.aborted) this.fail('', error);
    }
  }

  /** `kept` is still wanted: what comes next was made of it. */
  private dropModel(kept?: Original): void {
    const { presented, madeFrom: before } = this;
    if (before && before.mesh !== kept?.mesh) before.mesh.dispose();
    this.madeFrom = undefined;
    this.halted = undefined;
    this.pointedVertex = undefined;
    if (!presented) return;
    this.presented = undefined;
    presented.dispose(kept?.mesh === presented.model.mesh);
    this.status.clear();
    this.legend.update(undefined);
  }

  /** Computes what the attributes ask for, and shows it. */
  private async showField(): Promise<void> {
    const { presented } = this;
    if (!presented) return;
    const { name } = this.wishes;
    const isWanted = (): boolean => this.presented === presented && this.wishes.name === name;
    await this.untilInView();
    if (!isWanted()) return;
    try {
      await presented.shading.prepare();
      if (!isWanted()) return;
      presented.paint();
      this.sendChange();
    } catch (error) {
      if (this.presented === presented) this.fail('', error);
    }
  }

  private readonly fieldsHost: FieldsHost = {
    received: (state, partial) => {
      if (!this.isPresent(state)) return;
      this.presented!.shading.receive(state, partial);
      this.stage?.invalidateSoon();
    },
    progressed: (name, fraction, secondsLeft) => {
      this.status.showProgress(fieldTitle(name), fraction, secondsLeft);
      this.updateTurning();
      if (fraction > 0) this.send<ProgressDetail>('progress', { name, fraction, secondsLeft });
    },
    ended: (state, error) => {
      if (!this.isPresent(state)) return;
      const { name, field } = state;
      const { shading, model } = this.presented!;
      if (!model.fields.computing) this.status.clear();
      if (field) {
        if (shading.wishes.name === name) this.presented!.paint();
        this.sendField(name, field.range, 1);
      } else if (fieldsOf(error).code === 'CANCELLED') {
        const share = model.fields.shareOf(name);
        this.halted = name;
        this.status.showPartial(fieldTitle(name), share);
        this.sendField(name, state.preview?.range ?? [NaN, NaN], share);
      } else {
        this.fail(model.mesh.info.name, error);
      }
      this.updateTurning();
    },
  };

  /** Whether a field is one of the model that is shown. */
  private isPresent(state: FieldState): boolean {
    return this.presented?.model.fields.get(state.name) === state;
  }

  /** Goes on with what was cancelled. */
  private async restart(): Promise<void> {
    const { halted } = this;
    this.halted = undefined;
    // What goes wrong is said where the field ends.
    if (halted && this.presented) await this.fieldOf(halted).catch(() => undefined);
    await this.showField();
  }

  /** Turns where it is asked for, but not while it computes: the work goes first. */
  private updateTurning(): void {
    if (!this.stage) return;
    const still = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    const isBusy = this.presented?.model.fields.computing ?? false;
    const turning = this.hasAttribute('turn') && !this.touched && !still && !isBusy;
    if (this.stage.turning !== turning) this.stage.turning = turning;
  }

  // ---- colours

  /** What the attributes ask for. */
  private get wishes(): ShadingWishes {
    const field = this.getAttribute('field');
    const colormap = this.getAttribute('colormap');
    return {
      name: isShownName(field) ? field : 'igf',
      colormap: isColormapName(colormap) ? colormap : undefined,
      range: parseRange(this.getAttribute('range')),
      isolines: parseCount(this.getAttribute('isolines'), mostIsolines),
      unit: this.unit,
    };
  }

  /** Shows what there is as the attributes ask for now; `anew` where each vertex has another colour. */
  private restyle(anew: boolean): void {
    const { presented } = this;
    if (!presented) return;
    presented.shading.wishes = this.wishes;
    if (anew) presented.paint();
    else presented.refresh();
  }

  // ---- odds and ends

  private require(): Presented {
    if (!this.presented) throw new Error('no model is loaded');
    return this.presented;
  }

  private pointed(vertex: number | undefined): void {
    if (vertex === this.pointedVertex) return;
    this.pointedVertex = vertex;
    const values = vertex === undefined ? {} : this.require().valuesAt(vertex);
    this.send<HoverDetail>('hover', { vertex, values });
  }

  private sendField(name: FieldName, range: [number, number], share: number): void {
    const unit = fieldUnit(name, this.unit);
    this.send<FieldDetail>('field', { name, range, unit, share });
    if (share === 1) this.live.textContent = `${fieldTitle(name)}: computed.`;
  }

  private sendChange(): void {
    if (!this.presented) return;
    const { name } = this.wishes;
    this.send<FieldChangeDetail>('fieldchange', { name, shown: this.shown });
  }

  private send<Detail>(name: string, detail: Detail): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  /** Says what went wrong, once; that something was cancelled is no news. */
  private fail(name: string, error: unknown): void {
    const fields = fieldsOf(error);
    if (fields.code === 'CANCELLED') return;
    if (error instanceof Error) {
      if (this.said.has(error)) return;
      this.said.add(error);
    }
    this.message.show(name, fields, this.presented !== undefined);
    this.send<GirthErrorFields>('error', fields);
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
