// Results of actions that a person cannot see, said once: one live region for the page.

import { make } from '../../src/element/index.js';

const said = make('p', { id: 'said', class: 'unseen', 'aria-live': 'polite' });
/** How long words are seen, in milliseconds. */
const seenFor = 4000;
let hiding: ReturnType<typeof setTimeout> | undefined;

/** Says something to screen readers; `isSeen`: everybody sees it for a while. */
export function announce(words: string, { isSeen = false } = {}): void {
  if (!said.isConnected) document.querySelector('main')!.append(said);
  // Equal words, set again, are no change that would be heard.
  said.textContent = said.textContent === words ? `${words}\u00a0` : words;
  said.className = isSeen ? 'told' : 'unseen';
  clearTimeout(hiding);
  if (isSeen) hiding = setTimeout(() => (said.className = 'unseen'), seenFor);
}
