// Announcements for those who cannot see the element: what is on the canvas, how it is moved, and
// what has ended.

import type { FieldName } from '../../kernel/types/types.js';
import { fieldTitle, formatLength } from '../../view/index.js';
import { make } from './dom.js';
import type { Presented } from '../presented.js';

const keyWords =
  'Arrows turn, plus and minus zoom, 0 goes back to the first view, Shift with arrows moves a probe, ' +
  'Enter pins its loop.';

export class Voice {
  readonly #live = make('div', { class: 'quiet-live', 'aria-live': 'polite' });
  /** Elements in the same tree as the canvas, which they describe. */
  readonly elements = [this.#live, make('p', { id: 'keys', hidden: '' }, keyWords)];

  /** Calls a canvas by what is on it: the model and its field. */
  call(canvas: HTMLCanvasElement, presented: Presented | undefined): void {
    if (!presented) return;
    const field = presented.shading.title;
    const what = presented.model.mesh.info.name || 'Surface';
    canvas.setAttribute('aria-label', field ? `${what}, coloured by: ${field}` : what);
  }

  /** A field is there: 'Girth: computed, from 0.0760 m to 0.5624 m.' */
  computed(name: FieldName, range: readonly [number, number], { shading }: Presented): void {
    const format = shading.formatOf(name);
    const [low, high] = range.map((value) => formatLength(value, format));
    const words = Number.isNaN(range[0]) ? 'no values' : `from ${low} to ${high}`;
    this.#live.textContent = `${shading.name === name ? shading.title : fieldTitle(name)}: computed, ${words}.`;
  }
}
