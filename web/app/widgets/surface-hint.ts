// A hint above the surface: what to do on it next, with a button to end that.

import { make } from '../../src/element/index.js';
import { byId } from './dom.js';

export class SurfaceHint {
  readonly #words = make('span');
  readonly #element: HTMLElement;

  /** `words` are on the button that ends it; `more` buttons stand before it. */
  constructor(ended: () => void, words = 'Cancel', ...more: HTMLButtonElement[]) {
    const end = make('button', { type: 'button', class: 'plain' }, words);
    end.addEventListener('click', ended);
    this.#element = make('p', { class: 'asking', role: 'status' }, this.#words, ...more, end);
    this.#element.hidden = true;
    byId('asking').append(this.#element);
  }

  /** Asks for something; undefined: for nothing any more. */
  show(words: string | undefined): void {
    this.#element.hidden = words === undefined;
    this.#words.textContent = words ?? '';
  }
}
