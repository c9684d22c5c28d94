// The slow turning of the surface: it begins by itself where that is wished for, and ends with the first
// action anywhere on the page. Whoever wants it longer, or not at all, has a button.

import type { Stage } from '../../view/index.js';
import { isMotionReduced } from '../surface/surroundings.js';

export interface TurningHost {
  /** The stage, if there is one. */
  stage(): Stage | undefined;
  /** Whether the surface is to turn by itself. */
  isWished(): boolean;
  /** Whether something is computed: the work goes first. */
  isBusy(): boolean;
  /** Somebody has done something for the first time: the surface no longer turns by itself. */
  ended(): void;
  /** The surface turns, or no longer. */
  changed(isTurning: boolean): void;
}

export class Turning {
  readonly #host: TurningHost;
  /** Whether somebody has done something since. */
  #isEnded = false;
  /** Whether somebody asked for the turning. */
  #isAskedFor = false;

  constructor(host: TurningHost) {
    this.#host = host;
  }

  /** Listens on the whole page until the signal; events on `button` are left to `toggle`. */
  listen(button: Element, signal: AbortSignal): void {
    const act = (event: Event): void => {
      if (event.composedPath().includes(button)) return;
      if (!this.#isAskedFor) this.end();
    };
    for (const type of ['pointerdown', 'keydown', 'wheel']) {
      window.addEventListener(type, act, { signal, capture: true, passive: true });
    }
  }

  /** Whether the surface turns, or will when the work is done. */
  get isOn(): boolean {
    const byItself = this.#host.isWished() && !this.#isEnded && !isMotionReduced();
    return byItself || this.#isAskedFor;
  }

  /** The surface is moved or pointed at, or something else is done on the page. */
  end(): void {
    const isFirst = !this.#isEnded;
    this.#isEnded = true;
    this.#isAskedFor = false;
    this.update();
    if (isFirst) this.#host.ended();
  }

  /** Starts and stops it by hand. */
  toggle(): void {
    if (this.isOn) {
      this.end();
      return;
    }
    this.#isAskedFor = true;
    this.update();
  }

  update(): void {
    const stage = this.#host.stage();
    if (!stage) return;
    const { isOn } = this;
    const turning = isOn && !this.#host.isBusy();
    if (stage.turning !== turning) stage.turning = turning;
    stage.turnsAtHome = isOn;
    this.#host.changed(isOn);
  }
}
