// Elements of the page that explain a term. The explanations are fetched later (`explanation.ts`).

import { make } from '../../src/element/index.js';
import type { TermName } from './terms.js';

/** A word that can be asked about. Not for the inside of other controls: see `explains`. */
export function term(name: TermName, words: string): HTMLButtonElement {
  const button = make('button', { type: 'button', class: 'term' }, words);
  explains(button, name);
  return button;
}

/** Lets a heading or a control explain a term while it is pointed at; undefined: no longer. */
export function explains(element: HTMLElement, name: TermName | undefined): void {
  if (name === undefined) delete element.dataset['term'];
  else element.dataset['term'] = name;
  if (element instanceof HTMLButtonElement && name) {
    element.setAttribute('aria-describedby', `term-${name}`);
  }
}
