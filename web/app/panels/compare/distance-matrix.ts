// The distances between models as a table of numbers and colours: one grid, through which arrow keys go.

import { make } from '../../../src/element/index.js';
import { colourAt } from '../../../src/element/plots.js';

/** Short and of equal width: '0.0123'. */
export function distanceWords(distance: number | undefined): string {
  if (distance === undefined) return '…';
  return Number.isFinite(distance) ? distance.toFixed(4) : '–';
}

/** Shares of the greatest distance above which a cell is light, and its number dark: a contrast of 4.5 or more. */
const lightFrom = 0.44;

export class DistanceMatrix {
  readonly element = make('div');
  readonly #words = make(
    'p',
    { class: 'hint matrix-words', id: 'matrix-words' },
    'Distances between models, by their numbers in the list; dark: similar',
  );
  readonly #table = make('table', {
    class: 'matrix',
    role: 'grid',
    'aria-labelledby': 'matrix-words',
  });
  readonly #box = make('div', { class: 'matrix-box' }, this.#table);
  readonly #choose: (row: number, column: number) => void;
  /** The models of the present table: while they stay, so do its cells. */
  #names = '';
  #rows: { row: HTMLElement; buttons: HTMLButtonElement[] }[] = [];
  /** The one cell that the tab key reaches. */
  #current: readonly [number, number] = [0, 0];

  constructor(choose: (row: number, column: number) => void) {
    this.#choose = choose;
    this.element.append(this.#words, this.#box);
    this.#table.addEventListener('keydown', (event) => this.#key(event));
    this.#box.addEventListener('scroll', () => this.#showMore(), { passive: true });
    new ResizeObserver(() => this.#showMore()).observe(this.#box);
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
        const number = i === j ? '0' : distanceWords(distance);
        const words = `${names[i]} and ${names[j]}: distance ${number}`;
        button.title = words;
        button.setAttribute('aria-label', words);
        button.textContent = number;
        const isKnown = distance !== undefined && Number.isFinite(distance);
        const share = isKnown ? distance / highest : 0;
        button.style.background = isKnown ? colourAt('viridis', share) : '';
        button.style.color = !isKnown ? '' : share > lightFrom ? '#000000' : '#ffffff';
      });
    });
  }

  #build(names: readonly string[]): void {
    this.#names = JSON.stringify(names);
    this.#rows = names.map((name, i) => {
      const buttons = names.map((_, j) => {
        const button = make('button', { type: 'button', tabindex: '-1' });
        button.addEventListener('click', () => {
          this.#goTo(i, j);
          this.#choose(i, j);
        });
        return button;
      });
      const header = make('th', { scope: 'row', title: name }, String(i + 1));
      const cells = buttons.map((button) => make('td', { role: 'gridcell' }, button));
      return { row: make('tr', {}, header, ...cells), buttons };
    });
    const head = names.map((name, i) => make('th', { scope: 'col', title: name }, String(i + 1)));
    this.#table.replaceChildren(
      make('thead', {}, make('tr', {}, make('td'), ...head)),
      make('tbody', {}, ...this.#rows.map(({ row }) => row)),
    );
    this.#goTo(...this.#current);
    this.#showMore();
  }

  /** Says by its looks whether there is more to the right. */
  #showMore(): void {
    const { scrollLeft, clientWidth, scrollWidth } = this.#box;
    this.#box.classList.toggle('more', scrollLeft + clientWidth < scrollWidth - 1);
  }

  /** Moves the grid's one tab stop to a cell, or to the nearest there is. */
  #goTo(row: number, column: number): HTMLButtonElement | undefined {
    const last = this.#rows.length - 1;
    const [i, j] = [row, column].map((at) => Math.max(0, Math.min(last, at))) as [number, number];
    const cell = (at: readonly [number, number]) => this.#rows[at[0]]?.buttons[at[1]];
    cell(this.#current)?.setAttribute('tabindex', '-1');
    this.#current = [i, j];
    const now = cell(this.#current);
    now?.setAttribute('tabindex', '0');
    return now;
  }

  #key(event: KeyboardEvent): void {
    const [i, j] = this.#current;
    const last = this.#rows.length - 1;
    const goals: Record<string, readonly [number, number]> = {
      ArrowLeft: [i, j - 1],
      ArrowRight: [i, j + 1],
      ArrowUp: [i - 1, j],
      ArrowDown: [i + 1, j],
      Home: event.ctrlKey ? [0, 0] : [i, 0],
      End: event.ctrlKey ? [last, last] : [i, last],
    };
    const goal = goals[event.key];
    if (!goal) return;
    event.preventDefault();
    this.#goTo(...goal)?.focus();
  }
}
