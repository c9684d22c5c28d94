// A panel of the side: a line that opens, with a count, and what is in it.

import { make } from '../../src/element/index.js';
import { byId } from './dom.js';

export class Panel {
  readonly element: HTMLDetailsElement;
  /** The element that the panel's own things go into. */
  readonly body = make('div', { class: 'body' });
  readonly #count = make('span', { class: 'count' });

  constructor(id: string) {
    this.element = byId<HTMLDetailsElement>(id);
    this.element.querySelector('summary')!.append(this.#count);
    this.element.append(this.body);
  }

  get isOpen(): boolean {
    return this.element.open;
  }

  open(): void {
    this.element.open = true;
  }

  /** Opens it where it is seen. */
  reveal(): void {
    this.open();
    this.element.scrollIntoView({ block: 'start' });
  }

  /**
   * Calls back when it is opened or closed: before anything else that people do can come, unlike the `toggle`
   * event, which may be late by many frames.
   */
  onToggle(act: (isOpen: boolean) => void): void {
    let wasOpen = this.isOpen;
    const watcher = new MutationObserver(() => {
      if (this.isOpen === wasOpen) return;
      wasOpen = this.isOpen;
      act(wasOpen);
    });
    watcher.observe(this.element, { attributes: true, attributeFilter: ['open'] });
  }

  /** Calls back when it is about to be opened by hand. */
  onChosen(act: () => void): void {
    this.element.querySelector('summary')!.addEventListener('click', () => {
      if (!this.element.open) act();
    });
  }

  /** The words behind the title; '' for none. */
  set summary(words: string) {
    this.#count.textContent = words;
  }
}
