// A text that somebody is editing is never overwritten: the rule that all controls of the page keep.

import { expect, test, vi } from 'vitest';
import { Draft, type DraftEvents } from '../../../web/app/widgets/draft.js';

/** A control as browsers have it: what is typed is reported, what is written is not. */
class Control extends EventTarget {
  #value = '';

  /** `sanitise`: what the control makes of a text, as sliders round. */
  constructor(readonly sanitise = (text: string): string => text) {
    super();
  }

  get value(): string {
    return this.#value;
  }

  set value(text: string) {
    this.#value = this.sanitise(text);
  }

  type(text: string): void {
    this.value = text;
    this.dispatchEvent(new Event('input'));
  }

  /** Leaves the control; browsers report a change first, if there is one. */
  leave(isChanged = true): void {
    if (isChanged) this.dispatchEvent(new Event('change'));
    this.dispatchEvent(new Event('blur'));
  }

  press(key: string): Event {
    const event = Object.assign(new Event('keydown', { cancelable: true }), { key });
    this.dispatchEvent(event);
    return event;
  }
}

function drafted(events: DraftEvents = {}): { control: Control; draft: Draft } {
  const control = new Control();
  const draft = new Draft(control, events);
  draft.show('1');
  return { control, draft };
}

test('what the page shows stands there at once as long as nobody edits', () => {
  const { control, draft } = drafted();
  expect(control.value).toBe('1');
  draft.show('2');
  expect(control.value).toBe('2');
  expect(draft.isEdited).toBe(false);
});

test('what is being typed stays, however often the page shows something else', () => {
  const { control, draft } = drafted();
  control.type('3');
  for (const text of ['1', '2', '']) draft.show(text);
  expect(control.value).toBe('3');
  control.type('');
  draft.show('4');
  expect(control.value).toBe('');
  expect(draft.isEdited).toBe(true);
});

test('a draft that was put back as it was ends, and what has come meanwhile appears', () => {
  const { control, draft } = drafted();
  control.type('12');
  draft.show('7');
  control.type('1');
  control.leave(false);
  expect(control.value).toBe('7');
  expect(draft.isEdited).toBe(false);
});

test('a slider that was dragged and put back is free again when it is let go', () => {
  const { control, draft } = drafted();
  control.type('5');
  draft.show('2');
  control.dispatchEvent(new Event('pointercancel'));
  expect(control.value).toBe('5');
  control.type('1');
  control.dispatchEvent(new Event('pointerup'));
  expect(control.value).toBe('2');
});

test('a change takes the draft once; the owner may show its own form of it', () => {
  const committed = vi.fn((text: string) => draft.show(text.trim()));
  const { control, draft } = drafted({ committed });
  control.type(' 3 ');
  control.leave();
  expect(committed.mock.calls).toEqual([[' 3 ']]);
  expect(control.value).toBe('3');
  // Without a word of the owner it stays as it was typed.
  committed.mockImplementation(() => undefined);
  control.type(' 4 ');
  control.leave();
  expect(control.value).toBe(' 4 ');
  expect(draft.isEdited).toBe(false);
});

test('a submit takes what was typed, though no change was reported yet', () => {
  const committed = vi.fn();
  const { control, draft } = drafted({ committed });
  expect(draft.commit()).toBe(true);
  expect(committed).not.toHaveBeenCalled();
  control.type('3');
  draft.show('');
  expect(draft.commit()).toBe(true);
  expect(committed.mock.calls).toEqual([['3']]);
  control.leave();
  expect(committed).toHaveBeenCalledTimes(1);
});

test('leaving takes a draft even where the browser reports no change', () => {
  const committed = vi.fn();
  const { control } = drafted({ committed });
  control.type('3');
  control.leave(false);
  expect(committed.mock.calls).toEqual([['3']]);
});

test('what cannot be taken stays to be mended', () => {
  const committed = vi.fn((text: string) => text !== 'three');
  const { control, draft } = drafted({ committed });
  control.type('three');
  expect(draft.commit()).toBe(false);
  control.leave();
  draft.show('9');
  expect(control.value).toBe('three');
  expect(draft.isEdited).toBe(true);
  control.type('3');
  expect(draft.commit()).toBe(true);
  expect(control.value).toBe('3');
});

test('Escape reverts to what the page has by now; a second Escape is for somebody else', () => {
  const ended = vi.fn();
  const { control, draft } = drafted({ ended });
  control.type('3');
  draft.show('2');
  expect(control.press('a').defaultPrevented).toBe(false);
  expect(control.press('Escape').defaultPrevented).toBe(true);
  expect(control.value).toBe('2');
  expect(ended).toHaveBeenCalledTimes(1);
  expect(control.press('Escape').defaultPrevented).toBe(false);
});

test('the owner discards what has lost its meaning', () => {
  const committed = vi.fn();
  const { control, draft } = drafted({ committed });
  control.type('3');
  draft.discard();
  expect(control.value).toBe('1');
  control.leave(false);
  expect(committed).not.toHaveBeenCalled();
});

test('each step of an edit is reported, and may be corrected', () => {
  const edited = vi.fn((text: string) => (Number(text) > 8 ? '8' : undefined));
  const { control, draft } = drafted({ edited });
  control.type('3');
  control.type('9');
  expect(edited.mock.calls).toEqual([['3'], ['9']]);
  expect(control.value).toBe('8');
  expect(draft.text).toBe('8');
});

test('taking a draft may move the focus away without taking it twice', () => {
  const committed = vi.fn(() => control.leave(false));
  const { control } = drafted({ committed });
  control.type('3');
  control.dispatchEvent(new Event('change'));
  expect(committed).toHaveBeenCalledTimes(1);
});

test('a control that rounds what it is given is not taken for edited', () => {
  const committed = vi.fn();
  const control = new Control((text) => String(Math.round(Number(text))));
  const draft = new Draft(control, { committed });
  draft.show('3.4');
  expect(draft.commit()).toBe(true);
  control.type('5');
  control.type('3');
  control.leave(false);
  expect(committed).not.toHaveBeenCalled();
  expect(draft.isEdited).toBe(false);
});
