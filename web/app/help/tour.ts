// A tour on the octopus: what a loop is, where it slips off, and what is measured by it.

import { type GirthViewer, make } from '../../src/element/index.js';
import type { PanelName } from '../state/address-state.js';
import { slideLoop } from './meaning.js';
import { byDevice } from '../widgets/device.js';

/** A step: its words, and what it opens on the page. */
interface Step {
  words: string;
  panel?: PanelName;
  slides?: boolean;
}

const steps: readonly Step[] = [
  {
    words:
      'Colours show the girth: how long the shortest loop round the surface is at each point. Arms are dark: they are thin. The head is lighter: it is thicker.',
  },
  {
    words:
      'This band is such a loop. It slides along an arm, grows over the head, and shrinks along another arm.',
    slides: true,
  },
  {
    words:
      'At the end of an arm the loop slips off, and the girth jumps to the way to the farthest point and back. So ends of arms are bright. Such an end is a tip; the panel lists tips.',
    panel: 'tips',
    slides: true,
  },
  {
    words:
      'The panel Limbs measures each arm: how long it is, where it is narrowest, and its girth all along. Its number stands on the surface.',
    panel: 'limbs',
  },
  {
    words:
      'A neck is a loop that is shorter than all loops near it. The panel Necks lists them, and cuts the surface along them.',
    panel: 'necks',
  },
  {
    words: `${byDevice('Point at the surface to see the loop of a point, and click to keep it', 'Tap the surface to see the loop of a point, and tap again to keep it')}. Kept loops have names and lengths, to be copied and exported.`,
    panel: 'loops',
  },
  {
    words:
      'The print check finds walls and tubes that are too thin for a printer. Its limits have a unit: where the file states none, choose it in the panel.',
    panel: 'print',
  },
  {
    words: `Now a model of your own: ${byDevice('drop a file anywhere, or use Open', 'use Open')}. It stays on your device. Help is behind the question mark.`,
  },
];

export interface TourPage {
  /** Shows the model that the tour is about. */
  begin(): Promise<void>;
  open(panel: PanelName): void;
}

export class Tour {
  readonly #viewer: GirthViewer;
  readonly #page: TourPage;
  readonly #count = make('b');
  readonly #words = make('p', { 'aria-live': 'polite' });
  readonly #back = make('button', { type: 'button', class: 'open' }, 'Back');
  readonly #next = make('button', { type: 'button', class: 'open' });
  readonly #card: HTMLElement;
  #step = 0;
  #sliding = new AbortController();

  constructor(viewer: GirthViewer, page: TourPage) {
    this.#viewer = viewer;
    this.#page = page;
    const close = make('button', { type: 'button', 'aria-label': 'End the tour' }, '✕');
    close.addEventListener('click', () => this.#end());
    this.#back.addEventListener('click', () => this.#show(this.#step - 1));
    this.#next.addEventListener('click', () => this.#show(this.#step + 1));
    this.#card = make(
      'section',
      { class: 'tour', 'aria-label': 'Tour', hidden: '' },
      make('header', {}, this.#count, close),
      this.#words,
      make('p', { class: 'steps' }, this.#back, this.#next),
    );
    viewer.after(this.#card);
    this.#card.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      this.#end();
    });
  }

  async start(): Promise<void> {
    await this.#page.begin();
    this.#card.hidden = false;
    this.#show(0);
    this.#next.focus();
  }

  #show(step: number): void {
    this.#sliding.abort();
    const now = steps[step];
    if (!now) return this.#end();
    this.#step = step;
    this.#count.textContent = `${step + 1} of ${steps.length}`;
    this.#words.textContent = now.words;
    this.#back.disabled = step === 0;
    this.#next.textContent = step + 1 < steps.length ? 'Next' : 'Done';
    if (now.panel) this.#page.open(now.panel);
    if (!now.slides) return;
    this.#sliding = new AbortController();
    void slideLoop(this.#viewer, this.#sliding.signal);
  }

  #end(): void {
    this.#sliding.abort();
    this.#card.hidden = true;
    this.#viewer.shadowRoot?.querySelector('canvas')?.focus();
  }
}
