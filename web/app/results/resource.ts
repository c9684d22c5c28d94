// A result that is computed for what is shown: its key says of what. A result whose key is no longer wanted is ended, and
// never shown, however late it comes.

import type { WatchedOptions } from '../../src/kernel/index.js';

/** Options of one step of the work: its progress is said behind these words. */
export type Watch = (words: string) => Required<WatchedOptions>;

/** The surface and the parameters that a result is of: equal keys have equal results. */
export type Key = readonly unknown[];

export type Status<Found> =
  | { readonly is: 'unwanted' }
  /** `words` is what is being done, and `share` how much of it is; undefined: it waits for something else. */
  | {
      readonly is: 'pending';
      readonly words: string | undefined;
      readonly share: number | undefined;
    }
  | { readonly is: 'done'; readonly found: Found }
  /** Ended by hand before there was a result. */
  | { readonly is: 'stopped' }
  | { readonly is: 'failed'; readonly error: unknown };

export interface ResourceEvents<Found> {
  /** Computes it; `watch` is called when each step begins. */
  find(watch: Watch): Promise<Found>;
  changed(status: Status<Found>): void;
}

export class Resource<Found> {
  #key: Key | undefined;
  #status: Status<Found> = { is: 'unwanted' };
  #running: AbortController | undefined;
  readonly #events: ResourceEvents<Found>;

  constructor(events: ResourceEvents<Found>) {
    this.#events = events;
  }

  get status(): Status<Found> {
    return this.#status;
  }

  /** The result for the wanted key; undefined where it is not there. */
  get found(): Found | undefined {
    return this.#status.is === 'done' ? this.#status.found : undefined;
  }

  /** Whether the result for a key is there or under way. */
  isFor(key: Key): boolean {
    const isSame = this.#key?.every((part, i) => part === key[i]) ?? false;
    return isSame && (this.#status.is === 'done' || this.#status.is === 'pending');
  }

  /** Asks for the result of a key, unless that is there or under way. Work for another key ends. */
  want(key: Key): void {
    if (this.isFor(key)) return;
    this.drop();
    this.#key = key;
    void this.#run();
  }

  /** Forgets the result, and ends the work for it. */
  drop(): void {
    this.#running?.abort();
    this.#running = undefined;
    this.#key = undefined;
    if (this.#status.is !== 'unwanted') this.#set({ is: 'unwanted' });
  }

  /** Ends the work by hand. */
  stop(): void {
    this.#running?.abort();
  }

  async #run(): Promise<void> {
    const running = new AbortController();
    this.#running = running;
    const { signal } = running;
    const say = (words: string, share?: number): void => {
      if (this.#running === running && !signal.aborted) this.#set({ is: 'pending', words, share });
    };
    const watch: Watch = (words) => {
      say(words);
      return { signal, onProgress: (share) => say(words, share) };
    };
    this.#set({ is: 'pending', words: undefined, share: undefined });
    let end: Status<Found>;
    try {
      end = { is: 'done', found: await this.#events.find(watch) };
    } catch (error) {
      end = signal.aborted ? { is: 'stopped' } : { is: 'failed', error };
    }
    if (this.#running !== running) return;
    this.#running = undefined;
    this.#set(end);
  }

  #set(status: Status<Found>): void {
    this.#status = status;
    this.#events.changed(status);
  }
}
