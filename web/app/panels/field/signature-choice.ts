// Which number of a signature (heat kernel, wave kernel, scale-invariant heat kernel) colours the surface.

import { type GirthViewer, make } from '../../../src/element/index.js';
import { type SpectralFieldName, signatureNumbers, usualTime } from '../../../src/kernel/index.js';
import type { Store } from '../../state/store.js';
import { Draft } from '../../widgets/draft.js';

interface Signature {
  /** The name of the element's attribute, and of its key in the page's state. */
  attribute: 'time' | 'energy' | 'component';
  label: string;
  steps: number;
  usual: number;
  /** The number at a step from 0 on, and the step of a number. */
  at: (step: number) => number;
  stepOf: (number: number) => number;
  words: (number: number) => string;
}

/**
 * Times of heat: ten steps for each power of ten. At the shortest only points are seen, at the
 * longest the whole shape.
 */
const [shortest, perPower] = [1e-4, 10];

function counted(
  attribute: 'energy' | 'component',
  label: string,
  { count: last, usual }: { count: number; usual: number },
) {
  return {
    attribute,
    label,
    steps: last - 1,
    usual,
    at: (step: number) => step + 1,
    stepOf: (number: number) => number - 1,
    words: (number: number) => `${number} of ${last}`,
  };
}

const signatures: Record<SpectralFieldName, Signature> = {
  hks: {
    attribute: 'time',
    label: 'Time (share of the area)',
    steps: 4 * perPower,
    usual: usualTime,
    at: (step) => Number((shortest * 10 ** (step / perPower)).toPrecision(2)),
    stepOf: (time) => Math.round(perPower * Math.log10(Math.max(time, shortest) / shortest)),
    words: String,
  },
  wks: counted('energy', 'Energy', signatureNumbers.wks),
  sihks: counted('component', 'Frequency', signatureNumbers.sihks),
};

export class SignatureChoice {
  readonly element = make('div', { class: 'slide signature' });
  readonly #label = make('label', { for: 'signature' });
  readonly #words = make('output', { for: 'signature' });
  readonly #slider = make('input', { id: 'signature', type: 'range', min: '0' });
  readonly #draft: Draft;
  #shown: Signature | undefined;
  readonly #viewer: GirthViewer;

  constructor(viewer: GirthViewer, store: Store) {
    this.#viewer = viewer;
    const slider = this.#slider;
    this.element.append(this.#label, this.#words, slider);
    this.#draft = new Draft(slider, {
      edited: () => this.#write(),
      // Not before the hand lets go: to be computed takes a while, and a new wish would end it.
      committed: (text) => {
        if (!this.#shown) return;
        store.choose({ [this.#shown.attribute]: this.#shown.at(Number(text)) });
        this.#write();
      },
      ended: () => this.#write(),
    });
    this.show('igf');
  }

  /** Shows the choice for a field; hidden where the field is no signature. */
  show(name: string): void {
    const shown = Object.hasOwn(signatures, name)
      ? signatures[name as SpectralFieldName]
      : undefined;
    // A place on the slider means nothing to another signature.
    if (shown !== this.#shown) this.#draft.discard();
    this.#shown = shown;
    this.element.hidden = !this.#shown;
    if (!this.#shown) return;
    const { label, steps, stepOf } = this.#shown;
    this.#label.textContent = label;
    this.#slider.max = String(steps);
    this.#draft.show(String(stepOf(this.#number(this.#shown))));
    this.#write();
  }

  #number({ attribute, usual }: Signature): number {
    const text = this.#viewer.getAttribute(attribute);
    return text !== null && Number.isFinite(Number(text)) ? Number(text) : usual;
  }

  /** The number that the slider is at; exactly the attribute's where it was not moved. */
  #write(): void {
    const [shown, slider] = [this.#shown, this.#slider];
    if (!shown) return;
    const [now, step] = [this.#number(shown), Number(this.#draft.text)];
    const number = shown.stepOf(now) === step ? now : shown.at(step);
    this.#words.textContent = shown.words(number);
    slider.setAttribute('aria-valuetext', this.#words.textContent);
  }
}
