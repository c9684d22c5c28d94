// Everything that the page can do, read from its own controls when it is asked for: their words, their keys, whether they
// can be used now. The command palette and the list of keys show it, so that neither has words of its own.

import type { GirthViewer } from '../../src/element/index.js';
import type { Action } from './action.js';
import { shortcutsOf } from './shortcuts.js';
import { surfaceActions } from './surface-keys.js';

const controls = 'button, summary, select, input, a[href]';
/** Content is no command: rows of tables and lists, typed values, words that are explained. */
const content =
  'table, .places, .matrix, .term, .link, .parts, .sliders, [type=file], [type=range]';
/** Controls of the tour and of dialogs are no commands; the help's links and those with an id are. */
const elsewhere = '.tour *, dialog:not(#explanation) *, #explanation :not([id], a)';
const places =
  'section[aria-label], [role=group][aria-label], [role=toolbar], .sheet, details, aside';

/** All actions, in the order of the page. */
export function actionsOf(viewer: GirthViewer): Action[] {
  // A closed sheet has to offer the commands that it would offer if it was opened now.
  for (const sheet of document.querySelectorAll('.sheet:not(:popover-open)')) {
    sheet.dispatchEvent(new ToggleEvent('beforetoggle', { oldState: 'closed', newState: 'open' }));
  }
  const ofPage = [...document.body.querySelectorAll<HTMLElement>(controls)].filter(
    (control) => !control.matches(elsewhere) && !control.closest(`${content}, [hidden]`),
  );
  const bar = viewer.shadowRoot?.querySelector('[role=toolbar]');
  // A control counts in a closed menu, too; one that the bar does not offer is hidden itself.
  const ofBar = [...(bar?.querySelectorAll<HTMLElement>(controls) ?? [])].filter(
    (control) => !control.hidden && !control.closest('.tool[hidden]'),
  );
  return [
    ...ofPage.flatMap(actionsFor),
    ...ofBar.filter((control) => !control.hasAttribute('aria-expanded')).flatMap(actionsFor),
    ...surfaceActions(viewer),
  ];
}

function actionsFor(control: HTMLElement): Action[] {
  const words = wordsOf(control);
  if (words === '') return [];
  const common = {
    words,
    place: placeOf(control),
    keys: shortcutsOf(control),
    isOn: false,
    isPossible: !control.matches(':disabled') && control.getAttribute('aria-disabled') !== 'true',
  };
  if (control instanceof HTMLSelectElement) {
    return [...control.options].map((option) => ({
      ...common,
      words: option.text.trim(),
      place: [...common.place, ...(common.place.at(-1) === words ? [] : [words])],
      isOn: option.selected,
      isPossible: common.isPossible && !option.disabled,
      run: () => choose(control, option),
    }));
  }
  const isText = control instanceof HTMLInputElement && !/checkbox|radio/.test(control.type);
  const isOn =
    (control instanceof HTMLInputElement && control.checked) ||
    control.getAttribute('aria-pressed') === 'true';
  return [{ ...common, isOn, run: () => (isText ? goTo(control) : press(control)) }];
}

/** Opens what the control is in, as far as that is closed. */
function reveal(control: HTMLElement): void {
  const sheet = control.closest<HTMLElement>('[popover]');
  if (sheet && !sheet.matches(':popover-open')) sheet.showPopover();
  const isSummary = control instanceof HTMLElement && control.matches('summary');
  const panel = (isSummary ? control.parentElement!.parentElement! : control).closest('details');
  if (panel) panel.open = true;
  if (control.checkVisibility()) control.scrollIntoView({ block: 'nearest' });
}

function goTo(control: HTMLElement): void {
  reveal(control);
  control.focus();
}

function press(control: HTMLElement): void {
  // A panel that is open is gone to, not closed.
  const panel = control.matches('summary') ? (control.parentElement as HTMLDetailsElement) : null;
  if (panel?.open) {
    goTo(control);
    return;
  }
  if (!control.closest('dialog')) reveal(control);
  control.click();
  if (panel) control.focus();
}

function choose(list: HTMLSelectElement, option: HTMLOptionElement): void {
  if (list.closest('[popover]')) reveal(list);
  option.selected = true;
  list.dispatchEvent(new Event('input', { bubbles: true }));
  list.dispatchEvent(new Event('change', { bubbles: true }));
}

/** The name of a control. */
function wordsOf(control: HTMLElement): string {
  const label = (control as Partial<HTMLInputElement>).labels?.[0];
  const named = control.getAttribute('aria-label') ?? textOf(label ?? control);
  const words = (named || control.title).replace(/\s*…$/, '');
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** The words of an element as they are heard: without keys, pictures and what is chosen in it. */
function textOf(element: Element): string {
  const texts = [...element.childNodes].map((node) => {
    if (node instanceof Text) return node.data;
    const isHeard =
      node instanceof HTMLElement && !node.matches('[aria-hidden], .count, kbd, select, input');
    return isHeard ? ` ${textOf(node)} ` : '';
  });
  return texts.join('').replace(/\s+/g, ' ').trim();
}

/** The titles of what a control is in; the side is named only where nothing else is. */
function placeOf(control: HTMLElement): string[] {
  const names: string[] = [];
  const start = control.matches('summary') ? control.parentElement! : control;
  for (let at = start.parentElement?.closest(places); at; at = at.parentElement?.closest(places)) {
    const title = at.querySelector(':scope > h2, :scope > summary h2');
    const name = at.getAttribute('aria-label') ?? (title ? textOf(title) : '');
    if (name !== '' && !(at.matches('aside') && names.length > 0)) names.unshift(name);
  }
  return names;
}
