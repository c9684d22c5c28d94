// The text of a control, and the draft that somebody is making in it.
//
// One rule for every control of the page: what is being edited is never overwritten. A draft begins with the
// first `input` event and ends when it is committed (`change`, Enter, a submit), reverted (Escape) or
// discarded by the owner because it has lost its meaning, for example with another model. Texts that the page wants to
// show meanwhile wait and appear when the draft ends. No other file writes `control.value`.

/** Any input, slider or list. */
export interface EditableControl extends EventTarget {
  value: string;
}

export interface DraftEvents {
  /**
   * The draft has changed: a letter was typed, or a slider moved that is still held. A returned text takes
   * its place, for example where a slider meets its neighbour.
   */
  edited?(text: string): string | void;
  /** The draft is to be taken. False: it cannot be; it stays in the control and stays a draft. */
  committed?(text: string): boolean | void;
  /** Nothing is edited any more, for whatever reason. */
  ended?(): void;
}

export class Draft {
  readonly #control: EditableControl;
  readonly #events: DraftEvents;
  /** The text that the page wants the control to show. */
  #shown: string;
  /** How often `show` was called: an owner may show its own form of what it takes. */
  #shows = 0;
  /** The text that stood in the control before the draft; undefined without a draft. */
  #before: string | undefined;
  #isCommitting = false;

  constructor(control: EditableControl, events: DraftEvents = {}) {
    this.#control = control;
    this.#events = events;
    this.#shown = control.value;
    control.addEventListener('input', () => this.#edit());
    control.addEventListener('change', () => this.commit());
    control.addEventListener('blur', () => this.#leave());
    // A slider that was dragged and put back reports no change.
    for (const release of ['pointerup', 'pointercancel']) {
      control.addEventListener(release, () => this.#endUnchanged());
    }
    control.addEventListener('keydown', (event) => {
      if (!this.isEdited || (event as KeyboardEvent).key !== 'Escape') return;
      // The first Escape is for the draft, the next one for the sheet that the control is on.
      event.preventDefault();
      this.discard();
    });
  }

  /** Whether somebody is editing the control, or has left text in it that could not be taken. */
  get isEdited(): boolean {
    return this.#before !== undefined;
  }

  /** The text in the control: the draft, or what is shown. */
  get text(): string {
    return this.#control.value;
  }

  /** Shows a text as soon as nothing is edited. */
  show(text: string): void {
    this.#shown = text;
    ++this.#shows;
    this.#write();
  }

  /** Takes the draft as `change` does; false where it cannot be taken. Without a draft nothing happens. */
  commit(): boolean {
    const text = this.text;
    if (this.#isCommitting || (!this.isEdited && text === this.#shown)) return true;
    this.#before ??= this.#shown;
    const shows = this.#shows;
    this.#isCommitting = true;
    try {
      if (this.#events.committed?.(text) === false) return false;
    } finally {
      this.#isCommitting = false;
    }
    if (shows === this.#shows) this.#shown = text;
    this.#end();
    return true;
  }

  /** Drops the draft and shows what the page has. */
  discard(): void {
    if (this.isEdited) this.#end();
  }

  #edit(): void {
    this.#before ??= this.#shown;
    const corrected = this.#events.edited?.(this.text);
    if (typeof corrected === 'string' && corrected !== this.text) this.#control.value = corrected;
  }

  #leave(): void {
    this.#endUnchanged();
    if (this.isEdited) this.commit();
  }

  #endUnchanged(): void {
    if (this.text === this.#before) this.#end();
  }

  #end(): void {
    this.#before = undefined;
    this.#write();
    this.#events.ended?.();
  }

  #write(): void {
    // A text that is set again would move the cursor.
    if (this.isEdited || this.text === this.#shown) return;
    this.#control.value = this.#shown;
    // The control may change a text: sliders round, lists know only their choices.
    this.#shown = this.#control.value;
  }
}
