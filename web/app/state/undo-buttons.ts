// Undo and redo: the buttons, which have the usual keys.

import { announce } from '../widgets/announcer.js';
import { byId } from '../widgets/dom.js';

export interface UndoActions {
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  undo(): void;
  redo(): void;
}

/** Makes the page's two buttons work; returns a function to call when `actions` has changed. */
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
  // A disabled button would lose the focus of whoever has just pressed it.
  const update = (): void => {
    undo.setAttribute('aria-disabled', String(!actions.canUndo));
    redo.setAttribute('aria-disabled', String(!actions.canRedo));
  };
  update();
  return update;
}
