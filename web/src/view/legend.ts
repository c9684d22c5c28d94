// The legend of a field: the colour map with numbers and the unit, or the categories with their names.

import type { Category } from './categories.js';
import { type ColormapName, colormapStops } from './colormaps.js';
import { type LengthFormat, formatNumber, roundTicks } from './numbers.js';

/** Of a field of numbers. */
export interface ScaleContent {
  title: string;
  colormap: ColormapName;
  /** The values at the ends of the colour map. */
  range: readonly [number, number];
  /** The field's smallest and largest value: the ends say so where there is more beyond. */
  extent: readonly [number, number];
  format: LengthFormat;
  /** Lines of equal value, evenly spaced between the ends. */
  isolines: number;
  /** What else there is to say, for example what grey means; '' for nothing. */
  note: string;
}

/** Of a field of categories. */
export interface KeyContent {
  title: string;
  categories: readonly Category[];
  note: string;
}

export type LegendContent = ScaleContent | KeyContent;

/** A number beside the bar. */
export interface Tick {
  /** Share of the bar's length below it. */
  place: number;
  text: string;
  /** Not one of the two ends. */
  inner: boolean;
}

/** Share of the bar next to each end that is kept free of inner ticks. */
const endZone = 0.1;

/** The legend's heading: what it is, and in which unit. */
export function headingOf(content: LegendContent): string {
  const unit = 'format' in content ? content.format.unit : '';
  return unit ? `${content.title}, ${unit}` : content.title;
}

/** The numbers beside a colour map, the highest first. */
export function ticksOf({ range: [low, high], extent, format }: ScaleContent): Tick[] {
  const beyond = (sign: string, more: boolean): string => (more ? `${sign}\u2009` : '');
  const inner = roundTicks(low, high, 4)
    .map((value) => ({ value, place: (value - low) / (high - low) }))
    .filter(({ place }) => place > endZone && place < 1 - endZone)
    .map(({ value, place }) => ({ place, text: formatNumber(value, format), inner: true }));
  const atEnd = (place: number, text: string): Tick => ({ place, text, inner: false });
  return [
    atEnd(1, beyond('≥', extent[1] > high) + formatNumber(high, format)),
    ...inner.reverse(),
    atEnd(0, beyond('≤', extent[0] < low) + formatNumber(low, format)),
  ];
}

/** Where lines of equal value lie on the bar, as shares of its length. */
export function linePlaces(isolines: number): number[] {
  return Array.from({ length: isolines }, (_, i) => (i + 1) / (isolines + 1));
}

export class Legend {
  readonly element = document.createElement('figure');
  readonly #title = document.createElement('figcaption');
  readonly #bar = document.createElement('div');
  readonly #key = document.createElement('ul');
  readonly #note = document.createElement('p');
  #shown = '';

  constructor() {
    this.element.className = 'legend';
    this.element.hidden = true;
    this.#title.className = 'legend-title';
    this.#bar.className = 'legend-bar';
    this.#key.className = 'legend-key';
    this.#note.className = 'legend-note';
    this.element.append(this.#title, this.#bar, this.#key, this.#note);
  }

  update(content: LegendContent | undefined): void {
    this.element.hidden = !content;
    const key = JSON.stringify(content);
    if (!content || key === this.#shown) return;
    this.#shown = key;
    this.#title.textContent = headingOf(content);
    this.#note.textContent = content.note;
    this.#note.hidden = content.note === '';
    const isScale = 'range' in content;
    this.#bar.hidden = !isScale;
    this.#key.hidden = isScale;
    if (isScale) this.#showScale(content);
    else this.#key.replaceChildren(...content.categories.map(keyEntry));
  }

  #showScale(content: ScaleContent): void {
    this.#bar.style.setProperty('--colours', colormapStops(content.colormap));
    const lines = linePlaces(content.isolines).map((place) => at(place, 'legend-line', ''));
    const ticks = ticksOf(content).map(({ place, text, inner }) =>
      at(place, inner ? 'legend-tick inner' : 'legend-tick', text),
    );
    this.#bar.replaceChildren(...ticks, ...lines);
  }
}

function at(place: number, className: string, text: string): HTMLElement {
  const element = document.createElement('span');
  element.className = className;
  element.style.setProperty('--place', place.toFixed(4));
  element.textContent = text;
  return element;
}

function keyEntry({ name, colour, hatched }: Category): HTMLElement {
  const entry = document.createElement('li');
  const swatch = document.createElement('i');
  swatch.style.setProperty('--colour', colour);
  swatch.classList.toggle('hatched', hatched);
  entry.append(swatch, name);
  return entry;
}
