// Work on a model that is not there yet, one at a time: said in words, with a cross to end it.

import type { StatusBar } from './status-bar.js';

/** Milliseconds of work before the element says so. */
const delay = 150;

export interface Watched {
  signal: AbortSignal;
  /** The finished share in [0, 1]. */
  onProgress: (share: number) => void;
}

export class Work {
  #running: AbortController | undefined;
  readonly #status: StatusBar;

  constructor(status: StatusBar) {
    this.#status = status;
  }

  /** Ends what runs. */
  cancel(): void {
    this.#running?.abort();
    this.#running = undefined;
  }

  /** Runs something in place of what runs already, and says so where it takes a while. */
  async run<Answer>(words: string, act: (watched: Watched) => Promise<Answer>): Promise<Answer> {
    this.cancel();
    const running = new AbortController();
    this.#running = running;
    let share = 0;
    let isSlow = false;
    const show = (): void => {
      if (isSlow && this.#running === running) this.#status.showWork(words, share);
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
      if (this.#running === running || !this.#running) this.#status.endWork();
      if (this.#running === running) this.#running = undefined;
    }
  }
}
