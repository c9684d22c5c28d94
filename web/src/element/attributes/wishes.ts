// Wishes of attributes beside colours: the camera, tips, parts and pinned loops. An attribute is
// followed when it is set and when a model comes; hands and methods go on from there.

import { GirthError } from '../../kernel/types/errors.js';
import type { Mesh, SurfacePoint } from '../../kernel/types/types.js';
import { type Stage, readLength, straightNames } from '../../view/index.js';
import { attributeOf, isOn } from './attributes.js';
import type { ViewerState } from './attribute-types.js';
import { readCamera, writeCamera, writePoint } from './place-words.js';
import type { PartsWish, Presented } from '../presented.js';
import { type WishName, pinsOf } from './state.js';
import type { TipsChoice } from '../surface/tips-on-surface.js';
import {
  parseParts,
  parsePath,
  parseTips,
  parseTwoPoints,
  writeParts,
  writePins,
  writeTips,
} from './wish-words.js';

export interface WishesHost {
  readonly element: HTMLElement;
  stage(): Stage | undefined;
  presented(): Presented | undefined;
  /** The model, read by the kernel, so that all can be computed of it. */
  whole(): Promise<Presented>;
  showTips(choice: TipsChoice): Promise<void>;
  /** The thresholds of parts have changed. */
  recolour(): void;
  /** The unit of lengths; '' for none. */
  unit(): string;
  failed(error: unknown): void;
}

export class Wishes {
  readonly #host: WishesHost;
  /** Counts up with each wish for loops: only the last one counts. */
  #pinTurn = 0;
  /** Whether loops that are wished for are not pinned yet. */
  #isPinning = false;
  /** Counts up with each wish between two points: only the last one counts. */
  #betweenTurn = 0;
  /** Whether tips that are wished for are not drawn yet. */
  #isFinding = false;

  constructor(host: WishesHost) {
    this.#host = host;
  }

  /** Whether loops that are wished for are not pinned yet. */
  get isPinning(): boolean {
    return this.#isPinning;
  }

  /** An attribute has changed. */
  follow(name: WishName): void {
    const presented = this.#host.presented();
    if (!presented) return;
    if (name === 'camera') this.#look();
    else if (name === 'parts') this.#divide(presented, true);
    else if (name === 'tips') void this.#showTips(presented);
    else if (name === 'bottleneck' || name === 'profile') void this.#showBetween(presented, true);
    else void this.pin(presented, true);
  }

  /** A model has come, and nothing of it is drawn yet; `isSeen`: it is looked at from where another one was. */
  greet(presented: Presented, isSeen: boolean): void {
    if (!isSeen && attributeOf(this.#host.element, 'camera')) this.#look();
    this.#divide(presented, false);
    void this.#showBetween(presented, false);
  }

  /** A model has come: its tips are drawn, where they are wished for or its file has any. */
  greetTips(presented: Presented): void {
    const isWished = isOn(this.#host.element, 'tips') || presented.model.file.tips !== undefined;
    if (isWished) void this.#showTips(presented);
  }

  /** Draws the tips that are wished for, or else those that the file has. */
  async #showTips(presented: Presented): Promise<void> {
    const { element } = this.#host;
    const wish = isOn(element, 'tips') ? parseTips(element.getAttribute('tips')!) : undefined;
    this.#isFinding = true;
    try {
      if (wish === 'none') await this.#host.showTips({ shown: false });
      else if (!wish) await this.#host.showTips({ shown: presented.model.file.tips !== undefined });
      else {
        const leastJump = this.#lengthOf(wish.leastJump);
        const selected = wish.selected === undefined ? {} : { selected: wish.selected - 1 };
        await this.#host.showTips({ shown: true, leastJump, ...selected });
      }
    } catch (error) {
      if (!presented.model.life.signal.aborted) this.#host.failed(error);
    } finally {
      this.#isFinding = false;
    }
  }

  /** Draws what is asked for between two points, with the points; `anew`: something else may be drawn. */
  async #showBetween(presented: Presented, anew: boolean): Promise<void> {
    const { element } = this.#host;
    const turn = ++this.#betweenTurn;
    const neck = parseTwoPoints(attributeOf(element, 'bottleneck') ?? '');
    const points = neck ?? parsePath(attributeOf(element, 'profile') ?? '');
    if (anew) presented.showBetween([], undefined);
    if (!points) return;
    const { mesh, life, fields, file } = presented.model;
    const { signal } = life;
    try {
      if (file.isAll) {
        // The attribute is followed again of what the kernel makes of it.
        await this.#host.whole();
        return;
      }
      const [from, to] = points as [SurfacePoint, SurfacePoint];
      const { polyline } = neck
        ? await mesh.bottleneck(await fields.girth(signal), from, to, { signal })
        : await pathThrough(points, mesh, signal);
      if (turn === this.#betweenTurn) presented.showBetween(points, polyline);
    } catch (error) {
      if (turn === this.#betweenTurn && !signal.aborted) this.#host.failed(error);
    }
  }

  /**
   * Pins the loops that are wished for, or else those that the file has; `only`: no others stay. One that cannot be is
   * an error; the others are pinned all the same.
   */
  async pin({ model, loops }: Presented, only: boolean): Promise<void> {
    const turn = ++this.#pinTurn;
    const wishes = pinsOf(this.#host.element);
    const known = new Map(model.file.loops.map((loop) => [writePoint(loop.base), loop]));
    const wanted = wishes ?? model.file.loops.map(({ base }) => ({ point: base, name: '' }));
    const places = new Set(wanted.map(({ point }) => writePoint(point)));
    for (const { id, loop } of loops.pinned) {
      if (only && !places.has(writePoint(loop.base))) loops.unpin(id);
    }
    this.#isPinning = true;
    if (model.file.isAll && [...places].some((place) => !known.has(place))) {
      // The attribute is followed again of what the kernel makes of it.
      await this.#host.whole().catch(() => undefined);
      return;
    }
    for (const { point, name } of wanted) {
      try {
        const loop = known.get(writePoint(point));
        const { id } = loop ? loops.keep(loop) : await loops.pin(point);
        if (turn !== this.#pinTurn) return;
        loops.rename(id, name);
      } catch (error) {
        if (turn !== this.#pinTurn || model.life.signal.aborted) return;
        this.#host.failed(error);
      }
    }
    this.#isPinning = false;
  }

  /** Puts what is shown in place of what attributes ask for. */
  describe(state: ViewerState): void {
    const [presented, stage] = [this.#host.presented(), this.#host.stage()];
    if (!presented || !stage) return;
    const { thresholds, tips, model, shading } = presented;
    if (stage.isHome || !stage.view) delete state.camera;
    else state.camera = writeCamera(stage.view);
    if (!this.#isPinning) {
      const pins = presented.loops.pinned.map(({ loop, name }) => ({ point: loop.base, name }));
      if (pins.length > 0 || model.file.loops.length > 0) state.pins = writePins(pins);
      else delete state.pins;
    }
    if (!this.#isFinding) {
      if (tips.shown) state.tips = tipsWords(tips.shown.choice);
      else if (model.file.tips) state.tips = 'none';
      else delete state.tips;
    }
    if (thresholds && shading.wishes.name === 'parts') state.parts = partsWords(thresholds);
  }

  #look(): void {
    const stage = this.#host.stage();
    const text = attributeOf(this.#host.element, 'camera');
    const straight = straightNames.find((name) => name === text);
    const view = readCamera(text ?? '');
    if (straight) stage?.lookStraight(straight, true);
    else if (view) stage?.lookFrom(view);
    else stage?.resetView();
  }

  /** `anew`: other thresholds may be there. */
  #divide(presented: Presented, anew: boolean): void {
    const text = attributeOf(this.#host.element, 'parts');
    const wish = parseParts(text ?? '');
    // A model that is shown as its file has it has no parts.
    if (presented.model.file.isAll) return;
    try {
      if (wish) {
        const [girth, shapeDiameter] = [wish.girth, wish.shapeDiameter].map((word) =>
          this.#lengthOf(word),
        );
        presented.setThresholds({
          girth: girth!,
          shapeDiameter: shapeDiameter!,
          smoothing: wish.smoothing,
        });
      } else if (anew) presented.forgetThresholds();
    } catch (error) {
      this.#host.failed(error);
    }
    if (anew) this.#host.recolour();
  }

  /** The length of a word, in model units. */
  #lengthOf(word: string): number {
    if (word === 'inf') return Infinity;
    const read = readLength(word, this.#host.unit());
    if ('length' in read) return read.length;
    const hint = 'state the unit of the file with the attribute unit, or leave the unit out';
    throw new GirthError({ code: 'INVALID_OPTION', element: -1, message: read.fault, hint });
  }
}

/** The shortest paths from each point to the next, as one line. */
async function pathThrough(
  points: readonly SurfacePoint[],
  mesh: Mesh,
  signal: AbortSignal,
): Promise<{ polyline: Float32Array }> {
  const pieces = await Promise.all(
    points.slice(1).map((to, i) => mesh.path(points[i]!, to, { signal })),
  );
  return { polyline: Float32Array.from(pieces.flatMap(({ polyline }) => [...polyline])) };
}

const lengthWords = (length: number): string => (length === Infinity ? 'inf' : String(length));

function partsWords({ girth, shapeDiameter, smoothing }: Required<PartsWish>): string {
  return writeParts({
    girth: lengthWords(girth),
    shapeDiameter: lengthWords(shapeDiameter),
    smoothing,
  });
}

function tipsWords({ leastJump = 0, selected }: TipsChoice): string {
  return writeTips({
    leastJump: lengthWords(leastJump),
    selected: selected === undefined ? undefined : selected + 1,
  });
}
