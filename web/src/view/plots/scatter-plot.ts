// Girth against shape diameter, a point for every vertex, with the two thresholds that make tubes, plates
// and body of it; both can be dragged.

import {
  type Density,
  type Scale,
  density,
  densityImage,
  placeOn,
  scaleFor,
  valueAt,
} from './density.js';
import type { Weights } from './distribution.js';
import { PlotFrame, svgWidth } from './plot-frame.js';
import type { PlotPen } from './plot-svg.js';

/** Where tubes, plates and body are divided; in model units. */
export interface Thresholds {
  /** Tubes have a girth below it, plates one above. */
  girth: number;
  /** Tubes and plates have a shape diameter below it. */
  shapeDiameter: number;
}

/** sRGB bytes of what lies where. */
export interface RegionColours {
  /** The colour of thick points. */
  body: readonly [number, number, number];
  /** The colour of thin points with a small girth. */
  tube: readonly [number, number, number];
  /** The colour of thin points with a large girth. */
  plate: readonly [number, number, number];
}

/** The names of the axes, with the unit. */
export interface ScatterLabels {
  /** The name of the axis to the right. */
  girth: string;
  /** The name of the axis upwards. */
  shapeDiameter: string;
}

/** The content of a plot. */
export interface ScatterContent {
  /** One value for each vertex. */
  girth: ArrayLike<number>;
  /** The shape diameter, one value for each vertex. */
  shapeDiameter: ArrayLike<number>;
  /** How much each vertex counts. */
  weights: Weights;
  /** Whether the axes are logarithmic. */
  log: boolean;
  /** Colours of the points, by where they lie. */
  colours: RegionColours;
  /** Writes a value at an axis. */
  format: (value: number) => string;
  /** The unit of both values; '' where it is not known. */
  unit: string;
  /** The names of the axes. */
  labels: ScatterLabels;
}

/** The events of a plot. */
export interface ScatterEvents {
  /** A threshold was moved; `settled` once the hand has let go. */
  moved(thresholds: Thresholds, settled: boolean): void;
}

/** CSS pixels of a cell of the raster. */
const cell = 1.5;
/** Shares of an axis that an arrow key and a page key move. */
const keySteps: Record<string, number> = {
  ArrowRight: 0.01,
  ArrowUp: 0.01,
  ArrowLeft: -0.01,
  ArrowDown: -0.01,
  PageUp: 0.1,
  PageDown: -0.1,
};

/** A plot of girth against the shape diameter with two thresholds to drag. */
export class ScatterPlot {
  /** To be put into the page. */
  readonly element = document.createElement('div');
  readonly #frame = new PlotFrame(this.element);
  readonly #handles: Record<keyof Thresholds, HTMLElement>;
  readonly #cross = document.createElement('div');
  #content: ScatterContent | undefined;
  #axes: { x: Scale; y: Scale } | undefined;
  #thresholds: Thresholds = { girth: 0, shapeDiameter: 0 };
  #counted: { density: Density; key: string } | undefined;
  #images: Record<keyof RegionColours, OffscreenCanvas> | undefined;
  readonly #events: ScatterEvents;

  /** An empty plot. */
  constructor(events: ScatterEvents) {
    this.#events = events;
    this.element.className = 'plot scatter';
    this.#handles = {
      girth: this.#handle('girth', 'Girth below which thin parts are tubes'),
      shapeDiameter: this.#handle('shapeDiameter', 'Shape diameter below which parts are thin'),
    };
    this.#cross.className = 'plot-cross';
    this.#drags(this.#cross, ['girth', 'shapeDiameter']);
    this.#frame.over.append(this.#handles.girth, this.#handles.shapeDiameter, this.#cross);
  }

  /** Shows points; false where none of them has both values. */
  show(content: ScatterContent): boolean {
    this.#content = content;
    const x = scaleFor(content.girth, content.log);
    const y = scaleFor(content.shapeDiameter, content.log);
    this.#counted = undefined;
    this.#images = undefined;
    this.#axes = x && y && { x, y };
    if (!x || !y) return false;
    this.#frame.show({
      x: { scale: x, format: content.format, label: content.labels.girth },
      y: { scale: y, format: content.format, label: content.labels.shapeDiameter },
      at: [x.low, x.high],
      lines: [],
      paint: (context, inside, pixelRatio) => this.#paint(context, inside, pixelRatio),
    });
    this.#place();
    return true;
  }

  /** Moves the lines without an event. */
  setThresholds(thresholds: Thresholds): void {
    this.#thresholds = { ...thresholds };
    this.#place();
    this.#frame.repaint();
  }

  /**
   * The plot as it is now as an SVG file's content, with numbers as text, so many millimetres wide; undefined where nothing
   * is shown, or it is not on a page.
   */
  svg(width = svgWidth): string | undefined {
    return this.#frame.svg(width, this.element.getAttribute('aria-label') ?? '');
  }

  /** Takes the plot out of use. */
  dispose(): void {
    this.#frame.dispose();
  }

  #handle(name: keyof Thresholds, label: string): HTMLElement {
    const handle = document.createElement('div');
    handle.className = `plot-handle plot-handle-${name}`;
    handle.tabIndex = 0;
    handle.setAttribute('role', 'slider');
    handle.setAttribute('aria-label', label);
    handle.setAttribute('aria-orientation', name === 'girth' ? 'horizontal' : 'vertical');
    handle.setAttribute('aria-valuemin', '0');
    handle.setAttribute('aria-valuemax', '100');
    handle.setAttribute('aria-valuenow', '0');
    this.#drags(handle, [name]);
    handle.addEventListener('keydown', (event) => {
      const step = keySteps[event.key];
      const scale = name === 'girth' ? this.#axes?.x : this.#axes?.y;
      if (step === undefined || !scale) return;
      event.preventDefault();
      const place = placeOn(scale, this.#thresholds[name]);
      const from = Math.min(1, Math.max(0, Number.isNaN(place) ? 0 : place));
      this.#move({ [name]: valueAt(scale, Math.min(1, Math.max(0, from + step))) }, true);
    });
    return handle;
  }

  #drags(handle: HTMLElement, names: (keyof Thresholds)[]): void {
    handle.addEventListener('pointerdown', (down) => {
      if (down.button !== 0 || !this.#axes) return;
      down.preventDefault();
      const axes = this.#axes;
      const box = this.#frame.over.getBoundingClientRect();
      const move = (event: PointerEvent): void => {
        const clamp = (place: number): number => Math.min(1, Math.max(0, place));
        const change: Partial<Thresholds> = {};
        if (names.includes('girth')) {
          change.girth = valueAt(axes.x, clamp((event.clientX - box.left) / box.width));
        }
        if (names.includes('shapeDiameter')) {
          change.shapeDiameter = valueAt(axes.y, clamp(1 - (event.clientY - box.top) / box.height));
        }
        this.#move(change, false);
      };
      handle.setPointerCapture(down.pointerId);
      handle.addEventListener('pointermove', move);
      handle.addEventListener(
        'lostpointercapture',
        () => {
          handle.removeEventListener('pointermove', move);
          this.#events.moved({ ...this.#thresholds }, true);
        },
        { once: true },
      );
    });
  }

  #move(change: Partial<Thresholds>, settled: boolean): void {
    this.setThresholds({ ...this.#thresholds, ...change });
    this.#events.moved({ ...this.#thresholds }, settled);
  }

  /** Places of the thresholds on the axes, within them. */
  #places(): { right: number; up: number } {
    const [axes, thresholds] = [this.#axes, this.#thresholds];
    const clamp = (place: number): number =>
      Math.min(1, Math.max(0, Number.isNaN(place) ? 0 : place));
    return {
      right: clamp(placeOn(axes!.x, thresholds.girth)),
      up: clamp(placeOn(axes!.y, thresholds.shapeDiameter)),
    };
  }

  #place(): void {
    const [handles, cross, axes, content] = [this.#handles, this.#cross, this.#axes, this.#content];
    for (const one of [handles.girth, handles.shapeDiameter, cross]) one.hidden = !axes;
    if (!axes || !content) return;
    const { right, up } = this.#places();
    handles.girth.style.left = cross.style.left = `${100 * right}%`;
    handles.girth.style.top =
      handles.shapeDiameter.style.top =
      cross.style.top =
        `${100 * (1 - up)}%`;
    for (const [name, place] of [
      ['girth', right],
      ['shapeDiameter', up],
    ] as const) {
      handles[name].setAttribute('aria-valuenow', String(Math.round(100 * place)));
      const value = content.format(this.#thresholds[name]);
      handles[name].setAttribute('aria-valuetext', `${value} ${content.unit}`.trim());
    }
  }

  /** The points, in the colour of the region that each lies in. */
  #paint(
    context: PlotPen,
    inside: { left: number; top: number; width: number; height: number },
    pixelRatio: number,
  ): void {
    const [content, axes] = [this.#content, this.#axes];
    if (!content || !axes) return;
    const width = Math.max(1, Math.round(inside.width / (pixelRatio * cell)));
    const height = Math.max(1, Math.round(inside.height / (pixelRatio * cell)));
    const key = `${width} ${height}`;
    if (this.#counted?.key !== key) {
      const { girth, shapeDiameter, weights } = content;
      this.#counted = { key, density: density(girth, shapeDiameter, weights, axes, width, height) };
      this.#images = undefined;
    }
    this.#images ??= this.#drawImages(content.colours);
    const { right, up } = this.#places();
    const [x, y] = [inside.left + inside.width * right, inside.top + inside.height * (1 - up)];
    const [endX, endY] = [inside.left + inside.width, inside.top + inside.height];
    const regions: [keyof RegionColours, number, number, number, number][] = [
      ['body', inside.left, inside.top, endX, y],
      ['tube', inside.left, y, x, endY],
      ['plate', x, y, endX, endY],
    ];
    for (const [region, left, top, end, bottom] of regions) {
      context.save();
      context.beginPath();
      context.rect(left, top, end - left, bottom - top);
      context.clip();
      const [r, g, b] = content.colours[region];
      context.fillStyle = `rgb(${r} ${g} ${b} / 0.1)`;
      context.fillRect(left, top, end - left, bottom - top);
      context.imageSmoothingEnabled = false;
      context.drawImage(this.#images[region], inside.left, inside.top, inside.width, inside.height);
      context.restore();
    }
  }

  #drawImages(colours: RegionColours): Record<keyof RegionColours, OffscreenCanvas> {
    const counted = this.#counted!.density;
    const draw = (region: keyof RegionColours): OffscreenCanvas => {
      const canvas = new OffscreenCanvas(counted.width, counted.height);
      const pixels = densityImage(counted, colours[region]);
      canvas
        .getContext('2d')!
        .putImageData(new ImageData(pixels, counted.width, counted.height), 0, 0);
      return canvas;
    };
    return { body: draw('body'), tube: draw('tube'), plate: draw('plate') };
  }
}
