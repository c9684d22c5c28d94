// The saddles of a pinned point as bars: each from where the growing disk meets itself to where what it cuts
// off is filled. Pointing at a bar shows its loop.

import { type GirthViewer, formatLength, make } from '../../../src/element/index.js';
import type { Barcode, Loop, SaddleBar } from '../../../src/kernel/index.js';
import { failureWords } from '../../widgets/failure-words.js';
import { persistenceOf } from '../field/persistence-choice.js';
import { PointList } from './point-list.js';

/** So many bars are drawn, those that last longest. */
const mostBars = 12;

interface Bar extends SaddleBar {
  loop: Loop;
}

export class PointBarcode {
  readonly element: HTMLElement;
  readonly #point: PointList;
  readonly #bars = make('ol', { class: 'bars' });
  /** The numbers at both ends of the bars' axis. */
  readonly #ends = make('p', { class: 'bar-ends' });
  readonly #words = make('p', { class: 'said', role: 'status' });
  /** The number of the pinned loop whose bars are shown; '' for none. */
  #shownFor = '';
  #barcode: Barcode | undefined;
  /** The bar that is pointed at, or has the focus: its loop is on the surface. */
  #attended: Bar | undefined;
  readonly #viewer: GirthViewer;

  constructor(viewer: GirthViewer) {
    this.#viewer = viewer;
    this.#point = new PointList('barcode-of', 'Loop', () => void this.#find());
    this.element = make(
      'section',
      { class: 'barcode', 'aria-label': 'Saddles of a point' },
      make('h3', {}, 'Saddles of a point'),
      make('p', { class: 'row' }, ...this.#point.parts),
      this.#bars,
      this.#ends,
      this.#words,
      make(
        'p',
        { class: 'hint' },
        'A disk grows from the point over the surface. Where it meets itself is a saddle, with a loop through it: a bar begins. The bar ends where the disk has covered one side of the loop.',
      ),
    );
    this.element.hidden = true;
    viewer.addEventListener('fieldchange', () => this.#draw());
  }

  /** The points have changed, or only how lengths are written. The last one is shown at first. */
  refresh(isOpen: boolean): void {
    const { pinned } = this.#viewer;
    this.element.hidden = pinned.length === 0;
    if (pinned.length === 0 || !isOpen) {
      this.#shownFor = '';
      this.#barcode = undefined;
      this.#attend(undefined);
      this.#draw();
      if (pinned.length === 0) return;
    }
    const points = pinned.map(({ id, name }) => ({ id, name }));
    this.#point.show(points, points.at(-1)!.id);
    if (isOpen) void this.#find();
  }

  async #find(): Promise<void> {
    const viewer = this.#viewer;
    const { pinned, info } = viewer;
    const pin = pinned.find(({ id }) => String(id) === this.#point.chosen);
    if (!pin || !info) return;
    const shownFor = `${pin.id}`;
    if (shownFor !== this.#shownFor) {
      this.#shownFor = shownFor;
      this.#barcode = undefined;
      this.#attend(undefined);
      this.#words.textContent = 'Looking for saddles …';
      try {
        const barcode = await viewer.barcode(pin.loop.base, { loops: true });
        if (shownFor !== this.#shownFor || viewer.info !== info) return;
        this.#barcode = barcode;
        this.#words.textContent = '';
      } catch (error) {
        if (shownFor === this.#shownFor && viewer.info === info) {
          this.#words.textContent = `Not found: ${failureWords(error)}.`;
        }
        return;
      }
    }
    this.#draw();
  }

  /** The bars that last longest, by their births, and the length of the axis. */
  #chosen(): { bars: Bar[]; end: number } {
    const { bars, loops, rest } = this.#barcode!;
    const all = bars.map((bar, i): Bar => ({ ...bar, loop: loops[i]! }));
    const lasting = ({ birth, death }: SaddleBar): number => death - birth;
    const longest = [...all].sort((a, b) => lasting(b) - lasting(a)).slice(0, mostBars);
    const ends = longest.flatMap(({ birth, death }) => (death < Infinity ? [death] : [birth]));
    return {
      bars: longest.sort((a, b) => a.birth - b.birth),
      end: 1.02 * Math.max(rest.length / 2, ...ends),
    };
  }

  #draw(): void {
    this.#ends.hidden = !this.#barcode;
    if (!this.#barcode) {
      this.#bars.replaceChildren();
      return;
    }
    const { bars, end } = this.#chosen();
    this.#ends.replaceChildren(
      make('span', {}, '0'),
      make('span', {}, `${formatLength(end, this.#viewer.lengthFormat)} from the point`),
    );
    const tau = persistenceOf(this.#viewer);
    const girth = bars.find(({ birth, death }) => death - birth > tau);
    const focused = [...this.#bars.querySelectorAll('button')].findIndex(
      (button) => button === document.activeElement,
    );
    this.#bars.replaceChildren(
      ...bars.map((bar) => make('li', {}, this.#button(bar, end, bar === girth, tau))),
    );
    this.#bars.querySelectorAll('button')[focused]?.focus();
    const hidden = this.#barcode.bars.length - bars.length;
    if (bars.length === 0) {
      this.#words.textContent = 'No saddle: the loop goes there and back.';
    } else if (!this.#attended) {
      this.#words.textContent = hidden > 0 ? `${hidden} shorter ones are not drawn.` : '';
    }
  }

  #button(bar: Bar, end: number, isGirth: boolean, tau: number): HTMLButtonElement {
    const { birth, death } = bar;
    const span = make('span');
    span.style.insetInlineStart = `${(100 * birth) / end}%`;
    span.style.inlineSize = `${(100 * (Math.min(death, end) - birth)) / end}%`;
    const passed = death - birth <= tau;
    const kind = `${isGirth ? ' girth' : ''}${passed ? ' passed' : ''}${death < Infinity ? '' : ' endless'}`;
    const button = make(
      'button',
      { type: 'button', class: `bar${kind}`, 'aria-label': this.#wordsOf(bar) },
      span,
    );
    for (const event of ['pointerenter', 'focus']) {
      button.addEventListener(event, () => this.#attend(bar));
    }
    for (const event of ['pointerleave', 'blur']) {
      button.addEventListener(event, () => this.#attend(undefined));
    }
    return button;
  }

  #wordsOf({ birth, death }: Bar): string {
    const { lengthFormat, info } = this.#viewer;
    const loop = `Loop of ${formatLength(2 * birth, lengthFormat)}`;
    if (death === Infinity) return `${loop}: no side is ever filled`;
    const lasts = death - birth;
    const percent = ((100 * lasts) / Math.sqrt(info?.area ?? 1)).toPrecision(2);
    return `${loop}: a side is filled ${formatLength(lasts, lengthFormat)} farther (${Number(percent)}\u202f% of √area)`;
  }

  #attend(bar: Bar | undefined): void {
    if (bar === this.#attended) return;
    this.#attended = bar;
    const viewer = this.#viewer;
    if (viewer.info) viewer.showPath(bar?.loop);
    this.#words.textContent = bar ? `${this.#wordsOf(bar)}.` : '';
  }
}
