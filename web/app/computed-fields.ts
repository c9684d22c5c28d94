// Which fields of the present model are computed from end to end.

import type { FieldName } from '../src/kernel/index.js';
import type { GirthViewer } from '../src/element/index.js';

export class ComputedFields {
  readonly #names = new Set<FieldName>();

  /** Listens before anybody who asks. */
  constructor(viewer: GirthViewer) {
    viewer.addEventListener('load', () => this.#names.clear());
    viewer.addEventListener('field', (event) => {
      const { name, share } = event.detail;
      if (share === 1) this.#names.add(name);
    });
  }

  has(name: FieldName): boolean {
    return this.#names.has(name);
  }
}
