// When frames are drawn: only after something has changed, and while something moves.

/** Milliseconds between two frames of a surface that only turns by itself. */
const turningInterval = 30;
/** Milliseconds between two frames while only colours change, at least and at most. */
const colourInterval = [100, 1000] as const;
/** Share of the time that may go into such frames, where drawing is slow: the work goes first. */
const colourShare = 0.2;
/** Seconds that a motion goes on by in one frame, at most. */
const longestStep = 0.1;

/** How a motion goes on: not at all, with a last step that is to be drawn, or with more to come. */
export type Motion = 'none' | 'last' | 'more';

/** What is done in a frame. */
export interface FrameWork {
  /** First in each frame. Returns true to ask for another one. */
  begin(now: number): boolean;
  /** Whether nothing moves but a slow turning, for which fewer frames will do. */
  isUnhurried(): boolean;
  /** Goes on with what moves, by so many seconds. */
  advance(seconds: number): Motion;
  draw(): void;
}

export class FrameScheduler {
  readonly #work: FrameWork;
  #requested = 0;
  #soon: ReturnType<typeof setTimeout> | undefined;
  #isDirty = false;
  #lastFrame = 0;
  /** Milliseconds that a frame keeps the page busy, drawing and compositing, smoothed. */
  #frameCost = 0;
  #isResting = true;

  /** Rests until `rest(false)`. */
  constructor(work: FrameWork) {
    this.#work = work;
  }

  /** Asks for a frame that is drawn. */
  invalidate(): void {
    this.#isDirty = true;
    this.look();
  }

  /** Asks for a drawn frame before long; many such requests share one. */
  invalidateSoon(): void {
    this.#soon ??= setTimeout(
      () => {
        this.#soon = undefined;
        this.invalidate();
      },
      Math.min(colourInterval[1], Math.max(colourInterval[0], this.#frameCost / colourShare)),
    );
  }

  /** Asks for a frame that is drawn only if something turns out to move. */
  look(): void {
    if (this.#requested || this.#isResting) return;
    this.#requested = requestAnimationFrame((now) => this.#frame(now));
  }

  /** Nothing is drawn while resting, for example out of view. */
  rest(isResting: boolean): void {
    this.#isResting = isResting;
    if (!isResting) this.invalidate();
  }

  /** No frame comes any more. */
  stop(): void {
    cancelAnimationFrame(this.#requested);
    clearTimeout(this.#soon);
    this.#isResting = true;
  }

  #frame(now: number): void {
    // What `begin` changes is drawn in this frame; only what it returns asks for another.
    const again = this.#work.begin(now);
    this.#requested = 0;
    const elapsed = now - this.#lastFrame;
    if (!this.#isDirty && this.#work.isUnhurried() && elapsed < turningInterval) {
      this.look();
      return;
    }
    this.#lastFrame = now;
    const motion = this.#work.advance(Math.min(longestStep, elapsed / 1000));
    if (this.#isDirty || motion !== 'none') {
      this.#isDirty = false;
      const begun = performance.now();
      this.#work.draw();
      // A task of its own comes after the browser has composited what was drawn.
      setTimeout(() => (this.#frameCost = 0.5 * (this.#frameCost + performance.now() - begun)));
    }
    if (again) this.invalidate();
    else if (motion === 'more') this.look();
  }
}
