// The one state of the page: what is shown, and the wish that waits for its model. The link, undo, projects, the element's
// attributes and the panels follow it; it changes by the methods here and by nothing else.

import { type SurfaceFacts, chosen, fitted, heldChoice, left } from './actions.js';
import type { PageState } from './address-state.js';

/** A whole state that a link, undo or a project asks for, until its model is there. */
export interface Wish {
  readonly number: number;
  readonly state: PageState;
  /** Whether the wish is a step of its own: the address does not have it yet. */
  readonly byHand: boolean;
  /** Whether the file is missing: nothing is under way for the wish. */
  readonly isMissing: boolean;
}

/** All that the page holds of its state; never changed, only replaced. */
export interface Held {
  readonly shown: PageState;
  /** Facts of the surface that is shown; undefined before the first one. */
  readonly facts: SurfaceFacts | undefined;
  readonly wish: Wish | undefined;
  /** How many wishes have come about that were no step of their own. */
  readonly settled: number;
}

interface Watcher {
  keys: readonly (keyof PageState)[];
  act: (state: PageState) => void;
}

export class Store {
  #held: Held = { shown: {}, facts: undefined, wish: undefined, settled: 0 };
  readonly #watchers: Watcher[] = [];
  readonly #listeners: ((held: Held) => void)[] = [];
  #told = this.#held;
  #isTelling = false;
  #wishes = 0;

  get held(): Held {
    return this.#held;
  }

  /** The state that is shown; empty before the first model. */
  get shown(): PageState {
    return this.#held.shown;
  }

  /** The state for the address: before the first model, the one that the link asks for. */
  get meant(): PageState {
    const { shown, facts, wish } = this.#held;
    return facts || !wish ? shown : wish.state;
  }

  get wish(): Wish | undefined {
    return this.#held.wish;
  }

  /** Calls back when one of these is another, and when another surface is shown; in the order of the calls. */
  watch(keys: readonly (keyof PageState)[], act: (state: PageState) => void): void {
    this.#watchers.push({ keys, act });
  }

  /** Calls back whenever anything of it is another, after those who watch. */
  listen(act: (held: Held) => void): void {
    this.#listeners.push(act);
  }

  /** Somebody has chosen something; undefined takes a choice back. */
  choose(choice: PageState): void {
    const held = this.#held;
    const { shown, wish } = held;
    const next = chosen(shown, choice);
    if (next === shown) return;
    if (!wish) return this.#set({ ...held, shown: next });
    const state = chosen(wish.state, heldChoice(shown, wish.state, choice));
    // The address has what the link or the step asked for, not what is chosen meanwhile.
    const byHand = wish.byHand || state !== wish.state;
    this.#set({ ...held, shown: next, wish: { ...wish, state, byHand } });
  }

  /** A whole state is asked for: it waits for its model. Returns its number; an older wish is given up. */
  ask(state: PageState, { byHand = false, isMissing = false } = {}): number {
    const number = ++this.#wishes;
    this.#set({ ...this.#held, wish: { number, state, byHand, isMissing } });
    return number;
  }

  /** The model of a wish did not come: the state stays as it is, and before the first model the wish does. */
  fail(number: number): void {
    const held = this.#held;
    const { wish, facts } = held;
    if (wish?.number !== number) return;
    this.#set({ ...held, wish: facts ? undefined : { ...wish, isMissing: true } });
  }

  /** Another model is opened by hand: no wish waits any more. */
  giveUp(): void {
    this.#set({ ...this.#held, wish: undefined });
  }

  /**
   * A surface is shown: with the state that was wished for it, or with what is left of the present one. `model` says where
   * it is from, `number` which wish it was opened for, `isAnother` that it is of another model.
   */
  arrive(model: PageState, facts: SurfaceFacts, number?: number, isAnother = false): void {
    const held = this.#held;
    const wish = held.wish?.number === number ? held.wish : undefined;
    const shown = fitted(wish?.state ?? left(held.shown, isAnother), model, facts);
    const settled = held.settled + (wish && !wish.byHand ? 1 : 0);
    this.#set({
      shown,
      facts: held.facts?.surface === facts.surface ? held.facts : facts,
      wish: wish ? undefined : held.wish,
      settled,
    });
  }

  #set(held: Held): void {
    this.#held = held;
    if (this.#isTelling) return;
    this.#isTelling = true;
    try {
      // A change that one watcher makes is told to all of them.
      while (this.#told !== this.#held) this.#tell();
    } finally {
      this.#isTelling = false;
    }
  }

  #tell(): void {
    const [before, now] = [this.#told, this.#held];
    this.#told = now;
    for (const { keys, act } of this.#watchers) {
      const isAnother = before.facts !== now.facts;
      if (isAnother || keys.some((key) => before.shown[key] !== now.shown[key])) act(this.shown);
    }
    for (const act of this.#listeners) act(this.#held);
  }
}
