// Explains the words that not everybody knows: pointing at one, focusing it or tapping it shows its two lines and its
// picture (`terms.ts`).

import { make } from '../../src/element/index.js';
import { explains } from './term.js';
import { type TermName, termNames, terms } from './terms.js';

/** Milliseconds: a pointer that only passes by asks nothing, and one on its way to the words loses nothing. */
const showDelay = 250;
const hideDelay = 300;
/** CSS pixels between the words and what they are about, and the edge of the window. */
const gap = 10;

/** Explains every element of the page that has `data-term`, also such as come later. */
export function explainTerms(): void {
  const explanation = new Explanation();
  // Screen readers have the words before the picture is there.
  document.body.append(
    ...termNames.map((name) =>
      make('p', { id: `term-${name}`, hidden: '' }, terms[name].lines.join(' ')),
    ),
  );
  for (const button of document.querySelectorAll<HTMLButtonElement>('button[data-term]')) {
    explains(button, termOf(button));
  }
  explanation.listen();
}

function termOf(element: HTMLElement): TermName | undefined {
  return termNames.find((name) => name === element.dataset['term']);
}

/** The term that an event is about; undefined beside all terms. */
function askedAt(event: Event): HTMLElement | undefined {
  const { target } = event;
  if (!(target instanceof Element)) return undefined;
  return target.closest<HTMLElement>('[data-term]') ?? undefined;
}

class Explanation {
  readonly #picture = make('img', { alt: '', width: '112', height: '84' });
  readonly #title = make('b');
  readonly #lines = [make('span'), make('span')] as const;
  readonly #element = make(
    'div',
    { class: 'explained', popover: 'manual', role: 'tooltip' },
    this.#picture,
    make('p', {}, this.#title, this.#lines[0], ' ', this.#lines[1]),
  );
  #anchor: HTMLElement | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    // The explanation is in the top layer anyway; for screen readers it belongs within a landmark
    // of the page.
    document.querySelector('main')!.append(this.#element);
  }

  listen(): void {
    document.addEventListener('pointerover', (event) => {
      if (event.pointerType !== 'mouse') return;
      const anchor = askedAt(event);
      const isInside = event.target instanceof Node && this.#element.contains(event.target);
      if (isInside || (anchor && anchor === this.#anchor)) this.#later(undefined);
      else if (anchor) this.#later(() => this.#show(anchor), showDelay);
      else this.#later(this.#anchor && (() => this.#hide()), hideDelay);
    });
    document.addEventListener('focusin', (event) => {
      const anchor = askedAt(event);
      // Only terms on buttons are explained on focus: a control that has it is about to be used.
      if (anchor instanceof HTMLButtonElement && anchor.matches(':focus-visible')) {
        this.#show(anchor);
      }
    });
    document.addEventListener('focusout', () => this.#hide());
    document.addEventListener('pointerdown', (event) => {
      const anchor = askedAt(event);
      if (anchor !== this.#anchor || !(anchor instanceof HTMLButtonElement)) this.#hide();
    });
    document.addEventListener('click', (event) => {
      const anchor = askedAt(event);
      if (!(anchor instanceof HTMLButtonElement)) return;
      if (anchor === this.#anchor && event.pointerType === 'touch') this.#hide();
      else this.#show(anchor);
    });
    document.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.#anchor) return;
      // Escape also closes the sheet that the word is on.
      this.#hide();
    });
    for (const moved of ['scroll', 'resize']) {
      window.addEventListener(
        moved,
        () => this.#anchor && this.#place(this.#anchor.getBoundingClientRect()),
        { capture: true, passive: true },
      );
    }
  }

  #later(act: (() => void) | undefined, delay = 0): void {
    clearTimeout(this.#timer);
    this.#timer = act && setTimeout(act, delay);
  }

  #show(anchor: HTMLElement): void {
    this.#later(undefined);
    const name = termOf(anchor);
    if (!name || !anchor.isConnected) return;
    const { title, lines, picture } = terms[name];
    this.#anchor = anchor;
    this.#title.textContent = title;
    this.#lines.forEach((line, i) => (line.textContent = lines[i]!));
    if (this.#picture.src !== picture.href) this.#picture.src = picture.href;
    if (!this.#element.matches(':popover-open')) this.#element.showPopover();
    this.#place(anchor.getBoundingClientRect());
  }

  #hide(): void {
    this.#later(undefined);
    this.#anchor = undefined;
    if (this.#element.matches(':popover-open')) this.#element.hidePopover();
  }

  /** Beside the panels, so that it covers nothing of them; where there is no room, above the word or below. */
  #place(anchor: DOMRect): void {
    const element = this.#element;
    const { offsetWidth: width, offsetHeight: height } = element;
    const side = document.querySelector('aside')?.getBoundingClientRect();
    const isInSide = side !== undefined && anchor.left >= side.left && anchor.right <= side.right;
    let [x, y] = [anchor.left, anchor.top - height - gap];
    if (isInSide && side.left >= width + 2 * gap)
      [x, y] = [side.left - width - gap, anchor.top - gap];
    else if (y < gap) y = anchor.bottom + gap;
    const within = (place: number, size: number, room: number): number =>
      Math.max(gap, Math.min(place, room - size - gap));
    element.style.left = `${within(x, width, innerWidth)}px`;
    element.style.top = `${within(y, height, innerHeight)}px`;
  }
}
