// The link to what is shown.

import { make } from '../src/element/index.js';
import { copyText } from './clipboard.js';
import { byId } from './dom.js';
import { Draft } from './draft.js';

/** `fileName`: what a link cannot have in it; undefined where it has all. */
export function offerLink(link: () => string, fileName: () => string | undefined): void {
  const sheet = byId('share');
  const address = make('input', { type: 'text', readonly: '', 'aria-label': 'Link' });
  const shown = new Draft(address);
  const copy = make('button', { type: 'button', class: 'plain' }, 'Copy the link');
  const said = make('p', { class: 'hint', role: 'status' });
  const words = make('p', { class: 'hint' });
  sheet.append(make('div', { class: 'link' }, address, copy), words, said);
  address.addEventListener('focus', () => address.select());
  copy.addEventListener('click', () => {
    address.select();
    void copyText(shown.text).then((isCopied) => {
      said.textContent = isCopied
        ? 'Copied.'
        : 'This browser does not let pages copy: copy the link from the line above.';
    });
  });
  sheet.addEventListener('beforetoggle', (event) => {
    if (event.newState !== 'open') return;
    said.textContent = '';
    shown.show(link());
    const name = fileName();
    words.textContent =
      name === undefined
        ? 'It opens this model with field, colours, camera, loops and thresholds as they are now.'
        : `${name} stays on your machine: a link cannot have it. Whoever opens the link and drops ` +
          'that file sees it as it is now.';
  });
}
