// Results of actions that a person cannot see, said once: one live region for the page.

import { make } from '../../src/element/index.js';

const said = make('p', { id: 'said', class: 'unseen', 'aria-live': 'polite' });

/** Says something to screen readers. */
export function announce(words: string): void {
  if (!said.isConnected) document.querySelector('main')!.append(said);
  // Equal words, set again, are no change that would be heard.
  said.textContent = said.textContent === words ? `${words}\u00a0` : words;
}
