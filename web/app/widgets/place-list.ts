// A list of places on the surface; choosing one takes the camera there.

import { announce } from './announcer.js';
import { formatCount, make } from '../../src/element/index.js';

export interface PlaceRow {
  /** The words in front; by default the row's number in the list. */
  lead?: string;
  /** The colour of a small square in front, where rows are of several kinds. */
  colour?: string;
  /** The line that a row stands for: lengths of strokes and gaps, by turns; empty: one stroke. */
  dash?: readonly number[];
  /** The main measure, with its unit. */
  main: string;
  detail: string;
  /** Shown at the row's end. */
  picture?: HTMLElement | undefined;
  choose(): void;
  /** The row is pointed at or has the focus, or no longer. */
  attend?(isAttended: boolean): void;
}

/** More rows than these are only counted. */
const mostRows = 100;

export class PlaceList {
  readonly element = make('ol', { class: 'places' });
  readonly #lines: Line[] = [];
  readonly #more = make('li', { class: 'hint' });

  constructor(label: string) {
    this.element.setAttribute('aria-label', label);
  }

  /** Rows that are there already stay the same elements: a press that has begun on one ends on it. */
  show(rows: readonly PlaceRow[]): void {
    const shown = rows.slice(0, mostRows);
    for (const line of this.#lines.splice(shown.length)) line.element.remove();
    shown.forEach((row, i) => {
      let line = this.#lines[i];
      if (!line) {
        line = new Line(() => this.select(i));
        this.#lines.push(line);
        this.element.append(line.element);
      }
      line.show(row, String(i + 1));
    });
    const more = rows.length - shown.length;
    this.#more.textContent = `and ${formatCount(more)} more`;
    if (more > 0) this.element.append(this.#more);
    else this.#more.remove();
    this.element.hidden = rows.length === 0;
  }

  /** Marks a row as the chosen one; undefined for none. */
  select(chosen: number | undefined): void {
    this.#lines.forEach((line, i) => line.select(i === chosen));
  }
}

/** One row, whose content comes and goes. */
class Line {
  readonly element: HTMLElement;
  readonly #lead = make('i');
  readonly #main = make('b');
  readonly #detail = make('span');
  readonly #button = make(
    'button',
    { type: 'button', 'aria-pressed': 'false' },
    this.#lead,
    make('span', { class: 'words' }, this.#main, ' ', this.#detail),
  );
  readonly #swatch = make('em', { class: 'swatch' });
  #picture: HTMLElement | undefined;
  #row: PlaceRow | undefined;

  constructor(chosen: () => void) {
    this.element = make('li', {}, this.#button);
    this.#button.addEventListener('click', () => {
      chosen();
      this.#row?.choose();
      announce(`Shown: ${this.#main.textContent}, ${this.#detail.textContent}`);
    });
    for (const [event, isAttended] of [
      ['pointerenter', true],
      ['pointerleave', false],
      ['focus', true],
      ['blur', false],
    ] as const) {
      this.#button.addEventListener(event, () => this.#row?.attend?.(isAttended));
    }
  }

  show(row: PlaceRow, number: string): void {
    this.#row = row;
    this.#lead.textContent = row.lead ?? number;
    this.#main.textContent = row.main;
    this.#detail.textContent = row.detail;
    if (row.colour === undefined) this.#swatch.remove();
    else {
      this.#swatch.classList.toggle('line', row.dash !== undefined);
      this.#swatch.style.background = row.dash ? dashed(row.colour, row.dash) : row.colour;
      this.#button.prepend(this.#swatch);
    }
    if (row.picture === this.#picture) return;
    this.#picture?.remove();
    this.#picture = row.picture;
    if (row.picture) this.#button.append(row.picture);
  }

  select(isChosen: boolean): void {
    this.#button.setAttribute('aria-pressed', String(isChosen));
  }
}

/** A line of strokes as a background. */
function dashed(colour: string, dash: readonly number[]): string {
  if (dash.length === 0) return colour;
  let at = 0;
  const stops = dash.map((length, i) => {
    const from = at;
    at += length;
    return `${i % 2 === 0 ? colour : 'transparent'} ${from}px ${at}px`;
  });
  return `repeating-linear-gradient(90deg, ${stops.join(', ')})`;
}
