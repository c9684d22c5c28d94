// Failures in words, where the user looks.

import type { GirthErrorFields, UnreadableModel } from '../../kernel/types/types.js';
import type { Graphics } from '../../view/index.js';
import { make } from './dom.js';
import { noGraphics } from './no-graphics.js';
import { sentence } from './sentence.js';

/** Names of models that cannot be read that are written out; of further ones only the number. */
const mostNamed = 4;

export class MessageBox {
  readonly element = make('div', { class: 'message', role: 'alert' });
  readonly #what = make('p');
  readonly #remedy = make('p');

  constructor() {
    const close = make(
      'button',
      { class: 'cross', type: 'button', 'aria-label': 'Dismiss the message' },
      '✕',
    );
    close.addEventListener('click', () => this.clear());
    this.element.append(make('div', {}, this.#what, this.#remedy), close);
    this.clear();
  }

  /** `name` is the file's; `kept`: whether the previous model is still shown. */
  show(name: string, error: GirthErrorFields, kept: boolean): void {
    this.element.hidden = false;
    this.element.dataset['code'] = error.code;
    // Where the program is missing, no model is to blame.
    const blamed = error.code === 'PROGRAM_NOT_LOADED' ? '' : name;
    const before = blamed ? `${blamed} could not be used. ` : '';
    this.#what.textContent = `${before}${sentence(error.message)}`;
    this.#remedy.textContent = [
      error.hint ? `What helps: ${error.hint.replace(/[.\s]+$/, '')}.` : '',
      kept ? 'The former model is still here.' : '',
    ]
      .filter(Boolean)
      .join(' ');
  }

  /** Tells which of several models were passed over, and that `shown` was taken instead. */
  showPassedOver(unreadable: readonly UnreadableModel[], shown: string): void {
    const [first] = unreadable;
    if (!first) return;
    this.element.hidden = false;
    this.element.dataset['code'] = first.error.code;
    const words = unreadable
      .slice(0, mostNamed)
      .map(({ model, error }) => `${model} could not be used. ${sentence(error.message)}`);
    const more = unreadable.length - words.length;
    if (more > 0) words.push(`Nor could ${more} more.`);
    this.#what.textContent = words.join(' ');
    this.#remedy.textContent = `${shown} is shown instead.`;
  }

  /** Tells why there is no picture, until there is one. */
  showGraphics(graphics: Graphics): void {
    if (graphics !== 'drawing') this.show('', noGraphics[graphics], false);
    else if (this.element.dataset['code'] === noGraphics.lost.code) this.clear();
  }

  clear(): void {
    this.element.hidden = true;
    delete this.element.dataset['code'];
  }
}
