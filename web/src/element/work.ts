// Work on a model that is not there yet, one at a time: announced in words, with a cross to end it.

/** Milliseconds of work before the element shows that it works. */
const delay = 150;

export interface Watched {
  signal: AbortSignal;
  /** The finished share in [0, 1]. */
  onProgress: (share: number) => void;
}

/** The display of work. */
export interface WorkDisplay {
  /** Shows the words for the work, and its finished share. */
  showWork(words: string, share: number): void;
  endWork(): void;
}

export class Work {
  #running: AbortController | undefined;
  readonly #display: WorkDisplay;

  constructor(display: WorkDisplay) {
    this.#display = display;
  }

  get isRunning(): boolean {
    return this.#running !== undefined;
  }

  /** Ends what runs. */
  cancel(): void {
    this.#running?.abort();
    this.#running = undefined;
  }

  /** Runs something in place of what runs already, and shows it where it takes a while. */
  async run<Answer>(words: string, act: (watched: Watched) => Promise<Answer>): Promise<Answer> {
    this.cancel();
    const running = new AbortController();
    this.#running = running;
    let share = 0;
    let isSlow = false;
    const show = (): void => {
      if (isSlow && this.#running === running) this.#display.showWork(words, share);
    };
    const onProgress = (fraction: number): void => {
      share = fraction;
      show();
    };
    const slow = setTimeout(() => {
      isSlow = true;
      show();
    }, delay);
    try {
      return await act({ signal: running.signal, onProgress });
    } finally {
      clearTimeout(slow);
      if (this.#running === running || !this.#running) this.#display.endWork();
      if (this.#running === running) this.#running = undefined;
    }
  }
}
