// A panel's search, once the girth is there where it needs that: its progress in words, to be stopped and started again.

import { type GirthViewer, make } from '../../src/element/index.js';
import { type Key, Resource, type Status, type Watch } from '../results/resource.js';
import { failureWords } from './failure-words.js';

export interface Searched<Found> {
  /** The words on the button that starts the search again. */
  again: string;
  /** The words as long as the girth is not there. */
  pending: string;
  /** Whether the search needs the girth. Default: true. */
  needsGirth?: boolean;
  /** The parameters of the search, beside the surface. */
  parameters(): Key;
  /** The words after it was stopped. */
  stopped: string;
  /** The words before the reason why the search failed. */
  failed: string;
  search(watch: Watch): Promise<Found>;
  /** Takes the result; the words that are returned are shown. */
  found(found: Found): string;
}

export class PanelSearch<Found> {
  readonly element: HTMLElement;
  readonly #words = make('span', { class: 'hint', role: 'status' });
  readonly #cancel = make('button', { type: 'button', class: 'plain', hidden: '' }, 'Cancel');
  readonly #again: HTMLButtonElement;
  readonly #resource: Resource<Found>;
  readonly #viewer: GirthViewer;
  readonly #searched: Searched<Found>;

  constructor(viewer: GirthViewer, searched: Searched<Found>) {
    this.#viewer = viewer;
    this.#searched = searched;
    this.#again = make('button', { type: 'button', class: 'plain', hidden: '' }, searched.again);
    this.#cancel.addEventListener('click', () => this.#resource.stop());
    this.#again.addEventListener('click', () => this.start());
    this.#resource = new Resource<Found>({
      find: (watch) => this.#find(watch),
      changed: (status) => this.#show(status),
    });
    this.element = make('p', { class: 'working' }, this.#words, this.#cancel, this.#again);
  }

  /** The result for the present key. */
  get found(): Found | undefined {
    return this.#resource.found;
  }

  /** Whether the result for the present key is there, or under way. */
  get isCurrent(): boolean {
    return this.#resource.isFor(this.#key);
  }

  say(words: string): void {
    this.#words.textContent = words;
  }

  /** Forgets the result: it is of another model, or of another question. */
  clear(): void {
    this.#resource.drop();
    this.#show({ is: 'unwanted' });
  }

  /** Searches unless that is done or under way; where it needs the girth, once that is there. */
  start(): void {
    if (this.#viewer.info) this.#resource.want(this.#key);
  }

  get #key(): Key {
    return [this.#viewer.info, ...this.#searched.parameters()];
  }

  async #find(watch: Watch): Promise<Found> {
    if (this.#searched.needsGirth !== false) await this.#viewer.fieldOf('igf');
    return this.#searched.search(watch);
  }

  #show(status: Status<Found>): void {
    const searched = this.#searched;
    this.#again.hidden = status.is !== 'stopped' && status.is !== 'failed';
    this.#cancel.hidden = status.is !== 'pending' || status.words === undefined;
    this.say(wordsOf(status, searched, this.#viewer));
  }
}

function wordsOf<Found>(
  status: Status<Found>,
  searched: Searched<Found>,
  viewer: GirthViewer,
): string {
  switch (status.is) {
    case 'unwanted':
      return '';
    case 'pending': {
      const { words, share } = status;
      if (words === undefined) return viewer.shareOf('igf') < 1 ? searched.pending : '';
      return `${words} …${share === undefined ? '' : ` ${Math.round(100 * share)}\u202f%`}`;
    }
    case 'done':
      return searched.found(status.found);
    case 'stopped':
      return searched.stopped;
    case 'failed':
      return `${searched.failed}${failureWords(status.error)}.`;
  }
}
