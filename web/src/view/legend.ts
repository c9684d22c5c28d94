// The legend of a field: the colour map with numbers and the unit, or the categories with their names.

import type { Category } from './categories.js';
import type { ColormapName } from './colormap-names.js';
import { colormapStops, colourAt } from './colormaps.js';
import { type LengthFormat, formatNumber, placeIn, roundTicks } from './numbers.js';
import { logTicks } from './plots/density.js';

/** The legend of a field of numbers. */
export interface ScaleContent {
  title: string;
  colormap: ColormapName;
  /** The values at the ends of the colour map. */
  range: readonly [number, number];
  /** The field's smallest and largest value: the ends show it where there is more beyond. */
  extent: readonly [number, number];
  format: LengthFormat;
  /** Whether equal factors are equally far apart. */
  log: boolean;
  /** Lines of equal value, evenly spaced between the ends. */
  isolines: number;
  /** A further remark, for example what grey means; '' for none. */
  note: string;
  /** A remark on values beyond the ends, where these were chosen to follow the body of the values. */
  beyond: string | undefined;
}

/** The legend of a field of categories. */
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

/** Angles that mean something: of an equilateral triangle, and of a loop that passes straight through its base. */
const angleTicks = [60, 120, 180];

/** Round values between two ends, ascending. */
function innerValues({ range: [low, high], format, log }: ScaleContent): number[] {
  if (format.unit === '°') return angleTicks.map((angle) => angle / format.scale);
  const { scale } = format;
  const ends = [low * scale, high * scale] as const;
  const ticks = log
    ? logTicks({ low: ends[0], high: ends[1], log: true }, 4)
    : roundTicks(low, high, 4);
  return log ? ticks.map((tick) => tick / scale) : ticks;
}

/** The numbers beside a colour map, the highest first. */
export function ticksOf(content: ScaleContent): Tick[] {
  const { range, extent, format, log } = content;
  const [low, high] = range;
  const beyond = (sign: string, more: boolean): string => (more ? `${sign}\u2009` : '');
  const inner = innerValues(content)
    .map((value) => ({ value, place: placeIn(range, log, value) }))
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
  readonly #beyond = document.createElement('p');
  readonly #beyondWords = document.createElement('span');
  #shown = '';

  /** `showAll`: the whole range is asked for. */
  constructor(showAll: () => void) {
    this.element.className = 'legend';
    this.element.hidden = true;
    this.#title.className = 'legend-title';
    this.#bar.className = 'legend-bar';
    this.#key.className = 'legend-key';
    this.#note.className = 'legend-note';
    this.#beyond.className = 'legend-beyond';
    const all = document.createElement('button');
    all.type = 'button';
    all.textContent = 'Full range';
    all.addEventListener('click', showAll);
    this.#beyond.append(this.#beyondWords, ' ', all);
    this.element.append(this.#title, this.#bar, this.#key, this.#note, this.#beyond);
  }

  /** All that it lies on: the numbers stand beside the box of the element. */
  get pieces(): Element[] {
    return [this.element, ...this.#bar.children];
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
    const beyond = isScale ? content.beyond : undefined;
    this.#beyondWords.textContent = beyond ?? '';
    this.#beyond.hidden = beyond === undefined;
    this.#bar.hidden = !isScale;
    this.#key.hidden = isScale;
    if (isScale) this.#showScale(content);
    else this.#key.replaceChildren(...content.categories.map(keyEntry));
  }

  #showScale(content: ScaleContent): void {
    this.#bar.style.setProperty('--colours', colormapStops(content.colormap));
    this.#bar.style.setProperty('--top', colourAt(content.colormap, 1));
    this.#bar.style.setProperty('--bottom', colourAt(content.colormap, 0));
    const { range, extent } = content;
    this.#bar.classList.toggle('more-above', extent[1] > range[1]);
    this.#bar.classList.toggle('more-below', extent[0] < range[0]);
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
