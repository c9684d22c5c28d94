// The built-in examples, one button each.

import { make } from '../src/element/index.js';

/** An entry of `examples/index.json`. */
export interface Example {
  name: string;
  title: string;
  about: string;
  /** The file's name in the folder `examples`. */
  file: string;
  faces: number;
}

export class ExamplesStrip {
  readonly #about = make('p');
  readonly #folder = new URL('examples/', document.baseURI);
  readonly #buttons = new Map<Example, HTMLButtonElement>();
  readonly #strip: HTMLElement;
  readonly #chosen: (example: Example) => void;

  constructor(strip: HTMLElement, chosen: (example: Example) => void) {
    this.#strip = strip;
    this.#chosen = chosen;
  }

  /** Fetches the list. */
  async prepare(): Promise<void> {
    const response = await fetch(new URL('index.json', this.#folder));
    const examples = (await response.json()) as Example[];
    for (const example of examples) {
      const button = make('button', { type: 'button', title: example.about }, example.title);
      button.dataset['example'] = example.name;
      button.addEventListener('click', () => this.#chosen(example));
      this.#buttons.set(example, button);
    }
    this.#strip.append(...this.#buttons.values(), this.#about);
  }

  get all(): Example[] {
    return [...this.#buttons.keys()];
  }

  addressOf({ file }: Example): string {
    return new URL(file, this.#folder).href;
  }

  /** Marks an example as the one that is shown; none where the user's own model is. */
  mark(example: Example | undefined): void {
    this.#about.textContent = example?.about ?? '';
    for (const [one, button] of this.#buttons) {
      button.setAttribute('aria-pressed', String(one === example));
    }
  }
}
