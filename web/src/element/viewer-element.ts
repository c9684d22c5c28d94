// `<girth-viewer>`: a surface, its girth as colours, and the loop under the pointer.

import type {
  Field,
  FieldFormat,
  GirthErrorFields,
  LoadOptions,
  Loop,
  LoopFormat,
  Mesh,
  MeshInfo,
  MeshSource,
  SurfacePoint,
} from '../kernel/types.js';
import {
  type CameraView,
  type ColormapName,
  GroundShadow,
  Legend,
  type LengthFormat,
  type ScreenPoint,
  Stage,
  TimeLeft,
  inSlices,
  isColormapName,
  lengthFormat,
  splatShadow,
} from '../view/index.js';
import { make } from './dom.js';
import { LoopsOnSurface, type PickDetail, type PinnedLoop } from './loops-on-surface.js';
import { MessageBox } from './message-box.js';
import { Model } from './model.js';
import { sharedKernel } from './shared-kernel.js';
import { StatusBar } from './status-bar.js';
import { style } from './style.js';

/** In an element up to this wide, as in the style, the legend lies at the bottom; CSS pixels. */
const narrow = 520;
const legendHeight = 92;
/** Milliseconds of work on a model before the element says so. */
const workDelay = 150;
/** Shares of the time to show a model: until the kernel has it; the rest is spent on drawing. */
const kernelShare = 0.7;
/** The events' details; see `GirthViewer`. */
export interface LoadDetail {
  info: MeshInfo;
}
export interface ProgressDetail {
  /** The finished share in [0, 1]. */
  fraction: number;
  /** Undefined while it is too early to tell. */
  secondsLeft: number | undefined;
}
export interface FieldDetail {
  name: 'igf';
  range: [number, number];
  unit: string;
  /** 1, or the computed share of the vertices where the work was cancelled. */
  share: number;
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
 * - `field`: `igf` (default) or `none` for a plain surface.
 * - `colormap`: `viridis` (default), `cividis`, `plasma`, `magma` or `turbo`.
 * - `range`: `auto` (default) or two numbers, the values at the ends of the colour map.
 * - `loop`: `hover` (default), `none`, or vertices whose loops are pinned once the model is there,
 *   as in `loop="12 4031"`.
 * - `edges`: draws the mesh's edges.
 * - `turn`: turns slowly once it is computed and until touched, unless the system asks for reduced motion.
 *
 * Events: `load` (`LoadDetail`), `progress` (`ProgressDetail`), `field` (`FieldDetail`), `pick`
 * (`PickDetail`), `error` (`GirthErrorFields`), `touch` (no detail: the surface no longer turns),
 * `unit` (no detail: lengths are written in another unit), `camera` (no detail: it was moved, and is at
 * rest again). None bubbles.
 *
 * Keyboard, while the surface has the focus: arrows turn, + and − zoom, 0 resets; Shift with an
 * arrow moves a probe over the surface, Enter pins its loop, Escape hides it, Delete removes the
 * last pinned loop.
 *
 * Nothing is fetched for `src` or computed before the element is in view. All elements of a page
 * share one kernel.
 */
export class GirthViewer extends HTMLElement {
  static readonly observedAttributes = [
    'src',
    'unit',
    'field',
    'colormap',
    'range',
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
    cancelWork: () => this.loading?.abort(),
    restart: () => void this.compute(),
  });

  private stage: Stage | undefined;
  private model: Model | undefined;
  private madeFrom: Original | undefined;
  private loops: LoopsOnSurface | undefined;
  private format: LengthFormat = lengthFormat(1, '');
  private colormapName: ColormapName = 'viridis';
  private fixedRange: [number, number] | undefined;

  private inView = false;
  /** Whether the surface was moved by hand, so that it no longer turns by itself. */
  private touched = false;
  private whenInView: (() => void)[] = [];
  private loading: AbortController | undefined;
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
        beforeFrame: () => this.beforeFrame(),
        afterFrame: () => this.loops?.place(),
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
    this.loading?.abort();
    this.loading = undefined;
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
        this.updateFormat();
        this.updateRange();
        if (this.model) this.dispatchEvent(new CustomEvent('unit'));
        break;
      case 'field':
        if (value === 'none') this.cancel();
        this.paintAll();
        if (this.model && !this.model.field && value !== 'none') void this.compute();
        break;
      case 'colormap':
        this.colormapName = isColormapName(value) ? value : 'viridis';
        this.model?.surface.setColormap(this.colormapName);
        this.updateRange();
        break;
      case 'range':
        this.fixedRange = parseRange(value);
        this.updateRange();
        break;
      case 'loop':
        if (value === 'none') this.loops?.clear();
        break;
      case 'edges':
        this.model?.surface.showEdges(value !== null);
        break;
      case 'turn':
        this.updateTurning();
        break;
    }
    this.stage?.invalidate();
  }

  /** The model that is shown; undefined before the first. */
  get info(): MeshInfo | undefined {
    return this.model?.mesh.info;
  }

  /** The vertex of the surface for each vertex of the file; 0xFFFFFFFF where no face uses it. */
  get vertexOfInput(): Uint32Array {
    return this.requireModel().mesh.vertexOfInput;
  }

  /** The unit of lengths: the file's, or where it does not say, the attribute's; '' for none. */
  get unit(): string {
    return this.model?.mesh.info.unit || (this.getAttribute('unit') ?? '');
  }

  /** How the element writes lengths of the present field. */
  get lengthFormat(): LengthFormat {
    return this.format;
  }

  /** The pinned loops, oldest first. */
  get pinned(): PinnedLoop[] {
    return this.loops?.pinned ?? [];
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
    return this.work(`Reading ${name || 'the model'} …`, name, async (watched) => {
      const kernel = await sharedKernel();
      return kernel.load(address, { ...options, ...watched });
    });
  }

  /** Makes another mesh ready to draw and shows it, with words and a cross meanwhile. */
  private async work(
    words: string,
    name: string,
    make: (watched: { signal: AbortSignal; onProgress(share: number): void }) => Promise<Mesh>,
    before?: Original,
  ): Promise<MeshInfo> {
    this.loading?.abort();
    const loading = new AbortController();
    this.loading = loading;
    const { signal } = loading;
    let share = 0;
    let isSlow = false;
    const show = (): void => {
      if (isSlow && this.loading === loading) this.status.showWork(words, share);
    };
    const onProgress = (fraction: number): void => {
      share = kernelShare * fraction;
      show();
    };
    const slow = setTimeout(() => {
      isSlow = true;
      show();
    }, workDelay);
    try {
      const mesh = await make({ signal, onProgress });
      try {
        onProgress(1);
        signal.throwIfAborted();
        const model = await Model.of(mesh, signal);
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
    } finally {
      clearTimeout(slow);
      if (this.loading === loading) {
        this.loading = undefined;
        this.status.endWork();
      }
    }
  }

  /**
   * Shows a surface of about `faces` faces in place of the present one; of a remeshed surface, in
   * place of that which it was made of.
   */
  async remesh(faces: number): Promise<MeshInfo> {
    const model = this.requireModel();
    const from = this.madeFrom ?? { mesh: model.mesh, field: model.field };
    const { name } = from.mesh.info;
    const words = `Remeshing ${name || 'the model'} …`;
    return this.work(words, name, (watched) => from.mesh.remesh(faces, watched), from);
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
    const { madeFrom: before, model } = this;
    if (!before?.field || !model?.field) return undefined;
    const { signal } = model.life;
    return model.mesh.difference(model.field, before.mesh, before.field, { signal });
  }

  /** A copy of a field's values, one per vertex of the surface; NaN where not (yet) computed. */
  values(name: 'igf'): Float64Array {
    const model = this.requireModel();
    if (name !== 'igf') throw new RangeError(`no field is called ${String(name)}`);
    return model.values.slice();
  }

  /** The exact loop at a vertex of the surface, or at a point of one of its faces. */
  async loop(point: SurfacePoint): Promise<Loop> {
    const { mesh, life } = this.requireModel();
    return mesh.loop(point, { signal: life.signal });
  }

  /** Computes the loop at a vertex or at a point of a face, and keeps it on the surface. */
  async pin(point: SurfacePoint): Promise<PinnedLoop> {
    if (!this.loops) throw new Error('no model is on the page');
    return this.loops.pin(point);
  }

  /** Removes a pinned loop; nothing happens where there is none of that id. */
  unpin(id: number): void {
    this.loops?.unpin(id);
  }

  /** Stops computing the field; what there is stays. */
  cancel(): void {
    this.model?.computing?.abort();
  }

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

  /** Where a point of the surface is on the element, in CSS pixels from its top left corner. */
  screenPosition(point: SurfacePoint): ScreenPoint {
    const { surface } = this.requireModel();
    if (!this.stage) throw new Error('the element is not on a page');
    return this.stage.project(surface.positionOf(point));
  }

  /** The picture as it is now, without the legend, as a PNG with a transparent background. */
  async snapshot(): Promise<Blob> {
    if (!this.stage) throw new Error('the element is not on a page');
    return this.stage.snapshot();
  }

  /** The field as a file's content, in the element's unit; only once it is complete. */
  async exportField(format: FieldFormat): Promise<Uint8Array> {
    const { mesh, field, life } = this.requireModel();
    if (!field) throw new Error('the field is not computed yet');
    return mesh.exportField({ ...field, unit: this.unit }, format, { signal: life.signal });
  }

  /** The pinned loops, oldest first, a file's content for each, in the element's unit. */
  async exportLoops(format: LoopFormat): Promise<Uint8Array[]> {
    const { mesh, life } = this.requireModel();
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
    const { mesh, surface } = model;
    this.dropModel(before);
    this.madeFrom = before;
    this.message.clear();
    this.model = model;
    surface.setColormap(this.colormapName);
    surface.showEdges(this.hasAttribute('edges'));
    this.updateFormat();
    if (this.stage) {
      this.stage.show(surface);
      this.loops = new LoopsOnSurface(this.stage, this.canvas, model, this.format, {
        followsPointer: () => this.getAttribute('loop') !== 'none',
        picked: (detail) => this.send<PickDetail>('pick', detail),
        failed: (error) => this.fail('', error),
      });
      this.legend.element.after(this.loops.element);
    }
    this.send<LoadDetail>('load', { info: mesh.info });
    void this.afterShowing(model);
    void this.compute();
  }

  /** What may come after the first picture. */
  private async afterShowing(model: Model): Promise<void> {
    const { signal } = model.life;
    try {
      await new Promise((resolve) => setTimeout(resolve));
      signal.throwIfAborted();
      await model.surface.prepareToPick();
      signal.throwIfAborted();
      const { positions, indices } = model.mesh.geometry;
      const { center, radius } = model.surface.bounds;
      let [ground, top] = [Infinity, -Infinity];
      for (let i = 1; i < positions.length; i += 3) {
        ground = Math.min(ground, positions[i]!);
        top = Math.max(top, positions[i]!);
      }
      const halfWidth = 1.5 * radius;
      const grid = await inSlices(
        splatShadow(positions, indices, [center.x, center.z], ground, halfWidth, top - ground),
        signal,
      );
      const shadow = new GroundShadow(grid, model.surface.bounds, ground, halfWidth);
      await this.stage?.prepare(shadow.object);
      signal.throwIfAborted();
      this.stage?.setShadow(shadow);
      await this.loops?.prepare();
      signal.throwIfAborted();
      for (const vertex of parseVertices(this.getAttribute('loop'))) await this.pin(vertex);
    } catch (error) {
      if (!signal.aborted) this.fail('', error);
    }
  }

  private async compute(): Promise<void> {
    const { model } = this;
    if (!model || model.computing || model.field) return;
    await this.untilInView();
    if (!this.showsField || this.model !== model || model.computing) return;
    const computing = new AbortController();
    model.computing = computing;
    const timeLeft = new TimeLeft(performance.now());
    this.updateTurning();
    this.status.showProgress(0, undefined);
    try {
      const field = await model.mesh.field('igf', {
        signal: computing.signal,
        onProgress: (fraction) => {
          if (this.model !== model || computing.signal.aborted) return;
          const secondsLeft = timeLeft.update(fraction, performance.now());
          this.status.showProgress(fraction, secondsLeft);
          this.send<ProgressDetail>('progress', { fraction, secondsLeft });
        },
        onPartial: (partial) => {
          if (this.model !== model || !this.showsField) return;
          model.receive(partial);
          this.stage?.invalidateSoon();
        },
      });
      if (this.model !== model) return;
      model.field = field;
      this.status.clear();
      this.paintAll();
      this.sendField(1);
    } catch (error) {
      if (this.model !== model) return;
      if (computing.signal.aborted) {
        const share = model.preview.computed / model.mesh.info.vertexCount;
        this.status.showPartial(share);
        this.sendField(share);
      } else {
        this.status.clear();
        this.fail(model.mesh.info.name, error);
      }
    } finally {
      model.computing = undefined;
      this.updateTurning();
    }
  }

  /** Turns where it is asked for, but not while it computes: the work goes first. */
  private updateTurning(): void {
    if (!this.stage) return;
    const still = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.stage.turning =
      this.hasAttribute('turn') && !this.touched && !still && !this.model?.computing;
  }

  private sendField(share: number): void {
    const { extent } = this.requireModel();
    const range = extent ?? [NaN, NaN];
    this.send<FieldDetail>('field', { name: 'igf', range, unit: this.unit, share });
    if (share === 1) this.live.textContent = 'The girth is computed.';
  }

  /** `kept` is still wanted: what comes next was made of it. */
  private dropModel(kept?: Original): void {
    const { model, madeFrom: before } = this;
    if (before && before.mesh !== kept?.mesh) before.mesh.dispose();
    this.madeFrom = undefined;
    if (!model) return;
    this.loops?.dispose();
    this.loops = undefined;
    this.model = undefined;
    model.dispose(kept?.mesh === model.mesh);
    this.stage?.show(undefined);
    this.status.clear();
    this.legend.update(undefined);
  }

  // ---- colours

  private get showsField(): boolean {
    return this.getAttribute('field') !== 'none';
  }

  /** Once a frame: colours spread a little further. Returns whether some are still to come. */
  private beforeFrame(): boolean {
    const { model } = this;
    if (!model || model.field || model.preview.computed === 0 || !this.showsField) return false;
    const done = model.spread();
    this.updateRange();
    return !done;
  }

  private paintAll(): void {
    if (this.showsField) this.model?.paint();
    else this.model?.surface.clearScalars();
    this.updateRange();
    this.stage?.invalidate();
  }

  private updateRange(): void {
    const { model } = this;
    const reach = this.showsField ? model?.extent : undefined;
    if (!model || !reach) {
      this.legend.update(undefined);
      return;
    }
    this.updateFormat();
    const range = this.fixedRange ?? reach;
    // Where all values are the same but for rounding, they have the same colour.
    const least = 1e-5 * Math.abs(range[1]);
    const widen = range[1] - range[0] < least ? least : 0;
    model.surface.setRange(range[0] - widen, range[1] + widen);
    this.legend.update({
      title: 'Girth',
      colormap: this.colormapName,
      range,
      extent: reach,
      format: this.format,
    });
  }

  /** Lengths are written alike everywhere: as fits the field's, or before there is one, the model. */
  private updateFormat(): void {
    const { model } = this;
    if (!model) return;
    const largest =
      (this.showsField ? model.extent?.[1] : undefined) ?? 2 * model.surface.bounds.radius;
    const format = lengthFormat(largest, this.unit);
    if (JSON.stringify(format) === JSON.stringify(this.format)) return;
    this.format = format;
    this.loops?.setFormat(format);
  }

  // ---- odds and ends

  private requireModel(): Model {
    if (!this.model) throw new Error('no model is loaded');
    return this.model;
  }

  private send<Detail>(name: string, detail: Detail): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  private fail(name: string, error: unknown): void {
    const fields = fieldsOf(error);
    this.message.show(name, fields, this.model !== undefined);
    this.send<GirthErrorFields>('error', fields);
  }
}

function fieldsOf(error: unknown): GirthErrorFields {
  if (error instanceof Error && 'code' in error && typeof error.code === 'string') {
    const { element = -1, hint = '' } = error as Partial<GirthErrorFields>;
    return { code: error.code, element, message: error.message, hint };
  }
  const message = error instanceof Error ? error.message : String(error);
  return { code: 'INTERNAL', element: -1, message, hint: 'reload the page and try again' };
}

function nameOf(source: MeshSource): string {
  if (typeof source === 'string' || source instanceof URL) {
    return decodeURIComponent(String(source).split(/[?#]/)[0]!.split('/').pop() ?? '');
  }
  // Of several, that which is the model by its name; the kernel looks closer.
  const names = (Array.isArray(source) ? (source as object[]) : [source]).map(nameOfFile);
  return names.find((name) => /\.(glb|gltf|obj|off|ply|stl|zip)$/i.test(name)) ?? names[0] ?? '';
}

function nameOfFile(file: object): string {
  const { name = '', path = name } = file as { name?: string; path?: string };
  return path.slice(path.lastIndexOf('/') + 1);
}

/** Two ascending numbers; undefined for anything else. */
function parseRange(text: string | null): [number, number] | undefined {
  const numbers = (text ?? '')
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const [low = NaN, high = NaN] = numbers;
  return numbers.length === 2 && low < high ? [low, high] : undefined;
}

function parseVertices(text: string | null): number[] {
  return (text ?? '')
    .split(/[\s,]+/)
    .filter((word) => /^\d+$/.test(word))
    .map(Number);
}
