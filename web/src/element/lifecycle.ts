// The life of the element: a state machine of loading, showing and colouring. It knows no document
// and no canvas; its effects are its host's work.
//
// | event                | detached | empty    | loading      | shown     | replacing    |
// | -------------------- | -------- | -------- | ------------ | --------- | ------------ |
// | `attach`             | empty    |          |              |           |              |
// | `detach`             |          | detached | detached ¹ ² | detached² | detached ¹ ² |
// | `load`               | ³        | loading  | loading ¹    | replacing | replacing ¹  |
// | the load succeeds    | ³        |          | shown        |           | shown ²      |
// | the load fails       |          |          | empty ⁴      |           | shown ⁴      |
// | `cancelLoad`         |          |          | empty ¹      |           | shown ¹      |
//
// ¹ The load before is ended: its promise rejects, and what it still brings is disposed of.
// ² The model that was shown is dropped; a mesh that the next model was made of stays. Such a mesh can be shown again.
// Where a load brings what is shown already, nothing is dropped.
// ³ It is read, and shown if the element is attached by then; otherwise it fails.
// ⁴ The host is given the reason.
//
// While a model is shown, a field may be wanted as its colours: pending until the element is in view, then
// computing, then done, halted (cancelled; it can be resumed) or failed. Only the newest wish counts.

import type { Watched, Work } from './work.js';

/** Shares of the time to show a model: until it is read; the rest is spent on drawing. */
const readingShare = 0.7;

export type Phase = 'detached' | 'empty' | 'loading' | 'shown' | 'replacing';
export type Colouring = 'none' | 'pending' | 'computing' | 'done' | 'halted' | 'failed';

/** A resource that a model is drawn from; it takes memory until it is disposed of. */
export interface Disposable {
  dispose(): void;
}

/** A load as it is asked for. */
export interface Wanted<Mesh, Origin> {
  /** Shown meanwhile. */
  words: string;
  /** The name of the model, for messages; '' for none. */
  name: string;
  read: (watched: Watched) => Promise<Mesh>;
  /** The original that the mesh is made of, where it is to be kept. */
  origin?: Origin | undefined;
}

/** The host, which carries out what the machine decides. */
export interface LifecycleHost<Mesh, Model, Shown, Origin> {
  /** Makes what was read ready to draw. */
  prepare(mesh: Mesh, signal: AbortSignal): Promise<Model>;
  /** Draws a model in place of nothing. */
  present(model: Model, origin: Origin | undefined): Shown;
  /** The model is there. */
  presented(shown: Shown): void;
  /** Takes away what is drawn and disposes of its mesh, unless that is kept. */
  drop(shown: Shown, keepsMesh: boolean): void;
  /** A load, or the colouring of what is shown, has failed. */
  failed(name: string, error: unknown): void;
}

/** `Name` is of what can colour a model, `Field` of what has to be computed for it. */
export class Lifecycle<
  Mesh extends Disposable,
  Model,
  Shown,
  Origin extends { mesh: Mesh },
  Name extends string,
  Field extends Name,
> {
  readonly #work: Work;
  readonly #host: LifecycleHost<Mesh, Model, Shown, Origin>;
  #isAttached = false;
  #isInView = false;
  #awaitsView: (() => void)[] = [];
  #present: { mesh: Mesh; shown: Shown } | undefined;
  #origin: Origin | undefined;
  #colouring: Colouring = 'none';
  #wanted: Name | undefined;
  #halted: Field | undefined;

  constructor(work: Work, host: LifecycleHost<Mesh, Model, Shown, Origin>) {
    this.#work = work;
    this.#host = host;
  }

  get phase(): Phase {
    if (!this.#isAttached) return 'detached';
    if (this.#work.isRunning) return this.#present ? 'replacing' : 'loading';
    return this.#present ? 'shown' : 'empty';
  }

  /** How far the newest wish for colours has come. */
  get colouring(): Colouring {
    return this.#colouring;
  }

  /** The model as it is shown; undefined where none is. */
  get shown(): Shown | undefined {
    return this.#present?.shown;
  }

  /** The original that the shown model was made of; undefined where it was not kept. */
  get origin(): Origin | undefined {
    return this.#origin;
  }

  /** Whether the wanted field is the one whose computation was cancelled. */
  get #isHalted(): boolean {
    return this.#colouring === 'halted';
  }

  /** The element is on a page. */
  attach(): void {
    this.#isAttached = true;
  }

  /** The element is taken off its page: all work ends, and nothing is shown. */
  detach(): void {
    this.#isAttached = false;
    this.#work.cancel();
    this.#drop();
    this.#isInView = false;
    this.#awaitsView = [];
  }

  /** The element has come into view, or has left it. */
  setInView(isInView: boolean): void {
    this.#isInView = isInView;
    if (isInView) for (const go of this.#awaitsView.splice(0)) go();
  }

  /** Resolves once the element is in view; never if it is detached before. */
  inView(): Promise<void> {
    return this.#isInView
      ? Promise.resolve()
      : new Promise((resolve) => this.#awaitsView.push(resolve));
  }

  /** Reads a model and shows it in place of the present one, which stays where that fails. */
  load({ words, name, read, origin }: Wanted<Mesh, Origin>): Promise<Mesh> {
    return this.#work.run(words, async ({ signal, onProgress }) => {
      try {
        const mesh = await read({
          signal,
          onProgress: (share) => onProgress(readingShare * share),
        });
        // A mesh that is shown already, or was before, is not this load's to dispose of.
        const isOwn = mesh !== this.#present?.mesh && mesh !== this.#origin?.mesh;
        try {
          onProgress(readingShare);
          signal.throwIfAborted();
          if (mesh === this.#present?.mesh) return mesh;
          const model = await this.#host.prepare(mesh, signal);
          signal.throwIfAborted();
          this.#replace(mesh, model, origin);
        } catch (error) {
          if (isOwn) mesh.dispose();
          throw error;
        }
        return mesh;
      } catch (error) {
        if (!signal.aborted) this.#host.failed(name, error);
        throw error;
      }
    });
  }

  /** Ends the present load; the model that was shown before stays. */
  cancelLoad(): void {
    this.#work.cancel();
  }

  /**
   * Colours what is shown by a field, once it is in view: `compute` makes it ready, `paint` shows it. A wish
   * for another field, or another model, ends this one; what was computed stays.
   */
  async colour(name: Name, compute: () => Promise<void>, paint: () => void): Promise<void> {
    const present = this.#present;
    if (!present) return;
    this.#wanted = name;
    this.#colouring = this.#isInView ? 'computing' : 'pending';
    const isWanted = (): boolean => this.#present === present && this.#wanted === name;
    await this.inView();
    if (!isWanted()) return;
    this.#colouring = 'computing';
    try {
      await compute();
      if (!isWanted()) return;
      this.#colouring = 'done';
      paint();
    } catch (error) {
      if (this.#present !== present) return;
      if (isWanted() && !this.#isHalted) this.#colouring = 'failed';
      this.#host.failed('', error);
    }
  }

  /** The computation of a field was cancelled by hand: it can be resumed. */
  halt(name: Field): void {
    this.#halted = name;
    if (this.#wanted === name) this.#colouring = 'halted';
  }

  /**
   * Goes on with the field that was halted last; false where there is none, or where it did not come to its
   * end. Failures are the host's to report, where fields end.
   */
  async resume(compute: (shown: Shown, name: Field) => Promise<unknown>): Promise<boolean> {
    const [present, name] = [this.#present, this.#halted];
    this.#halted = undefined;
    if (!present || name === undefined) return false;
    if (this.#wanted === name) this.#colouring = 'computing';
    return compute(present.shown, name).then(
      () => true,
      () => false,
    );
  }

  #replace(mesh: Mesh, model: Model, origin: Origin | undefined): void {
    if (!this.#isAttached) throw new Error('the element is no longer on a page');
    this.#drop([mesh, ...(origin ? [origin.mesh] : [])]);
    this.#origin = origin;
    const shown = this.#host.present(model, origin);
    this.#present = { mesh, shown };
    this.#host.presented(shown);
  }

  /** `kept` are still wanted: what comes next, and what that was made of. */
  #drop(kept: readonly Mesh[] = []): void {
    const [present, origin] = [this.#present, this.#origin];
    if (origin && !kept.includes(origin.mesh)) origin.mesh.dispose();
    this.#origin = undefined;
    this.#present = undefined;
    this.#halted = undefined;
    this.#wanted = undefined;
    this.#colouring = 'none';
    if (present) this.#host.drop(present.shown, kept.includes(present.mesh));
  }
}
