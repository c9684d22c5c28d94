// Undo and redo: the buttons, which have the usual keys.

import { withKeys } from '../commands/shortcuts.js';
import { announce } from '../widgets/announcer.js';
import { byId } from '../widgets/dom.js';

export interface UndoActions {
  /** Words for the changes that both would make; undefined where there is none. */
  readonly undoWords: string | undefined;
  readonly redoWords: string | undefined;
  /** Writes a change that was made just now. */
  flush(): void;
  undo(): void;
  redo(): void;
}

/** Makes the page's two buttons work; returns a function to call when `actions` has changed. */
export function offerUndo(actions: UndoActions): () => void {
  const [undo, redo] = [byId('undo'), byId('redo')];
  const run = (isRedo: boolean): void => {
    actions.flush();
    const words = isRedo ? actions.redoWords : actions.undoWords;
    if (words === undefined) return;
    if (isRedo) actions.redo();
    else actions.undo();
    announce(`${isRedo ? 'Redone' : 'Undone'}${words && ': '}${words}.`, { isSeen: true });
  };
  undo.addEventListener('click', () => run(false));
  redo.addEventListener('click', () => run(true));
  const show = (button: HTMLElement, name: string, words: string | undefined): void => {
    // A disabled button would lose the focus of whoever has just pressed it.
    button.setAttribute('aria-disabled', String(words === undefined));
    button.title = withKeys(words ? `${name}: ${words}` : name, button);
  };
  const update = (): void => {
    show(undo, 'Undo', actions.undoWords);
    show(redo, 'Redo', actions.redoWords);
  };
  update();
  return update;
}
