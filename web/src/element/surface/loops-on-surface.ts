// The loop under the pointer, under the finger or at the keyboard's probe, and the pinned loops.

import { cancelled } from '../../kernel/types/errors.js';
import type { Loop, SurfacePoint } from '../../kernel/types/types.js';
import {
  Latest,
  type LengthFormat,
  LoopBand,
  type Box,
  type Silhouette,
  type Stage,
  type Surface,
  formatLength,
} from '../../view/index.js';
import { make } from '../controls/dom.js';
import type { Model } from '../model/model.js';
import { placeLabels } from './label-places.js';
import { rounded, type StrokeOptions, strokeOn } from './stroke.js';
import { PinTag, Readout, type TagLabel, kindWords } from '../controls/readout.js';
import { isMotionReduced } from './surroundings.js';

/** The pointer may move this far, in CSS pixels, between press and release of a click. */
const clickSlack = 5;
/** Milliseconds between the two clicks or taps of a pair; a single click counts once they are over. */
const pairTime = 280;
/** A second tap within this many CSS pixels of the first one pins a loop. */
const fingerWidth = 24;
/** A second tap within this many CSS pixels of the first one means the first one's place. */
const fingerSlack = 8;
/** So many points of a loop show where it is on the canvas. */
const outlinePoints = 24;
/** CSS pixels of a cell of the grid in which tags look for room. */
const cell = 8;
/** Milliseconds from one look for room to the next while the surface moves. */
const restTime = 120;
/** The share of a loop's length by which the colour at its point must differ to be told. */
const apart = 0.02;
/** CSS pixels that one key press moves the probe. */
const probeStep = 14;

const liveStyle = { colour: '#ffffff', weight: 1 };
const pinnedStyle = { colour: '#ff7a45', weight: 0.9 };

/** A loop that stays on the surface until it is removed. */
export interface PinnedLoop {
  /** Counts up from 1 for each model; also written on the surface. */
  id: number;
  /** The name that the loop was given, also written on the surface; '' for none. */
  name: string;
  /** `loop.base` is the point that it is the loop of. */
  loop: Loop;
}

/** Details of `pick`: a loop was shown, kept, named or let go. */
export interface PickDetail {
  /** 'hover': the loop under the pointer is shown; 'pin', 'name', 'unpin': it was kept, named, let go. */
  action: 'hover' | 'pin' | 'name' | 'unpin';
  /** Which loop. */
  loop: Loop;
}

type Point = Surface['bounds']['center'];

interface Pin extends PinnedLoop {
  band: LoopBand;
  tag: PinTag;
  midpoint: Point;
  /** Some points of the loop, and which of them could be seen when its tag was placed. */
  outline: Point[];
  seen: Point[];
}

export interface LoopsHost {
  /** False where loops do not follow the pointer. */
  followsPointer(): boolean;
  /** The vertex nearest to what is pointed at; undefined where that is beside the surface. */
  pointed(vertex: number | undefined): void;
  picked(detail: PickDetail): void;
  failed(error: unknown): void;
  /** The boxes of other things that lie on the canvas. */
  furniture(): Box[];
}

function isSame(a: SurfacePoint, b: SurfacePoint): boolean {
  if (typeof a === 'number' || typeof b === 'number') return a === b;
  return a.face === b.face && a.weights.every((share, k) => share === b.weights[k]);
}

/** A length that is there. */
function finite(length: number | undefined): number | undefined {
  return length !== undefined && Number.isFinite(length) ? length : undefined;
}

/** The least box round some points. */
function boxOf(points: readonly { x: number; y: number }[]): Box {
  const [across, down] = [points.map(({ x }) => x), points.map(({ y }) => y)];
  const [left, top] = [Math.min(...across), Math.min(...down)];
  return { left, top, width: Math.max(...across) - left, height: Math.max(...down) - top };
}

/** Everything about loops for one model on one stage. */
export class LoopsOnSurface {
  /** Words on the surface. */
  readonly element = make('div');

  readonly #readout = new Readout();
  readonly #leaders = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  readonly #live = make('div', { class: 'quiet-live', 'aria-live': 'polite' });
  readonly #ending = new AbortController();
  readonly #request: Latest<SurfacePoint, Loop>;
  #pins: Pin[] = [];
  #nextPin = 1;
  /** The state that the tags were placed for, its time, and the timer to look at them again. */
  #placedFor = '';
  #placedAt = -Infinity;
  #placing: ReturnType<typeof setTimeout> | undefined;
  #isQuiet = false;
  /** The time at which the words of a quiet loop were placed. */
  #besideAt = 0;
  #besideLater: ReturnType<typeof setTimeout> | undefined;
  #hover: { loop: Loop; band: LoopBand } | undefined;
  /** The length in words while its loop is still to come. */
  #awaitedLength: number | undefined;
  /** Bands that are never seen: programs are deleted with the last material that uses them. */
  readonly #compiled: LoopBand[] = [];
  /** The point whose loop is shown or asked for. */
  #hovered: SurfacePoint | undefined;
  #pointer: { x: number; y: number; isTouch: boolean } | undefined;
  #pressed: { x: number; y: number } | undefined;
  /** Clicks and taps since the surface was last moved, while it cannot be picked yet. */
  #unheard: PointerEvent[] = [];
  /** The last click, until another one cannot make a pair with it. */
  #clicked: { x: number; y: number; time: number } | undefined;
  /** The point that a single click will pin. */
  #awaited: SurfacePoint | undefined;
  #pinning: ReturnType<typeof setTimeout> | undefined;
  #pickRequested = 0;
  /** Somebody who asks for a point: the next click is theirs. */
  #chooser: { take(point: SurfacePoint): void; stop(): void } | undefined;
  readonly #stage: Stage;
  readonly #canvas: HTMLCanvasElement;
  readonly #model: Model;
  #format: LengthFormat;
  readonly #host: LoopsHost;

  constructor(
    stage: Stage,
    canvas: HTMLCanvasElement,
    model: Model,
    format: LengthFormat,
    host: LoopsHost,
  ) {
    this.#stage = stage;
    this.#canvas = canvas;
    this.#model = model;
    this.#format = format;
    this.#host = host;
    this.#request = new Latest(
      (point, signal) => model.mesh.loop(point, { signal, persistence: model.fields.persistence }),
      (_point, loop) => this.#show(loop),
      (_point, error) => host.failed(error),
    );
    this.#leaders.classList.add('leaders');
    this.#leaders.setAttribute('aria-hidden', 'true');
    this.element.append(this.#leaders, this.#readout.element, this.#live);
    this.#listen();
  }

  get pinned(): PinnedLoop[] {
    return this.#pins.map(({ id, name, loop }) => ({ id, name, loop }));
  }

  /** The tags of pinned loops, for a picture. */
  get labels(): TagLabel[] {
    this.#arrange();
    return this.#pins.map(({ tag }) => tag.label);
  }

  setFormat(format: LengthFormat): void {
    this.#format = format;
    for (const pin of this.#pins) pin.tag.setFormat(format);
    if (this.#hover) this.#read(this.#hover.loop);
    else this.#showLength();
  }

  async pin(point: SurfacePoint): Promise<PinnedLoop> {
    const { signal } = this.#model.life;
    const { persistence } = this.#model.fields;
    const shown = this.#hover?.loop;
    const loop =
      shown && isSame(shown.base, point)
        ? shown
        : await this.#model.mesh.loop(point, { signal, persistence });
    signal.throwIfAborted();
    return this.keep(loop);
  }

  /** Keeps a loop that is known on the surface. */
  keep(loop: Loop): PinnedLoop {
    const already = this.#pins.find((pin) => isSame(pin.loop.base, loop.base));
    if (already) return { id: already.id, name: already.name, loop };
    const id = this.#nextPin++;
    const pin: Pin = {
      id,
      name: '',
      loop,
      band: new LoopBand(loop, pinnedStyle),
      tag: new PinTag(id, loop, () => this.unpin(id)),
      midpoint: this.#pointOf(loop.midpoint),
      outline: this.#outlineOf(loop),
      seen: [],
    };
    pin.tag.setFormat(this.#format);
    this.#pins.push(pin);
    this.#leaders.after(pin.tag.element);
    this.#leaders.append(pin.tag.leader);
    this.#stage.add(pin.band);
    this.clear();
    this.#live.textContent = `Loop ${id} pinned: ${formatLength(loop.length, this.#format)}`;
    this.#host.picked({ action: 'pin', loop });
    return { id, name: pin.name, loop };
  }

  /** The next point that is clicked, tapped or chosen by Enter; a newer call ends an older one. */
  choosePoint(signal: AbortSignal | undefined): Promise<SurfacePoint> {
    this.stopChoosing();
    return new Promise((resolve, reject) => {
      const end = (): void => {
        this.#chooser = undefined;
        signal?.removeEventListener('abort', stop);
        this.#canvas.classList.remove('choosing');
      };
      const stop = (): void => {
        end();
        reject(cancelled());
      };
      if (signal?.aborted) {
        stop();
        return;
      }
      const take = (point: SurfacePoint): void => {
        end();
        this.#live.textContent = 'Point chosen';
        resolve(point);
      };
      signal?.addEventListener('abort', stop);
      this.#chooser = { take, stop };
      this.#canvas.classList.add('choosing');
    });
  }

  /**
   * Chooses one point, or the points along the way of a pointer that is dragged over the surface.
   * The pointer is heard from this call on: pressed a moment later, it would turn the surface.
   */
  async chooseStroke({ signal, drawn }: StrokeOptions): Promise<SurfacePoint[]> {
    const ending = new AbortController();
    const end = (): void => ending.abort();
    signal?.addEventListener('abort', end);
    if (signal?.aborted) end();
    const click = this.choosePoint(ending.signal).then((point) => [point]);
    try {
      const pick = (x: number, y: number) => this.#stage.pick(x, y);
      const stroke = strokeOn(this.#canvas, pick, ending.signal, (points) => {
        this.#stage.touch();
        this.clear();
        drawn?.(points.map(rounded));
      });
      return (await Promise.race([click, stroke])).map(rounded);
    } finally {
      signal?.removeEventListener('abort', end);
      // Whichever of the two has not been answered is not waited for.
      click.catch(() => undefined);
      end();
    }
  }

  /** Nobody gets a point any more; false where nobody has asked for one. */
  stopChoosing(): boolean {
    const chooser = this.#chooser;
    chooser?.stop();
    return chooser !== undefined;
  }

  /** Computes the pinned loops anew, each in its place: another persistence is wanted. */
  async renew(): Promise<void> {
    this.clear();
    const { life, mesh, fields } = this.#model;
    const { persistence } = fields;
    for (const pin of [...this.#pins]) {
      const loop = await mesh.loop(pin.loop.base, { signal: life.signal, persistence });
      // A newer wish has its own loops, and one that was removed needs none.
      if (persistence !== fields.persistence) return;
      if (!this.#pins.includes(pin)) continue;
      this.#stage.remove(pin.band);
      pin.loop = loop;
      pin.band = new LoopBand(loop, pinnedStyle);
      pin.midpoint = this.#pointOf(loop.midpoint);
      pin.outline = this.#outlineOf(loop);
      pin.seen = [];
      pin.tag.setLoop(loop, this.#format);
      this.#placedFor = '';
      this.#stage.add(pin.band);
      this.#host.picked({ action: 'pin', loop });
    }
  }

  /** Calls a pinned loop by a name; nothing happens where there is none of that id. */
  rename(id: number, name: string): void {
    const pin = this.#pins.find((one) => one.id === id);
    if (!pin || pin.name === name) return;
    pin.name = name;
    pin.tag.setName(name);
    this.#stage.invalidate();
    this.#host.picked({ action: 'name', loop: pin.loop });
  }

  #pointOf(numbers: ArrayLike<number>): Point {
    return this.#model.surface.bounds.center.clone().fromArray(Array.from(numbers));
  }

  #outlineOf({ polyline, midpoint }: Loop): Point[] {
    const count = polyline.length / 3;
    const step = Math.max(1, Math.floor(count / outlinePoints));
    const points = [this.#pointOf(midpoint)];
    for (let i = 0; i < count; i += step) {
      points.push(this.#pointOf(polyline.subarray(3 * i, 3 * i + 3)));
    }
    return points;
  }

  unpin(id: number): void {
    const pin = this.#pins.find((one) => one.id === id);
    if (!pin) return;
    this.#pins = this.#pins.filter((one) => one !== pin);
    this.#stage.remove(pin.band);
    pin.tag.remove();
    this.#live.textContent = `Loop ${id} removed`;
    this.#host.picked({ action: 'unpin', loop: pin.loop });
  }

  /** Shows the loop at a point that nothing on the surface points at; undefined: none. `isQuiet`: it is not announced. */
  lookAt(point: SurfacePoint | undefined, isQuiet = false): void {
    this.#isQuiet = isQuiet;
    this.#pointer = undefined;
    if (point === undefined) {
      this.clear();
      return;
    }
    // A loop that shows itself stops nothing.
    if (!isQuiet) this.#stage.touch();
    this.#hoverOn(point);
  }

  /** Hides the loop under the pointer; false where there is none. */
  clear(): boolean {
    const wasShown = this.#hovered !== undefined;
    this.#hovered = undefined;
    this.#request.clear();
    this.#readout.clear();
    this.#hide();
    return wasShown;
  }

  #hide(): void {
    if (this.#hover) this.#stage.remove(this.#hover.band);
    this.#hover = undefined;
    this.#awaitedLength = undefined;
  }

  /** Compiles what loops are drawn with, so that the first one appears at once. */
  async prepare(): Promise<void> {
    const polyline = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 0, 0);
    const rest = { length: 2, base: 0, polyline, angle: 0, unit: '' };
    for (const kind of ['loop', 'antipodal'] as const) {
      const band = new LoopBand({ ...rest, kind, midpoint: [1, 0, 0] }, liveStyle);
      this.#compiled.push(band);
      await this.#stage.prepare(band.object);
    }
  }

  /** Places words after a frame: they move with the surface. */
  place(): void {
    if (this.#pins.length > 0) this.#placeTags();
    if (!this.#pointer || this.#pointer.isTouch) this.#placeReadout();
  }

  /** Tags stay where they are while the surface moves, with their lines, and look for room now and then. */
  #placeTags(): void {
    const wait = this.#placedAt + restTime - performance.now();
    if (wait <= 0 || this.#pins.some(({ tag }) => !tag.spot)) this.#arrange();
    else this.#placing ??= setTimeout(() => this.#stage.invalidate(), wait);
    for (const pin of this.#pins) {
      const points = pin.seen.length > 0 ? pin.seen : pin.outline;
      pin.tag.pointAt(
        points.map((point) => this.#stage.placeOf(point)),
        !this.#stage.project(pin.midpoint).visible,
      );
    }
  }

  /** Places the tags where the surface and the other things on the canvas are not. */
  #arrange(): void {
    clearTimeout(this.#placing);
    this.#placing = undefined;
    const stage = this.#stage;
    // Asking for sizes makes the browser lay the page out: only where it is needed.
    const { clientWidth: width, clientHeight: height } = this.#canvas;
    const sizes = this.#pins.map(({ id, tag }) => [id, tag.size.width]);
    const placedFor = JSON.stringify([stage.clipMatrix, width, height, sizes]);
    if (placedFor === this.#placedFor) return;
    this.#placedFor = placedFor;
    this.#placedAt = performance.now();
    const labels = this.#pins.map((pin) => {
      pin.seen = pin.outline.filter((point) => stage.project(point).visible);
      const about = boxOf(
        (pin.seen.length > 0 ? pin.seen : pin.outline).map((p) => stage.placeOf(p)),
      );
      return { about, ...pin.tag.size, before: pin.tag.spot };
    });
    const places = placeLabels(labels, this.#taken(), { width, height });
    this.#pins.forEach(({ tag }, i) => tag.place(places[i]!));
  }

  dispose(): void {
    this.#ending.abort();
    this.stopChoosing();
    clearTimeout(this.#pinning);
    clearTimeout(this.#placing);
    clearTimeout(this.#besideLater);
    cancelAnimationFrame(this.#pickRequested);
    this.clear();
    for (const pin of this.#pins) this.#stage.remove(pin.band);
    for (const band of this.#compiled) band.dispose();
    this.element.remove();
  }

  #listen(): void {
    const canvas = this.#canvas;
    const { signal } = this.#ending;
    canvas.addEventListener('pointermove', (event) => this.#moved(event), { signal });
    canvas.addEventListener(
      'pointerdown',
      (event) => {
        this.#pressed = event.isPrimary ? { x: event.clientX, y: event.clientY } : undefined;
      },
      { signal },
    );
    canvas.addEventListener('pointerup', (event) => this.#released(event), { signal });
    canvas.addEventListener(
      'pointerleave',
      (event) => {
        if (event.pointerType === 'touch') return;
        this.#pointer = undefined;
        this.clear();
        this.#host.pointed(undefined);
      },
      { signal },
    );
    const zoomed = (): void => {
      this.#unheard = [];
      this.#stage.touch();
    };
    canvas.addEventListener('wheel', zoomed, { signal, passive: true });
  }

  // ---- pointer and finger

  #remember(event: PointerEvent): void {
    const isTouch = event.pointerType === 'touch';
    this.#pointer = { x: event.clientX, y: event.clientY, isTouch };
  }

  /** Picks once a frame at most, and not while the surface is being turned. */
  #moved(event: PointerEvent): void {
    if (event.buttons !== 0 || event.pointerType === 'touch') return;
    this.#remember(event);
    this.#pickSoon();
  }

  /** The surface can be picked now: a pointer that came before may rest on it, or have clicked. */
  pointAgain(): void {
    for (const click of this.#unheard.splice(0)) this.#click(click);
    if (this.#pointer && !this.#pointer.isTouch && !this.#pressed) this.#pickSoon();
  }

  #pickSoon(): void {
    this.#pickRequested ||= requestAnimationFrame(() => {
      this.#pickRequested = 0;
      const pointer = this.#pointer;
      if (!pointer) return;
      const point = this.#stage.pick(pointer.x, pointer.y);
      this.#host.pointed(point && this.#model.surface.nearestVertex(point));
      const isFollowed = point !== undefined && this.#host.followsPointer();
      this.#canvas.classList.toggle('picking', isFollowed);
      if (!isFollowed) {
        this.clear();
        return;
      }
      this.#stage.touch();
      this.#isQuiet = false;
      this.#hoverOn(point);
      this.#placeReadout();
    });
  }

  #released(event: PointerEvent): void {
    const pressed = this.#pressed;
    this.#pressed = undefined;
    if (!pressed || event.button !== 0) return;
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > clickSlack) {
      this.#unheard = [];
    } else if (this.#model.surface.canPick) this.#click(event);
    else this.#unheard.push(event);
  }

  #click(event: PointerEvent): void {
    const isTouch = event.pointerType === 'touch';
    const point = this.#stage.pick(event.clientX, event.clientY);
    if (this.#isSecond(event, isTouch ? fingerWidth : clickSlack)) {
      // The second click of a pair cancels the first, whose pin was still to come.
      this.#clicked = undefined;
      clearTimeout(this.#pinning);
      if (point !== undefined) this.#turnAbout(point);
      return;
    }
    this.#pinNow();
    this.#clicked = { x: event.clientX, y: event.clientY, time: event.timeStamp };
    if (this.#chooser) {
      if (point !== undefined) this.#chooser.take(point);
      return;
    }
    if (!this.#host.followsPointer()) return;
    this.#remember(event);
    if (isTouch) this.#host.pointed(point && this.#model.surface.nearestVertex(point));
    if (point === undefined) this.clear();
    // The loop that is seen is pinned, even if the surface has just moved a little further.
    else if (!isTouch) this.#pinSoon(this.#hovered ?? point);
    // A finger cannot hover: its first tap shows the loop, a later tap near by pins it.
    else {
      const seen = this.#hover?.loop.base;
      const pixels = seen === undefined ? Infinity : this.#pixelsBetween(point, seen);
      if (pixels >= fingerWidth) this.#hoverOn(point);
      else this.#pinSoon(pixels < fingerSlack ? seen! : point);
    }
  }

  /** Whether a click follows another one at the same place at once. */
  #isSecond({ clientX, clientY, timeStamp }: PointerEvent, slack: number): boolean {
    const first = this.#clicked;
    if (!first || timeStamp - first.time > pairTime) return false;
    return Math.hypot(clientX - first.x, clientY - first.y) <= slack;
  }

  /** Pins a loop unless a second click follows. */
  #pinSoon(point: SurfacePoint): void {
    this.#awaited = point;
    this.#pinning = setTimeout(() => this.#pinNow(), pairTime);
  }

  #pinNow(): void {
    clearTimeout(this.#pinning);
    const point = this.#awaited;
    this.#awaited = undefined;
    if (point !== undefined) this.#pinHere(point);
  }

  #turnAbout(point: SurfacePoint): void {
    this.#awaited = undefined;
    this.#stage.turnAbout(this.#model.surface.positionOf(point), isMotionReduced());
  }

  #pixelsBetween(a: SurfacePoint, b: SurfacePoint): number {
    const [p, q] = [a, b].map((at) => this.#stage.project(this.#model.surface.positionOf(at)));
    return Math.hypot(p!.x - q!.x, p!.y - q!.y);
  }

  #pinHere(point: SurfacePoint): void {
    this.pin(point).catch((error: unknown) => {
      if (!this.#model.life.signal.aborted) this.#host.failed(error);
    });
  }

  // ---- the live loop

  #hoverOn(point: SurfacePoint): void {
    if (this.#hovered !== undefined && isSame(point, this.#hovered)) return;
    this.#hovered = point;
    this.#request.request(point);
    const length = this.#isQuiet ? undefined : this.#lengthAt(point);
    if (length === undefined) return;
    this.#hide();
    this.#awaitedLength = length;
    this.#showLength();
  }

  /** The length at a point by the girth, for surfaces so large that their loops take a while. */
  #lengthAt(point: SurfacePoint): number | undefined {
    const { fields, mesh } = this.#model;
    const state = fields.method === 'exact' ? undefined : fields.get('igf');
    const values = state?.field?.values ?? state?.preview?.values;
    if (!values) return undefined;
    if (typeof point === 'number') return finite(values[point]);
    const { indices } = mesh.geometry;
    const { face, weights } = point;
    return finite(
      weights.reduce((sum, share, k) => sum + share * values[indices[3 * face + k]!]!, 0),
    );
  }

  #showLength(): void {
    if (this.#awaitedLength === undefined || this.#hovered === undefined) return;
    this.#readout.showLength(this.#hovered, this.#awaitedLength, this.#format);
    this.#placeReadout();
  }

  /** Shows an answer, also one for a place that the pointer has just passed. */
  #show(loop: Loop): void {
    if (this.#hovered === undefined) return;
    this.#hide();
    this.#hover = { loop, band: new LoopBand(loop, liveStyle) };
    this.#stage.add(this.#hover.band);
    this.#read(loop);
    this.#placeReadout();
    if (!this.#pointer && !this.#isQuiet) {
      const words = kindWords[loop.kind].sentence || 'Loop';
      this.#live.textContent = `${words} ${formatLength(loop.length, this.#format)}`;
    }
    this.#host.picked({ action: 'hover', loop });
  }

  /** Words on a loop; where the colours come from fewer triangles and differ from it, on these too. */
  #read(loop: Loop): void {
    const coloured = this.#lengthAt(loop.base) ?? loop.length;
    const isApart = Math.abs(coloured - loop.length) > apart * loop.length;
    this.#readout.show(loop, this.#format, isApart ? coloured : undefined);
  }

  #placeReadout(): void {
    const awaited = this.#awaitedLength === undefined ? undefined : this.#hovered;
    const base = this.#hover?.loop.base ?? awaited;
    if (base === undefined) return;
    const box = this.#canvas.getBoundingClientRect();
    const pointer = this.#pointer;
    const point =
      pointer && !pointer.isTouch
        ? { x: pointer.x - box.left, y: pointer.y - box.top }
        : this.#stage.project(this.#model.surface.positionOf(base));
    if (this.#isQuiet) {
      this.#placeBeside(point, box);
      return;
    }
    this.#readout.place(point.x, point.y, box.width, box.height, this.#host.furniture());
  }

  /** Places the length of a loop that shows itself clear of the surface; it rests where it can. */
  #placeBeside({ x, y }: { x: number; y: number }, { width, height }: DOMRect): void {
    const wait = this.#besideAt + restTime - performance.now();
    if (this.#readout.spot && wait > 0) {
      this.#besideLater ??= setTimeout(() => this.#stage.invalidate(), wait);
      return;
    }
    clearTimeout(this.#besideLater);
    this.#besideLater = undefined;
    this.#besideAt = performance.now();
    const about = { left: x, top: y, width: 0, height: 0 };
    const label = { about, ...this.#readout.size, before: this.#readout.spot };
    this.#readout.moveTo(placeLabels([label], this.#taken(), { width, height })[0]!);
  }

  /** The outline of the surface and of the other things on the canvas. */
  #taken(): Silhouette {
    const taken = this.#stage.silhouette(cell);
    for (const box of this.#host.furniture()) taken.add(box);
    return taken;
  }

  // ---- keyboard

  /** Keeps the loop that was asked for last, even if it is still to come; false where there is none. */
  pinProbe(): boolean {
    if (this.#hovered === undefined) return false;
    if (this.#chooser) {
      this.#chooser.take(this.#hovered);
      return true;
    }
    this.#pinHere(this.#hovered);
    return true;
  }

  /** Turns the surface about the point whose loop is shown; false where there is none. */
  turnAboutProbe(): boolean {
    if (this.#hovered === undefined) return false;
    this.#turnAbout(this.#hovered);
    return true;
  }

  unpinLast(): void {
    const last = this.#pins.at(-1);
    if (last) this.unpin(last.id);
  }

  /** Moves the loop from vertex to vertex along edges, to the right and up on the screen. */
  moveProbe(right: number, up: number): void {
    if (!this.#host.followsPointer() && !this.#chooser) return;
    const [stage, model] = [this.#stage, this.#model];
    this.#pointer = undefined;
    this.#isQuiet = false;
    stage.touch();
    if (this.#hovered === undefined) {
      const vertex = this.#vertexInMiddle();
      if (vertex === undefined) return;
      this.#hoverOn(vertex);
      this.#host.pointed(vertex);
      return;
    }
    let vertex = model.surface.nearestVertex(this.#hovered);
    const start = stage.project(model.surface.positionOf(vertex));
    const along = (v: number): number => {
      const point = stage.project(model.surface.positionOf(v));
      return right * (point.x - start.x) - up * (point.y - start.y);
    };
    let reached = 0;
    for (let step = 0; step < 40 && reached < probeStep; ++step) {
      let best = reached;
      let next = vertex;
      for (const neighbour of model.surface.neighboursOf(vertex)) {
        const distance = along(neighbour);
        if (distance > best) [best, next] = [distance, neighbour];
      }
      if (next === vertex) break;
      [vertex, reached] = [next, best];
    }
    this.#hoverOn(vertex);
    this.#host.pointed(vertex);
  }

  /** A vertex near the middle of the view, which may itself look past the surface or through a hole. */
  #vertexInMiddle(): number | undefined {
    const box = this.#canvas.getBoundingClientRect();
    for (let ring = 0; ring < 12; ++ring) {
      const reach = (ring / 24) * Math.min(box.width, box.height);
      const places = Math.max(1, 6 * ring);
      for (let k = 0; k < places; ++k) {
        const angle = (2 * Math.PI * k) / places;
        const point = this.#stage.pick(
          box.left + box.width / 2 + reach * Math.cos(angle),
          box.top + box.height / 2 + reach * Math.sin(angle),
        );
        if (point !== undefined) return this.#model.surface.nearestVertex(point);
      }
    }
    return undefined;
  }
}
