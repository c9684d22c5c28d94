// The page's address says what is shown, so that a link reproduces it and 'back' goes back to it.

import { type PageState, readState, writeState } from './address-state.js';

/** Milliseconds after a change until it is in the address: many changes come together. */
const delay = 250;

/** What a hand moves all the time makes no step to go back to. */
function withoutMoves({ camera, range, panel, ...rest }: PageState): PageState {
  void [camera, range, panel];
  return rest;
}

export class Address {
  private timer: ReturnType<typeof setTimeout> | undefined;
  private isHeld = true;

  constructor(
    private readonly read: () => PageState,
    apply: (state: PageState) => void,
  ) {
    window.addEventListener('popstate', () => {
      clearTimeout(this.timer);
      apply(this.state);
    });
  }

  /** What the address says. */
  get state(): PageState {
    return readState(location.hash);
  }

  /** What is shown as an address. */
  get link(): string {
    const link = new URL(location.href);
    link.hash = writeState(this.read());
    return link.href;
  }

  /** Nothing is written while what the address says is still being brought about. */
  hold(isHeld: boolean): void {
    this.isHeld = isHeld;
    if (isHeld) clearTimeout(this.timer);
  }

  /** What is shown has changed: writes it before long. */
  changed(): void {
    if (this.isHeld) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write(), delay);
  }

  private write(): void {
    if (this.isHeld) return;
    const before = this.state;
    const now = this.read();
    const text = writeState(now);
    if (text === writeState(before)) return;
    const address = text === '' ? location.pathname + location.search : `#${text}`;
    const isStep = writeState(withoutMoves(now)) !== writeState(withoutMoves(before));
    if (isStep) history.pushState(null, '', address);
    else history.replaceState(null, '', address);
  }
}
