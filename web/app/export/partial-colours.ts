// A question before a picture is saved whose colours are not all there.

import { type GirthViewer, fieldTitle, isFieldName, make } from '../../src/element/index.js';
import type { FieldName } from '../../src/kernel/index.js';
import { failureWords } from '../widgets/failure-words.js';

export class PartialColours {
  readonly element = make('div', { class: 'partial-colours', role: 'status', hidden: '' });
  readonly #words = make('p', { class: 'hint' });
  readonly #viewer: GirthViewer;
  readonly #save: () => Promise<void>;
  #isWaiting = false;

  constructor(viewer: GirthViewer, save: () => Promise<void>) {
    this.#viewer = viewer;
    this.#save = save;
    const wait = make('button', { type: 'button', class: 'plain' }, 'Wait and save');
    const now = make('button', { type: 'button', class: 'plain' }, 'Save as it is');
    wait.addEventListener('click', () => void this.#saveWhole());
    now.addEventListener('click', () => {
      this.leave();
      void save();
    });
    this.element.append(this.#words, make('p', { class: 'buttons' }, wait, now));
  }

  /** Asks about a field that is computed in part. */
  ask(name: FieldName): void {
    const percent = Math.min(99, Math.round(100 * this.#viewer.shareOf(name)));
    this.#words.textContent = `${fieldTitle(name)}: ${percent}% of the vertices are computed.`;
    this.element.hidden = false;
    this.element.scrollIntoView({ block: 'nearest' });
  }

  /** Forgets a question that was not answered; what is waited for stays. */
  leave(): void {
    this.element.hidden = !this.#isWaiting;
  }

  async #saveWhole(): Promise<void> {
    const viewer = this.#viewer;
    const name = viewer.shown?.name;
    if (!name || !isFieldName(name) || this.#isWaiting) return;
    this.#isWaiting = true;
    this.#words.textContent = `${fieldTitle(name)} is being computed. The picture is saved after it.`;
    try {
      await viewer.fieldOf(name);
      // The colours are drawn in the frame after the last values.
      await new Promise((resolve) => requestAnimationFrame(resolve));
      this.element.hidden = true;
      await this.#save();
    } catch (error) {
      this.#words.textContent = `Not saved: ${failureWords(error)}.`;
    } finally {
      this.#isWaiting = false;
    }
  }
}
