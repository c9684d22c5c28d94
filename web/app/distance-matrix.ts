// The distances between models as a heat map.

import { colourAt, make } from '../src/element/index.js';

/** Short and of equal width: '0.0123'. */
export function distanceWords(distance: number | undefined): string {
  if (distance === undefined) return '…';
  return Number.isFinite(distance) ? distance.toFixed(4) : '–';
}

export class DistanceMatrix {
  readonly element = make('table', { class: 'matrix' });
  readonly #choose: (row: number, column: number) => void;
  /** The models of the present table: while they stay, so do its cells. */
  #names = '';
  #rows: { row: HTMLElement; buttons: HTMLButtonElement[] }[] = [];

  constructor(choose: (row: number, column: number) => void) {
    this.#choose = choose;
  }

  /** `distances[i][j]`: undefined while it is not computed, NaN where there is none. */
  show(
    names: readonly string[],
    distances: readonly (readonly (number | undefined)[])[],
    query: number,
  ): void {
    if (JSON.stringify(names) !== this.#names) this.#build(names);
    const known = distances.flat().filter((one) => one !== undefined && Number.isFinite(one));
    const highest = Math.max(...(known as number[]), Number.MIN_VALUE);
    this.#rows.forEach(({ row, buttons }, i) => {
      row.classList.toggle('query', i === query);
      buttons.forEach((button, j) => {
        const distance = distances[i]?.[j];
        const words = `${names[i]} and ${names[j]}: distance ${distanceWords(distance)}`;
        button.title = words;
        button.setAttribute('aria-label', words);
        const isKnown = distance !== undefined && Number.isFinite(distance);
        button.style.background = isKnown ? colourAt('viridis', distance / highest) : '';
      });
    });
  }

  #build(names: readonly string[]): void {
    this.#names = JSON.stringify(names);
    this.#rows = names.map((name, i) => {
      const buttons = names.map((_, j) => {
        const button = make('button', { type: 'button' });
        button.addEventListener('click', () => this.#choose(i, j));
        return button;
      });
      const header = make('th', { scope: 'row', title: name }, String(i + 1));
      const cells = buttons.map((button) => make('td', {}, button));
      return { row: make('tr', {}, header, ...cells), buttons };
    });
    const head = names.map((name, i) => make('th', { scope: 'col', title: name }, String(i + 1)));
    this.element.replaceChildren(
      make('caption', {}, 'Distances between models; dark: similar'),
      make('thead', {}, make('tr', {}, make('td'), ...head)),
      make('tbody', {}, ...this.#rows.map(({ row }) => row)),
    );
  }
}
