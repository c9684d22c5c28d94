// The command palette: everything that the page can do, found by a few letters, with the keyboard alone. A combobox with
// a listbox, as the ARIA Authoring Practices have them, in a dialog.

import { type GirthViewer, formatCount, make } from '../../src/element/index.js';
import type { Action } from './action.js';
import { actionsOf } from './actions.js';
import { fuzzyScore } from './fuzzy.js';
import { keyWords, usualHere } from './shortcuts.js';

/** Rows that Page Up and Page Down pass. */
const page = 8;
/** The weight of a match in an action's own words over one in the names of its place. */
const ownWords = 10;

/** The keys of a shortcut. */
export function keyElements(shortcut: string): (Node | string)[] {
  return keyWords(shortcut).flatMap((key, i) => [...(i > 0 ? [' '] : []), make('kbd', {}, key)]);
}

/** The actions that answer a search, the best first; all where nothing is searched. */
export function found(actions: readonly Action[], search: string): Action[] {
  if (search.trim() === '') return [...actions];
  const scored = actions.flatMap((action) => {
    const own = fuzzyScore(search, action.words);
    const whole = fuzzyScore(search, [...action.place, action.words].join(' '));
    const score = Math.max(own === undefined ? -Infinity : own + ownWords, whole ?? -Infinity);
    return score > -Infinity ? [{ action, score }] : [];
  });
  return scored.sort((a, b) => b.score - a.score).map(({ action }) => action);
}

export class Palette {
  readonly #input = make('input', {
    type: 'text',
    role: 'combobox',
    'aria-label': 'Search commands',
    'aria-expanded': 'true',
    'aria-controls': 'palette-list',
    'aria-autocomplete': 'list',
    autocomplete: 'off',
    spellcheck: 'false',
    placeholder: 'Search commands',
  });
  readonly #form = make('form', {}, this.#input);
  readonly #list = make('ul', { id: 'palette-list', role: 'listbox', 'aria-label': 'Commands' });
  readonly #said = make('p', { class: 'hint', role: 'status' });
  readonly #dialog = make(
    'dialog',
    { id: 'palette', 'aria-label': 'Commands' },
    this.#form,
    this.#list,
    this.#said,
  );
  readonly #viewer: GirthViewer;
  #all: Action[] = [];
  #shown: Action[] = [];
  #at = 0;

  constructor(viewer: GirthViewer) {
    this.#viewer = viewer;
    document.body.append(this.#dialog);
    this.#input.addEventListener('input', () => this.#search());
    this.#input.addEventListener('keydown', (event) => this.#press(event));
    this.#list.addEventListener('click', ({ target }) => {
      const row = target instanceof Element ? target.closest('li') : null;
      if (row) this.#run([...this.#list.children].indexOf(row));
    });
    // Keys are for the page again, also where nothing had the focus before. The event comes late: by then it may be open
    // once more.
    this.#dialog.addEventListener('close', () => {
      if (!this.#dialog.open) this.#input.blur();
    });
    // Beside it.
    this.#dialog.addEventListener('click', ({ target }) => {
      if (target === this.#dialog) this.#dialog.close();
    });
  }

  open(): void {
    if (this.#dialog.open) return;
    this.#all = actionsOf(this.#viewer);
    this.#form.reset();
    this.#dialog.showModal();
    this.#search();
  }

  #search(): void {
    const search = this.#input.value;
    this.#shown = found(this.#all, search);
    const count = this.#shown.length;
    this.#list.replaceChildren(...this.#shown.map((action, i) => row(action, i)));
    this.#list.hidden = count === 0;
    this.#input.setAttribute('aria-expanded', String(count > 0));
    if (count === 0) this.#said.textContent = 'No command has this name.';
    else this.#said.textContent = count === 1 ? '1 command' : `${formatCount(count)} commands`;
    this.#mark(0);
  }

  #mark(index: number): void {
    this.#list.children[this.#at]?.setAttribute('aria-selected', 'false');
    this.#at = Math.max(0, Math.min(index, this.#shown.length - 1));
    const row = this.#list.children[this.#at];
    if (!row) {
      this.#input.removeAttribute('aria-activedescendant');
      return;
    }
    row.setAttribute('aria-selected', 'true');
    this.#input.setAttribute('aria-activedescendant', row.id);
    row.scrollIntoView({ block: 'nearest' });
  }

  #press(event: KeyboardEvent): void {
    const steps: Record<string, number> = {
      ArrowUp: -1,
      ArrowDown: 1,
      PageUp: -page,
      PageDown: page,
    };
    const step = steps[event.key];
    if (step !== undefined) {
      const [next, last] = [this.#at + step, this.#shown.length - 1];
      // The mark goes from one end to the other by single steps only.
      const wraps = Math.abs(step) === 1 && (next < 0 || next > last);
      this.#mark(wraps ? (next < 0 ? last : 0) : next);
    } else if (event.key === 'Enter' && !event.isComposing) this.#run(this.#at);
    else return;
    event.preventDefault();
  }

  #run(index: number): void {
    const action = this.#shown[index];
    if (!action) return;
    if (!action.isPossible) {
      this.#said.textContent = `${action.words}: not now.`;
      return;
    }
    // The focus goes back to where it was, before the action moves it.
    this.#dialog.close();
    action.run();
  }
}

function row({ words, place, keys, isOn, isPossible }: Action, index: number): HTMLElement {
  const [first] = usualHere(keys);
  return make(
    'li',
    {
      id: `palette-${index}`,
      role: 'option',
      'aria-selected': 'false',
      ...(isPossible ? {} : { 'aria-disabled': 'true' }),
    },
    make('span', {}, words, ...(isOn ? [' ', make('i', {}, 'on')] : [])),
    ...(place.length > 0 ? [make('small', {}, place.join(' › '))] : []),
    ...(first ? [make('span', { class: 'keys' }, ...keyElements(first))] : []),
  );
}
