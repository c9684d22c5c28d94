// A slider for a threshold, over the values of a field by their logarithms where they allow it.

import { make } from '../../src/element/index.js';
import { Draft } from './draft.js';

const steps = 1000;

export class ThresholdSlider {
  readonly element: HTMLInputElement;
  readonly #draft: Draft;
  #reach: readonly [number, number] | undefined;

  constructor(label: string, moved: (length: number, settled: boolean) => void) {
    this.element = make('input', {
      type: 'range',
      class: 'threshold',
      min: '0',
      max: String(steps),
      'aria-label': label,
    });
    const length = (): number => {
      const [low, high] = this.#reach!;
      const place = Number(this.#draft.text) / steps;
      // The threshold at an end divides nothing: all values are above, or below.
      if (place === 0) return 0;
      if (place === 1) return 1.001 * high;
      return low > 0 ? low * (high / low) ** place : low + (high - low) * place;
    };
    const move = (settled: boolean): void => {
      if (this.#reach) moved(length(), settled);
    };
    this.#draft = new Draft(this.element, {
      edited: () => move(false),
      committed: () => move(true),
    });
  }

  show(
    reach: readonly [number, number] | undefined,
    length: number | undefined,
    format: (length: number) => string,
  ): void {
    const hasReach = reach !== undefined && Number.isFinite(reach[0]) && Number.isFinite(reach[1]);
    this.#reach = hasReach ? reach : undefined;
    this.element.disabled = !hasReach || length === undefined;
    if (!hasReach || length === undefined) return;
    const [low, high] = reach;
    let place =
      low > 0 ? Math.log(length / low) / Math.log(high / low) : (length - low) / (high - low);
    if (Number.isNaN(place)) place = 0.5;
    this.#draft.show(String(Math.round(steps * Math.min(1, Math.max(0, place)))));
    this.element.setAttribute('aria-valuetext', format(length));
  }
}
