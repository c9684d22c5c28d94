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

/** The steps of a frame. */
export interface FrameWork {
  /** First in each frame. Returns true to ask for another one. */
  begin(now: number): boolean;
  /** Whether nothing moves but a slow turning, for which fewer frames will do. */
  isUnhurried(): boolean;
  /** Goes on with what moves, by so many seconds. */
  advance(seconds: number): Motion;
  draw(): void;
}

/**
 * The page's frames, one for all schedulers: all advance before any draws, so that what one changes in another is
 * drawn together with it.
 */
class PageFrames {
  #requested = 0;
  #next = new Set<FrameScheduler>();
  /** While a frame's schedulers advance: those that are still to advance. */
  #due: Set<FrameScheduler> | undefined;
  /** The one that advances. */
  #current: FrameScheduler | undefined;
  /** How often each has begun to advance in this frame. */
  readonly #turns = new Map<FrameScheduler, number>();

  /**
   * Asks for a frame: this one, where another scheduler advances, otherwise the next. One that has advanced already then
   * does so again, once: whoever comes first, what is moved by another notices it in the same frame.
   */
  request(scheduler: FrameScheduler): void {
    if (this.#due && scheduler !== this.#current && (this.#turns.get(scheduler) ?? 0) < 2) {
      this.#next.delete(scheduler);
      this.#due.add(scheduler);
      return;
    }
    this.#next.add(scheduler);
    this.#requested ||= requestAnimationFrame((now) => this.#frame(now));
  }

  leave(scheduler: FrameScheduler): void {
    this.#due?.delete(scheduler);
    this.#turns.delete(scheduler);
    this.#next.delete(scheduler);
    if (this.#next.size > 0) return;
    cancelAnimationFrame(this.#requested);
    this.#requested = 0;
  }

  #frame(now: number): void {
    this.#requested = 0;
    this.#due = this.#next;
    this.#next = new Set();
    this.#turns.clear();
    try {
      // Schedulers that are added meanwhile come last.
      for (const scheduler of this.#due) {
        this.#due.delete(scheduler);
        this.#turns.set(scheduler, (this.#turns.get(scheduler) ?? 0) + 1);
        this.#current = scheduler;
        scheduler.advance(now);
      }
    } finally {
      this.#due = this.#current = undefined;
    }
    for (const scheduler of this.#turns.keys()) scheduler.draw();
  }
}

const frames = new PageFrames();

export class FrameScheduler {
  readonly #work: FrameWork;
  /** Whether a frame begins: what changes now is drawn in it. */
  #isBeginning = false;
  /** The motion that the last step of a frame has returned, until the frame is drawn. */
  #motion: Motion = 'none';
  /** Whether another frame was asked for by what began this one. */
  #isAgain = false;
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
    if (!this.#isBeginning && !this.#isResting) frames.request(this);
  }

  /** Nothing is drawn while resting, for example out of view. */
  rest(isResting: boolean): void {
    this.#isResting = isResting;
    if (!isResting) this.invalidate();
  }

  /** No frame comes any more. */
  stop(): void {
    frames.leave(this);
    clearTimeout(this.#soon);
    this.#isResting = true;
  }

  /** For the page's frames: goes on with what moves; again in the same frame where another one has moved it. */
  advance(now: number): void {
    // Changes by `begin` are drawn in this frame; only its result asks for another.
    this.#isBeginning = true;
    try {
      this.#isAgain = this.#work.begin(now);
    } finally {
      this.#isBeginning = false;
    }
    this.#motion = 'none';
    const elapsed = now - this.#lastFrame;
    if (!this.#isDirty && this.#work.isUnhurried() && elapsed < turningInterval) {
      this.#isAgain = false;
      this.look();
      return;
    }
    this.#lastFrame = now;
    this.#motion = this.#work.advance(Math.min(longestStep, elapsed / 1000));
    if (this.#motion !== 'none') this.#isDirty = true;
  }

  /** For the page's frames, after `advance`: draws what has changed. */
  draw(): void {
    if (this.#isDirty && !this.#isResting) {
      this.#isDirty = false;
      const begun = performance.now();
      this.#work.draw();
      // A task of its own comes after the browser has composited what was drawn.
      setTimeout(() => (this.#frameCost = 0.5 * (this.#frameCost + performance.now() - begun)));
    }
    if (this.#isAgain) this.invalidate();
    else if (this.#motion === 'more') this.look();
  }
}
