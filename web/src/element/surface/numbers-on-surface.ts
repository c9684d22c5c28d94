// Short words at places of the surface, such as the numbers of limbs.

import type { SurfacePoint } from '../../kernel/types/types.js';
import type { Stage } from '../../view/index.js';
import { make } from '../controls/dom.js';
import type { Model } from '../model/model.js';

/** A word at a place. */
export interface PlaceNumber {
  /** A vertex, or a point of a face. */
  point: SurfacePoint;
  /** A number, or a few letters. */
  text: string;
}

export class NumbersOnSurface {
  /** Screen readers have the list beside the surface. */
  readonly element = make('div', { class: 'numbers', 'aria-hidden': 'true' });
  #numbers: { place: ReturnType<Model['surface']['positionOf']>; element: HTMLElement }[] = [];
  readonly #stage: Stage;
  readonly #model: Model;

  constructor(stage: Stage, model: Model) {
    this.#stage = stage;
    this.#model = model;
  }

  /** Shows these in place of those before. */
  show(numbers: readonly PlaceNumber[]): void {
    const { surface } = this.#model;
    this.#numbers = numbers.map(({ point, text }) => ({
      place: surface.positionOf(point),
      element: make('span', { class: 'number-mark' }, text),
    }));
    this.element.replaceChildren(...this.#numbers.map(({ element }) => element));
    this.#stage.invalidate();
  }

  /** Puts them where their places are, after a frame. */
  place(): void {
    for (const { place, element } of this.#numbers) {
      const { x, y } = this.#stage.placeOf(place);
      element.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px) translate(-50%, -50%)`;
      element.classList.toggle('behind', !this.#stage.project(place).visible);
    }
  }
}
