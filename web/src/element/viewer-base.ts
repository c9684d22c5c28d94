// The element on its page: its attributes, a model that comes and goes, and what is computed of it.

import type { Field, FieldName, LoadOptions, Mesh, MeshInfo, MeshSource } from '../kernel/types.js';
import { openWorker } from '../kernel/worker-from-elsewhere.js';
import {
  type Box,
  Legend,
  type ShownName,
  Stage,
  fieldTitle,
  fieldUnit,
  findLengthUnit,
  isColormapName,
  isShownName,
  readLengthOrShare,
} from '../view/index.js';
import { type AttributeName, attributeNames, attributeOf, faultOf, isOn } from './attributes.js';
import { CanvasControls } from './canvas-controls.js';
import { make } from './dom.js';
import type { GirthViewerEvents } from './events.js';
import type { FieldState, FieldsHost } from './fields.js';
import { Lifecycle } from './lifecycle.js';
import { MessageBox } from './message-box.js';
import { Model } from './model.js';
import { fieldsOf, nameOf, parseRange, parseSpectral, parseVertices } from './parse.js';
import { pageParsed } from './page-parsed.js';
import { Presented } from './presented.js';
import type { ShadingWishes } from './shading.js';
import { sharedKernel } from './shared-kernel.js';
import { StatusBar } from './status-bar.js';
import { style } from './style.js';
import { watchSurroundings } from './surroundings.js';
import { Voice } from './voice.js';
import { Work, type Watched } from './work.js';

/** In an element up to this wide, as in the style, the legend lies at the bottom; CSS pixels. */
const narrow = 520;
const legendHeight = 92;
/** Of the status, with its margin, at the bottom; CSS pixels. */
const statusHeight = 56;

/** The symbol of a unit of length; '' for none. */
const unitOf = (text: string | null): string => findLengthUnit(text ?? '')?.symbol ?? '';

/** What a remeshed surface was made of. */
export interface Original {
  mesh: Mesh;
  field: Field | undefined;
}

/** On a server, which renders pages but has no elements, a class that nobody makes one of. */
const ElementOrNone = globalThis.HTMLElement ?? class {};

/** See `GirthViewer`, which adds what can be asked of the element. */
export abstract class ViewerBase extends ElementOrNone {
  /** The attributes that the element follows; see `GirthViewer`. */
  static readonly observedAttributes: readonly string[] = attributeNames;

  #canvas = make('canvas', {
    tabindex: '0',
    role: 'application',
    'aria-roledescription': '3D surface',
    'aria-label': 'Surface',
    'aria-describedby': 'keys',
  });
  readonly #legend = new Legend(() => {
    this.setAttribute('range', '0% 100%');
    this.#send('view', null);
  });
  readonly #message = new MessageBox();
  readonly #voice = new Voice();
  readonly #status = new StatusBar({
    cancel: () => this.cancel(),
    cancelWork: () => this.#lifecycle.cancelLoad(),
    restart: () => void this.#restart(),
  });

  readonly #lifecycle = new Lifecycle<Mesh, Model, Presented, Original, ShownName, FieldName>(
    new Work(this.#status),
    {
      prepare: async (mesh, signal) => {
        const model = await Model.of(mesh, this.#fieldsHost, signal);
        await this.stage?.prepare(model.surface.object);
        return model;
      },
      present: (model, origin) => this.#present(model, origin),
      presented: (presented) => this.#greet(presented),
      drop: (presented, keepsMesh) => {
        this.#controls.leave();
        this.#pointedVertex = undefined;
        presented.dispose(keepsMesh);
        this.#status.clear();
        this.#legend.update(undefined);
      },
      failed: (name, error) => this.#fail(name, error),
    },
  );

  protected stage: Stage | undefined;
  readonly #reported = new WeakSet<object>();
  #pointedVertex: number | undefined;
  readonly #controls: CanvasControls;
  #stopWatching: (() => void) | undefined;
  #attached = new AbortController();

  constructor() {
    super();
    const host = { element: this, stage: () => this.stage, presented: () => this.presented };
    this.#controls = new CanvasControls(host);
    const root = this.attachShadow({ mode: 'open' });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style);
    root.adoptedStyleSheets = [sheet];
    root.append(
      this.#canvas,
      this.#legend.element,
      this.#status.element,
      this.#controls.element,
      this.#message.element,
      ...this.#voice.elements,
    );
  }

  /** Called by the browser when the element comes onto a page: it can draw from now on. */
  connectedCallback(): void {
    try {
      this.stage = new Stage(this.#canvas, {
        beforeFrame: () => this.presented?.spread() ?? false,
        afterFrame: () => {
          this.presented?.loops.place();
          this.#controls.place();
        },
        touched: () => this.#controls.touched(),
        rested: () => this.#send('camera', null),
      });
    } catch {
      this.#message.show(
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
    this.#lifecycle.attach();
    this.#stopWatching = watchSurroundings(this, {
      resized: (width, height) => {
        const bottom = width <= narrow ? legendHeight : 0;
        stage.resize(width, height, this.#headHeight, bottom, window.devicePixelRatio);
      },
      sighted: (isInView) => {
        stage.rest(!isInView);
        this.#lifecycle.setInView(isInView);
      },
      motionChanged: (isReduced) => {
        stage.setDamping(!isReduced);
        this.#controls.updateTurning();
      },
    });
    this.#attached = new AbortController();
    this.#controls.attach(this.#canvas, this.#attached.signal);
    if (this.hasAttribute('src')) void this.#loadSrc();
  }

  /** Called by the browser when the element leaves its page: all work ends, and all memory is let go. */
  disconnectedCallback(): void {
    this.#stopWatching?.();
    this.#stopWatching = undefined;
    this.#attached.abort();
    this.#lifecycle.detach();
    this.stage?.dispose();
    this.stage = undefined;
    // A lost context cannot be had again from the same canvas.
    const fresh = this.#canvas.cloneNode() as HTMLCanvasElement;
    this.#canvas.replaceWith(fresh);
    this.#canvas = fresh;
  }

  /** Called by the browser when one of `observedAttributes` has changed. */
  attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    if (before === value) return;
    const fault = value === null ? undefined : faultOf(name as AttributeName, value);
    if (fault) void pageParsed().then(() => this.#send('error', fault));
    switch (name) {
      case 'src':
        if (value !== null && this.stage) void this.#loadSrc();
        break;
      case 'unit':
      case 'shown-unit':
        this.#restyle(false);
        if (this.presented) this.#send('unit', null);
        break;
      case 'field':
        if (value === 'none') this.cancel();
        if (this.presented) this.presented.shading.places = undefined;
        this.#restyle(true);
        void this.#showField();
        break;
      case 'range':
        this.#restyle(false);
        // Percentages ask for the vertices' areas.
        void this.#showField();
        break;
      case 'colormap':
      case 'log':
      case 'isolines':
        this.#restyle(false);
        this.#sendChange();
        break;
      case 'persistence':
        this.#forgetGirth();
        break;
      case 'time':
        this.#choose('hks');
        break;
      case 'energy':
        this.#choose('wks');
        break;
      case 'component':
        this.#choose('sihks');
        break;
      case 'loop':
        if (value === 'none') this.presented?.loops.clear();
        break;
      default:
        this.#controls.follow(name);
        break;
    }
    this.stage?.invalidate();
  }

  protected get presented(): Presented | undefined {
    return this.#lifecycle.shown;
  }

  /** What the shown surface was remeshed from; undefined where it was not. */
  protected get madeFrom(): Original | undefined {
    return this.#lifecycle.origin;
  }

  /** The model that is shown; undefined before the first. */
  get info(): MeshInfo | undefined {
    return this.presented?.model.mesh.info;
  }

  /** The unit of lengths: the file's; where it states none, the attribute's; '' for none. */
  get unit(): string {
    return this.info?.unit || unitOf(attributeOf(this, 'unit'));
  }

  /** The unit that lengths are written in: the attribute's where it is one, otherwise ''. */
  get shownUnit(): string {
    return unitOf(attributeOf(this, 'shown-unit'));
  }

  /**
   * Reads a model and shows it, grey at first; the field follows by itself. Where the file cannot
   * be used the model before stays, the element shows why, `error` is sent and the promise rejected.
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
  protected async bring(
    words: string,
    name: string,
    read: (watched: Watched) => Promise<Mesh>,
    origin?: Original,
  ): Promise<MeshInfo> {
    return (await this.#lifecycle.load({ words, name, read, origin })).info;
  }

  /** Does what a key means for the surface, as if it had the focus; false where it means nothing. */
  press(event: KeyboardEvent): boolean {
    return this.#controls.press(event);
  }

  /** Stops computing fields; what there is stays. */
  cancel(): void {
    this.presented?.model.fields.cancel();
  }

  // ---- loading and computing

  async #loadSrc(): Promise<void> {
    await this.#lifecycle.inView();
    const src = attributeOf(this, 'src');
    // What went wrong has been reported already.
    if (src) await this.load(src).catch(() => undefined);
  }

  #present(model: Model, origin: Original | undefined): Presented {
    this.#message.clear();
    const { unreadable, name } = model.mesh.info;
    if (!origin) this.#message.showPassedOver(unreadable, name);
    // The unit of what is shown is the model's own, which is not there yet.
    const wishes = { ...this.#wishes, unit: model.mesh.info.unit || this.#wishes.unit };
    const up = attributeOf(this, 'up');
    const presented = new Presented(this.stage!, this.#canvas, model, wishes, up, {
      followsPointer: () => attributeOf(this, 'loop') !== 'none',
      pointed: (vertex) => this.#pointed(vertex),
      picked: (detail) => this.#send('pick', detail),
      failed: (error) => this.#fail('', error),
      furniture: () => this.#furniture(),
      relabelled: (legend) => {
        this.#legend.update(legend);
        this.#voice.call(this.#canvas, this.presented);
      },
    });
    this.#legend.element.after(presented.loops.element);
    return presented;
  }

  /** What lies on the canvas beside the surface: what the page writes on top, and the element's own. */
  #furniture(): Box[] {
    const { left, top, width, height } = this.getBoundingClientRect();
    const own = [...this.#legend.pieces, ...this.#status.element.children, this.#controls.element];
    const boxes = own.map((element) => {
      const box = element.getBoundingClientRect();
      return { left: box.left - left, top: box.top - top, width: box.width, height: box.height };
    });
    boxes.push({ left: 0, top: 0, width, height: this.#headHeight });
    // The status comes and goes; a line to what is below the legend would cross it.
    boxes.push({ left: 0, top: height - statusHeight, width, height: statusHeight });
    return boxes.filter((box) => box.width > 0 && box.height > 0);
  }

  /** The height at the top where the page writes something, in CSS pixels. */
  get #headHeight(): number {
    return Number.parseFloat(getComputedStyle(this).getPropertyValue('--girth-top')) || 0;
  }

  #greet(presented: Presented): void {
    this.#controls.greet();
    this.#send('load', { info: presented.model.mesh.info });
    void this.#afterShowing(presented);
    void this.#showField();
  }

  /** What may come after the first picture. */
  async #afterShowing({ model, loops, standing }: Presented): Promise<void> {
    const { signal } = model.life;
    try {
      await new Promise((resolve) => setTimeout(resolve));
      signal.throwIfAborted();
      await model.surface.prepareToPick((make) => openWorker(make, import.meta.url));
      signal.throwIfAborted();
      await standing.castShadow();
      await loops.prepare();
      signal.throwIfAborted();
      for (const vertex of parseVertices(attributeOf(this, 'loop'))) await loops.pin(vertex);
    } catch (error) {
      if (!signal.aborted) this.#fail('', error);
    }
  }

  /** Computes what the attributes ask for, and shows it. */
  async #showField(): Promise<void> {
    const { presented } = this;
    if (!presented) return;
    await this.#lifecycle.colour(
      this.#wishes.name,
      () => presented.shading.prepare(),
      () => {
        presented.paint();
        this.#sendChange();
      },
    );
  }

  /** Another number of a signature is wanted: what was computed of it no longer counts. */
  #choose(name: FieldName): void {
    const { presented } = this;
    if (!presented) return;
    presented.model.fields.forget(name);
    if (!presented.model.fields.computing) this.#status.clear();
    if (this.#wishes.name !== name) return;
    this.#restyle(true);
    void this.#showField();
  }

  /** Another persistence is wanted: what was made of the girth no longer counts. */
  #forgetGirth(): void {
    const { presented } = this;
    if (!presented) return;
    presented.model.forgetGirth();
    const { signal } = presented.model.life;
    presented.loops.renew().catch((error: unknown) => {
      if (!signal.aborted) this.#fail('', error);
    });
    if (!presented.model.fields.computing) this.#status.clear();
    this.#restyle(true);
    void this.#showField();
  }

  readonly #fieldsHost: FieldsHost = {
    persistence: ({ area, unit }) => {
      const text = attributeOf(this, 'persistence') ?? '0';
      const read = readLengthOrShare(text, unit || this.unit, Math.sqrt(area));
      return 'length' in read ? read.length : 0;
    },
    spectral: (name) => parseSpectral(name, (attribute) => attributeOf(this, attribute)),
    received: (state, partial) => {
      if (!this.#isPresent(state)) return;
      this.presented!.shading.receive(state, partial);
      this.stage?.invalidateSoon();
    },
    progressed: (name, fraction, secondsLeft) => {
      // One after the other, where there are several.
      const { computing } = this.presented?.model.fields ?? {};
      if ((computing ?? name) === name) {
        this.#status.showProgress(fieldTitle(name), fraction, secondsLeft);
      }
      this.#controls.updateTurning();
      if (fraction > 0) this.#send('progress', { name, fraction, secondsLeft });
    },
    ended: (state, error) => {
      if (!this.#isPresent(state)) return;
      const { name, field } = state;
      const { shading, model } = this.presented!;
      if (!model.fields.computing) this.#status.clear();
      if (field) {
        if (shading.name === name) this.presented!.paint();
        this.#sendField(name, field.range, 1);
      } else if (fieldsOf(error).code === 'CANCELLED') {
        const share = model.fields.shareOf(name);
        this.#lifecycle.halt(name);
        this.#status.showPartial(fieldTitle(name), share);
        this.#sendField(name, state.preview?.range ?? [NaN, NaN], share);
      } else {
        this.#fail(model.mesh.info.name, error);
      }
      this.#controls.updateTurning();
    },
  };

  /** Whether a field is one of the model that is shown. */
  #isPresent(state: FieldState): boolean {
    return this.presented?.model.fields.get(state.name) === state;
  }

  /** Goes on with what was cancelled. */
  async #restart(): Promise<void> {
    const isComputed = await this.#lifecycle.resume(({ model }, name) =>
      model.fields.compute(name),
    );
    if (isComputed) await this.#showField();
  }

  // ---- colours

  /** What the attributes ask for. */
  get #wishes(): ShadingWishes {
    const field = attributeOf(this, 'field');
    const colormap = attributeOf(this, 'colormap');
    return {
      name: isShownName(field) ? field : 'igf',
      colormap: isColormapName(colormap) ? colormap : undefined,
      range: parseRange(attributeOf(this, 'range')),
      log: isOn(this, 'log'),
      isolines: Number(attributeOf(this, 'isolines') ?? 0),
      unit: this.unit,
      shownUnit: this.shownUnit,
    };
  }

  /** Shows what there is as the attributes ask for now; `anew` where each vertex has another colour. */
  #restyle(anew: boolean): void {
    const { presented } = this;
    if (!presented) return;
    presented.shading.wishes = this.#wishes;
    if (anew) presented.paint();
    else presented.refresh();
  }

  // ---- odds and ends

  protected require(): Presented {
    if (!this.presented) throw new Error('no model is loaded');
    return this.presented;
  }

  #pointed(vertex: number | undefined): void {
    if (vertex === this.#pointedVertex) return;
    this.#pointedVertex = vertex;
    const values = vertex === undefined ? {} : this.require().valuesAt(vertex);
    this.#send('hover', { vertex, values });
  }

  #sendField(name: FieldName, range: [number, number], share: number): void {
    const unit = fieldUnit(name, this.unit);
    this.#send('field', { name, range, unit, share });
    if (share === 1) this.#voice.computed(name, range, this.require());
  }

  #sendChange(): void {
    if (!this.presented) return;
    this.#voice.call(this.#canvas, this.presented);
    const { name } = this.#wishes;
    this.#send('fieldchange', { name, shown: this.presented.shading.shown });
  }

  #send<Name extends keyof GirthViewerEvents>(
    name: Name,
    detail: GirthViewerEvents[Name]['detail'],
  ): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  /** Says what went wrong, once; that something was cancelled is no news. */
  #fail(name: string, error: unknown): void {
    const fields = fieldsOf(error);
    if (fields.code === 'CANCELLED') return;
    if (error instanceof Error) {
      if (this.#reported.has(error)) return;
      this.#reported.add(error);
    }
    this.#message.show(name, fields, this.presented !== undefined);
    this.#send('error', fields);
  }
}
