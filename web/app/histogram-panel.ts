// The field's distribution, and the range that the colour map spans.

import {
  type ColormapName,
  type GirthViewer,
  colourAt,
  extent,
  formatLength,
  histogram,
  make,
  median,
} from '../src/element/index.js';

const bins = 48;
const steps = 1000;
/** Milliseconds between two pictures while values arrive. */
const interval = 200;
const svgNamespace = 'http://www.w3.org/2000/svg';

export class HistogramPanel {
  private readonly plot = document.createElementNS(svgNamespace, 'svg');
  private readonly bars: SVGRectElement[] = [];
  private readonly sliders = make('div', { class: 'sliders' });
  private readonly low = slider('Lower end of the colour map', 0);
  private readonly high = slider('Upper end of the colour map', steps);
  private readonly lowText = make('output', { id: 'range-low' });
  private readonly highText = make('output', { id: 'range-high' });
  private readonly reset = make('button', { type: 'button' }, 'Full range');
  private readonly median = make('p', { class: 'median' });
  private reach: [number, number] | undefined;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    host: HTMLElement,
    private readonly viewer: GirthViewer,
  ) {
    this.plot.setAttribute('viewBox', `0 0 ${bins} 100`);
    this.plot.setAttribute('preserveAspectRatio', 'none');
    this.plot.setAttribute('role', 'img');
    for (let i = 0; i < bins; ++i) {
      const bar = document.createElementNS(svgNamespace, 'rect');
      bar.setAttribute('x', String(i + 0.06));
      bar.setAttribute('width', '0.88');
      this.bars.push(bar);
    }
    this.plot.append(...this.bars);
    this.sliders.append(this.low, this.high);
    const ends = make('div', { class: 'ends' }, this.lowText, this.reset, this.highText);
    host.append(this.plot, this.sliders, ends, this.median);
    for (const one of [this.low, this.high]) {
      one.addEventListener('input', () => this.brush(one));
    }
    this.reset.addEventListener('click', () => this.setRange(0, steps));
    this.clear();
  }

  /** An empty plot and the full range, for a new model. */
  clear(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.reach = undefined;
    this.setRange(0, steps);
    this.refresh();
  }

  /** Draws again before long, but not at every one of many calls. */
  refreshSoon(): void {
    this.timer ??= setTimeout(() => this.refresh(), interval);
  }

  refresh(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    const values = this.viewer.info ? this.viewer.values('igf') : [];
    this.reach = extent(values);
    this.low.disabled = this.high.disabled = !this.reach;
    if (!this.reach) {
      for (const bar of this.bars) bar.setAttribute('height', '0');
      this.plot.setAttribute('aria-label', 'No values yet');
      this.lowText.textContent = this.highText.textContent = '–';
      this.median.textContent = '';
      return;
    }
    // Values that are the same but for rounding are one bar, in the middle.
    const [low, high] = this.reach;
    const least = 1e-6 * Math.abs(high);
    const widen = high - low < least ? least : 0;
    const { counts, peak } = histogram(values, bins, [low - widen, high + widen]);
    counts.forEach((count, i) => {
      // Square root: a bin with few values among thousands can still be seen.
      const height = 100 * Math.sqrt(count / peak);
      this.bars[i]!.setAttribute('y', (100 - height).toFixed(2));
      this.bars[i]!.setAttribute('height', height.toFixed(2));
    });
    const { lengthFormat } = this.viewer;
    const words = [...this.reach, median(values)].map((value) => formatLength(value, lengthFormat));
    this.median.textContent = `median ${words[2]}`;
    this.plot.setAttribute(
      'aria-label',
      `Distribution of the girth from ${words[0]} to ${words[1]}, median ${words[2]}`,
    );
    this.paint();
  }

  private brush(moved: HTMLInputElement): void {
    const gap = steps / 50;
    let [low, high] = [Number(this.low.value), Number(this.high.value)];
    if (moved === this.low) low = Math.min(low, high - gap);
    else high = Math.max(high, low + gap);
    this.setRange(low, high);
  }

  private setRange(low: number, high: number): void {
    this.low.value = String(low);
    this.high.value = String(high);
    const full = low <= 0 && high >= steps;
    this.reset.style.visibility = full ? 'hidden' : 'visible';
    this.sliders.style.setProperty('--low', String(low / steps));
    this.sliders.style.setProperty('--high', String(high / steps));
    if (full || !this.reach) this.viewer.removeAttribute('range');
    else this.viewer.setAttribute('range', `${this.valueAt(low)} ${this.valueAt(high)}`);
    this.paint();
  }

  private valueAt(step: number): number {
    const [low, high] = this.reach!;
    return low + ((high - low) * step) / steps;
  }

  /** Colours and the numbers at the ends. */
  private paint(): void {
    if (!this.reach) return;
    const [low, high] = [Number(this.low.value), Number(this.high.value)];
    const colormap = (this.viewer.getAttribute('colormap') ?? 'viridis') as ColormapName;
    this.bars.forEach((bar, i) => {
      const step = ((i + 0.5) / bins) * steps;
      bar.setAttribute('fill', colourAt(colormap, (step - low) / (high - low)));
      bar.setAttribute('opacity', step < low || step > high ? '0.35' : '1');
    });
    const { lengthFormat } = this.viewer;
    this.lowText.textContent = formatLength(this.valueAt(low), lengthFormat);
    this.highText.textContent = formatLength(this.valueAt(high), lengthFormat);
    this.low.setAttribute('aria-valuetext', this.lowText.textContent);
    this.high.setAttribute('aria-valuetext', this.highText.textContent);
  }
}

function slider(label: string, value: number): HTMLInputElement {
  return make('input', {
    type: 'range',
    min: '0',
    max: String(steps),
    value: String(value),
    'aria-label': label,
  });
}
