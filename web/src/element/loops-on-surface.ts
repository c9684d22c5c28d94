// The loop under the pointer, under the finger or at the keyboard's probe, and the pinned loops.

import type { Loop, SurfacePoint } from '../kernel/types.js';
import {
  Latest,
  type LengthFormat,
  LoopBand,
  type Stage,
  type Surface,
  formatLength,
} from '../view/index.js';
import { make } from './dom.js';
import type { Model } from './model.js';
import { PinTag, Readout, kindWords } from './readout.js';

/** The pointer may move this far, in CSS pixels, between press and release of a click. */
const clickSlack = 5;
/** A second tap within this many CSS pixels of the first one means the first one's loop. */
const fingerWidth = 24;
/** CSS pixels that one key press moves the probe. */
const probeStep = 14;

const liveStyle = { colour: '#ffffff', weight: 1 };
const pinnedStyle = { colour: '#ff7a45', weight: 0.9 };

/** A loop that stays on the surface until it is removed. */
export interface PinnedLoop {
  /** Counts up from 1 for each model; also written on the surface. */
  id: number;
  /** `loop.base` is the point that it is the loop of. */
  loop: Loop;
}

/** Of `pick`: a loop was shown, kept or let go. */
export interface PickDetail {
  /** 'hover': the loop under the pointer is shown; 'pin' and 'unpin': it was kept or let go. */
  action: 'hover' | 'pin' | 'unpin';
  /** Which loop. */
  loop: Loop;
}

interface Pin extends PinnedLoop {
  band: LoopBand;
  tag: PinTag;
  midpoint: Surface['bounds']['center'];
}

export interface LoopsHost {
  /** False where loops do not follow the pointer. */
  followsPointer(): boolean;
  /** The vertex nearest to what is pointed at; undefined where that is beside the surface. */
  pointed(vertex: number | undefined): void;
  picked(detail: PickDetail): void;
  failed(error: unknown): void;
}

function isSame(a: SurfacePoint, b: SurfacePoint): boolean {
  if (typeof a === 'number' || typeof b === 'number') return a === b;
  return a.face === b.face && a.weights.every((share, k) => share === b.weights[k]);
}

/** Everything about loops for one model on one stage. */
export class LoopsOnSurface {
  /** Words on the surface. */
  readonly element = make('div');

  readonly #readout = new Readout();
  readonly #live = make('div', { class: 'quiet-live', 'aria-live': 'polite' });
  readonly #ending = new AbortController();
  readonly #request: Latest<SurfacePoint, Loop>;
  #pins: Pin[] = [];
  #nextPin = 1;
  #hover: { loop: Loop; band: LoopBand } | undefined;
  /** The point whose loop is shown or asked for. */
  #hovered: SurfacePoint | undefined;
  #pointer: { x: number; y: number; isTouch: boolean } | undefined;
  #pressed: { x: number; y: number } | undefined;
  #pickRequested = 0;
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
      (point, signal) => model.mesh.loop(point, { signal }),
      (_point, loop) => this.#show(loop),
      (_point, error) => host.failed(error),
    );
    this.element.append(this.#readout.element, this.#live);
    this.#listen();
  }

  get pinned(): PinnedLoop[] {
    return this.#pins.map(({ id, loop }) => ({ id, loop }));
  }

  setFormat(format: LengthFormat): void {
    this.#format = format;
    for (const pin of this.#pins) pin.tag.setFormat(format);
    if (this.#hover) this.#readout.show(this.#hover.loop, format);
  }

  async pin(point: SurfacePoint): Promise<PinnedLoop> {
    const { signal } = this.#model.life;
    const shown = this.#hover?.loop;
    const loop =
      shown && isSame(shown.base, point) ? shown : await this.#model.mesh.loop(point, { signal });
    signal.throwIfAborted();
    const already = this.#pins.find((pin) => isSame(pin.loop.base, loop.base));
    if (already) return { id: already.id, loop };
    const id = this.#nextPin++;
    const pin: Pin = {
      id,
      loop,
      band: new LoopBand(loop, pinnedStyle),
      tag: new PinTag(id, loop, () => this.unpin(id)),
      midpoint: this.#model.surface.bounds.center.clone().fromArray(loop.midpoint),
    };
    pin.tag.setFormat(this.#format);
    this.#pins.push(pin);
    this.element.prepend(pin.tag.element);
    this.#stage.add(pin.band);
    this.clear();
    this.#host.picked({ action: 'pin', loop });
    return { id, loop };
  }

  unpin(id: number): void {
    const pin = this.#pins.find((one) => one.id === id);
    if (!pin) return;
    this.#pins = this.#pins.filter((one) => one !== pin);
    this.#stage.remove(pin.band);
    pin.tag.element.remove();
    this.#host.picked({ action: 'unpin', loop: pin.loop });
  }

  /** Hides the loop under the pointer. */
  clear(): void {
    this.#hovered = undefined;
    this.#request.clear();
    this.#readout.clear();
    if (this.#hover) this.#stage.remove(this.#hover.band);
    this.#hover = undefined;
  }

  /** Compiles what loops are drawn with, so that the first one appears at once. */
  async prepare(): Promise<void> {
    const polyline = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 0, 0);
    const rest = { length: 2, base: 0, polyline, angle: 0, unit: '' };
    for (const kind of ['loop', 'antipodal'] as const) {
      const band = new LoopBand({ ...rest, kind, midpoint: [1, 0, 0] }, liveStyle);
      await this.#stage.prepare(band.object);
      band.dispose();
    }
  }

  /** After a frame: words move with the surface. */
  place(): void {
    // Asking for the size makes the browser lay the page out: only where it is needed.
    if (this.#pins.length > 0) {
      const { clientWidth, clientHeight } = this.#canvas;
      for (const pin of this.#pins) {
        pin.tag.place(this.#stage.project(pin.midpoint), clientWidth, clientHeight);
      }
    }
    if (!this.#pointer || this.#pointer.isTouch) this.#placeReadout();
  }

  dispose(): void {
    this.#ending.abort();
    cancelAnimationFrame(this.#pickRequested);
    this.clear();
    for (const pin of this.#pins) this.#stage.remove(pin.band);
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
    canvas.addEventListener('wheel', () => this.#stage.touch(), { signal, passive: true });
    canvas.addEventListener('keydown', (event) => this.#key(event), { signal });
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
      this.#hoverOn(point);
      this.#placeReadout();
    });
  }

  #released(event: PointerEvent): void {
    const pressed = this.#pressed;
    this.#pressed = undefined;
    if (!pressed || event.button !== 0 || !this.#host.followsPointer()) return;
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > clickSlack) return;
    this.#remember(event);
    const point = this.#stage.pick(event.clientX, event.clientY);
    if (event.pointerType === 'touch') {
      this.#host.pointed(point && this.#model.surface.nearestVertex(point));
    }
    if (point === undefined) this.clear();
    // What is seen is what is pinned, even if the surface has just moved a little further.
    else if (event.pointerType !== 'touch') this.#pinHere(this.#hovered ?? point);
    // A finger cannot hover: its first tap shows the loop, a second tap near by pins it.
    else if (this.#hover && this.#isNear(point, this.#hover.loop.base)) {
      this.#pinHere(this.#hover.loop.base);
    } else this.#hoverOn(point);
  }

  #isNear(a: SurfacePoint, b: SurfacePoint): boolean {
    const [p, q] = [a, b].map((at) => this.#stage.project(this.#model.surface.positionOf(at)));
    return Math.hypot(p!.x - q!.x, p!.y - q!.y) < fingerWidth;
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
  }

  /** Shows an answer, also one for a place that the pointer has just passed. */
  #show(loop: Loop): void {
    if (this.#hovered === undefined) return;
    if (this.#hover) this.#stage.remove(this.#hover.band);
    this.#hover = { loop, band: new LoopBand(loop, liveStyle) };
    this.#stage.add(this.#hover.band);
    this.#readout.show(loop, this.#format);
    this.#placeReadout();
    if (!this.#pointer) {
      const words = kindWords[loop.kind].sentence || 'Loop';
      this.#live.textContent = `${words} ${formatLength(loop.length, this.#format)}`;
    }
    this.#host.picked({ action: 'hover', loop });
  }

  #placeReadout(): void {
    if (!this.#hover) return;
    const box = this.#canvas.getBoundingClientRect();
    const pointer = this.#pointer;
    const point =
      pointer && !pointer.isTouch
        ? { x: pointer.x - box.left, y: pointer.y - box.top }
        : this.#stage.project(this.#model.surface.positionOf(this.#hover.loop.base));
    this.#readout.place(point.x, point.y, box.width, box.height);
  }

  // ---- keyboard

  #key(event: KeyboardEvent): void {
    const stage = this.#stage;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const arrows: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) this.#moveProbe(...arrow);
    else if (arrow) stage.orbit(0.12 * arrow[0], 0.12 * arrow[1]);
    else if (event.key === '+' || event.key === '=') stage.zoom(0.88);
    else if (event.key === '-' || event.key === '_') stage.zoom(1 / 0.88);
    else if (event.key === '0' || event.key === 'Home') stage.resetView();
    // The point that was asked for last, even if its loop is still to come.
    else if (event.key === 'Enter' && this.#hovered !== undefined) this.#pinHere(this.#hovered);
    else if (event.key === 'Escape') this.clear();
    else if (event.key === 'Delete' || event.key === 'Backspace') {
      const last = this.#pins.at(-1);
      if (last) this.unpin(last.id);
    } else return;
    event.preventDefault();
  }

  /** Moves the loop from vertex to vertex along edges, to the right and up on the screen. */
  #moveProbe(right: number, up: number): void {
    if (!this.#host.followsPointer()) return;
    const [stage, model] = [this.#stage, this.#model];
    this.#pointer = undefined;
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
