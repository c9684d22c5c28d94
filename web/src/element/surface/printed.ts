// The print of an element: a figure with its legend, made when printing begins, in place of what is
// on the screen.

import { printDensity } from '../figure/snapshot.js';

const pixelsPerInch = 96;
/** The width of a sheet of A4 or letter between its margins, in inches. */
const widestFigure = 7.5;
/** All figures of a page together have no more pixels; the elements that are left print what is on the screen. */
const mostPixels = 64e6;

let pixelsLeft = mostPixels;

export class Printed {
  readonly #stopped = new AbortController();
  #figure: HTMLCanvasElement | undefined;

  /** `make` gives the figure of a width in pixels; undefined where there is none. */
  constructor(frame: HTMLElement, make: (width: number) => HTMLCanvasElement | undefined) {
    const { signal } = this.#stopped;
    const begin = (): void => {
      this.#end();
      // Nothing of a hidden element is printed.
      const { clientWidth, clientHeight } = frame;
      if (clientWidth === 0) return;
      const inches = Math.min(widestFigure, clientWidth / pixelsPerInch);
      const width = Math.round(inches * printDensity);
      if ((width * width * clientHeight) / clientWidth > pixelsLeft) return;
      const figure = make(width);
      if (!figure) return;
      pixelsLeft -= figure.width * figure.height;
      figure.className = 'printed';
      frame.append(figure);
      this.#figure = figure;
    };
    window.addEventListener('beforeprint', begin, { signal });
    window.addEventListener('afterprint', () => this.#end(), { signal });
  }

  /** The element has left its page. */
  stop(): void {
    this.#stopped.abort();
    this.#end();
  }

  #end(): void {
    if (!this.#figure) return;
    pixelsLeft += this.#figure.width * this.#figure.height;
    this.#figure.remove();
    this.#figure = undefined;
  }
}
