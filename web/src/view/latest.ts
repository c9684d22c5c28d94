// Answers the newest of many requests without queueing those in between.

/** How long a request may hold up a newer one before it is given up, in milliseconds. */
const patience = 120;

/**
 * Runs at most one request at a time and remembers only the newest pending one. The one that
 * runs is allowed to finish although a newer one is pending, so that something is shown while the
 * pointer moves, but is aborted when it takes too long.
 */
export class Latest<Key, Answer> {
  #running: Running<Key> | undefined;
  #pending: { key: Key } | undefined;
  readonly #ask: (key: Key, signal: AbortSignal) => Promise<Answer>;
  readonly #answered: (key: Key, answer: Answer) => void;
  readonly #failed: (key: Key, error: unknown) => void;

  constructor(
    ask: (key: Key, signal: AbortSignal) => Promise<Answer>,
    answered: (key: Key, answer: Answer) => void,
    failed: (key: Key, error: unknown) => void,
  ) {
    this.#ask = ask;
    this.#answered = answered;
    this.#failed = failed;
  }

  /** Asks for `key`; replaces whatever is pending. Asking again for what runs already does nothing. */
  request(key: Key): void {
    if (this.#running) {
      if (Object.is(this.#running.key, key)) {
        this.#pending = undefined;
        return;
      }
      this.#pending = { key };
      const { controller } = this.#running;
      this.#running.timer ??= setTimeout(() => controller.abort(), patience);
      return;
    }
    void this.#run(key);
  }

  /** Forgets what is pending and aborts what runs; neither is answered. */
  clear(): void {
    this.#pending = undefined;
    const running = this.#running;
    this.#running = undefined;
    clearTimeout(running?.timer);
    running?.controller.abort();
  }

  async #run(key: Key): Promise<void> {
    const current: Running<Key> = { key, controller: new AbortController() };
    this.#running = current;
    const { signal } = current.controller;
    try {
      const answer = await this.#ask(key, signal);
      if (this.#running === current) this.#answered(key, answer);
    } catch (error) {
      if (this.#running === current && !signal.aborted) this.#failed(key, error);
    } finally {
      clearTimeout(current.timer);
      if (this.#running === current) {
        this.#running = undefined;
        const next = this.#pending;
        this.#pending = undefined;
        if (next) void this.#run(next.key);
      }
    }
  }
}

type Timer = ReturnType<typeof setTimeout>;

interface Running<Key> {
  key: Key;
  controller: AbortController;
  timer?: Timer;
}
