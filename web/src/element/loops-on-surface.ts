// The loop under the pointer, under the finger or at the keyboard's probe, and the pinned loops.

import type { Loop } from '../kernel/types.js';
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
import { PinTag, Readout, antipodalWords } from './readout.js';

/** The pointer may move this far, in CSS pixels, between press and release of a click. */
const clickSlack = 5;
/** A second tap within this many CSS pixels of the first one's vertex means that vertex. */
const fingerWidth = 24;
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

export interface PickDetail {
  /** 'hover': the loop under the pointer is shown; 'pin' and 'unpin': it was kept or let go. */
  action: 'hover' | 'pin' | 'unpin';
  vertex: number;
  loop: Loop;
}

interface Pin extends PinnedLoop {
  band: LoopBand;
  tag: PinTag;
  midpoint: Surface['bounds']['center'];
}

interface Host {
  /** False where loops do not follow the pointer. */
  followsPointer(): boolean;
  picked(detail: PickDetail): void;
  failed(error: unknown): void;
}

/** Everything about loops for one model on one stage. */
export class LoopsOnSurface {
  /** Words on the surface. */
  readonly element = make('div');

  private readonly readout = new Readout();
  private readonly live = make('div', { class: 'quiet-live', 'aria-live': 'polite' });
  private readonly ending = new AbortController();
  private readonly request: Latest<number, Loop>;
  private pins: Pin[] = [];
  private nextPin = 1;
  private hover: { loop: Loop; band: LoopBand } | undefined;
  /** The vertex whose loop is shown or asked for. */
  private hovered: number | undefined;
  private pointer: { x: number; y: number; isTouch: boolean } | undefined;
  private pressed: { x: number; y: number } | undefined;
  private pickRequested = 0;

  constructor(
    private readonly stage: Stage,
    private readonly canvas: HTMLCanvasElement,
    private readonly model: Model,
    private format: LengthFormat,
    private readonly host: Host,
  ) {
    this.request = new Latest(
      (vertex, signal) => model.mesh.loop(vertex, { signal }),
      (_vertex, loop) => this.show(loop),
      (_vertex, error) => host.failed(error),
    );
    this.element.append(this.readout.element, this.live);
    this.listen();
  }

  get pinned(): PinnedLoop[] {
    return this.pins.map(({ id, vertex, loop }) => ({ id, vertex, loop }));
  }

  setFormat(format: LengthFormat): void {
    this.format = format;
    for (const pin of this.pins) pin.tag.setFormat(format);
    if (this.hover) this.readout.show(this.hover.loop, format);
  }

  async pin(vertex: number): Promise<PinnedLoop> {
    const { signal } = this.model.life;
    const loop =
      this.hover?.loop.vertex === vertex
        ? this.hover.loop
        : await this.model.mesh.loop(vertex, { signal });
    signal.throwIfAborted();
    const already = this.pins.find((pin) => pin.vertex === vertex);
    if (already) return { id: already.id, vertex, loop };
    const id = this.nextPin++;
    const pin: Pin = {
      id,
      vertex,
      loop,
      band: new LoopBand(loop, pinnedStyle),
      tag: new PinTag(id, loop, () => this.unpin(id)),
      midpoint: this.model.surface.bounds.center.clone().fromArray(loop.midpoint),
    };
    pin.tag.setFormat(this.format);
    this.pins.push(pin);
    this.element.prepend(pin.tag.element);
    this.stage.add(pin.band);
    this.clear();
    this.host.picked({ action: 'pin', vertex, loop });
    return { id, vertex, loop };
  }

  unpin(id: number): void {
    const pin = this.pins.find((one) => one.id === id);
    if (!pin) return;
    this.pins = this.pins.filter((one) => one !== pin);
    this.stage.remove(pin.band);
    pin.tag.element.remove();
    this.host.picked({ action: 'unpin', vertex: pin.vertex, loop: pin.loop });
  }

  /** Hides the loop under the pointer. */
  clear(): void {
    this.hovered = undefined;
    this.request.clear();
    this.readout.clear();
    if (this.hover) this.stage.remove(this.hover.band);
    this.hover = undefined;
  }

  /** Compiles what loops are drawn with, so that the first one appears at once. */
  async prepare(): Promise<void> {
    const polyline = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 0, 0);
    const rest = { length: 2, vertex: 0, polyline, angle: 0, unit: '' };
    for (const kind of ['loop', 'antipodal'] as const) {
      const band = new LoopBand({ ...rest, kind, midpoint: [1, 0, 0] }, liveStyle);
      await this.stage.prepare(band.object);
      band.dispose();
    }
  }

  /** After a frame: words move with the surface. */
  place(): void {
    // Asking for the size makes the browser lay the page out: only where it is needed.
    if (this.pins.length > 0) {
      const { clientWidth, clientHeight } = this.canvas;
      for (const pin of this.pins) {
        pin.tag.place(this.stage.project(pin.midpoint), clientWidth, clientHeight);
      }
    }
    if (!this.pointer || this.pointer.isTouch) this.placeReadout();
  }

  dispose(): void {
    this.ending.abort();
    cancelAnimationFrame(this.pickRequested);
    this.clear();
    for (const pin of this.pins) this.stage.remove(pin.band);
    this.element.remove();
  }

  private listen(): void {
    const { canvas } = this;
    const { signal } = this.ending;
    canvas.addEventListener('pointermove', (event) => this.moved(event), { signal });
    canvas.addEventListener(
      'pointerdown',
      (event) => {
        this.pressed = event.isPrimary ? { x: event.clientX, y: event.clientY } : undefined;
      },
      { signal },
    );
    canvas.addEventListener('pointerup', (event) => this.released(event), { signal });
    canvas.addEventListener(
      'pointerleave',
      (event) => {
        if (event.pointerType === 'touch') return;
        this.pointer = undefined;
        this.clear();
      },
      { signal },
    );
    canvas.addEventListener('wheel', () => this.stage.touch(), { signal, passive: true });
    canvas.addEventListener('keydown', (event) => this.key(event), { signal });
  }

  // ---- pointer and finger

  private remember(event: PointerEvent): void {
    const isTouch = event.pointerType === 'touch';
    this.pointer = { x: event.clientX, y: event.clientY, isTouch };
  }

  /** Picks once a frame at most, and not while the surface is being turned. */
  private moved(event: PointerEvent): void {
    if (event.buttons !== 0 || event.pointerType === 'touch') return;
    this.remember(event);
    if (!this.host.followsPointer()) return;
    this.pickRequested ||= requestAnimationFrame(() => {
      this.pickRequested = 0;
      const { pointer } = this;
      if (!pointer) return;
      const vertex = this.stage.pick(pointer.x, pointer.y);
      this.canvas.classList.toggle('picking', vertex !== undefined);
      if (vertex === undefined) {
        this.clear();
        return;
      }
      this.stage.touch();
      this.hoverOn(vertex);
      this.placeReadout();
    });
  }

  private released(event: PointerEvent): void {
    const { pressed } = this;
    this.pressed = undefined;
    if (!pressed || event.button !== 0 || !this.host.followsPointer()) return;
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > clickSlack) return;
    this.remember(event);
    const vertex = this.stage.pick(event.clientX, event.clientY);
    if (vertex === undefined) this.clear();
    // What is seen is what is pinned, even if the surface has just moved a little further.
    else if (event.pointerType !== 'touch') this.pinHere(this.hovered ?? vertex);
    // A finger cannot hover: its first tap shows the loop, a second tap near by pins it.
    else if (this.hover && this.isNear(vertex, this.hover.loop.vertex)) {
      this.pinHere(this.hover.loop.vertex);
    } else this.hoverOn(vertex);
  }

  private isNear(a: number, b: number): boolean {
    const [p, q] = [a, b].map((v) => this.stage.project(this.model.surface.positionOf(v)));
    return Math.hypot(p!.x - q!.x, p!.y - q!.y) < fingerWidth;
  }

  private pinHere(vertex: number): void {
    this.pin(vertex).catch((error: unknown) => {
      if (!this.model.life.signal.aborted) this.host.failed(error);
    });
  }

  // ---- the live loop

  private hoverOn(vertex: number): void {
    if (vertex === this.hovered) return;
    this.hovered = vertex;
    this.request.request(vertex);
  }

  /** Shows an answer, also one for a place that the pointer has just passed. */
  private show(loop: Loop): void {
    if (this.hovered === undefined) return;
    if (this.hover) this.stage.remove(this.hover.band);
    this.hover = { loop, band: new LoopBand(loop, liveStyle) };
    this.stage.add(this.hover.band);
    this.readout.show(loop, this.format);
    this.placeReadout();
    if (!this.pointer) {
      const words = loop.kind === 'loop' ? 'Loop' : antipodalWords;
      this.live.textContent = `${words} ${formatLength(loop.length, this.format)}`;
    }
    this.host.picked({ action: 'hover', vertex: loop.vertex, loop });
  }

  private placeReadout(): void {
    if (!this.hover) return;
    const box = this.canvas.getBoundingClientRect();
    const { pointer } = this;
    const point =
      pointer && !pointer.isTouch
        ? { x: pointer.x - box.left, y: pointer.y - box.top }
        : this.stage.project(this.model.surface.positionOf(this.hover.loop.vertex));
    this.readout.place(point.x, point.y, box.width, box.height);
  }

  // ---- keyboard

  private key(event: KeyboardEvent): void {
    const { stage } = this;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
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
    // The vertex that was asked for last, even if its loop is still to come.
    else if (event.key === 'Enter' && this.hovered !== undefined) this.pinHere(this.hovered);
    else if (event.key === 'Escape') this.clear();
    else if (event.key === 'Delete' || event.key === 'Backspace') {
      const last = this.pins.at(-1);
      if (last) this.unpin(last.id);
    } else return;
    event.preventDefault();
  }

  /** Moves the loop's vertex from edge to edge, to the right and up on the screen. */
  private moveProbe(right: number, up: number): void {
    if (!this.host.followsPointer()) return;
    const { stage, model } = this;
    this.pointer = undefined;
    stage.touch();
    if (this.hovered === undefined) {
      const vertex = this.vertexInMiddle();
      if (vertex !== undefined) this.hoverOn(vertex);
      return;
    }
    let vertex = this.hovered;
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
    this.hoverOn(vertex);
  }

  /** A vertex near the middle of the view, which may itself look past the surface or through a hole. */
  private vertexInMiddle(): number | undefined {
    const box = this.canvas.getBoundingClientRect();
    for (let ring = 0; ring < 12; ++ring) {
      const reach = (ring / 24) * Math.min(box.width, box.height);
      const places = Math.max(1, 6 * ring);
      for (let k = 0; k < places; ++k) {
        const angle = (2 * Math.PI * k) / places;
        const vertex = this.stage.pick(
          box.left + box.width / 2 + reach * Math.cos(angle),
          box.top + box.height / 2 + reach * Math.sin(angle),
        );
        if (vertex !== undefined) return vertex;
      }
    }
    return undefined;
  }
}
