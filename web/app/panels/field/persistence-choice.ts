// How long saddles must last to count: a slider through the persistent girths.

import {
  type GirthViewer,
  formatLength,
  make,
  readLengthOrShare,
} from '../../../src/element/index.js';
import { persistentFields } from '../../../src/kernel/index.js';
import type { Store } from '../../state/store.js';
import { setAttribute } from '../../widgets/dom.js';
import { Draft } from '../../widgets/draft.js';
import { failureWords } from '../../widgets/failure-words.js';

/** The reach and the steps of the slider, in percent of the square root of the area. */
const [reach, step] = [5, 0.05];
/** The fields that a persistence changes. */
const concerned = new Set<string>([...persistentFields, 'kind', 'tips', 'parts']);

/** How long saddles must last to count, in model units, as the element's attribute has it. */
export function persistenceOf(viewer: GirthViewer): number {
  const { info, unit } = viewer;
  const text = viewer.getAttribute('persistence') ?? '0';
  const read = readLengthOrShare(text, info?.unit || unit, Math.sqrt(info?.area ?? 1));
  return 'length' in read ? read.length : 0;
}

const textOf = (percent: number): string | undefined =>
  percent > 0 ? `${Number(percent.toFixed(2))}%` : undefined;

export class PersistenceChoice {
  readonly element = make('div', { class: 'slide persistence' });
  readonly #words = make('output', { for: 'persistence' });
  readonly #said = make('p', { class: 'said', role: 'status' });
  readonly #slider = make('input', {
    id: 'persistence',
    type: 'range',
    min: '0',
    max: String(reach / step),
  });
  readonly #draft: Draft;
  /** Whether the saddles of all vertices are there: then the surface follows the hand. */
  #isKept = false;
  /** The persistence to show once all saddles are there, in percent. */
  #awaited: number | undefined;
  #painting = 0;
  #name = 'igf';
  readonly #viewer: GirthViewer;
  readonly #store: Store;

  constructor(viewer: GirthViewer, store: Store) {
    this.#viewer = viewer;
    this.#store = store;
    this.element.append(
      make('label', { for: 'persistence' }, 'Wrinkles ignored'),
      this.#words,
      this.#slider,
      this.#said,
    );
    this.#draft = new Draft(this.#slider, {
      edited: () => {
        this.#write();
        if (this.#isKept && !viewer.hasAttribute('method')) this.#paintSoon();
      },
      committed: () => void this.#choose(this.#percent),
      ended: () => this.#write(),
    });
    viewer.addEventListener('load', () => {
      this.#isKept = false;
      this.#awaited = undefined;
      this.#said.textContent = '';
      this.#draft.discard();
    });
    this.show('igf');
  }

  /** Shows the choice for a field; hidden where saddles do not matter to it. */
  show(name: string): void {
    this.#name = name;
    this.element.hidden = !concerned.has(name);
    this.#slider.disabled = !this.#viewer.info;
    this.#draft.show(String(Math.round(this.#wanted / step)));
    this.#write();
  }

  /** The wished persistence in percent: the one waited for, or that of the attribute. */
  get #wanted(): number {
    const viewer = this.#viewer;
    return this.#awaited ?? (100 * persistenceOf(viewer)) / Math.sqrt(viewer.info?.area ?? 1);
  }

  /** The persistence of the slider; exactly the wished one where it was not moved. */
  get #percent(): number {
    const at = Number(this.#draft.text);
    const wanted = this.#wanted;
    return Math.round(Math.min(wanted, reach) / step) === at ? wanted : at * step;
  }

  #write(): void {
    const { info, lengthFormat } = this.#viewer;
    const percent = this.#percent;
    const share = `${Number(percent.toFixed(2))}\u202f%`;
    const length = info ? (percent / 100) * Math.sqrt(info.area) : 0;
    this.#words.textContent =
      percent > 0 && info ? `${formatLength(length, lengthFormat)} · ${share}` : 'none';
    this.#slider.setAttribute('aria-valuetext', this.#words.textContent);
  }

  /** Shows a persistence while the hand passes over it; the state does not take it. */
  #paint(text: string | undefined): void {
    if ((text ?? '') !== (this.#viewer.getAttribute('persistence') ?? '')) {
      setAttribute(this.#viewer, 'persistence', text);
    }
  }

  /** Once a frame is enough: a hand moves more often. */
  #paintSoon(): void {
    cancelAnimationFrame(this.#painting);
    this.#painting = requestAnimationFrame(() => this.#paint(textOf(this.#percent)));
  }

  /** Shows the girth with a persistence; at first the saddles of all vertices are computed. */
  async #choose(percent: number): Promise<void> {
    const viewer = this.#viewer;
    const { info } = viewer;
    if (!info || percent === this.#wanted) return;
    // Saddles of few triangles are found as quickly as they could be kept.
    const isExact = !viewer.hasAttribute('method');
    if (percent > 0 && !this.#isKept && isExact) {
      const isWaiting = this.#awaited !== undefined;
      this.#awaited = percent;
      if (isWaiting) return;
      this.#said.textContent = 'Looking for the saddles of all vertices …';
      const fault = await viewer.keepBarcodes((reach / 100) * Math.sqrt(info.area)).then(
        () => '',
        (error: unknown) => `As before: ${failureWords(error)}.`,
      );
      // Another model has its own.
      if (viewer.info !== info || this.#awaited === undefined) return;
      percent = this.#awaited;
      this.#awaited = undefined;
      this.#isKept = fault === '';
      this.#said.textContent = fault;
      if (fault) {
        this.show(this.#name);
        return;
      }
    }
    this.#awaited = undefined;
    const text = textOf(percent);
    this.#store.choose({ persistence: text });
    this.#paint(text);
    this.#write();
  }
}
