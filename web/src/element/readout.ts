// Words on the surface: the length beside the pointer, and a tag on every pinned loop.

import type { Loop } from '../kernel/types.js';
import { type LengthFormat, type ScreenPoint, formatLength } from '../view/index.js';
import { make } from './dom.js';

/** CSS pixels between the pointer and the length. */
const gap = 18;
/** CSS pixels between a tag and the loop that it is about. */
const tagGap = 14;

/** What the kind of a loop means, in a word and in a sentence; a plain loop needs none. */
export const kindWords = {
  loop: { name: 'loop', sentence: '' },
  antipodal: {
    name: 'there and back',
    sentence: 'There and back to the farthest point; no loop here is shorter.',
  },
  unresolved: {
    name: 'or more',
    sentence: 'The search was given up; the loop here is at least as long.',
  },
} as const;

export class Readout {
  readonly element = make('div', { class: 'readout' });
  readonly #length = make('b');
  readonly #kind = make('span');
  readonly #words = make('small');

  constructor() {
    this.element.append(this.#length, this.#kind, this.#words);
    this.clear();
  }

  show(loop: Loop, format: LengthFormat): void {
    this.element.hidden = false;
    this.element.dataset['base'] = JSON.stringify(loop.base);
    this.element.dataset['length'] = String(loop.length);
    this.element.dataset['kind'] = loop.kind;
    this.#length.textContent = formatLength(loop.length, format);
    const { name, sentence } = kindWords[loop.kind];
    this.#kind.textContent = name;
    this.#words.textContent = sentence;
    this.#words.hidden = sentence === '';
  }

  /** Beside a point of the canvas of the given size, on the side where there is room. */
  place(x: number, y: number, width: number, height: number): void {
    const { offsetWidth, offsetHeight } = this.element;
    const right = x + gap + offsetWidth > width - 4;
    const left = right ? Math.max(4, x - gap - offsetWidth) : x + gap;
    const above = y - gap - offsetHeight;
    const top = above < 4 ? Math.min(height - offsetHeight - 4, y + gap) : above;
    this.element.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
  }

  clear(): void {
    this.element.hidden = true;
  }
}

export class PinTag {
  readonly element = make('div', { class: 'tag' });
  readonly #name = make('b');
  readonly #length = make('span');
  #size: { width: number; height: number } | undefined;
  #spot = { x: 0, y: 0 };
  readonly number: number;
  readonly #loop: Loop;

  constructor(number: number, loop: Loop, remove: () => void) {
    this.number = number;
    this.#loop = loop;
    const cross = make('button', { class: 'cross', type: 'button' }, '✕');
    cross.setAttribute('aria-label', `Remove pinned loop ${number}`);
    cross.addEventListener('click', remove);
    this.element.append(make('i', {}, String(number)), this.#name, this.#length, cross);
  }

  setName(name: string): void {
    this.#name.textContent = name;
    this.#size = undefined;
  }

  setFormat(format: LengthFormat): void {
    this.#length.textContent = formatLength(this.#loop.length, format);
    this.#size = undefined;
  }

  /**
   * Beside what is measured, on the outer side of a canvas of the given size, never cut off by its edge;
   * `point` is half way round.
   */
  place(
    point: ScreenPoint,
    { left, right, middle }: { left: number; right: number; middle: number },
    width: number,
    height: number,
  ): void {
    this.#size ??= { width: this.element.offsetWidth, height: this.element.offsetHeight };
    const isLeft = left + right < width && left - tagGap - this.#size.width > 4;
    const beside = isLeft ? left - tagGap - this.#size.width : right + tagGap;
    const x = Math.max(4, Math.min(width - this.#size.width - 4, beside));
    const y = Math.max(4, Math.min(height - this.#size.height - 4, middle - 14));
    this.element.classList.toggle('behind', !point.visible);
    this.element.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
    this.#spot = { x, y };
  }

  /** What is written on it, and where it is, for a picture. */
  get label(): { words: string; x: number; y: number } {
    const words = [String(this.number), this.#name.textContent, this.#length.textContent];
    return { words: words.filter(Boolean).join(' '), ...this.#spot };
  }
}
