// Answers the newest of many requests without queueing those in between.

/** How long a request may hold up a newer one before it is given up, in milliseconds. */
const patience = 120;

/**
 * Runs at most one request at a time and remembers only the newest one waiting. A request that a
 * newer one waits for is allowed to finish, so that something is shown while the pointer moves,
 * but is aborted when it takes too long.
 */
export class Latest<Key, Answer> {
  private running: { key: Key; controller: AbortController; timer?: Timer } | undefined;
  private waiting: { key: Key } | undefined;

  constructor(
    private readonly ask: (key: Key, signal: AbortSignal) => Promise<Answer>,
    private readonly answered: (key: Key, answer: Answer) => void,
    private readonly failed: (key: Key, error: unknown) => void,
  ) {}

  /** Asks for `key`; replaces whatever waits. Asking again for what runs already does nothing. */
  request(key: Key): void {
    if (this.running) {
      if (Object.is(this.running.key, key)) {
        this.waiting = undefined;
        return;
      }
      this.waiting = { key };
      const { controller } = this.running;
      this.running.timer ??= setTimeout(() => controller.abort(), patience);
      return;
    }
    void this.run(key);
  }

  /** Forgets what waits and aborts what runs; neither is answered. */
  clear(): void {
    this.waiting = undefined;
    const { running } = this;
    this.running = undefined;
    clearTimeout(running?.timer);
    running?.controller.abort();
  }

  private async run(key: Key): Promise<void> {
    const current: NonNullable<typeof this.running> = { key, controller: new AbortController() };
    this.running = current;
    const { signal } = current.controller;
    try {
      const answer = await this.ask(key, signal);
      if (this.running === current) this.answered(key, answer);
    } catch (error) {
      if (this.running === current && !signal.aborted) this.failed(key, error);
    } finally {
      clearTimeout(current.timer);
      if (this.running === current) {
        this.running = undefined;
        const next = this.waiting;
        this.waiting = undefined;
        if (next) void this.run(next.key);
      }
    }
  }
}

type Timer = ReturnType<typeof setTimeout>;
