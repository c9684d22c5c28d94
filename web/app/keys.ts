// Keys that move the surface work wherever the focus is, but not while somebody types or moves a control.

import type { GirthViewer } from '../src/element/index.js';

/** What takes letters, digits or arrows for itself. */
const taking =
  'input:not([type=checkbox], [type=button]), select, textarea, [contenteditable], dialog, ' +
  '[popover], [role=slider], [role=grid], [role=listbox], [role=radiogroup], [role=tablist]';
/** What Enter and Delete do is up to the control that has the focus. */
const acting = 'a, button, summary, input, label';

export function forwardKeys(viewer: GirthViewer): void {
  document.addEventListener('keydown', (event) => {
    const [target] = event.composedPath();
    if (event.defaultPrevented || !(target instanceof Element) || target.closest(taking)) return;
    const isForControl = ['Enter', 'Delete', 'Backspace'].includes(event.key);
    if (isForControl && target.closest(acting)) return;
    viewer.press(event);
  });
}
