// `<girth-viewer>`: a surface, its girth as colours, and the loop under the pointer.

import type {
  Field,
  GirthErrorFields,
  Loop,
  Mesh,
  MeshInfo,
  MeshSource,
  PartialField,
} from '../kernel/types.js';
import {
  type Adjacency,
  type ColormapName,
  FieldPreview,
  GroundShadow,
  Latest,
  Legend,
  type LengthFormat,
  LoopBand,
  type ScreenPoint,
  Stage,
  Surface,
  TimeLeft,
  borrowedWeight,
  buildAdjacency,
  computedWeight,
  formatLength,
  inSlices,
  isColormapName,
  lengthFormat,
  splatShadow,
  splitCreases,
} from '../view/index.js';
import { make } from './dom.js';
import { MessageBox } from './message-box.js';
import { PinTag, Readout, antipodalWords } from './readout.js';
import { sharedKernel } from './shared-kernel.js';
import { StatusBar } from './status-bar.js';
import { style } from './style.js';

/** Edges sharper than this stay visible as creases, in radians. */
const creaseAngle = (38 * Math.PI) / 180;
/** Milliseconds a frame may spend on spreading colours. */
const spreadBudget = 5;
/** The pointer may move this far, in CSS pixels, between press and release of a click. */
const clickSlack = 5;
/** Milliseconds of reading before the element says that it reads. */
const readingDelay = 150;
/** CSS pixels that one key press moves the probe. */
const probeStep = 14;

const liveStyle = { colour: '#ffffff', weight: 1 };
const pinnedStyle = { colour: '#ff7a45', weight: 0.9 };

/** A loop that stays on the surface until it is removed. */
export interface PinnedLoop {
  /** Counts up from 1 for each model; also written on the surface. */
  id: number;
  vertex: number;
  loop: Loop;
}

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
export interface PickDetail {
  /** 'hover': the loop under the pointer is shown; 'pin' and 'unpin': it was kept or let go. */
  action: 'hover' | 'pin' | 'unpin';
  vertex: number;
  loop: Loop;
}

/** Everything that belongs to one model. */
interface Model {
  mesh: Mesh;
  surface: Surface;
  preview: FieldPreview;
  /** Set once the whole field is there. */
  field: Field | undefined;
  computing: AbortController | undefined;
  /** Aborted when the model goes. */
  life: AbortController;
  nextPin: number;
}

interface Pin extends PinnedLoop {
  band: LoopBand;
  tag: PinTag;
  midpoint: Surface['bounds']['center'];
}

/**
 * `<girth-viewer src="model.glb"></girth-viewer>`
 *
 * Attributes:
 * - `src`: address of a GLB, glTF or OBJ file.
 * - `field`: `igf` (default) or `none` for a plain surface.
 * - `colormap`: `viridis` (default), `cividis`, `plasma`, `magma` or `turbo`.
 * - `range`: `auto` (default) or two numbers, the values at the ends of the colour map.
 * - `loop`: `hover` (default), `none`, or vertices whose loops are pinned once the model is there,
 *   as in `loop="12 4031"`.
 * - `edges`: draws the mesh's edges.
 * - `turn`: turns slowly until touched, unless the system asks for reduced motion.
 *
 * Events: `load` (`LoadDetail`), `progress` (`ProgressDetail`), `field` (`FieldDetail`), `pick`
 * (`PickDetail`), `error` (`GirthErrorFields`), `touch` (no detail: the surface no longer turns).
 * None bubbles.
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
  private readonly readout = new Readout();
  private readonly tags = make('div');
  private readonly message = new MessageBox();
  private readonly live = make('div', { class: 'quiet-live', 'aria-live': 'polite' });
  private readonly status = new StatusBar({
    cancel: () => this.cancel(),
    restart: () => void this.compute(),
  });

  private stage: Stage | undefined;
  private model: Model | undefined;
  private pins: Pin[] = [];
  private hover: { loop: Loop; band: LoopBand } | undefined;
  private hovered: number | undefined;
  private format: LengthFormat = lengthFormat(1, '');
  private colormapName: ColormapName = 'viridis';
  private fixedRange: [number, number] | undefined;

  private inView = false;
  private whenInView: (() => void)[] = [];
  private loading: AbortController | undefined;
  private pointer: { x: number; y: number; type: string } | undefined;
  private pressed: { x: number; y: number } | undefined;
  private pickRequested = 0;
  private readonly watchers: (() => void)[] = [];

  private readonly loops = new Latest<number, Loop>(
    (vertex, signal) => this.requireModel().mesh.loop(vertex, { signal }),
    (_vertex, loop) => this.showHover(loop),
    (_vertex, error) => this.fail('', error),
  );

  constructor() {
    super();
    const root = this.attachShadow({ mode: 'open' });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style);
    root.adoptedStyleSheets = [sheet];
    root.append(
      this.canvas,
      this.legend.element,
      this.tags,
      this.readout.element,
      this.status.element,
      this.message.element,
      this.live,
    );
    this.listen();
  }

  connectedCallback(): void {
    try {
      this.stage = new Stage(this.canvas, {
        beforeFrame: () => this.beforeFrame(),
        afterFrame: () => this.afterFrame(),
        touched: () => this.dispatchEvent(new CustomEvent('touch')),
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
    const resized = new ResizeObserver(() =>
      stage.resize(this.clientWidth, this.clientHeight, window.devicePixelRatio),
    );
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
      stage.turning = this.hasAttribute('turn') && !motion.matches;
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
    this.listen();
    this.inView = false;
    this.whenInView = [];
  }

  attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    if (before === value) return;
    switch (name) {
      case 'src':
        if (value !== null && this.stage) void this.loadSrc();
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
        if (value === 'none') this.clearHover();
        break;
      case 'edges':
        this.model?.surface.showEdges(value !== null);
        break;
      case 'turn':
        if (this.stage) {
          const still = window.matchMedia('(prefers-reduced-motion: reduce)').matches;
          this.stage.turning = value !== null && !still;
        }
        break;
    }
    this.stage?.invalidate();
  }

  /** The model that is shown; undefined before the first. */
  get info(): MeshInfo | undefined {
    return this.model?.mesh.info;
  }

  /** How the element writes lengths of the present field. */
  get lengthFormat(): LengthFormat {
    return this.format;
  }

  /** The pinned loops, oldest first. */
  get pinned(): PinnedLoop[] {
    return this.pins.map(({ id, vertex, loop }) => ({ id, vertex, loop }));
  }

  /**
   * Reads a model and shows it, grey at first; the field follows by itself. Where the file cannot
   * be used the model before stays, the element says why, `error` is sent and the promise rejected.
   * A newer call ends an older one.
   */
  async load(source: MeshSource): Promise<MeshInfo> {
    this.loading?.abort();
    const loading = new AbortController();
    this.loading = loading;
    const { signal } = loading;
    const address = typeof source === 'string' ? new URL(source, this.baseURI) : source;
    const name = nameOf(source);
    const slow = setTimeout(() => this.status.showReading(name), readingDelay);
    let mesh: Mesh | undefined;
    try {
      const kernel = await sharedKernel();
      signal.throwIfAborted();
      mesh = await kernel.load(address, { signal });
      const { positions, indices } = mesh.geometry;
      const vertexCount = positions.length / 3;
      const adjacency = await inSlices(buildAdjacency(vertexCount, indices), signal);
      const creased = await inSlices(splitCreases(positions, indices, creaseAngle), signal);
      signal.throwIfAborted();
      this.show(mesh, new Surface(positions, indices, adjacency, creased), adjacency);
      return mesh.info;
    } catch (error) {
      mesh?.dispose();
      if (!signal.aborted) this.fail(name, error);
      throw error;
    } finally {
      clearTimeout(slow);
      if (this.loading === loading) {
        this.loading = undefined;
        this.status.endReading();
      }
    }
  }

  /** A copy of a field's values, one per vertex of the surface; NaN where not (yet) computed. */
  values(name: 'igf'): Float64Array {
    const model = this.requireModel();
    if (name !== 'igf') throw new RangeError(`no field is called ${String(name)}`);
    return (model.field?.values ?? model.preview.values).slice();
  }

  /** The exact loop at a vertex of the surface. */
  loop(vertex: number): Promise<Loop> {
    return this.requireModel().mesh.loop(vertex, { signal: this.requireModel().life.signal });
  }

  /** Computes the loop at a vertex and keeps it on the surface. */
  async pin(vertex: number): Promise<PinnedLoop> {
    const model = this.requireModel();
    const loop = this.hover?.loop.vertex === vertex ? this.hover.loop : await this.loop(vertex);
    const already = this.pins.find((pin) => pin.vertex === vertex);
    if (already) return already;
    if (this.model !== model) throw new Error('the model was replaced');
    const id = model.nextPin++;
    const pin: Pin = {
      id,
      vertex,
      loop,
      band: new LoopBand(loop, pinnedStyle),
      tag: new PinTag(id, loop, () => this.unpin(id)),
      midpoint: model.surface.bounds.center.clone().fromArray(loop.midpoint),
    };
    pin.tag.setFormat(this.format);
    this.pins.push(pin);
    this.tags.append(pin.tag.element);
    this.stage?.add(pin.band);
    this.clearHover();
    this.send<PickDetail>('pick', { action: 'pin', vertex, loop });
    return { id, vertex, loop };
  }

  /** Removes a pinned loop; nothing happens where there is none of that id. */
  unpin(id: number): void {
    const pin = this.pins.find((one) => one.id === id);
    if (!pin) return;
    this.pins = this.pins.filter((one) => one !== pin);
    this.stage?.remove(pin.band);
    pin.tag.element.remove();
    this.send<PickDetail>('pick', { action: 'unpin', vertex: pin.vertex, loop: pin.loop });
  }

  /** Stops computing the field; what there is stays. */
  cancel(): void {
    this.model?.computing?.abort();
  }

  /** Back to the first view of the model. */
  resetView(): void {
    this.stage?.resetView();
  }

  /** Where a vertex is on the element, in CSS pixels from its top left corner. */
  screenPosition(vertex: number): ScreenPoint {
    const { surface } = this.requireModel();
    if (!this.stage) throw new Error('the element is not on a page');
    return this.stage.project(surface.positionOf(vertex));
  }

  /** The picture as it is now, without the legend, as a PNG with a transparent background. */
  async snapshot(): Promise<Blob> {
    if (!this.stage) throw new Error('the element is not on a page');
    return this.stage.snapshot();
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

  private show(mesh: Mesh, surface: Surface, adjacency: Adjacency): void {
    this.dropModel();
    this.message.clear();
    const model: Model = {
      mesh,
      surface,
      preview: new FieldPreview(adjacency),
      field: undefined,
      computing: undefined,
      life: new AbortController(),
      nextPin: 1,
    };
    this.model = model;
    surface.setColormap(this.colormapName);
    surface.showEdges(this.hasAttribute('edges'));
    this.format = lengthFormat(2 * surface.bounds.radius, mesh.info.unit);
    this.stage?.show(surface);
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
      this.stage?.setShadow(new GroundShadow(grid, model.surface.bounds, ground, halfWidth));
      for (const vertex of parseVertices(this.getAttribute('loop'))) await this.pin(vertex);
    } catch (error) {
      if (!signal.aborted) this.fail('', error);
    }
  }

  private async compute(): Promise<void> {
    const { model } = this;
    if (!model || model.computing || model.field) return;
    await this.untilInView();
    if (this.getAttribute('field') === 'none' || this.model !== model || model.computing) return;
    const computing = new AbortController();
    model.computing = computing;
    const timeLeft = new TimeLeft(performance.now());
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
          if (this.model === model) this.receive(model, partial);
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
    }
  }

  private sendField(share: number): void {
    const model = this.requireModel();
    const range = this.extent() ?? [NaN, NaN];
    this.send<FieldDetail>('field', { name: 'igf', range, unit: model.mesh.info.unit, share });
    if (share === 1) this.live.textContent = 'The girth is computed.';
  }

  private dropModel(): void {
    const { model } = this;
    if (!model) return;
    this.loops.clear();
    this.clearHover();
    for (const pin of this.pins) {
      this.stage?.remove(pin.band);
      pin.tag.element.remove();
    }
    this.pins = [];
    this.model = undefined;
    model.computing?.abort();
    model.life.abort();
    model.mesh.dispose();
    this.stage?.show(undefined);
    this.status.clear();
    this.legend.update(undefined);
  }

  // ---- colours

  private receive({ surface, preview }: Model, partial: PartialField): void {
    if (this.getAttribute('field') === 'none') return;
    preview.receive(partial, (vertex) =>
      surface.setScalar(vertex, preview.shown[vertex]!, computedWeight),
    );
    this.stage?.invalidate();
  }

  /** Once a frame: colours spread a little further. Returns whether some are still to come. */
  private beforeFrame(): boolean {
    const { model } = this;
    if (!model || model.field || model.preview.computed === 0) return false;
    if (this.getAttribute('field') === 'none') return false;
    const { surface, preview } = model;
    const done = preview.spread(
      (vertex) => surface.setScalar(vertex, preview.shown[vertex]!, borrowedWeight),
      performance.now() + spreadBudget,
      () => performance.now(),
    );
    surface.uploadScalars();
    this.updateRange();
    return !done;
  }

  private paintAll(): void {
    const { model } = this;
    if (!model) return;
    const { surface, preview, field } = model;
    if (this.getAttribute('field') === 'none') surface.clearScalars();
    else {
      const shown = field?.values ?? preview.shown;
      for (let v = 0; v < shown.length; ++v) {
        const known = field || preview.isComputed(v) ? computedWeight : borrowedWeight;
        surface.setScalar(v, shown[v]!, Number.isNaN(shown[v]) ? 0 : known);
      }
      surface.uploadScalars();
    }
    this.updateRange();
    this.stage?.invalidate();
  }

  /** The smallest and largest value there is. */
  private extent(): [number, number] | undefined {
    return this.model?.field?.range ?? this.model?.preview.range;
  }

  private updateRange(): void {
    const { model } = this;
    const reach = this.getAttribute('field') === 'none' ? undefined : this.extent();
    if (!model || !reach) {
      this.legend.update(undefined);
      return;
    }
    const format = lengthFormat(reach[1], model.mesh.info.unit);
    if (JSON.stringify(format) !== JSON.stringify(this.format)) {
      this.format = format;
      for (const pin of this.pins) pin.tag.setFormat(format);
      if (this.hover) this.readout.show(this.hover.loop, format);
    }
    const range = this.fixedRange ?? reach;
    model.surface.setRange(...range);
    this.legend.update({
      title: 'Girth',
      colormap: this.colormapName,
      range,
      extent: reach,
      format,
    });
  }

  // ---- the loop under the pointer

  private listen(): void {
    const { canvas } = this;
    canvas.addEventListener('pointermove', (event) => {
      this.pointer = { x: event.clientX, y: event.clientY, type: event.pointerType };
      if (event.buttons === 0) this.requestPick();
    });
    canvas.addEventListener('pointerdown', (event) => {
      this.pressed = event.isPrimary ? { x: event.clientX, y: event.clientY } : undefined;
    });
    canvas.addEventListener('pointerup', (event) => {
      const { pressed } = this;
      this.pressed = undefined;
      if (!pressed || event.button !== 0) return;
      const moved = Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y);
      if (moved <= clickSlack) this.click(event);
    });
    canvas.addEventListener('pointerleave', (event) => {
      if (event.pointerType !== 'mouse' && event.pointerType !== 'pen') return;
      this.pointer = undefined;
      this.clearHover();
    });
    canvas.addEventListener('wheel', () => this.stage?.touch(), { passive: true });
    canvas.addEventListener('keydown', (event) => this.key(event));
  }

  private get followsPointer(): boolean {
    return this.getAttribute('loop') !== 'none';
  }

  /** Picks once per frame at most. */
  private requestPick(): void {
    if (!this.followsPointer) return;
    this.pickRequested ||= requestAnimationFrame(() => {
      this.pickRequested = 0;
      if (this.pointer) this.hoverAt(this.pointer.x, this.pointer.y);
    });
  }

  private hoverAt(x: number, y: number): void {
    const vertex = this.stage?.pick(x, y);
    this.canvas.classList.toggle('picking', vertex !== undefined);
    if (vertex === undefined) {
      this.clearHover();
      return;
    }
    this.stage?.touch();
    this.hoverOn(vertex);
    this.placeReadout();
  }

  private hoverOn(vertex: number): void {
    if (vertex === this.hovered) return;
    this.hovered = vertex;
    this.loops.request(vertex);
  }

  private click(event: PointerEvent): void {
    if (!this.followsPointer) return;
    const vertex = this.stage?.pick(event.clientX, event.clientY);
    this.pointer = { x: event.clientX, y: event.clientY, type: event.pointerType };
    if (vertex === undefined) {
      this.clearHover();
      return;
    }
    // A finger cannot hover: its first tap shows the loop, a second tap near by pins it.
    if (event.pointerType === 'touch' && !this.isNear(vertex)) {
      this.hoverOn(vertex);
      return;
    }
    this.pinHere(event.pointerType === 'touch' ? this.hover!.loop.vertex : vertex);
  }

  /** True where the loop that is shown belongs to a vertex within a finger's width. */
  private isNear(vertex: number): boolean {
    if (!this.hover) return false;
    const [a, b] = [this.screenPosition(vertex), this.screenPosition(this.hover.loop.vertex)];
    return Math.hypot(a.x - b.x, a.y - b.y) < 24;
  }

  private pinHere(vertex: number): void {
    this.pin(vertex).catch((error: unknown) => {
      if (this.model && !this.model.life.signal.aborted) this.fail('', error);
    });
  }

  private showHover(loop: Loop): void {
    const { stage } = this;
    if (!stage || loop.vertex !== this.hovered) {
      // An answer for a place that the pointer has passed is still worth seeing while it moves.
      if (!stage || this.hovered === undefined) return;
    }
    if (this.hover) stage.remove(this.hover.band);
    this.hover = { loop, band: new LoopBand(loop, liveStyle) };
    stage.add(this.hover.band);
    this.readout.show(loop, this.format);
    this.placeReadout();
    if (!this.pointer) this.announce(loop);
    this.send<PickDetail>('pick', { action: 'hover', vertex: loop.vertex, loop });
  }

  private announce(loop: Loop): void {
    const words = loop.kind === 'loop' ? 'Loop' : antipodalWords;
    this.live.textContent = `${words} ${formatLength(loop.length, this.format)}`;
  }

  private placeReadout(): void {
    if (!this.hover) return;
    const box = this.canvas.getBoundingClientRect();
    const point =
      this.pointer && this.pointer.type !== 'touch'
        ? { x: this.pointer.x - box.left, y: this.pointer.y - box.top }
        : this.screenPosition(this.hover.loop.vertex);
    this.readout.place(point.x, point.y, box.width, box.height);
  }

  private clearHover(): void {
    this.hovered = undefined;
    this.loops.clear();
    this.readout.clear();
    if (this.hover) this.stage?.remove(this.hover.band);
    this.hover = undefined;
  }

  private key(event: KeyboardEvent): void {
    const { stage } = this;
    if (!stage || !this.model || event.ctrlKey || event.altKey || event.metaKey) return;
    const arrows: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) this.moveProbe(...arrow);
    else if (arrow) stage.orbit(0.12 * arrow[0], 0.12 * arrow[1]);
    else if (event.key === '+' || event.key === '=') stage.zoom(0.88);
    else if (event.key === '-' || event.key === '_') stage.zoom(1 / 0.88);
    else if (event.key === '0' || event.key === 'Home') stage.resetView();
    else if (event.key === 'Enter' && this.hover) this.pinHere(this.hover.loop.vertex);
    else if (event.key === 'Escape') this.clearHover();
    else if (event.key === 'Delete' || event.key === 'Backspace') {
      const last = this.pins.at(-1);
      if (last) this.unpin(last.id);
    } else return;
    event.preventDefault();
  }

  /** Moves the loop's vertex over the surface, from edge to edge, to the right and up on the screen. */
  private moveProbe(right: number, up: number): void {
    const { stage } = this;
    if (!stage || !this.followsPointer) return;
    const { surface } = this.requireModel();
    this.pointer = undefined;
    stage.touch();
    let vertex = this.hovered;
    if (vertex === undefined) {
      const box = this.canvas.getBoundingClientRect();
      // The middle of the view may look through a hole: search outwards from it.
      for (let ring = 0; ring < 12 && vertex === undefined; ++ring) {
        for (let k = 0; k < Math.max(1, 6 * ring) && vertex === undefined; ++k) {
          const angle = (2 * Math.PI * k) / Math.max(1, 6 * ring);
          const reach = (ring / 24) * Math.min(box.width, box.height);
          vertex = stage.pick(
            box.left + box.width / 2 + reach * Math.cos(angle),
            box.top + box.height / 2 + reach * Math.sin(angle),
          );
        }
      }
      if (vertex !== undefined) this.hoverOn(vertex);
      return;
    }
    const start = stage.project(surface.positionOf(vertex));
    const along = (v: number): number => {
      const point = stage.project(surface.positionOf(v));
      return right * (point.x - start.x) - up * (point.y - start.y);
    };
    let reached = 0;
    for (let step = 0; step < 40 && reached < probeStep; ++step) {
      let best = reached;
      let next = vertex;
      for (const neighbour of surface.neighboursOf(vertex)) {
        const distance = along(neighbour);
        if (distance > best) [best, next] = [distance, neighbour];
      }
      if (next === vertex) break;
      [vertex, reached] = [next, best];
    }
    this.hoverOn(vertex);
  }

  private afterFrame(): void {
    const { stage } = this;
    if (!stage) return;
    for (const pin of this.pins) {
      pin.tag.place(stage.project(pin.midpoint), this.clientWidth, this.clientHeight);
    }
    if (!this.pointer || this.pointer.type === 'touch') this.placeReadout();
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
  return 'name' in source && typeof source.name === 'string' ? source.name : '';
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
