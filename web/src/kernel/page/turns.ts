// Turns at workers that do one thing at a time. Urgent wishes go first: the present turn is asked to pause, and goes on
// after them.

/** The order of turns: urgent ones, then those that were paused, then the others as they came. */
type Rank = 0 | 1 | 2;

export interface Wish {
  isUrgent: boolean;
  /** Whether it can stop and go on later. */
  canPause: boolean;
}

export interface Turn {
  /** Fires when the turn is wanted for something urgent: it is to be ended soon. */
  readonly pause: AbortSignal;
  end(): void;
}

interface Waiting {
  readonly wish: Wish;
  readonly rank: Rank;
  begin(turn: Turn): void;
}

export class Turns {
  readonly #waiting: Waiting[] = [];
  #present: { wish: Wish; pause: AbortController } | undefined;

  /** Whether something has the turn that cannot pause. */
  get isHeld(): boolean {
    return this.#present?.wish.canPause === false;
  }

  /** Waits for a turn. `again`: it was paused before. */
  take(wish: Wish, again = false): Promise<Turn> {
    return new Promise((begin) => {
      const rank = wish.isUrgent ? 0 : again ? 1 : 2;
      const behind = this.#waiting.findIndex((other) => other.rank > rank);
      const at = behind < 0 ? this.#waiting.length : behind;
      this.#waiting.splice(at, 0, { wish, rank, begin });
      const present = this.#present;
      if (wish.isUrgent && present?.wish.canPause && !present.wish.isUrgent) present.pause.abort();
      this.#next();
    });
  }

  #next(): void {
    if (this.#present) return;
    const next = this.#waiting.shift();
    if (!next) return;
    const present = { wish: next.wish, pause: new AbortController() };
    this.#present = present;
    next.begin({
      pause: present.pause.signal,
      end: () => {
        if (this.#present !== present) return;
        this.#present = undefined;
        this.#next();
      },
    });
  }
}
