// The list of all keys, from what the page's controls and the surface have.

import { type GirthViewer, make } from '../../src/element/index.js';
import type { Action } from './action.js';
import { actionsOf } from './actions.js';
import { keyElements } from './palette.js';
import { usualHere } from './shortcuts.js';

export class KeyList {
  readonly #groups = make('div');
  readonly #dialog: HTMLDialogElement;
  readonly #viewer: GirthViewer;

  constructor(viewer: GirthViewer) {
    this.#viewer = viewer;
    const close = make('button', { class: 'open' }, 'Close');
    this.#dialog = make(
      'dialog',
      { id: 'key-list', 'aria-labelledby': 'keys-title' },
      make('h2', { id: 'keys-title' }, 'Keys'),
      this.#groups,
      make('form', { method: 'dialog' }, close),
    );
    document.body.append(this.#dialog);
    this.#dialog.addEventListener('click', ({ target }) => {
      if (target === this.#dialog) this.#dialog.close();
    });
  }

  open(): void {
    if (this.#dialog.open) return;
    const withKeys = actionsOf(this.#viewer).filter(({ keys }) => keys.length > 0);
    const groups = new Map<string, Action[]>();
    for (const action of withKeys) {
      const title = action.place[0] ?? 'Page';
      groups.set(title, [...(groups.get(title) ?? []), action]);
    }
    this.#groups.replaceChildren(
      ...[...groups].flatMap(([title, actions]) => [
        make('h3', {}, title),
        make('dl', {}, ...actions.map(line)),
      ]),
    );
    this.#dialog.showModal();
  }
}

function line({ words, keys }: Action): HTMLElement {
  const ways = usualHere(keys).flatMap((shortcut, i) => [
    ...(i > 0 ? [' or '] : []),
    ...keyElements(shortcut),
  ]);
  return make('div', {}, make('dt', {}, words), make('dd', {}, ...ways));
}
