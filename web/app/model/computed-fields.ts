// Which fields of the present model are computed from end to end.

import type { FieldName } from '../../src/kernel/index.js';
import type { GirthViewer } from '../../src/element/index.js';

export class ComputedFields {
  readonly #names = new Set<FieldName>();

  readonly #viewer: GirthViewer;

  /** Listens before anybody who asks. */
  constructor(viewer: GirthViewer) {
    this.#viewer = viewer;
    viewer.addEventListener('load', () => this.#names.clear());
    viewer.addEventListener('field', (event) => {
      const { name, share } = event.detail;
      if (share === 1) this.#names.add(name);
    });
  }

  has(name: FieldName): boolean {
    // One that is computed again in another way is not.
    return this.#names.has(name) && this.#viewer.shareOf(name) === 1;
  }
}
