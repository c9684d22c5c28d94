// Lengths that people type: '28', '28 mm', '1.1in'.

import {
  type LengthFormat,
  findLengthUnit,
  make,
  readLength,
  typedUnit,
} from '../../src/element/index.js';
import { writtenOut } from '../../src/element/plots.js';
import { Draft } from './draft.js';

/**
 * A length in model units as it stands in a field: without its unit and without an exponent, of small ones
 * three digits at least.
 */
export function writeLength(length: number, { scale, decimals }: LengthFormat): string {
  if (!Number.isFinite(length)) return '';
  const value = length * scale;
  const digits = value > 0 ? 2 - Math.floor(Math.log10(value)) : 0;
  const number = writtenOut(value, Math.max(decimals + 1, digits));
  return number.includes('.') ? number.replace(/\.?0+$/, '') : number;
}

/** A value of a field from what was typed in the field's unit, which need not be one of length. */
export function readValue(
  text: string,
  { unit, scale }: LengthFormat,
): { value: number } | { fault: string } {
  const plain = text.replace(/\u2212/g, '-');
  if (unit === '' || findLengthUnit(unit)) {
    const read = readLength(plain, unit);
    if ('length' in read) return { value: read.length / scale };
    if (unit !== '') return read;
  }
  const digits = plain.replace(unit, '').trim().replace(',', '.');
  const number = digits === '' ? NaN : Number(digits);
  if (Number.isFinite(number)) return { value: number / scale };
  return { fault: `“${text}” is not a number: type one such as 1.5` };
}

export interface LengthEvents {
  /** Another length was typed; undefined: the field was emptied. */
  changed?(length: number | undefined): void;
  /** The typed text is no length, for this reason, and changed nothing. */
  wrong?(why: string): void;
  /** A unit was typed where that of the model is not known: it may be taken for the model's. */
  unitTyped?(symbol: string): void;
}

/**
 * A field for a length, with its label and the unit behind it, in which bare numbers count. While it is
 * edited, neither changes.
 */
export class LengthInput {
  readonly input: HTMLInputElement;
  readonly label: HTMLLabelElement;
  readonly #draft: Draft;
  readonly #unit = make('span', { class: 'unit' });
  readonly #events: LengthEvents;
  /** The format of the text in the field. */
  #format: LengthFormat | undefined;
  /** The format of the text that will stand in the field when nothing is edited. */
  #nextFormat: LengthFormat | undefined;
  #length: number | undefined;
  /** The length that was typed last, and how: it stays as it was typed. */
  #typed: { length: number; text: string; format: LengthFormat } | undefined;
  #fault = '';

  constructor(id: string, words: string, events: LengthEvents = {}) {
    this.#events = events;
    this.input = make('input', { id, type: 'text', inputmode: 'text', autocomplete: 'off' });
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

  /** The length in model units; undefined where nothing is typed. */
  get length(): number | undefined {
    return this.#length;
  }

  /** The reason why the text in the field is no length; '' where it is one. */
  get fault(): string {
    return this.#fault;
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

  /** Takes a text as if it had been typed; false where it is no length. */
  type(text: string): boolean {
    this.#draft.discard();
    const isTaken = this.#take(text);
    this.#write();
    return isTaken;
  }

  /**
   * Lengths are those of another unit from now on: a bare number that stands in the field counts in it; a
   * length that was typed with a unit remains what it is.
   */
  setUnit(format: LengthFormat): void {
    const typed = this.#typed;
    const hasUnit = typed !== undefined && typedUnit(typed.text) !== undefined;
    const text = hasUnit ? typed.text : this.#words();
    const read = text === '' ? undefined : lengthIn(text, format);
    const length = read && 'length' in read ? read.length : undefined;
    this.#typed = length === undefined ? undefined : { length, text, format };
    this.#length = length;
    this.#nextFormat = this.#format = format;
    this.#unit.textContent = format.unit;
    this.#write();
  }

  #take(text: string): boolean {
    this.#fault = '';
    if (text.trim() === '') {
      this.#typed = this.#length = undefined;
      this.#events.changed?.(undefined);
      return true;
    }
    const unit = typedUnit(text);
    if (unit && this.#format && !findLengthUnit(this.#format.unit)) {
      this.#events.unitTyped?.(unit.symbol);
    }
    const format = this.#nextFormat ?? this.#format;
    const read = format && lengthIn(text, unit ? format : (this.#format ?? format));
    if (!read || 'fault' in read) {
      this.input.setAttribute('aria-invalid', 'true');
      this.#fault = read ? read.fault : '';
      this.#events.wrong?.(this.#fault);
      return false;
    }
    this.#length = read.length;
    this.#typed = { length: read.length, text, format };
    this.#events.changed?.(read.length);
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
      typedUnit(typed.text) === undefined &&
      typed.format.unit === format.unit &&
      typed.format.scale === format.scale;
    return isTyped ? typed.text : writeLength(length, format);
  }
}

/** A typed length in model units. */
function lengthIn(text: string, { unit, scale }: LengthFormat): ReturnType<typeof readLength> {
  const read = readLength(text, unit);
  return 'fault' in read ? read : { length: read.length / scale };
}
