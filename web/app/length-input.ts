// Lengths that people type: a number in the unit of the page.

import { type LengthFormat, make } from '../src/element/index.js';
import { Draft } from './draft.js';

/** A length in model units from what was typed in the format's unit; undefined for anything else. */
export function readLength(text: string, { scale }: LengthFormat): number | undefined {
  const words = text.trim().replace(',', '.');
  if (words === '') return undefined;
  const number = Number(words);
  return Number.isFinite(number) && number >= 0 ? number / scale : undefined;
}

/** A length in model units as it stands in a field, without its unit. */
export function writeLength(length: number, { scale, decimals }: LengthFormat): string {
  if (!Number.isFinite(length)) return '';
  return String(Number((length * scale).toFixed(Math.min(decimals + 1, 100))));
}

/** Shown where what is typed is no length. */
export const noLength = 'That is no length: type a number from 0 on, such as 1.5.';

/**
 * A field for a length, with its label and the unit behind it. Number and unit belong together: while the
 * number is edited, neither changes.
 */
export class LengthInput {
  readonly input: HTMLInputElement;
  readonly label: HTMLLabelElement;
  readonly #draft: Draft;
  readonly #unit = make('span', { class: 'unit' });
  readonly #changed: (length: number | undefined) => void;
  readonly #wrong: () => void;
  /** Of what stands in the field. */
  #format: LengthFormat | undefined;
  /** Of what will stand there when nothing is edited. */
  #nextFormat: LengthFormat | undefined;
  #length: number | undefined;
  /** The length that was typed last, and how: it stays as it was typed. */
  #typed: { length: number; text: string; format: LengthFormat } | undefined;

  /** `changed`: another length was typed. `wrong`: what was typed is no length, and nothing was changed. */
  constructor(
    id: string,
    words: string,
    changed: (length: number | undefined) => void = () => undefined,
    wrong: () => void = () => undefined,
  ) {
    this.#changed = changed;
    this.#wrong = wrong;
    this.input = make('input', { id, type: 'text', inputmode: 'decimal', autocomplete: 'off' });
    this.label = make(
      'label',
      { for: id, class: 'length' },
      make('span', {}, words),
      this.input,
      this.#unit,
    );
    this.#draft = new Draft(this.input, {
      committed: (text) => this.#take(text),
      ended: () => this.#write(),
    });
  }

  /** In model units; undefined where nothing is typed. */
  get length(): number | undefined {
    return this.#length;
  }

  /** Takes what stands in the field; false where it is no length. */
  commit(): boolean {
    return this.#draft.commit();
  }

  /** Drops what is being typed. */
  discard(): void {
    this.#draft.discard();
  }

  /** Shows a length, or nothing, in a unit. */
  show(length: number | undefined, format: LengthFormat): void {
    this.#length = length;
    this.#nextFormat = format;
    this.#write();
  }

  /** From now on the number that stands in the field, typed or shown, counts in this unit. */
  setUnit(format: LengthFormat): void {
    const text = this.#words();
    const length = readLength(text, format);
    this.#typed = length === undefined ? undefined : { length, text, format };
    this.#length = length;
    this.#nextFormat = this.#format = format;
    this.#unit.textContent = format.unit;
    this.#write();
  }

  #take(text: string): boolean {
    const read = this.#format && readLength(text, this.#format);
    if (read === undefined && text.trim() !== '') {
      this.input.setAttribute('aria-invalid', 'true');
      this.#wrong();
      return false;
    }
    this.#length = read;
    this.#typed = read === undefined ? undefined : { length: read, text, format: this.#format! };
    this.#changed(read);
    return true;
  }

  #write(): void {
    if (this.#draft.isEdited) return;
    this.#format = this.#nextFormat;
    this.#unit.textContent = this.#format?.unit ?? '';
    this.input.setAttribute('aria-invalid', 'false');
    this.#draft.show(this.#words());
  }

  /** The length as it stands in the field when nothing is edited. */
  #words(): string {
    const [length, format, typed] = [this.#length, this.#format, this.#typed];
    if (length === undefined || !format) return '';
    const isTyped =
      typed?.length === length &&
      typed.format.unit === format.unit &&
      typed.format.scale === format.scale;
    return isTyped ? typed.text : writeLength(length, format);
  }
}
