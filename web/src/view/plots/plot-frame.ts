// A plot on the page: uPlot draws axes and lines, scaled to the screen and to the space there is; what
// is above it (marks, handles) is HTML.

import './locale.js';
import uPlot from 'uplot';
import { type Scale, logTicks, placeOn } from './density.js';
import { type PlotPen, type SvgAxis, plotSvg } from './plot-svg.js';
import { roundTicks } from '../numbers.js';

/** An axis of a plot as the reader sees it. */
export interface PlotAxis {
  scale: Scale;
  /** Numbers at the axis; undefined: none are written. */
  format?: ((value: number) => string) | undefined;
  /** The name of the numbers, with the unit. */
  label?: string | undefined;
}

/** A line of a plot. */
export interface PlotLine {
  /** A value for each x; what is no number is left out. */
  y: ArrayLike<number>;
  /** A CSS colour. */
  colour: string;
  /** Lengths of dashes and gaps, in CSS pixels; absent: a plain line. */
  dash?: number[] | undefined;
}

/** A rectangle of the canvas, in its pixels. */
export interface PlotBox {
  left: number;
  top: number;
  width: number;
  height: number;
}

export interface PlotContent {
  x: PlotAxis;
  y: PlotAxis;
  /** Values of x that all lines share, ascending. */
  at: ArrayLike<number>;
  lines: readonly PlotLine[];
  /** Draws below the lines: the plot's inside in pixels of the canvas, and pixels per CSS pixel. */
  paint?: (context: PlotPen, inside: PlotBox, pixelRatio: number) => void;
}

/** Millimetres on paper: one column of a paper. */
export const svgWidth = 85;

const font = '11px system-ui, sans-serif';

/** Keeps a plot as large as its host and in the colours of the page. */
export class PlotFrame {
  /** Above the plot's inside, its size. */
  readonly over = document.createElement('div');
  readonly #watchers: (() => void)[] = [];
  #plot: uPlot | undefined;
  #content: PlotContent | undefined;
  #layout = '';
  /** The colour of its numbers and axes, as it is drawn. */
  #ink = '';
  readonly #host: HTMLElement;

  /** `host` has a size of its own; the colour of its text is that of numbers and axes. */
  constructor(host: HTMLElement) {
    this.#host = host;
    this.over.className = 'plot-over';
    const resized = new ResizeObserver(() => this.#fit());
    resized.observe(host);
    this.#watchers.push(() => resized.disconnect());
    for (const query of ['(prefers-color-scheme: dark)', `(resolution: ${devicePixelRatio}dppx)`]) {
      const media = window.matchMedia(query);
      const changed = (): void => this.#rebuild();
      media.addEventListener('change', changed);
      this.#watchers.push(() => media.removeEventListener('change', changed));
    }
    // Pages whose readers choose between dark and light say so on their root.
    const root = new MutationObserver(() => {
      if (this.#plot && getComputedStyle(this.#host).color !== this.#ink) this.#rebuild();
    });
    root.observe(document.documentElement, { attributes: true });
    this.#watchers.push(() => root.disconnect());
  }

  show(content: PlotContent): void {
    this.#content = content;
    // Axes that come, go or change their kind need another plot. Otherwise only what is drawn changes.
    const { x, y, lines } = content;
    const layout = JSON.stringify([
      [x, y].map(({ scale, format, label }) => [scale.log, !!format, label]),
      lines.map(({ colour, dash }) => [colour, dash]),
    ]);
    if (!this.#plot || layout !== this.#layout) {
      this.#layout = layout;
      this.#rebuild();
      return;
    }
    this.#plot.setData(this.#data(), true);
  }

  /** Draws again what `paint` draws. */
  repaint(): void {
    this.#plot?.redraw(false, false);
  }

  /**
   * The plot as it is now as SVG, so many millimetres wide on paper; undefined as long as nothing is shown or it is not on
   * a page. `below`: what is written at the lower axis where the page writes nothing.
   */
  svg(
    paper: number,
    title: string,
    below: Pick<PlotAxis, 'format' | 'label'> = {},
  ): string | undefined {
    const [content, host] = [this.#content, this.#host];
    const size = { width: host.clientWidth, height: host.clientHeight };
    if (!content || size.width === 0 || size.height === 0) return undefined;
    // Words below the axis make the plot higher.
    if (!content.x.format && below.format) size.height += below.label ? 36 : 20;
    const axis = (side: 'x' | 'y'): SvgAxis | undefined => {
      const { scale } = content[side];
      const { format, label = '' } = side === 'x' && !content.x.format ? below : content[side];
      if (!format) return undefined;
      const ticks = this.#ticks(side).map((value) => ({
        place: placeOn(scale, value),
        text: format(value),
      }));
      return { ticks: ticks.filter(({ place }) => place >= 0 && place <= 1), label };
    };
    const places = Array.from(content.at, (value) => placeOn(content.x.scale, value));
    return plotSvg({
      ...{ title, size, paper, x: axis('x'), y: axis('y') },
      lines: content.lines.map(({ y, colour, dash = [] }) => ({
        points: places.map((place, i) => [place, placeOn(content.y.scale, y[i]!)] as const),
        // The colour of the page's own words may be light.
        ...{ colour: colour === getComputedStyle(host).color ? undefined : colour, dash },
      })),
      paint: (pen, inside) => content.paint?.(pen, inside, 1),
    });
  }

  dispose(): void {
    for (const stop of this.#watchers.splice(0)) stop();
    this.#plot?.destroy();
    this.#plot = undefined;
  }

  #data(): uPlot.AlignedData {
    const { at, lines } = this.#content!;
    const known = (value: number): number | null => (Number.isNaN(value) ? null : value);
    return [Array.from(at), ...lines.map(({ y }) => Array.from(y, known))];
  }

  #fit(): void {
    const { clientWidth, clientHeight } = this.#host;
    if (clientWidth === 0 || clientHeight === 0) return;
    if (!this.#plot) this.#rebuild();
    else if (this.#plot.width !== clientWidth || this.#plot.height !== clientHeight) {
      this.#plot.setSize({ width: clientWidth, height: clientHeight });
    }
  }

  #rebuild(): void {
    const [content, host] = [this.#content, this.#host];
    const { clientWidth, clientHeight } = host;
    if (!content || clientWidth === 0 || clientHeight === 0) return;
    this.#plot?.destroy();
    const style = getComputedStyle(host);
    const ink = (this.#ink = style.color);
    const line = style.getPropertyValue('--plot-line') || ink;
    const axis = (side: 'x' | 'y'): uPlot.Axis => {
      const { format, label } = content[side];
      return {
        scale: side,
        show: !!format,
        stroke: ink,
        font,
        labelFont: font,
        grid: { stroke: line, width: 1 },
        ticks: { show: false },
        border: { show: false },
        gap: 4,
        size: side === 'x' ? 20 : 44,
        ...(label === undefined ? {} : { label, labelSize: 16, labelGap: 0 }),
        splits: () => this.#ticks(side),
        values: (_, ticks) => ticks.map((tick) => this.#content![side].format?.(tick) ?? ''),
        filter: (_, ticks) => ticks,
      };
    };
    const scale = (side: 'x' | 'y'): uPlot.Scale => ({
      time: false,
      distr: content[side].scale.log ? 3 : 1,
      range: () => [this.#content![side].scale.low, this.#content![side].scale.high],
    });
    this.#plot = new uPlot(
      {
        width: clientWidth,
        height: clientHeight,
        padding: content.x.format ? [6, 10, 0, 0] : [1, 0, 1, 0],
        legend: { show: false },
        cursor: { show: false },
        scales: { x: scale('x'), y: scale('y') },
        axes: [axis('x'), axis('y')],
        series: [
          {},
          ...content.lines.map(({ colour, dash }) => ({
            scale: 'y',
            stroke: colour,
            width: 1.75,
            points: { show: false },
            ...(dash ? { dash } : {}),
          })),
        ],
        hooks: {
          drawAxes: [
            (plot) => {
              const { ctx, bbox } = plot;
              ctx.save();
              this.#content!.paint?.(ctx, bbox, uPlot.pxRatio);
              ctx.restore();
            },
          ],
        },
      },
      this.#data(),
      host,
    );
    this.#plot.over.append(this.over);
  }

  #ticks(side: 'x' | 'y'): number[] {
    const { scale } = this.#content![side];
    const room = side === 'x' ? this.#host.clientWidth / 64 : this.#host.clientHeight / 34;
    const wanted = Math.max(2, Math.floor(room));
    return scale.log ? logTicks(scale, wanted) : roundTicks(scale.low, scale.high, wanted);
  }
}
