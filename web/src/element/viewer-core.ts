// The core of the element, which draws and computes: a model that comes and goes, as the attributes
// ask for it. It is fetched when it is first needed; `viewer-shell.ts` is there before.

import { failure } from '../kernel/types/errors.js';
import type {
  Field,
  FieldName,
  GirthErrorFields,
  HandleOptions,
  HandleRemoval,
  LoadOptions,
  Mesh,
  MeshInfo,
  MeshSource,
  Tips,
} from '../kernel/types/types.js';
import { unitSymbol } from '../kernel/types/units.js';
import { openWorker } from '../kernel/workers/worker-from-elsewhere.js';
import {
  type Box,
  type CameraView,
  Legend,
  type LengthFormat,
  type ShownName,
  Stage,
  fieldTitle,
  fieldUnit,
  formatLength,
  isColormapName,
  isShownName,
  lengthFormat,
  readLengthOrShare,
} from '../view/index.js';
import type { ViewerState } from './attributes/attribute-types.js';
import { attributeOf, controlsOf, isOn } from './attributes/attributes.js';
import { CanvasControls } from './controls/canvas-controls.js';
import { make } from './controls/dom.js';
import type { DrawingOptions } from './figure/drawing.js';
import type { GirthViewerEvents } from './events.js';
import type { FieldState, FieldsHost } from './model/fields.js';
import { readFigure } from './model/figure-file.js';
import { type FileContent, onlySurface } from './model/file-content.js';
import { carriedTo, givenFields } from './model/given-fields.js';
import { Lifecycle } from './lifecycle.js';
import type { LinkedView, SharedRange } from './surface/link.js';
import type { MessageBox } from './controls/message-box.js';
import { noGraphics, requireGraphics } from './controls/no-graphics.js';
import { Model } from './model/model.js';
import { openModel, openToCompute, tipsCarriedTo } from './model/open-model.js';
import { fieldsOf, nameOf, parseRange, parseSpectral } from './attributes/parse.js';
import { type PlacePicture, Presented } from './presented.js';
import type { Printed } from './surface/printed.js';
import type { ShadingWishes } from './surface/shading.js';
import { sharedKernel } from './model/shared-kernel.js';
import { StatusBar } from './controls/status-bar.js';
import type { FigureOptions, FigureParts } from './figure/snapshot.js';
import { style } from './controls/style.js';
import type { TipsChoice } from './surface/tips-on-surface.js';
import { watchSurroundings } from './surface/surroundings.js';
import { Voice } from './controls/voice.js';
import type { PinWish } from './attributes/wish-words.js';
import { Wishes } from './attributes/wishes.js';
import { Work, type Watched } from './work.js';

/** The greatest width, as in the style, at which the legend lies at the bottom; CSS pixels. */
const narrow = 520;
const legendHeight = 92;
/** The share of the surface's radius that something must be in front of a drawn line to hide it. */
const drawnSlack = 0.004;
/** The height of the status at the bottom, with its margin; CSS pixels. */
const statusHeight = 56;

/** The surface from which another was made, by remeshing it or by taking its handles away. */
export interface Original {
  mesh: Mesh;
  field: Field | undefined;
  /** The handles that were taken away. */
  removal?: HandleRemoval;
}

/** The view, pins and tips of a model shown as its file has it, for the kernel's mesh of it. */
interface Continued {
  mesh: Mesh;
  /** Undefined: as at first. */
  view: CameraView | undefined;
  pins: readonly PinWish[];
  /** Whether no loops are to be pinned but these. */
  isPinned: boolean;
  tips: { all: Tips; choice: TipsChoice } | undefined;
}

/** The element, as what is drawn in it knows it. */
export interface ViewerHost {
  /** Has the attributes, and sends the events. */
  readonly element: HTMLElement;
  /** The frame that the surface is drawn in. */
  readonly frame: HTMLElement;
  readonly message: MessageBox;
  /** The unit of lengths: the model's, or the attribute's; '' for none. */
  unitOf(): string;
  /** The unit that lengths are written in; '' for the model's. */
  shownUnitOf(): string;
  /** The first picture of a model is there. */
  drawn(): void;
  /** The browser cannot draw surfaces. */
  undrawable(error: GirthErrorFields): void;
  /** Whether there is a picture to be seen in place of the surface. */
  readonly hasPoster: boolean;
}

export class ViewerCore {
  readonly #host: ViewerHost;
  readonly #canvas = make('canvas', {
    tabindex: '0',
    role: 'application',
    'aria-roledescription': '3D surface',
    'aria-label': 'Surface',
    'aria-describedby': 'keys',
  });
  readonly #legend = new Legend(() => {
    this.#element.setAttribute('range', '0% 100%');
    this.#send('view', null);
  });
  readonly #voice = new Voice();
  readonly #status = new StatusBar({
    cancel: (name) => this.presented?.model.fields.cancel(name),
    cancelWork: () => this.#lifecycle.cancelLoad(),
    restart: () => void this.#restart(),
  });

  readonly #lifecycle = new Lifecycle<Mesh, Model, Presented, Original, ShownName, FieldName>(
    new Work(this.#status),
    {
      prepare: async (mesh, signal) => {
        const [content, girth] = [this.#contents.get(mesh), this.#girths.get(mesh)];
        const model = await Model.of(mesh, this.#fieldsHost, signal, content, girth);
        await this.stage?.prepare(model.surface.object);
        return model;
      },
      present: (model, origin) => this.#present(model, origin),
      presented: (presented) => this.#greet(presented),
      drop: (presented, keepsMesh) => {
        this.#controls.leave();
        this.#pointedVertex = undefined;
        presented.dispose(keepsMesh);
        this.#shared?.range.forget();
        this.#status.clear();
        this.#legend.update(undefined);
      },
      failed: (name, error) => this.#fail(name, error),
    },
  );

  /** The stage that the surface is drawn on, while the element is on a page. */
  stage: Stage | undefined;
  readonly #reported = new WeakSet<object>();
  /** The content of files besides the surface, by the meshes that were made of them. */
  readonly #contents = new WeakMap<Mesh, FileContent>();
  /** The girths of meshes that were shown before. */
  readonly #girths = new WeakMap<Mesh, Field>();
  /**
   * The addresses from which the kernel can read models that are shown as their files have them.
   */
  readonly #addresses = new WeakMap<Mesh, URL>();
  #reading: Promise<Presented> | undefined;
  /** The view, pins and tips of the shown model, which go on with the kernel's mesh of it. */
  #continued: Continued | undefined;
  /** Whether the model of `src` is on its way: what attributes ask for is about it. */
  #isOpening = false;
  #openTurn = 0;
  /** Whether `src` names the model that is shown. */
  #isOfSrc = true;
  #tipsTurn = 0;
  readonly #asked: Wishes;
  #pointedVertex: number | undefined;
  /** The model that is shown as its file has it, once somebody has come near it. */
  #approachedBy: Model | undefined;
  readonly #controls: CanvasControls;
  #stopWatching: (() => void) | undefined;
  #printed: Printed | undefined;
  /** The view and the range in common with other elements, once they are asked for. */
  #shared: { view: LinkedView; range: SharedRange } | undefined;
  #attached = new AbortController();

  constructor(host: ViewerHost) {
    this.#host = host;
    const { element, frame } = host;
    this.#controls = new CanvasControls({
      element,
      stage: () => this.stage,
      presented: () => this.presented,
    });
    this.#asked = new Wishes({
      element,
      stage: () => this.stage,
      presented: () => (this.#isOpening ? undefined : this.presented),
      whole: () => this.whole(),
      showTips: (choice) => this.showTips(choice),
      recolour: () => {
        this.#restyle(true);
        void this.#showField();
      },
      unit: () => this.#host.unitOf(),
      failed: (error) => this.#fail('', error),
    });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style);
    const root = element.shadowRoot!;
    root.adoptedStyleSheets = [...root.adoptedStyleSheets, sheet];
    frame.prepend(
      this.#canvas,
      this.#legend.element,
      this.#status.element,
      this.#controls.element,
      ...this.#voice.elements,
    );
  }

  get #element(): HTMLElement {
    return this.#host.element;
  }

  /** The element is on a page: it can draw from now on. */
  attach(): void {
    if (this.stage) return;
    const stage = new Stage(this.#canvas, {
      beforeFrame: () => this.presented?.spread() ?? false,
      afterFrame: () => {
        this.#controls.place();
        if (!this.presented) return;
        this.presented.loops.place();
        this.presented.numbers.place();
        if (stage.graphics !== 'missing') this.#host.drawn();
      },
      touched: () => this.#controls.touched(),
      moved: () => {
        this.#shared?.view.move();
        this.#send('cameramove', null);
      },
      rested: () => this.#send('camera', null),
      graphicsChanged: () => this.#host.message.showGraphics(stage.graphics),
    });
    this.stage = stage;
    if (stage.graphics === 'missing') this.#host.undrawable(noGraphics.missing);
    this.#lifecycle.attach();
    this.#stopWatching = watchSurroundings(this.#host.frame, {
      resized: (width, height) => this.#resize(width, height),
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
    for (const type of ['pointerenter', 'pointerdown', 'focus']) {
      const { signal } = this.#attached;
      this.#canvas.addEventListener(type, () => this.#approached(), { signal });
    }
    if (this.#element.hasAttribute('src')) void this.#loadSrc();
    void this.#joinOthers();
  }

  /** Lets the element have in common with others what its attributes ask for. */
  async #joinOthers(): Promise<void> {
    const nameIn = (attribute: 'linked' | 'one-scale'): string =>
      (this.stage && attributeOf(this.#element, attribute)) || '';
    if (!this.#shared) {
      if (nameIn('linked') === '' && nameIn('one-scale') === '') return;
      const { LinkedView, SharedRange } = await import('./surface/link.js');
      this.#shared ??= {
        view: new LinkedView(() => (this.stage?.view ? this.stage : undefined)),
        range: new SharedRange(() => {
          const shading = this.presented?.shading;
          const before = String(shading?.shown?.range);
          this.presented?.refresh();
          if (String(shading?.shown?.range) !== before) this.#sendChange();
        }),
      };
    }
    this.#shared.view.join(nameIn('linked'));
    this.#shared.range.join(nameIn('one-scale'));
  }

  #resize(width: number, height: number): void {
    const bottom = width <= narrow && controlsOf(this.#element) !== 'none' ? legendHeight : 0;
    this.stage?.resize(width, height, this.#headHeight, bottom, window.devicePixelRatio);
  }

  /** The element has left its page: all work ends, and all memory is let go. */
  detach(): void {
    this.#stopWatching?.();
    this.#stopWatching = undefined;
    this.#printed?.stop();
    this.#printed = undefined;
    this.#attached.abort();
    ++this.#openTurn;
    this.#isOpening = false;
    this.#lifecycle.detach();
    if (!this.stage) return;
    this.stage.dispose();
    this.stage = undefined;
    void this.#joinOthers();
  }

  /** An attribute has changed. */
  follow(name: string, value: string | null): void {
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
      case 'field-title':
      case 'colormap':
      case 'log':
      case 'isolines':
        this.#restyle(false);
        this.#sendChange();
        break;
      case 'linked':
      case 'one-scale':
        void this.#joinOthers();
        break;
      case 'method':
        this.#forgetGirth();
        break;
      case 'persistence':
        this.#persist();
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
      case 'pins':
      case 'tips':
      case 'parts':
      case 'bottleneck':
      case 'profile':
      case 'camera':
        this.#asked.follow(name);
        break;
      case 'controls': {
        const { width, height } = this.#host.frame.getBoundingClientRect();
        this.#resize(width, height);
        this.#controls.follow(name);
        break;
      }
      default:
        this.#controls.follow(name);
        break;
    }
    this.stage?.invalidate();
  }

  /** Brings about again what an attribute asks for, whatever was done since. */
  followAgain(name: string, value: string | null): void {
    const wishes = ['pins', 'tips', 'parts', 'bottleneck', 'profile', 'camera'];
    const isWish = wishes.includes(name);
    if (isWish || (name === 'src' && !this.#isOfSrc && !this.#isOpening)) this.follow(name, value);
  }

  /** Puts what is shown in place of what attributes ask for. */
  describe(state: ViewerState): void {
    if (!this.#isOfSrc && !this.#isOpening) delete state.src;
    this.#asked.describe(state);
  }

  /** The model that is shown, and all about it; undefined before the first. */
  get presented(): Presented | undefined {
    return this.#lifecycle.shown;
  }

  /** The original that the shown surface was made of; undefined where it was not. */
  get madeFrom(): Original | undefined {
    return this.#lifecycle.origin;
  }

  /** The model that is shown; undefined before the first. */
  get info(): MeshInfo | undefined {
    return this.presented?.model.mesh.info;
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
    this.#continued = undefined;
    ++this.#openTurn;
    this.#isOpening = false;
    const name = nameOf(source);
    const address = typeof source === 'string' ? new URL(source, this.#element.baseURI) : source;
    return this.bring(`Reading ${name || 'the model'} …`, name, async (watched) => {
      const kernel = await sharedKernel();
      const mesh = await kernel.load(address, { ...options, ...watched });
      const { ownValues } = await import('./model/own-values.js');
      const scale = options.prepare?.scale ?? 1;
      const kit = { readFigure, givenFields, carriedTo, onlySurface };
      const content = await ownValues(source, mesh, scale, kit);
      if (content) this.#contents.set(mesh, content);
      return mesh;
    }).then((info) => {
      this.#isOfSrc = false;
      return info;
    });
  }

  #addressOf(src: string): URL | undefined {
    if (URL.canParse(src, this.#element.baseURI)) return new URL(src, this.#element.baseURI);
    const message = `“${src.slice(0, 60)}” is not an address`;
    this.#fail('', failure('FILE_NOT_FOUND', message, { hint: 'check what src names' }));
    return undefined;
  }

  /** Opens an address; a file that has its values in it is shown as it is. */
  async #open(src: string): Promise<void> {
    this.#continued = undefined;
    const address = this.#addressOf(src);
    if (!address) return;
    const name = nameOf(address);
    await this.bring(`Reading ${name || 'the model'} …`, name, async (watched) => {
      const { mesh, content } = await openModel(address, watched);
      if (content) this.#contents.set(mesh, content);
      this.#addresses.set(mesh, address);
      return mesh;
    });
  }

  /**
   * The model that is shown, so that all can be computed of it: one that is shown as its file has it is read
   * by the kernel first, and takes its own place.
   */
  async whole(): Promise<Presented> {
    const presented = this.require();
    const { file } = presented.model;
    if (!file.isAll) return presented;
    this.#reading ??= this.#goOn(presented).finally(() => (this.#reading = undefined));
    return this.#reading;
  }

  async #goOn({ model, loops, tips }: Presented): Promise<Presented> {
    const { name } = model.mesh.info;
    const address = this.#addresses.get(model.mesh)!;
    await this.bring(`Reading ${name} …`, name, async (watched) => {
      const { mesh, content } = await openToCompute(address, model.file, watched);
      if (content) this.#contents.set(mesh, content);
      const shown = tips.shown && {
        all: tipsCarriedTo(tips.shown.all, mesh.vertexOfInput),
        choice: tips.shown.choice,
      };
      this.#continued = {
        mesh,
        view: this.stage?.isHome ? undefined : this.stage?.view,
        pins: loops.pinned.map(({ loop, name }) => ({
          point: mesh.vertexOfInput[loop.base as number]!,
          name,
        })),
        isPinned: !this.#asked.isPinning,
        tips: shown,
      };
      return mesh;
    });
    return this.require();
  }

  /** Makes another mesh ready to draw and shows it, with words and a cross meanwhile. */
  async bring(
    words: string,
    name: string,
    read: (watched: Watched) => Promise<Mesh>,
    origin?: Original,
  ): Promise<MeshInfo> {
    return (await this.#lifecycle.load({ words, name, read, origin })).info;
  }

  /** Shows the surface without its short handles; see `GirthViewer.removeHandles`. */
  async removeHandles(
    length: number,
    options: Pick<HandleOptions, 'basePoints'>,
  ): Promise<HandleRemoval> {
    const { mesh, fields } = (await this.whole()).model;
    const { name } = mesh.info;
    const origin: Original = { mesh, field: fields.get('igf')?.field };
    let removal: HandleRemoval;
    await this.bring(
      'Removing handles …',
      name,
      async (watched) => {
        const made = await mesh.removeHandles(length, { ...options, ...watched });
        origin.removal = removal = made.removal;
        if (removal.removed.length > 0) return made;
        made.dispose();
        return mesh;
      },
      origin,
    );
    return removal!;
  }

  /** Shows again what the shown surface was made of; see `GirthViewer.restore`. */
  async restore(): Promise<MeshInfo> {
    const { madeFrom } = this;
    if (!madeFrom) {
      throw failure('USAGE', 'the surface was not made of another one', {
        hint: 'load the model again',
      });
    }
    const { mesh, field } = madeFrom;
    if (field && !field.persistence) this.#girths.set(mesh, field);
    const { name } = mesh.info;
    return this.bring(`Showing ${name || 'the model'} …`, name, () => Promise.resolve(mesh));
  }

  /** Draws the tips' contours and apexes and tints their regions, or no longer. */
  async showTips(choice: TipsChoice): Promise<void> {
    const before = this.require();
    const turn = ++this.#tipsTurn;
    if (!choice.shown) {
      before.tips.clear();
      return;
    }
    const presented = before.model.file.tips ? before : await this.whole();
    const tips = await presented.model.tips();
    if (this.presented === presented && turn === this.#tipsTurn) presented.tips.show(tips, choice);
  }

  /** How lengths are written: those of loops, and the girth. */
  get lengthFormat(): LengthFormat {
    return (
      this.presented?.lengthFormat ?? lengthFormat(1, this.#host.unitOf(), this.#host.shownUnitOf())
    );
  }

  /** The picture as it is now, as a PNG; see `GirthViewer.snapshot`. */
  async snapshot(options: FigureOptions): Promise<Blob> {
    if (this.stage) requireGraphics(this.stage.graphics);
    const { figure, isTransparent, sizeOf } = await import('./figure/snapshot.js');
    const { stage } = this;
    if (!stage) throw new Error('the element is not on a page');
    const { width, dotsPerInch } = sizeOf(options);
    const parts = this.#figureParts(stage);
    const drawn = { ...options, dotsPerInch };
    // A shadow on nothing would be a grey veil.
    const picture = stage.picture(width, !isTransparent(options));
    const blob = await blobOf(figure(picture, parts, drawn, this.#element));
    if (dotsPerInch === undefined) return blob;
    const { withDensity } = await import('./figure/png-density.js');
    return withDensity(blob, dotsPerInch);
  }

  /** The outline and the loops as SVG; see `GirthViewer.drawing`. */
  async drawing(options: DrawingOptions): Promise<string> {
    const [{ drawingSvg }, { scaleBarLength, scaleBarWords }] = await Promise.all([
      import('./figure/drawing.js'),
      import('./figure/snapshot.js'),
    ]);
    const { model } = this.require();
    const { surface, mesh } = model;
    if (!surface.canPick) await this.#prepareToPick(model);
    const { stage, presented } = this;
    if (!stage || presented?.model !== model) throw new Error('the element is not on a page');
    const { x, y, z } = stage.eye;
    const point = surface.positionOf(0);
    const slack = drawnSlack * surface.bounds.radius;
    const { width, height } = this.#host.frame.getBoundingClientRect();
    return drawingSvg(
      {
        scene: {
          ...mesh.geometry,
          eye: [x, y, z],
          place: (...at) => stage.placeOf(point.set(...at)),
          hides: (...at) => surface.hides(point.set(...at), stage.eye, slack),
        },
        lines: presented.lines,
        parts: this.#figureParts(stage),
        ...{ width, height, title: mesh.info.name },
        ...{ barLength: scaleBarLength, barWords: scaleBarWords },
      },
      options,
    );
  }

  /** Lets the browser print a figure of the surface from now on. */
  async #offerPrint(): Promise<void> {
    const [{ Printed }, { figure, printDensity }] = await Promise.all([
      import('./surface/printed.js'),
      import('./figure/snapshot.js'),
    ]);
    if (!this.stage) return;
    this.#printed ??= new Printed(this.#host.frame, (width) => {
      const { stage } = this;
      if (!this.presented || stage?.graphics !== 'drawing') return undefined;
      const legend = controlsOf(this.#element) !== 'none';
      const options = { legend, transparent: true, dotsPerInch: printDensity };
      return figure(stage.picture(width), this.#figureParts(stage), options, this.#element);
    });
  }

  /** The parts of a picture beside the surface. */
  #figureParts(stage: Stage): FigureParts {
    return {
      legend: this.presented?.shading.legend,
      labels: this.presented?.loops.labels ?? [],
      scale: stage.pixelsPerUnit,
      format: this.lengthFormat,
      lengthWords: formatLength,
    };
  }

  /** A picture of one place; see `GirthViewer.snapshotOf`. */
  async snapshotOf(picture: PlacePicture): Promise<Blob> {
    if (this.stage) requireGraphics(this.stage.graphics);
    return blobOf(this.require().pictureOf(picture));
  }

  /** Does what a key means for the surface, as if it had the focus; false where it means nothing. */
  press(event: KeyboardEvent): boolean {
    return this.#controls.press(event);
  }

  /** Stops computing fields; what there is stays. */
  cancel(): void {
    this.presented?.model.fields.cancel();
  }

  /** Computes the saddles of all vertices, with progress, and keeps them. */
  async keepBarcodes(maxPersistence: number): Promise<void> {
    // Begun at once where the file has been read, so that `cancel` reaches it from then on.
    const { model } = this.require().model.file.isAll ? await this.whole() : this.require();
    const { fields } = model;
    try {
      await fields.keepBarcodes(maxPersistence);
    } finally {
      if (this.presented?.model.fields === fields) {
        if (!fields.get('igf')?.running) this.#endStatus('igf');
        this.#controls.updateTurning();
      }
    }
  }

  // ---- loading and computing

  async #loadSrc(): Promise<void> {
    const src = attributeOf(this.#element, 'src');
    const turn = ++this.#openTurn;
    this.#isOpening = !!src;
    await this.#lifecycle.inView();
    if (!src || turn !== this.#openTurn) return;
    // A failure has been reported already.
    await this.#open(src).catch(() => undefined);
    if (turn === this.#openTurn) this.#isOpening = false;
  }

  #present(model: Model, origin: Original | undefined): Presented {
    this.#host.message.clear();
    if (!this.#host.hasPoster) this.#host.message.showGraphics(this.stage!.graphics);
    const { unreadable, name } = model.mesh.info;
    if (!origin) this.#host.message.showPassedOver(unreadable, name);
    const wishes = this.#wishesFor(model);
    const up = attributeOf(this.#element, 'up');
    const presented = new Presented(this.stage!, this.#canvas, model, wishes, up, {
      followsPointer: () => attributeOf(this.#element, 'loop') !== 'none',
      pointed: (vertex) => this.#pointed(vertex),
      picked: (detail) => this.#send('pick', detail),
      failed: (error) => this.#fail('', error),
      furniture: () => this.#furniture(),
      relabelled: (legend) => {
        this.#legend.update(legend);
        this.#voice.call(this.#canvas, this.presented);
      },
    });
    presented.shading.rangeFor = (own) => this.#shared?.range.of(own) ?? own.ends;
    this.#legend.element.after(presented.numbers.element, presented.loops.element);
    return presented;
  }

  /** The boxes on the canvas beside the surface: the top that the page writes on, and the element's own. */
  #furniture(): Box[] {
    const { left, top, width, height } = this.#host.frame.getBoundingClientRect();
    const own = [...this.#legend.pieces, ...this.#status.plates, this.#controls.element];
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
    return Number.parseFloat(getComputedStyle(this.#element).getPropertyValue('--girth-top')) || 0;
  }

  #greet(presented: Presented): void {
    const { mesh } = presented.model;
    if (this.#isOpening && this.#addresses.has(mesh)) {
      this.#isOpening = false;
      this.#isOfSrc = true;
    }
    const isSeen = this.#controls.greet();
    const continued = this.#continued?.mesh === mesh ? this.#continued : undefined;
    this.#continued = undefined;
    this.#asked.greet(presented, isSeen || continued !== undefined);
    if (continued?.view) this.stage!.lookFrom(continued.view);
    this.#shared?.view.arrive();
    if (continued?.tips) presented.tips.show(continued.tips.all, continued.tips.choice);
    else if (!continued) this.#asked.greetTips(presented);
    // Calls made on `load` override the attributes: they are newer.
    if (!continued) this.#send('load', { info: mesh.info });
    void this.#afterShowing(presented, continued);
    void this.#showField();
  }

  /** Does the work that may come after the first picture. */
  async #afterShowing(presented: Presented, continued: Continued | undefined): Promise<void> {
    const { model, loops, standing } = presented;
    const { signal } = model.life;
    try {
      await new Promise((resolve) => setTimeout(resolve));
      signal.throwIfAborted();
      // A model that is shown as its file has it waits for a pointer.
      if (!model.file.isAll) await this.#prepareToPick(model);
      signal.throwIfAborted();
      await standing.castShadow();
      await loops.prepare();
      signal.throwIfAborted();
      for (const { point, name } of continued?.pins ?? []) {
        loops.rename((await loops.pin(point)).id, name);
      }
      if (!continued?.isPinned) await this.#asked.pin(presented, false);
      // A page without the figure prints what is on the screen.
      await this.#offerPrint().catch(() => undefined);
    } catch (error) {
      if (!signal.aborted) this.#fail('', error);
    }
  }

  async #prepareToPick(model: Model): Promise<void> {
    await model.surface.prepareToPick(openWorker);
    if (this.presented?.model === model) this.presented.loops.pointAgain();
  }

  /** A pointer or the focus has come to the surface: loops can be asked for. */
  #approached(): void {
    const { model } = this.presented ?? {};
    if (!model?.file.isAll || this.#approachedBy === model) return;
    this.#approachedBy = model;
    // A failure is reported where it occurs.
    if (attributeOf(this.#element, 'loop') === 'none') void this.#prepareToPick(model);
    else void this.whole().catch(() => undefined);
  }

  /** Computes what the attributes ask for, and shows it. */
  async #showField(): Promise<void> {
    const { presented } = this;
    if (!presented) return;
    if (presented.model.file.isAll && !presented.shading.isReady) {
      // The kernel's mesh, once it is shown, asks for the field again.
      await this.whole().catch(() => undefined);
      return;
    }
    await this.#lifecycle.colour(
      this.#wishes.name,
      () => presented.shading.prepare(),
      () => {
        presented.paint();
        this.#sendChange();
      },
    );
  }

  /** Another number of a signature is wanted: values of the one before no longer count. */
  #choose(name: FieldName): void {
    const { presented } = this;
    if (!presented) return;
    presented.model.fields.forget(name);
    this.#endStatus(name);
    if (this.#wishes.name !== name) return;
    this.#restyle(true);
    void this.#showField();
  }

  /** Another persistence is wanted: fields that depend on it no longer count. */
  #persist(): void {
    const { presented } = this;
    if (!presented) return;
    const { fields, life } = presented.model;
    fields.forget('angle');
    this.#endStatus('angle');
    presented.loops.renew().catch((error: unknown) => {
      if (!life.signal.aborted) this.#fail('', error);
    });
    this.#forgetGirth();
  }

  /** Another girth is wanted: results made of the one before no longer count. */
  #forgetGirth(): void {
    const { presented } = this;
    if (!presented) return;
    presented.model.forgetGirth();
    this.#endStatus('igf');
    this.#restyle(true);
    void this.#showField();
  }

  readonly #fieldsHost: FieldsHost = {
    persistence: ({ area, unit }) => {
      const text = attributeOf(this.#element, 'persistence') ?? '0';
      const read = readLengthOrShare(text, unit || this.#host.unitOf(), Math.sqrt(area));
      return 'length' in read ? read.length : 0;
    },
    method: () => {
      const method = attributeOf(this.#element, 'method');
      return method === 'coarse' || method === 'refined' ? method : 'exact';
    },
    lent: (state) => {
      if (!this.#isPresent(state) || this.presented!.shading.name !== state.name) return;
      this.presented!.paint();
      this.#sendChange();
    },
    spectral: (name) => parseSpectral(name, (attribute) => attributeOf(this.#element, attribute)),
    received: (state, partial) => {
      if (!this.#isPresent(state)) return;
      this.presented!.shading.receive(state, partial);
      this.stage?.invalidateSoon();
    },
    progressed: (name, fraction, secondsLeft) => {
      this.#status.showProgress(name, fieldTitle(name), fraction, secondsLeft);
      this.#controls.updateTurning();
      if (fraction > 0) this.#send('progress', { name, fraction, secondsLeft });
    },
    arriving: (state, field) =>
      this.#isPresent(state) ? this.presented!.shading.awaitRange(field) : undefined,
    ended: (state, error) => {
      if (!this.#isPresent(state)) return;
      const { name, field } = state;
      const { shading, model } = this.presented!;
      this.#endStatus(name);
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

  /** A field is no longer computed. */
  #endStatus(name: FieldName): void {
    this.#status.end(name);
    if (!this.presented?.model.fields.computing) this.#status.clear();
  }

  /** Whether the state of a field belongs to the model that is shown. */
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

  /** The wishes of the attributes. */
  get #wishes(): ShadingWishes {
    return this.#wishesFor(this.presented?.model);
  }

  /** The wishes of the attributes for a model, which need not be shown yet. */
  #wishesFor(model: Model | undefined): ShadingWishes {
    const field = attributeOf(this.#element, 'field')?.toLowerCase() ?? null;
    const given = model?.file.leads ? model.fields.givenNames : [];
    const usual = given.includes('igf') ? 'igf' : (given[0] ?? 'igf');
    const colormap = attributeOf(this.#element, 'colormap');
    return {
      name: isShownName(field) ? field : usual,
      title: attributeOf(this.#element, 'field-title') ?? '',
      colormap: isColormapName(colormap) ? colormap : undefined,
      range: parseRange(attributeOf(this.#element, 'range')),
      log: isOn(this.#element, 'log'),
      isolines: Number(attributeOf(this.#element, 'isolines') ?? 0),
      // The unit of a model goes before the attribute's.
      unit: unitSymbol(model?.mesh.info.unit ?? '') || this.#host.unitOf(),
      shownUnit: this.#host.shownUnitOf() || (model?.file.ownUnit ?? ''),
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

  /** The model that is shown; throws where there is none. */
  require(): Presented {
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
    const unit = fieldUnit(name, this.#host.unitOf());
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
    this.#element.dispatchEvent(new CustomEvent(name, { detail }));
  }

  /** Says what went wrong, once; that something was cancelled is no news. */
  #fail(name: string, error: unknown): void {
    const fields = fieldsOf(error);
    if (fields.code === 'CANCELLED') return;
    if (error instanceof Error) {
      if (this.#reported.has(error)) return;
      this.#reported.add(error);
    }
    this.#host.message.show(name, fields, this.presented !== undefined);
    this.#send('error', fields);
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
