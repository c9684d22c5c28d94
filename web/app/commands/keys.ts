// Keys work wherever the focus is, but not while somebody types or moves a control: those of the page's controls, and
// those that move the surface.

import type { GirthViewer } from '../../src/element/index.js';
import { isPressed, shortcutsOf, withKeys } from './shortcuts.js';

/** Controls that take letters, digits or arrows for themselves. */
const taking =
  'input:not([type=checkbox], [type=button]), select, textarea, [contenteditable], dialog, ' +
  '[popover], [role=slider], [role=grid], [role=listbox], [role=radiogroup], [role=tablist]';
/** Controls that act on Enter or Delete themselves while they have the focus. */
const acting = 'a, button, summary, input, label';
/** Text is undone by the browser, where it is typed; other keys with Ctrl mean nothing there. */
const typing =
  'input:not([type=checkbox], [type=radio], [type=range], [type=button]), textarea, select';
const ofText = /^((Control|Meta)\+(Shift\+)?[YZ]|[^+]+)$/;

export function forwardKeys(viewer: GirthViewer): void {
  document.addEventListener('keydown', (event) => {
    const [target] = event.composedPath();
    if (event.defaultPrevented || !(target instanceof Element) || target.closest(taking)) return;
    const isForControl = ['Enter', 'Delete', 'Backspace'].includes(event.key);
    if (isForControl && target.closest(acting)) return;
    viewer.press(event);
  });
}

/** Makes the keys that controls say they have press them, and writes them into their titles. */
export function pressControls(): void {
  const controls = [...document.querySelectorAll<HTMLElement>('[aria-keyshortcuts]')];
  for (const control of controls) {
    const words = control.getAttribute('aria-label') ?? control.innerText.replace(/\s*…?\s*$/, '');
    control.title = withKeys(words, control);
  }
  document.addEventListener('keydown', (event) => {
    const [target] = event.composedPath();
    if (event.defaultPrevented || !(target instanceof Element) || target.closest('dialog[open]'))
      return;
    // The palette's own field may have the focus for a moment after it was closed.
    const isTyping = target.closest(typing)?.checkVisibility() ?? false;
    for (const control of controls) {
      const shortcut = shortcutsOf(control).find((one) => isPressed(one, event));
      if (!shortcut || (ofText.test(shortcut) && isTyping)) continue;
      event.preventDefault();
      control.click();
      return;
    }
  });
}
