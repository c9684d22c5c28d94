// How much of the surface is of which kind, as one bar and in words.

import { type Category, make } from '../../../src/element/index.js';

export class CategoryShares {
  readonly element = make('div', { class: 'shares' });
  readonly #bar = make('div', { class: 'bar', 'aria-hidden': 'true' });
  readonly #list = make('ul');

  constructor() {
    this.element.append(this.#bar, this.#list);
  }

  /** Nothing is to be said. */
  clear(): void {
    this.#bar.replaceChildren();
    this.#list.replaceChildren();
  }

  /** `kinds`: for each vertex the number of its category; empty while it is not known. */
  show(
    categories: readonly Category[],
    kinds: ArrayLike<number>,
    areas: ArrayLike<number> | undefined,
  ): void {
    const sums = categories.map(() => 0);
    let whole = 0;
    for (let vertex = 0; vertex < kinds.length; ++vertex) {
      const area = areas ? areas[vertex]! : 1;
      sums[kinds[vertex]!]! += area;
      whole += area;
    }
    const shown = categories
      .map(({ name, colour }, i) => ({ name, colour, share: whole > 0 ? sums[i]! / whole : 0 }))
      .filter(({ share }) => share > 0);
    const swatch = (colour: string): HTMLElement => {
      const element = make('em', { class: 'swatch' });
      element.style.background = colour;
      return element;
    };
    this.#bar.replaceChildren(
      ...shown.map(({ colour, share }) => {
        const piece = make('span');
        piece.style.background = colour;
        piece.style.flexGrow = String(share);
        return piece;
      }),
    );
    this.#list.replaceChildren(
      ...shown.map(({ name, colour, share }) => {
        const percent = share < 0.001 ? '<\u202f0.1' : (100 * share).toFixed(1);
        return make('li', {}, swatch(colour), name, make('b', {}, `${percent}\u202f%`));
      }),
    );
    if (shown.length === 0) this.#list.append(make('li', { class: 'hint' }, 'not computed yet'));
  }
}
