// The built-in examples, one button each.

import { make } from '../../src/element/index.js';
import { failureWords } from '../widgets/failure-words.js';

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

  /** Fetches the list; where it cannot be had, the strip says so, and there are no examples. */
  async prepare(): Promise<void> {
    const examples = await this.#list().catch((error: unknown) => {
      const words = `The examples could not be fetched: ${failureWords(error)}. Open a model of your own.`;
      this.#strip.append(make('p', { class: 'failure', role: 'status' }, words));
      return [];
    });
    for (const example of examples) {
      const button = make('button', { type: 'button', title: example.about }, example.title);
      button.dataset['example'] = example.name;
      button.addEventListener('click', () => this.#chosen(example));
      this.#buttons.set(example, button);
    }
    this.#strip.append(...this.#buttons.values(), this.#about);
  }

  async #list(): Promise<Example[]> {
    const response = await fetch(new URL('index.json', this.#folder));
    if (!response.ok) throw new Error(`the server answered ${response.status}`);
    return (await response.json()) as Example[];
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
