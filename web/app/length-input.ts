// Lengths that people type or push: a number in the unit of the page, and a slider for it.

import { type LengthFormat, make } from '../src/element/index.js';

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

/** Said of what is typed and is none. */
export const noLength = 'That is no length: type a number from 0 on, such as 1.5.';

/** A field for a length, with its label and the unit behind it. */
export class LengthInput {
  readonly input: HTMLInputElement;
  readonly label: HTMLLabelElement;
  private readonly unit = make('span', { class: 'unit' });
  private format: LengthFormat | undefined;
  private length: number | undefined;

  /** `wrong`: what was typed is no length, and nothing was changed. */
  constructor(
    id: string,
    words: string,
    changed: (length: number | undefined) => void,
    wrong: () => void = () => undefined,
  ) {
    this.input = make('input', { id, type: 'text', inputmode: 'decimal', autocomplete: 'off' });
    this.label = make(
      'label',
      { for: id, class: 'length' },
      make('span', {}, words),
      this.input,
      this.unit,
    );
    this.input.addEventListener('change', () => {
      const read = this.format && readLength(this.input.value, this.format);
      const isWrong = read === undefined && this.input.value.trim() !== '';
      this.input.setAttribute('aria-invalid', String(isWrong));
      if (isWrong) {
        wrong();
        return;
      }
      this.length = read;
      changed(read);
    });
  }

  /** In model units; undefined where nothing is typed. */
  get value(): number | undefined {
    return this.length;
  }

  set value(length: number | undefined) {
    this.length = length;
    this.write();
  }

  /** Whether what stands there is no length. */
  get isWrong(): boolean {
    return this.input.getAttribute('aria-invalid') === 'true';
  }

  show(format: LengthFormat): void {
    this.format = format;
    this.unit.textContent = format.unit;
    this.write();
  }

  private write(): void {
    this.input.setAttribute('aria-invalid', 'false');
    this.input.value =
      this.length === undefined || !this.format ? '' : writeLength(this.length, this.format);
  }
}
