// The distances between models as a heat map.

import { colourAt, make } from '../src/element/index.js';

/** Short and of equal width: '0.0123'. */
export function distanceWords(distance: number | undefined): string {
  if (distance === undefined) return '…';
  return Number.isFinite(distance) ? distance.toFixed(4) : '–';
}

export class DistanceMatrix {
  readonly element = make('table', { class: 'matrix' });

  constructor(private readonly choose: (row: number, column: number) => void) {}

  /** `distances[i][j]`: undefined while it is not computed, NaN where there is none. */
  show(
    names: readonly string[],
    distances: readonly (readonly (number | undefined)[])[],
    query: number,
  ): void {
    const known = distances.flat().filter((one) => one !== undefined && Number.isFinite(one));
    const highest = Math.max(...(known as number[]), Number.MIN_VALUE);
    const head = names.map((name, i) => make('th', { scope: 'col', title: name }, String(i + 1)));
    const rows = names.map((name, i) => {
      const cells = names.map((other, j) => {
        const distance = distances[i]?.[j];
        const words = `${name} and ${other}: ${distanceWords(distance)}`;
        const button = make('button', { type: 'button', title: words, 'aria-label': words });
        if (distance !== undefined && Number.isFinite(distance)) {
          button.style.background = colourAt('viridis', distance / highest);
        }
        button.addEventListener('click', () => this.choose(i, j));
        return make('td', {}, button);
      });
      const header = make('th', { scope: 'row', title: name }, String(i + 1));
      const row = make('tr', {}, header, ...cells);
      row.classList.toggle('query', i === query);
      return row;
    });
    this.element.replaceChildren(
      make('caption', {}, 'Distances, dark: alike'),
      make('thead', {}, make('tr', {}, make('td'), ...head)),
      make('tbody', {}, ...rows),
    );
  }
}
