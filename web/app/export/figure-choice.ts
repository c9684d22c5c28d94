// Choices for a picture of the surface: its parts, and its size on a screen or on paper.

import { type DrawingOptions, type FigureOptions, make } from '../../src/element/index.js';
import { Draft } from '../widgets/draft.js';

/** Widths on paper in millimetres, as journals ask for them; 0: as on the screen. */
const widths = [
  [0, 'as on the screen'],
  [85, 'one column: 85 mm at 300 dpi'],
  [175, 'two columns: 175 mm at 300 dpi'],
] as const;
const another = 'another';
/** Widths that can be typed, in millimetres: from a stamp to a poster, the most that browsers draw. */
const narrowest = 20;
const widest = 400;

export class FigureChoice {
  readonly element = make('div', { class: 'figure' });
  readonly #width = make('select', { id: 'picture-width', 'aria-label': 'Size of the picture' });
  readonly #chosen: Draft;
  readonly #typed = make('input', {
    id: 'picture-millimetres',
    type: 'number',
    min: String(narrowest),
    max: String(widest),
    value: '120',
  });
  readonly #own = make('label', { class: 'check', hidden: '' }, this.#typed, 'mm wide at 300 dpi');
  readonly #legend = check('picture-legend', true);
  readonly #scaleBar = check('picture-scale', true);
  readonly #transparent = check('picture-transparent', false);

  constructor() {
    this.#width.append(
      ...widths.map(([width, words]) => make('option', { value: String(width) }, words)),
      make('option', { value: another }, 'another width'),
    );
    this.#chosen = new Draft(this.#width, {
      committed: (text) => {
        this.#own.hidden = text !== another;
      },
    });
    const label = (input: HTMLInputElement, words: string): HTMLElement =>
      make('label', { class: 'check' }, input, words);
    this.element.append(
      this.#width,
      this.#own,
      label(this.#legend, 'Legend and labels'),
      label(this.#scaleBar, 'Scale bar'),
      label(this.#transparent, 'Transparent'),
    );
  }

  /** The choices for a drawing in lines; as on the screen is one column of a paper. */
  get drawing(): DrawingOptions {
    const width = this.#millimetres;
    return {
      labels: this.#legend.checked,
      scaleBar: this.#scaleBar.checked,
      ...(width > 0 ? { width } : {}),
    };
  }

  get options(): FigureOptions {
    const millimetres = this.#millimetres;
    return {
      legend: this.#legend.checked,
      scaleBar: this.#scaleBar.checked,
      transparent: this.#transparent.checked,
      ...(millimetres > 0 ? { millimetres } : {}),
    };
  }

  /** 0: as on the screen. */
  get #millimetres(): number {
    const { text } = this.#chosen;
    if (text !== another) return Number(text);
    return Math.max(narrowest, Math.min(widest, this.#typed.valueAsNumber || narrowest));
  }
}

function check(id: string, checked: boolean): HTMLInputElement {
  const input = make('input', { id, type: 'checkbox' });
  input.checked = checked;
  return input;
}
