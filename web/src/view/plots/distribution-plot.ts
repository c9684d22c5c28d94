// A field's distribution over the surface, as a histogram or cumulative, of one model or of several
// over each other; a range of values can be marked on it with the mouse, a finger or the keyboard.

import { type Cumulative, type Weights, cumulative, histogram } from './distribution.js';
import { type ValueRange, dragged, movedByKey } from './brush-range.js';
import { PlotFrame, svgWidth } from './plot-frame.js';
import type { PlotPen } from './plot-svg.js';

/** Bars, or the cumulative distribution. */
export type DistributionKind = 'histogram' | 'cdf';

/** The values of one model. */
export interface DistributionSeries {
  /** The values; entries that are no numbers do not count. */
  values: ArrayLike<number>;
  /** How much each counts. */
  weights: Weights;
  /** A CSS colour, of the cumulative line. */
  colour: string;
  /** The pattern of the cumulative line: lengths of dashes and gaps, in CSS pixels; absent: a plain line. */
  dash?: number[] | undefined;
}

/** A colour, and whether it stands back. */
export interface BarColour {
  /** A CSS colour. */
  colour: string;
  /** Drawn fainter. */
  faint: boolean;
}

/** The content of a plot. */
export interface DistributionContent {
  /** In which form. */
  kind: DistributionKind;
  /** The first of them is the one that the histogram shows. */
  series: readonly DistributionSeries[];
  /** The values at the ends of the axis. */
  range: ValueRange;
  /** The colour of a bar by its value. */
  colourOf: (value: number) => BarColour;
  /** Writes a value. */
  format: (value: number) => string;
  /** Writes numbers at the axes; absent: there are none. */
  axes?: DistributionAxes | undefined;
}

/** The words at the axes. */
export interface DistributionAxes {
  /** The name of the values, with the unit. */
  label: string;
}

/** The words at an axis. */
export interface AxisWords extends DistributionAxes {
  /** Writes a value. */
  format: (value: number) => string;
}

/** The events of a plot. */
export interface DistributionEvents {
  /** A range was marked, or none any more; `settled` once the hand has let go. */
  brushed(range: [number, number] | undefined, settled: boolean): void;
}

export const histogramBins = 48;
const steps = 256;
/** A drag shorter than this is a click, CSS pixels. */
const leastDrag = 3;

/** A plot of how values are distributed. */
export class DistributionPlot {
  /** To be put into the page. */
  readonly element = document.createElement('div');
  readonly #frame = new PlotFrame(this.element);
  readonly #band = document.createElement('div');
  readonly #mark = document.createElement('div');
  #content: DistributionContent | undefined;
  #range: [number, number] | undefined;
  #marked: number | undefined;
  readonly #events: DistributionEvents | undefined;

  /** Without events no range can be marked: it is a picture. */
  constructor(events?: DistributionEvents) {
    this.#events = events;
    const [band, mark] = [this.#band, this.#mark];
    const { element } = this;
    const { over } = this.#frame;
    element.className = 'plot';
    band.className = 'plot-band';
    mark.className = 'plot-mark';
    over.append(band, mark);
    element.setAttribute('role', events ? 'slider' : 'img');
    element.classList.toggle('fixed', !events);
    if (events) {
      element.tabIndex = 0;
      element.setAttribute('aria-valuemin', '0');
      element.setAttribute('aria-valuemax', String(histogramBins));
      over.addEventListener('pointerdown', (event) => this.#beginDrag(event));
      element.addEventListener('keydown', (event) => this.#key(event));
    }
    this.#place();
  }

  /** The marked range; undefined where none is. */
  get brush(): [number, number] | undefined {
    return this.#range;
  }

  /** Marks a range without an event. */
  set brush(range: ValueRange | undefined) {
    this.#range = range && [...range];
    this.#place();
  }

  /** Shows other content; the marked range stays. */
  show(content: DistributionContent): void {
    this.#content = content;
    const [low, high] = content.range;
    const isCumulative = content.kind === 'cdf';
    const lines: { curve: Cumulative; series: DistributionSeries }[] = isCumulative
      ? content.series.map((series) => ({
          series,
          curve: cumulative(series.values, series.weights, steps, content.range),
        }))
      : [];
    const at = lines[0]?.curve.at ?? [low, high];
    const axes = content.axes !== undefined;
    this.#frame.show({
      x: {
        scale: { low, high, log: false },
        format: axes ? content.format : undefined,
        label: content.axes?.label,
      },
      y: {
        scale: { low: 0, high: 1, log: false },
        format: axes && isCumulative ? (share) => `${Math.round(100 * share)}\u202f%` : undefined,
      },
      at,
      lines: isCumulative
        ? lines.map(({ curve, series }) => ({
            y: curve.shares,
            colour: series.colour,
            dash: series.dash,
          }))
        : [],
      paint: (context, inside, pixelRatio) => {
        if (isCumulative) this.#paintQuarters(context, inside, pixelRatio);
        else this.#paintBars(context, inside, pixelRatio);
      },
    });
    this.#place();
  }

  /** Draws bars in their present colours. */
  recolour(colourOf: DistributionContent['colourOf']): void {
    if (!this.#content) return;
    this.#content.colourOf = colourOf;
    this.#frame.repaint();
  }

  /** A line at a value, for example that of the point under the pointer. */
  markValue(value: number | undefined): void {
    this.#marked = value;
    this.#place();
  }

  /**
   * The plot as it is now as an SVG file's content, with numbers as text, so many millimetres wide; undefined where nothing
   * is shown, or it is not on a page. `below`: what is written at the axis of values, where the page writes nothing there.
   */
  svg(width = svgWidth, below?: AxisWords): string | undefined {
    const title = below?.label ?? this.element.getAttribute('aria-label') ?? '';
    return this.#frame.svg(width, title, below ?? { format: this.#content?.format });
  }

  /** Takes the plot out of use. */
  dispose(): void {
    this.#frame.dispose();
  }

  #paintBars(
    context: PlotPen,
    inside: { left: number; top: number; width: number; height: number },
    pixelRatio: number,
  ): void {
    const { series, range, colourOf } = this.#content!;
    const [first] = series;
    if (!first) return;
    const { shares, peak } = histogram(first.values, first.weights, histogramBins, range);
    const width = inside.width / histogramBins;
    const gap = Math.min(pixelRatio, 0.14 * width);
    shares.forEach((share, bin) => {
      if (share === 0) return;
      const { colour, faint } = colourOf(
        range[0] + ((range[1] - range[0]) * (bin + 0.5)) / histogramBins,
      );
      // Square root: a bin with little area among much can still be seen.
      const height = Math.max(pixelRatio, inside.height * Math.sqrt(share / peak));
      context.globalAlpha = faint ? 0.35 : 1;
      context.fillStyle = colour;
      context.fillRect(
        inside.left + bin * width + gap / 2,
        inside.top + inside.height - height,
        width - gap,
        height,
      );
    });
  }

  /** Hairlines at the quarters, where no axis has them. */
  #paintQuarters(
    context: PlotPen,
    inside: { left: number; top: number; width: number; height: number },
    pixelRatio: number,
  ): void {
    if (this.#content!.axes) return;
    context.strokeStyle = getComputedStyle(this.element).getPropertyValue('--plot-line');
    context.lineWidth = pixelRatio;
    context.beginPath();
    for (const share of [0, 0.25, 0.5, 0.75, 1]) {
      const y = Math.round(inside.top + inside.height * (1 - share)) + 0.5 * pixelRatio;
      context.moveTo(inside.left, y);
      context.lineTo(inside.left + inside.width, y);
    }
    context.stroke();
  }

  #valueAt(place: number): number {
    const [low, high] = this.#content!.range;
    return place >= 1 ? high : low + (high - low) * place;
  }

  #placeOf(value: number): number {
    const [low, high] = this.#content!.range;
    return high > low ? (value - low) / (high - low) : 0.5;
  }

  #beginDrag(down: PointerEvent): void {
    if (down.button !== 0 || !this.#content) return;
    const { over } = this.#frame;
    const box = over.getBoundingClientRect();
    const placeOf = (event: PointerEvent): number => (event.clientX - box.left) / box.width;
    const from = placeOf(down);
    let isDrag = false;
    const move = (event: PointerEvent): void => {
      isDrag ||= Math.abs(event.clientX - down.clientX) >= leastDrag;
      if (!isDrag) return;
      const [low, high] = dragged(from, placeOf(event));
      this.#setBrush([this.#valueAt(low), this.#valueAt(high)], false);
    };
    const before = this.brush;
    let isTaken = false;
    // The browser scrolls the page with this finger: it never meant the plot.
    const take = (): void => {
      isTaken = true;
    };
    const end = (): void => {
      over.removeEventListener('pointermove', move);
      over.removeEventListener('pointercancel', take);
      if (isTaken) this.#setBrush(before, true);
      else this.#setBrush(isDrag ? this.#range : undefined, true);
    };
    over.setPointerCapture(down.pointerId);
    over.addEventListener('pointermove', move);
    over.addEventListener('pointercancel', take);
    over.addEventListener('lostpointercapture', end, { once: true });
  }

  #key(event: KeyboardEvent): void {
    if (!this.#content || event.ctrlKey || event.altKey || event.metaKey) return;
    const bins = this.#range?.map((value) => this.#placeOf(value) * histogramBins);
    const now: ValueRange | undefined = bins && [
      Math.min(histogramBins - 1, Math.max(0, Math.round(bins[0]!))),
      Math.max(0, Math.round(bins[1]!) - 1),
    ];
    const next = movedByKey(now, event.key, event.shiftKey, histogramBins);
    if (next === undefined) return;
    event.preventDefault();
    this.#setBrush(
      next === 'none'
        ? undefined
        : [this.#valueAt(next[0] / histogramBins), this.#valueAt((next[1] + 1) / histogramBins)],
      true,
    );
  }

  #setBrush(range: ValueRange | undefined, settled: boolean): void {
    this.brush = range;
    this.#events?.brushed(this.#range, settled);
  }

  /** Puts the band and the mark where they belong. */
  #place(): void {
    const [band, mark, range, marked, content] = [
      this.#band,
      this.#mark,
      this.#range,
      this.#marked,
      this.#content,
    ];
    const { element } = this;
    const format = content?.format;
    band.hidden = !range || !content;
    mark.hidden = marked === undefined || !Number.isFinite(marked) || !content;
    if (!this.#events) return;
    if (!content || !format) {
      element.setAttribute('aria-valuenow', '0');
      element.setAttribute('aria-valuetext', 'no range marked');
      return;
    }
    if (range) {
      const [low, high] = range.map((value) => Math.min(1, Math.max(0, this.#placeOf(value))));
      band.style.left = `${100 * low!}%`;
      band.style.right = `${100 * (1 - high!)}%`;
    }
    if (!mark.hidden) {
      mark.style.left = `${100 * Math.min(1, Math.max(0, this.#placeOf(marked!)))}%`;
    }
    const now = range ? Math.round(histogramBins * this.#placeOf(range[0])) : 0;
    element.setAttribute('aria-valuenow', String(Math.min(histogramBins, Math.max(0, now))));
    element.setAttribute(
      'aria-valuetext',
      range ? `${format(range[0])} to ${format(range[1])} marked` : 'no range marked',
    );
  }
}
