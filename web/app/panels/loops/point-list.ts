// A list of pinned points to choose one from.

import { make } from '../../../src/element/index.js';
import { Draft } from '../../widgets/draft.js';

export interface NamedPoint {
  id: number;
  name: string;
}

export class PointList {
  readonly #select: HTMLSelectElement;
  readonly parts: HTMLElement[];
  readonly #draft: Draft;
  #known = '';
  #words = '';

  constructor(id: string, words: string, chosen: () => void) {
    this.#select = make('select', { id });
    this.parts = [make('label', { for: id }, words), this.#select];
    this.#draft = new Draft(this.#select, { committed: () => chosen() });
  }

  get chosen(): string {
    return this.#draft.text;
  }

  /** Keeps the choice as long as no point has come or gone; then `usual` is chosen. */
  show(points: readonly NamedPoint[], usual: number): void {
    const words = JSON.stringify(points);
    // Equal options, set again, would close a list that is open.
    if (words === this.#words) return;
    this.#words = words;
    const ids = points.map(({ id }) => id).join();
    const isAnother = ids !== this.#known;
    this.#known = ids;
    const before = this.chosen;
    this.#select.replaceChildren(
      ...points.map(({ id, name }) =>
        make('option', { value: String(id) }, name ? `${id} ${name}` : String(id)),
      ),
    );
    // The list itself forgets the choice with its options.
    this.#draft.show(isAnother ? String(usual) : before);
  }
}
