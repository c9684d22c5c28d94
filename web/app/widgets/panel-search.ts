// What a panel searches for once the girth is there: its progress in words, to be stopped and started again.

import { type GirthViewer, make } from '../../src/element/index.js';
import type { WatchedOptions } from '../../src/kernel/index.js';
import { failureWords } from './failure-words.js';

/** Options of one step of a search: its progress is said behind these words. */
export type Watch = (words: string) => Required<WatchedOptions>;

export interface Searched<Found> {
  /** On the button that starts it again. */
  again: string;
  /** As long as the girth is not there. */
  pending: string;
  /** When it was stopped. */
  stopped: string;
  /** Before the reason why it failed. */
  failed: string;
  search(watch: Watch): Promise<Found>;
  /** It was found. What is returned is said. */
  found(found: Found): string;
}

export class PanelSearch<Found> {
  readonly element: HTMLElement;
  readonly #words = make('span', { class: 'hint', role: 'status' });
  readonly #cancel = make('button', { type: 'button', class: 'plain', hidden: '' }, 'Cancel');
  readonly #again: HTMLButtonElement;
  #found: Found | undefined;
  #running: AbortController | undefined;
  readonly #viewer: GirthViewer;
  readonly #searched: Searched<Found>;

  constructor(viewer: GirthViewer, searched: Searched<Found>) {
    this.#viewer = viewer;
    this.#searched = searched;
    this.#again = make('button', { type: 'button', class: 'plain', hidden: '' }, searched.again);
    this.#cancel.addEventListener('click', () => this.#running?.abort());
    this.#again.addEventListener('click', () => void this.start());
    this.element = make('p', { class: 'working' }, this.#words, this.#cancel, this.#again);
  }

  /** What was found of the present model. */
  get found(): Found | undefined {
    return this.#found;
  }

  say(words: string): void {
    this.#words.textContent = words;
  }

  /** Another model, or another question: what was found no longer counts. */
  clear(): void {
    this.#running?.abort();
    this.#running = undefined;
    this.#found = undefined;
    this.say('');
    this.#again.hidden = this.#cancel.hidden = true;
  }

  /** Searches as soon as the girth is there, unless that is done or under way. */
  async start(): Promise<void> {
    const [viewer, searched] = [this.#viewer, this.#searched];
    if (!viewer.info || this.#found !== undefined || this.#running) return;
    const running = new AbortController();
    this.#running = running;
    this.#again.hidden = true;
    const say = (words: string): void => {
      if (this.#running === running) this.say(words);
    };
    const watch: Watch = (words) => {
      say(`${words} …`);
      return {
        signal: running.signal,
        onProgress: (share) => say(`${words} … ${Math.round(100 * share)}\u202f%`),
      };
    };
    try {
      if (viewer.shareOf('igf') < 1) say(searched.pending);
      await viewer.fieldOf('igf');
      if (this.#running !== running) return;
      this.#cancel.hidden = false;
      const found = await searched.search(watch);
      if (this.#running !== running) return;
      this.#found = found;
      say(searched.found(found));
    } catch (error) {
      if (this.#running !== running) return;
      say(running.signal.aborted ? searched.stopped : `${searched.failed}${failureWords(error)}.`);
      this.#again.hidden = false;
    } finally {
      if (this.#running === running) {
        this.#running = undefined;
        this.#cancel.hidden = true;
      }
    }
  }
}
