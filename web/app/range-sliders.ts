// The two ends of a range on one line, each a slider.

import { make } from '../src/element/index.js';
import { Draft } from './draft.js';

const steps = 1000;
/** The ends come no nearer to each other. */
const gap = steps / 50;

export class RangeSliders {
  readonly element = make('div', { class: 'sliders' });
  readonly low = make('output', { id: 'range-low' });
  readonly high = make('output', { id: 'range-high' });
  readonly #lowSlider = slider('Lower end of the colours', 0);
  readonly #highSlider = slider('Upper end of the colours', steps);
  readonly #lowDraft: Draft;
  readonly #highDraft: Draft;
  readonly #moved: (low: number, high: number) => void;
  #reach: readonly [number, number] | undefined;

  constructor(moved: (low: number, high: number) => void) {
    this.#moved = moved;
    this.element.append(this.#lowSlider, this.#highSlider);
    this.#lowDraft = new Draft(this.#lowSlider, {
      edited: (text) =>
        this.#move(Math.min(Number(text), Number(this.#highDraft.text) - gap), 'low'),
    });
    this.#highDraft = new Draft(this.#highSlider, {
      edited: (text) =>
        this.#move(Math.max(Number(text), Number(this.#lowDraft.text) + gap), 'high'),
    });
  }

  set disabled(disabled: boolean) {
    this.#lowSlider.disabled = this.#highSlider.disabled = disabled;
  }

  /** The field's own range, and that of the colours within it. */
  show(
    reach: readonly [number, number] | undefined,
    ends: readonly [number, number] | undefined,
    format: (value: number) => string,
  ): void {
    this.#reach = reach;
    const stepOf = (value: number): number => {
      if (!reach || reach[1] <= reach[0]) return value <= (reach?.[0] ?? 0) ? 0 : steps;
      return Math.min(steps, Math.max(0, (steps * (value - reach[0])) / (reach[1] - reach[0])));
    };
    const at = ends && reach ? [stepOf(ends[0]), Math.max(stepOf(ends[1]), 0)] : [0, steps];
    if (ends && reach && reach[1] <= reach[0]) at[1] = steps;
    this.#lowDraft.show(String(at[0]));
    this.#highDraft.show(String(at[1]));
    this.element.style.setProperty('--low', String(at[0]! / steps));
    this.element.style.setProperty('--high', String(at[1]! / steps));
    const words = ends && reach ? ends.map(format) : ['–', '–'];
    [this.low.textContent, this.high.textContent] = [words[0]!, words[1]!];
    this.#lowSlider.setAttribute('aria-valuetext', words[0]!);
    this.#highSlider.setAttribute('aria-valuetext', words[1]!);
  }

  /** Moves one end; returns where it comes to rest. */
  #move(wanted: number, end: 'low' | 'high'): string {
    const at = Math.min(steps, Math.max(0, wanted));
    if (!this.#reach) return String(at);
    const [least, most] = this.#reach;
    const valueAt = (step: number): number =>
      step >= steps ? most : least + ((most - least) * step) / steps;
    const [low, high] = [this.#lowDraft, this.#highDraft].map(({ text }) => valueAt(Number(text)));
    if (end === 'low') this.#moved(valueAt(at), high!);
    else this.#moved(low!, valueAt(at));
    return String(at);
  }
}

function slider(label: string, value: number): HTMLInputElement {
  return make('input', {
    type: 'range',
    min: '0',
    max: String(steps),
    value: String(value),
    'aria-label': label,
  });
}
