// The two ends of a range on one line, each a slider and a field.

import { make } from '../../../src/element/index.js';
import { Draft } from '../../widgets/draft.js';

const steps = 1000;
/** The ends come no nearer to each other. */
const gap = steps / 50;

export interface RangeEvents {
  /** Another range was chosen. */
  moved(low: number, high: number): void;
  /** A value from what was typed, or why it is none. */
  read(text: string): { value: number } | { fault: string };
  /** The typed text is no end, for this reason, and changed nothing; '' once that is over. */
  wrong(why: string): void;
}

export class RangeSliders {
  readonly element = make('div', { class: 'sliders' });
  readonly low = field('range-low', 'Colours from');
  readonly high = field('range-high', 'Colours up to');
  readonly #typed: Record<'low' | 'high', Draft>;
  readonly #lowSlider = slider('Lower end of the colours', 0);
  readonly #highSlider = slider('Upper end of the colours', steps);
  readonly #lowDraft: Draft;
  readonly #highDraft: Draft;
  readonly #events: RangeEvents;
  #ends: readonly [number, number] | undefined;
  #reach: readonly [number, number] | undefined;

  constructor(events: RangeEvents) {
    this.#events = events;
    const typed = (end: 'low' | 'high', input: HTMLInputElement): Draft =>
      new Draft(input, {
        committed: (text) => this.#type(end, text, input),
        ended: () => {
          input.setAttribute('aria-invalid', 'false');
          events.wrong('');
        },
      });
    this.#typed = { low: typed('low', this.low), high: typed('high', this.high) };
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
    for (const input of [this.#lowSlider, this.#highSlider, this.low, this.high]) {
      input.disabled = disabled;
    }
  }

  /** The field's own range, and that of the colours within it. */
  show(
    reach: readonly [number, number] | undefined,
    ends: readonly [number, number] | undefined,
    format: (value: number) => string,
  ): void {
    this.#reach = reach;
    this.#ends = ends;
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
    const words = ends && reach ? ends.map(format) : ['', ''];
    this.#typed.low.show(words[0]!);
    this.#typed.high.show(words[1]!);
    this.#lowSlider.setAttribute('aria-valuetext', words[0]! || 'no values yet');
    this.#highSlider.setAttribute('aria-valuetext', words[1]! || 'no values yet');
  }

  /** Takes what was typed for one end; false where it cannot be. */
  #type(end: 'low' | 'high', text: string, input: HTMLInputElement): boolean {
    const [read, ends] = [this.#events.read(text), this.#ends];
    if (!ends) return false;
    const wrong = (why: string): boolean => {
      input.setAttribute('aria-invalid', 'true');
      this.#events.wrong(why);
      return false;
    };
    if ('fault' in read) return wrong(read.fault);
    const [low, high] = end === 'low' ? [read.value, ends[1]] : [ends[0], read.value];
    if (!(low < high)) return wrong('The lower end must be below the upper one');
    this.#events.moved(low, high);
    return true;
  }

  /** Moves one end; returns where it comes to rest. */
  #move(wanted: number, end: 'low' | 'high'): string {
    const at = Math.min(steps, Math.max(0, wanted));
    if (!this.#reach) return String(at);
    const [least, most] = this.#reach;
    const valueAt = (step: number): number =>
      step >= steps ? most : least + ((most - least) * step) / steps;
    const [low, high] = [this.#lowDraft, this.#highDraft].map(({ text }) => valueAt(Number(text)));
    if (end === 'low') this.#events.moved(valueAt(at), high!);
    else this.#events.moved(low!, valueAt(at));
    return String(at);
  }
}

function field(id: string, label: string): HTMLInputElement {
  return make('input', { id, type: 'text', autocomplete: 'off', 'aria-label': label });
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
