// The page's address holds what is shown, so that a link reproduces it and 'back' goes back to it.

import { type PageState, readState, writeState } from './address-state.js';
import type { Store } from './store.js';
import { stepWords } from './step-words.js';
import { UndoSteps } from './undo-steps.js';

/** Milliseconds after a change until it is in the address: many changes come together. */
const delay = 250;

/** Leaves out what a hand moves all the time: such moves make no step to go back to. */
function withoutMoves({ camera, range, panel, values, ...rest }: PageState): PageState {
  void [camera, range, panel, values];
  return rest;
}

/** The address of a state in text. */
const addressOf = (text: string): string =>
  text === '' ? location.pathname + location.search : `#${text}`;

export interface AddressEvents {
  /** A state with what its link says besides. */
  written(state: PageState): PageState;
  /** A link, or a step of undo, asks for a state. */
  followed(state: PageState): void;
  /** Whether there is something to undo or to redo may be another now. */
  stepped(): void;
}

export class Address {
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** The state as it was written last, or came about by itself. */
  #known: string;
  /** The known state, with what a link says besides. */
  #bar: string;
  #settled = 0;
  /** A step is being undone or redone: what comes about is that step. */
  #isRestoring = false;
  readonly #steps: UndoSteps;
  readonly #store: Store;
  readonly #events: AddressEvents;

  constructor(store: Store, events: AddressEvents) {
    this.#store = store;
    this.#events = events;
    this.#steps = new UndoSteps(() => events.stepped());
    this.#bar = this.#known = writeState(this.state);
    // A click is an action of its own, however soon after another one.
    window.addEventListener('click', () => this.flush(), { capture: true });
    window.addEventListener('popstate', () => events.followed(this.state));
    store.listen(({ settled }) => {
      if (settled !== this.#settled) this.#settle(settled);
      else this.#writeSoon();
    });
  }

  /** The state that the address holds. */
  get state(): PageState {
    return readState(location.hash);
  }

  /** The address of what is shown. */
  get link(): string {
    const link = new URL(location.href);
    link.hash = this.#link;
    return link.href;
  }

  get #link(): string {
    return writeState(this.#events.written(this.#store.meant));
  }

  /** Words for the change that `undo` would make; undefined where there is nothing to undo. */
  get undoWords(): string | undefined {
    return this.#wordsOf(this.#steps.before);
  }

  /** Words for the change that `redo` would make; undefined where there is nothing to redo. */
  get redoWords(): string | undefined {
    return this.#wordsOf(this.#steps.after);
  }

  #wordsOf(step: string | undefined): string | undefined {
    return step === undefined ? undefined : stepWords(this.#steps.present ?? '', step);
  }

  /** Shows what was shown before the last change of anything that the address holds: the camera, too. */
  undo(): void {
    // The last change, if not written yet, is the step to undo.
    this.flush();
    this.#restore(this.#steps.undo());
  }

  /** Shows what was undone last. */
  redo(): void {
    this.flush();
    this.#restore(this.#steps.redo());
  }

  /** Writes a change at once that was to be written before long: what comes next is another step. */
  flush(): void {
    if (this.#timer !== undefined) this.#write();
  }

  #restore(text: string | undefined): void {
    if (text === undefined) return;
    this.#isRestoring = true;
    history.replaceState(null, '', addressOf(text));
    this.#events.followed(readState(text));
  }

  /** Takes note that the state of a link or a step is shown now. */
  #settle(settled: number): void {
    this.#settled = settled;
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#bar = this.#link;
    this.#step(writeState(this.#store.meant));
  }

  #step(text: string): void {
    this.#known = text;
    if (this.#isRestoring) this.#steps.correct(text);
    else this.#steps.take(text);
    this.#isRestoring = false;
  }

  #writeSoon(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#write(), delay);
  }

  #write(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    const { wish, meant } = this.#store;
    // A wished state is in the address already, or will be written when it is shown.
    if (wish && !wish.isMissing) return;
    const bar = this.#link;
    if (bar === this.#bar) return;
    this.#bar = bar;
    const isStep =
      !this.#isRestoring &&
      writeState(withoutMoves(meant)) !== writeState(withoutMoves(readState(this.#known)));
    this.#step(writeState(meant));
    if (isStep) history.pushState(null, '', addressOf(bar));
    else history.replaceState(null, '', addressOf(bar));
  }
}
