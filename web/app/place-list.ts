// A list of places on the surface; choosing one takes the camera there.

import { formatCount, make } from '../src/element/index.js';

export interface PlaceRow {
  /** Before the number; by default the row's number in the list. */
  lead?: string;
  /** The colour of a small square in front, where rows are of several kinds. */
  colour?: string;
  /** What matters most, with its unit. */
  main: string;
  detail: string;
  /** Shown at the row's end. */
  picture?: HTMLElement | undefined;
  choose(): void;
}

/** More rows than these are only counted. */
const mostRows = 100;

export class PlaceList {
  readonly element = make('ol', { class: 'places' });
  private readonly buttons: HTMLButtonElement[] = [];

  constructor(label: string) {
    this.element.setAttribute('aria-label', label);
  }

  show(rows: readonly PlaceRow[]): void {
    this.buttons.length = 0;
    const items = rows.slice(0, mostRows).map((row, i) => {
      const button = make(
        'button',
        { type: 'button', 'aria-pressed': 'false' },
        make('i', {}, row.lead ?? String(i + 1)),
        make(
          'span',
          { class: 'words' },
          make('b', {}, row.main),
          ' ',
          make('span', {}, row.detail),
        ),
      );
      if (row.colour !== undefined) {
        const swatch = make('em', { class: 'swatch' });
        swatch.style.background = row.colour;
        button.prepend(swatch);
      }
      if (row.picture) button.append(row.picture);
      button.addEventListener('click', () => {
        this.select(i);
        row.choose();
      });
      this.buttons.push(button);
      return make('li', {}, button);
    });
    const more = rows.length - items.length;
    if (more > 0) items.push(make('li', { class: 'hint' }, `and ${formatCount(more)} more`));
    this.element.replaceChildren(...items);
    this.element.hidden = rows.length === 0;
  }

  /** Marks a row as the chosen one; undefined for none. */
  select(chosen: number | undefined): void {
    this.buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(i === chosen)));
  }
}
