// The two ends of a range on one line, each a slider.

import { make } from '../src/element/index.js';

const steps = 1000;
/** The ends come no nearer to each other. */
const gap = steps / 50;

export class RangeSliders {
  readonly element = make('div', { class: 'sliders' });
  readonly low = make('output', { id: 'range-low' });
  readonly high = make('output', { id: 'range-high' });
  private readonly lowSlider = slider('Lower end of the colours', 0);
  private readonly highSlider = slider('Upper end of the colours', steps);
  private reach: readonly [number, number] | undefined;

  constructor(private readonly moved: (low: number, high: number) => void) {
    this.element.append(this.lowSlider, this.highSlider);
    for (const one of [this.lowSlider, this.highSlider]) {
      one.addEventListener('input', () => this.move(one));
    }
  }

  set disabled(disabled: boolean) {
    this.lowSlider.disabled = this.highSlider.disabled = disabled;
  }

  /** The field's own range, and that of the colours within it. */
  show(
    reach: readonly [number, number] | undefined,
    ends: readonly [number, number] | undefined,
    format: (value: number) => string,
  ): void {
    this.reach = reach;
    const stepOf = (value: number): number => {
      if (!reach || reach[1] <= reach[0]) return value <= (reach?.[0] ?? 0) ? 0 : steps;
      return Math.min(steps, Math.max(0, (steps * (value - reach[0])) / (reach[1] - reach[0])));
    };
    const at = ends && reach ? [stepOf(ends[0]), Math.max(stepOf(ends[1]), 0)] : [0, steps];
    if (ends && reach && reach[1] <= reach[0]) at[1] = steps;
    this.lowSlider.value = String(at[0]);
    this.highSlider.value = String(at[1]);
    this.element.style.setProperty('--low', String(at[0]! / steps));
    this.element.style.setProperty('--high', String(at[1]! / steps));
    const words = ends && reach ? ends.map(format) : ['–', '–'];
    [this.low.textContent, this.high.textContent] = [words[0]!, words[1]!];
    this.lowSlider.setAttribute('aria-valuetext', words[0]!);
    this.highSlider.setAttribute('aria-valuetext', words[1]!);
  }

  private move(moved: HTMLInputElement): void {
    if (!this.reach) return;
    let [low, high] = [Number(this.lowSlider.value), Number(this.highSlider.value)];
    if (moved === this.lowSlider) low = Math.max(0, Math.min(low, high - gap));
    else high = Math.min(steps, Math.max(high, low + gap));
    const [least, most] = this.reach;
    const valueAt = (step: number): number =>
      step >= steps ? most : least + ((most - least) * step) / steps;
    this.moved(valueAt(low), valueAt(high));
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
