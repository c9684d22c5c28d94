// What a picture of the surface has, and how large it is: for a screen, or for a column of a paper.

import { type DrawingOptions, type FigureOptions, make } from '../src/element/index.js';
import { Draft } from './draft.js';

const printDensity = 300;
const millimetresPerInch = 25.4;
/** Widths on paper in millimetres, as journals ask for them; 0: as on the screen. */
const widths = [
  [0, 'as on the screen'],
  [85, 'one column: 85 mm at 300 dpi'],
  [175, 'two columns: 175 mm at 300 dpi'],
] as const;

export class FigureChoice {
  readonly element = make('div', { class: 'figure' });
  readonly #width = make('select', { id: 'picture-width', 'aria-label': 'Size of the picture' });
  readonly #chosen: Draft;
  readonly #legend = check('picture-legend', true);
  readonly #scaleBar = check('picture-scale', true);
  readonly #transparent = check('picture-transparent', false);

  constructor() {
    this.#width.append(
      ...widths.map(([width, words]) => make('option', { value: String(width) }, words)),
    );
    this.#chosen = new Draft(this.#width);
    const label = (input: HTMLInputElement, words: string): HTMLElement =>
      make('label', { class: 'check' }, input, words);
    this.element.append(
      this.#width,
      label(this.#legend, 'Legend and labels'),
      label(this.#scaleBar, 'Scale bar'),
      label(this.#transparent, 'Transparent'),
    );
  }

  /** The same of a drawing in lines; as on the screen is one column of a paper. */
  get drawing(): DrawingOptions {
    const width = Number(this.#chosen.text);
    return {
      labels: this.#legend.checked,
      scaleBar: this.#scaleBar.checked,
      ...(width > 0 ? { width } : {}),
    };
  }

  get options(): FigureOptions {
    const millimetres = Number(this.#chosen.text);
    const width = Math.round((millimetres / millimetresPerInch) * printDensity);
    return {
      legend: this.#legend.checked,
      scaleBar: this.#scaleBar.checked,
      transparent: this.#transparent.checked,
      ...(millimetres > 0 ? { width, dotsPerInch: printDensity } : {}),
    };
  }
}

function check(id: string, checked: boolean): HTMLInputElement {
  const input = make('input', { id, type: 'checkbox' });
  input.checked = checked;
  return input;
}
