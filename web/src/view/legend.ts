// The legend of a scalar field: the colour map with numbers and the unit.

import { type ColormapName, colormapStops } from './colormaps.js';
import { type LengthFormat, formatNumber, roundTicks } from './numbers.js';

export interface LegendContent {
  title: string;
  colormap: ColormapName;
  /** The values at the ends of the colour map. */
  range: readonly [number, number];
  /** The field's smallest and largest value: the ends say so where there is more beyond. */
  extent: readonly [number, number];
  format: LengthFormat;
}

/** Share of the bar next to each end that is kept free of inner ticks. */
const endZone = 0.1;

export class Legend {
  readonly element = document.createElement('figure');
  private readonly title = document.createElement('figcaption');
  private readonly bar = document.createElement('div');
  private shown = '';

  constructor() {
    this.element.className = 'legend';
    this.element.hidden = true;
    this.title.className = 'legend-title';
    this.bar.className = 'legend-bar';
    this.element.append(this.title, this.bar);
  }

  update(content: LegendContent | undefined): void {
    this.element.hidden = !content;
    const key = JSON.stringify(content);
    if (!content || key === this.shown) return;
    this.shown = key;
    const { title, colormap, range, extent, format } = content;
    this.title.textContent = format.unit ? `${title}, ${format.unit}` : title;
    this.bar.style.setProperty('--colours', colormapStops(colormap));
    const [low, high] = range;
    const inner = roundTicks(low, high, 4).filter((tick) => {
      const place = (tick - low) / (high - low);
      return place > endZone && place < 1 - endZone;
    });
    const beyond = (sign: string, more: boolean): string => (more ? `${sign}\u2009` : '');
    this.bar.replaceChildren(
      tickAt(1, beyond('≥', extent[1] > high) + formatNumber(high, format)),
      ...inner.reverse().map((value) => {
        const tick = tickAt((value - low) / (high - low), formatNumber(value, format));
        tick.classList.add('inner');
        return tick;
      }),
      tickAt(0, beyond('≤', extent[0] < low) + formatNumber(low, format)),
    );
  }
}

function tickAt(place: number, text: string): HTMLElement {
  const tick = document.createElement('span');
  tick.className = 'legend-tick';
  tick.style.setProperty('--place', place.toFixed(4));
  tick.textContent = text;
  return tick;
}
