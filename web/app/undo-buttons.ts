// Undo and redo, by buttons and by the usual keys.

import { announce } from './announcer.js';
import { byId } from './dom.js';

/** Text is undone by the browser, where it is typed. */
const typing =
  'input:not([type=checkbox], [type=radio], [type=range], [type=button]), textarea, select';

export interface UndoActions {
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  undo(): void;
  redo(): void;
}

/** Makes the page's two buttons and the keys work; what it returns is called when `actions` can do otherwise. */
export function offerUndo(actions: UndoActions): () => void {
  const [undo, redo] = [byId('undo'), byId('redo')];
  const run = (isRedo: boolean): void => {
    if (!(isRedo ? actions.canRedo : actions.canUndo)) return;
    if (isRedo) actions.redo();
    else actions.undo();
    announce(isRedo ? 'Redone.' : 'Undone.');
  };
  undo.addEventListener('click', () => run(false));
  redo.addEventListener('click', () => run(true));
  document.addEventListener('keydown', (event) => {
    const [target] = event.composedPath();
    const isAsked = (event.ctrlKey || event.metaKey) && !event.altKey;
    const key = event.key.toLowerCase();
    if (!isAsked || (key !== 'z' && key !== 'y') || event.defaultPrevented) return;
    if (target instanceof Element && target.closest(`${typing}, dialog`)) return;
    event.preventDefault();
    run(key === 'y' || event.shiftKey);
  });
  // A disabled button would lose the focus of whoever has just pressed it.
  const update = (): void => {
    undo.setAttribute('aria-disabled', String(!actions.canUndo));
    redo.setAttribute('aria-disabled', String(!actions.canRedo));
  };
  update();
  return update;
}
