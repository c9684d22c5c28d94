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
  private readonly about = make('p');
  private readonly buttons = new Map<Example, HTMLButtonElement>();

  constructor(
    private readonly strip: HTMLElement,
    private readonly load: (address: string) => void,
  ) {}

  /** Fetches the list and opens its first example. */
  async open(): Promise<void> {
    const folder = new URL('examples/', document.baseURI);
    const response = await fetch(new URL('index.json', folder));
    const examples = (await response.json()) as Example[];
    for (const example of examples) {
      const button = make('button', { type: 'button', title: example.about }, example.title);
      button.dataset['example'] = example.name;
      button.addEventListener('click', () => {
        this.choose(example);
        this.load(new URL(example.file, folder).href);
      });
      this.buttons.set(example, button);
    }
    this.strip.append(...this.buttons.values(), this.about);
    this.buttons.values().next().value?.click();
  }

  /** Marks an example as the one that is shown; none where the user's own model is. */
  choose(example: Example | undefined): void {
    this.about.textContent = example?.about ?? '';
    for (const [one, button] of this.buttons) {
      button.setAttribute('aria-pressed', String(one === example));
    }
  }
}
