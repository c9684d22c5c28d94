// The page's address holds what is shown, so that a link reproduces it and 'back' goes back to it.

import { type PageState, readState, writeState } from './address-state.js';

/** Milliseconds after a change until it is in the address: many changes come together. */
const delay = 250;

/** What a hand moves all the time makes no step to go back to. */
function withoutMoves({ camera, range, panel, values, ...rest }: PageState): PageState {
  void [camera, range, panel, values];
  return rest;
}

export class Address {
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** How many tasks are still applying what the address holds. */
  #holders = 0;
  /** What needs no writing: the state as it came about by itself, or was written last. */
  #known = '';
  readonly #read: () => PageState;

  constructor(read: () => PageState, apply: (state: PageState) => void) {
    this.#read = read;
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
    if (--this.#holders === 0) this.changed();
  }

  /** What is shown now did not come about by hand. */
  settle(): void {
    this.#known = writeState(this.#read());
  }

  /** What is shown has changed: writes it before long. */
  changed(): void {
    if (this.#holders > 0) return;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#write(), delay);
  }

  #write(): void {
    if (this.#holders > 0) return;
    const before = this.state;
    const now = this.#read();
    const text = writeState(now);
    if (text === this.#known || text === writeState(before)) return;
    this.#known = text;
    const address = text === '' ? location.pathname + location.search : `#${text}`;
    const isStep = writeState(withoutMoves(now)) !== writeState(withoutMoves(before));
    if (isStep) history.pushState(null, '', address);
    else history.replaceState(null, '', address);
  }
}
