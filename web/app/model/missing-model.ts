// The card that stands in the middle where a link is about a file that this reader has not opened: what the link
// names, how to go on, and the values that it carries.

import { make } from '../../src/element/index.js';
import type { PageState } from '../state/address-state.js';
import { byId } from '../widgets/dom.js';

export class MissingModel {
  readonly #card = byId('missing');
  readonly #line = byId('model');
  readonly #title = byId('missing-title');
  readonly #open = byId<HTMLButtonElement>('missing-open');
  readonly #values = byId('missing-values');

  /** `openFiles`: lets the reader choose the file. */
  constructor(openFiles: () => void) {
    this.#open.addEventListener('click', openFiles);
  }

  /** Says which file is missing; the title on top names it, too, as no other model is there. */
  show({ file = '', loops = [], names = [], values = [] }: PageState, isEmpty: boolean): void {
    this.#title.textContent = file;
    if (isEmpty) this.#line.replaceChildren(make('b', {}, file), ' · not opened yet');
    const rows = loops.map((_, i) =>
      make(
        'tr',
        {},
        make('th', { scope: 'row' }, String(i + 1)),
        make('td', {}, names[i] ?? ''),
        make('td', { class: 'number' }, values[i] ?? ''),
      ),
    );
    const head = ['#', 'Name'].map((words) => make('th', { scope: 'col' }, words));
    head.push(make('th', { scope: 'col', class: 'number' }, 'Girth'));
    this.#values.replaceChildren(
      make('caption', {}, 'What is pinned on it'),
      make('thead', {}, make('tr', {}, ...head)),
      make('tbody', {}, ...rows),
    );
    this.#values.hidden = rows.length === 0 || values.length === 0;
    this.#card.hidden = false;
  }

  hide(): void {
    this.#card.hidden = true;
  }
}
