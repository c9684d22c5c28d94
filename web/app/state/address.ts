// The page's address holds what is shown, so that a link reproduces it and 'back' goes back to it.

import { type PageState, readState, writeState } from './address-state.js';
import { UndoSteps } from './undo-steps.js';

/** Milliseconds after a change until it is in the address: many changes come together. */
const delay = 250;

/** What a hand moves all the time makes no step to go back to. */
function withoutMoves({ camera, range, panel, values, ...rest }: PageState): PageState {
  void [camera, range, panel, values];
  return rest;
}

/** Of a state as text. */
const addressOf = (text: string): string =>
  text === '' ? location.pathname + location.search : `#${text}`;

export class Address {
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** How many tasks are still applying what the address holds. */
  #holders = 0;
  /** What needs no writing: the state as it came about by itself, or was written last. */
  #known = '';
  /** A step is being undone or redone: what comes about is that step. */
  #isRestoring = false;
  readonly #steps: UndoSteps;
  readonly #read: () => PageState;
  readonly #apply: (state: PageState) => void;

  /** `stepped`: whether there is something to undo or to redo may be another now. */
  constructor(read: () => PageState, apply: (state: PageState) => void, stepped: () => void) {
    this.#read = read;
    this.#apply = apply;
    this.#steps = new UndoSteps(stepped);
    // A click is an action of its own, however soon after another one.
    window.addEventListener('click', () => this.flush(), { capture: true });
    window.addEventListener('popstate', () => {
      clearTimeout(this.#timer);
      apply(this.state);
    });
  }

  /** The state that the address holds. */
  get state(): PageState {
    return readState(location.hash);
  }

  /** What is shown as an address. */
  get link(): string {
    const link = new URL(location.href);
    link.hash = writeState(this.#read());
    return link.href;
  }

  /** Writes nothing until this work, which applies what the address holds, is over. */
  async during(work: Promise<unknown>): Promise<void> {
    ++this.#holders;
    clearTimeout(this.#timer);
    await work.catch(() => undefined);
    if (--this.#holders > 0) return;
    this.#isRestoring = false;
    this.changed();
  }

  /** What is shown now did not come about by hand. */
  settle(): void {
    this.#known = writeState(this.#read());
    this.#step(this.#known);
  }

  get canUndo(): boolean {
    return this.#steps.canUndo;
  }

  get canRedo(): boolean {
    return this.#steps.canRedo;
  }

  /** Shows what was shown before the last change of anything that the address holds: the camera, too. */
  undo(): void {
    // What has just been changed is the step to undo.
    this.flush();
    this.#restore(this.#steps.undo());
  }

  /** Shows what was undone last. */
  redo(): void {
    this.flush();
    this.#restore(this.#steps.redo());
  }

  #restore(text: string | undefined): void {
    if (text === undefined) return;
    this.#isRestoring = true;
    history.replaceState(null, '', addressOf(text));
    this.#apply(readState(text));
  }

  #step(text: string): void {
    if (this.#isRestoring) this.#steps.correct(text);
    else this.#steps.take(text);
    this.#isRestoring = false;
  }

  /** Writes a change at once that was to be written before long: what comes next is another step. */
  flush(): void {
    if (this.#timer !== undefined) this.#write();
  }

  /** What is shown has changed: writes it before long. */
  changed(): void {
    if (this.#holders > 0) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#write(), delay);
  }

  #write(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    if (this.#holders > 0) return;
    const before = this.state;
    const now = this.#read();
    const text = writeState(now);
    if (text === this.#known) return;
    if (text === writeState(before)) {
      // What the address asks for has come about bit by bit.
      this.#steps.correct(text);
      return;
    }
    this.#known = text;
    const isStep =
      !this.#isRestoring && writeState(withoutMoves(now)) !== writeState(withoutMoves(before));
    this.#step(text);
    if (isStep) history.pushState(null, '', addressOf(text));
    else history.replaceState(null, '', addressOf(text));
  }
}
