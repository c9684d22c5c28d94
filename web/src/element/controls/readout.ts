// Words on the surface: the length beside the pointer, and a tag on every pinned loop.

import type { Loop, SurfacePoint } from '../../kernel/types/types.js';
import { type Box, type LengthFormat, formatLength } from '../../view/index.js';
import { make } from './dom.js';

/** CSS pixels between the pointer and the length. */
const gap = 18;

/** The meaning of a loop's kind, in a word and in a sentence; a plain loop needs none. */
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
  #spot: { left: number; top: number } | undefined;

  constructor() {
    this.element.append(this.#length, this.#kind, this.#words);
    this.clear();
  }

  /** `coloured`: the length that the colour at the loop's point stands for, where it is another one. */
  show({ base, length, kind }: Loop, format: LengthFormat, coloured?: number): void {
    const { name, sentence } = kindWords[kind];
    const colour =
      coloured === undefined
        ? ''
        : `The colour stands for ${formatLength(coloured, format)}, computed on fewer triangles.`;
    const words = [sentence, colour].filter(Boolean).join(' ');
    this.#say(base, formatLength(length, format), name, words);
    this.element.dataset['length'] = String(length);
    this.element.dataset['kind'] = kind;
  }

  /** The length at a point whose loop is still to come. */
  showLength(base: SurfacePoint, length: number, format: LengthFormat): void {
    this.#say(base, formatLength(length, format), '', 'Read off the colours; the loop follows.');
    this.element.dataset['length'] = String(length);
    delete this.element.dataset['kind'];
  }

  #say(base: SurfacePoint, length: string, kind: string, sentence: string): void {
    this.element.hidden = false;
    this.element.dataset['base'] = JSON.stringify(base);
    this.#length.textContent = length;
    this.#kind.textContent = kind;
    this.#words.textContent = sentence;
    this.#words.hidden = sentence === '';
  }

  /** Beside a point of the canvas of the given size, on the side where there is room and nothing else is. */
  place(x: number, y: number, width: number, height: number, others: readonly Box[]): void {
    const { offsetWidth, offsetHeight } = this.element;
    const within = (value: number, size: number, most: number): number =>
      Math.max(4, Math.min(most - size - 4, value));
    const places = [y - gap - offsetHeight, y + gap].flatMap((top) =>
      [x + gap, x - gap - offsetWidth].map((left) => ({
        left: within(left, offsetWidth, width),
        top: within(top, offsetHeight, height),
      })),
    );
    const isFree = ({ left, top }: { left: number; top: number }): boolean => {
      const isOver = (box: Box): boolean =>
        left < box.left + box.width &&
        box.left < left + offsetWidth &&
        top < box.top + box.height &&
        box.top < top + offsetHeight;
      return !others.some(isOver) && !isOver({ left: x, top: y, width: 0, height: 0 });
    };
    this.moveTo(places.find(isFree) ?? places[0]!);
  }

  /** The place of the readout, while it is shown. */
  get spot(): { left: number; top: number } | undefined {
    return this.#spot;
  }

  get size(): { width: number; height: number } {
    return { width: this.element.offsetWidth, height: this.element.offsetHeight };
  }

  moveTo(spot: { left: number; top: number }): void {
    this.#spot = spot;
    this.element.style.transform = `translate(${Math.round(spot.left)}px, ${Math.round(spot.top)}px)`;
  }

  clear(): void {
    this.element.hidden = true;
    this.#spot = undefined;
  }
}

/** A tag as a picture has it, in CSS pixels. */
export interface TagLabel {
  words: string;
  x: number;
  y: number;
  /** The end of the line to the loop. */
  end: { x: number; y: number };
}

export class PinTag {
  readonly element = make('div', { class: 'tag' });
  readonly #name = make('b');
  readonly #length = make('span');
  /** The line from the tag to its loop. */
  readonly leader = document.createElementNS('http://www.w3.org/2000/svg', 'line');
  #size: { width: number; height: number } | undefined;
  #spot: { left: number; top: number } | undefined;
  #end = { x: 0, y: 0 };
  readonly number: number;
  #loop: Loop;

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

  /** Another loop of the same point. */
  setLoop(loop: Loop, format: LengthFormat): void {
    this.#loop = loop;
    this.setFormat(format);
  }

  /** The size of the tag, in CSS pixels. */
  get size(): { width: number; height: number } {
    return (this.#size ??= { width: this.element.offsetWidth, height: this.element.offsetHeight });
  }

  /** The top left corner of the tag on the canvas; undefined before it was placed. */
  get spot(): { left: number; top: number } | undefined {
    return this.#spot;
  }

  place(spot: { left: number; top: number }): void {
    this.#spot = spot;
    this.element.style.transform = `translate(${Math.round(spot.left)}px, ${Math.round(spot.top)}px)`;
  }

  /** Draws the line to the nearest of these points of the loop. */
  pointAt(points: readonly { x: number; y: number }[], isHidden: boolean): void {
    const { left, top } = this.#spot ?? { left: 0, top: 0 };
    const box: Box = { left, top, ...this.size };
    const inside = (value: number, from: number, size: number): number =>
      Math.max(from, Math.min(from + size, value));
    let shortest = Infinity;
    let begin = { x: left, y: top };
    for (const { x, y } of points) {
      const near = { x: inside(x, left, box.width), y: inside(y, top, box.height) };
      const distance = Math.hypot(x - near.x, y - near.y);
      if (distance < shortest) [shortest, begin, this.#end] = [distance, near, { x, y }];
    }
    const ends = { x1: begin.x, y1: begin.y, x2: this.#end.x, y2: this.#end.y };
    for (const [name, value] of Object.entries(ends)) {
      this.leader.setAttribute(name, value.toFixed(1));
    }
    this.element.classList.toggle('behind', isHidden);
  }

  remove(): void {
    this.element.remove();
    this.leader.remove();
  }

  /** The words of the tag, its place, and the end of its line, for a picture. */
  get label(): TagLabel {
    const words = [String(this.number), this.#name.textContent, this.#length.textContent];
    const { left: x, top: y } = this.#spot ?? { left: 0, top: 0 };
    return { words: words.filter(Boolean).join(' '), x, y, end: this.#end };
  }
}
