// The pinned loops, each with its length and a cross.

import { type GirthViewer, type PinnedLoop, formatLength, make } from '../src/element/index.js';
import type { PageState } from './address-state.js';
import { byId } from './dom.js';
import { Panel } from './panel.js';

export class PinnedList {
  readonly panel = new Panel('loops-panel');
  readonly #list = byId('loops');
  readonly #hint = byId('no-loops');
  /** By the loops' numbers: a row stays the same element for as long as its loop is pinned. */
  readonly #rows = new Map<number, { element: HTMLElement; show(loop: PinnedLoop): void }>();
  readonly #viewer: GirthViewer;
  readonly #changed: () => void;

  constructor(viewer: GirthViewer, changed: () => void) {
    this.#viewer = viewer;
    this.#changed = changed;
    this.panel.body.append(this.#hint, this.#list);
    this.panel.onToggle(changed);
    const refresh = (): void => this.#refresh();
    for (const event of ['load', 'unit', 'field', 'pick']) viewer.addEventListener(event, refresh);
    viewer.addEventListener('pick', changed);
  }

  read(): PageState {
    const loops = this.#viewer.pinned.map(({ loop }) => loop.base);
    return loops.length > 0 ? { loops } : {};
  }

  /** Pins what is missing and removes what is too much. */
  async apply({ loops = [] }: PageState): Promise<void> {
    const viewer = this.#viewer;
    const wanted = new Set(loops.map((base) => JSON.stringify(base)));
    for (const { id, loop } of viewer.pinned) {
      if (!wanted.delete(JSON.stringify(loop.base))) viewer.unpin(id);
    }
    const { info } = viewer;
    for (const base of loops) {
      if (viewer.info !== info) return;
      // A place that this model does not have is no reason to complain.
      if (wanted.delete(JSON.stringify(base))) await viewer.pin(base).catch(() => undefined);
    }
  }

  #refresh(): void {
    const { pinned } = this.#viewer;
    for (const [id, { element }] of this.#rows) {
      if (pinned.some((one) => one.id === id)) continue;
      element.remove();
      this.#rows.delete(id);
    }
    for (const one of pinned) {
      const row = this.#rows.get(one.id) ?? this.#row(one.id);
      row.show(one);
      if (row.element.isConnected) continue;
      this.#rows.set(one.id, row);
      this.#list.append(row.element);
    }
    this.#hint.hidden = pinned.length > 0;
    this.panel.summary = pinned.length > 0 ? String(pinned.length) : '';
  }

  #row(id: number): { element: HTMLElement; show(loop: PinnedLoop): void } {
    const viewer = this.#viewer;
    const remove = make('button', { type: 'button', title: 'Remove' }, '✕');
    remove.addEventListener('click', () => {
      viewer.unpin(id);
      this.#changed();
    });
    const [length, place] = [make('b'), make('span')];
    const element = make('li', {}, make('i', {}, String(id)), length, place, remove);
    return {
      element,
      show: ({ loop: { base, kind, length: value } }) => {
        length.textContent = formatLength(value, viewer.lengthFormat);
        const from = typeof base === 'number' ? `vertex ${base}` : `face ${base.face}`;
        place.textContent = { loop: from, antipodal: 'there and back', unresolved: 'or more' }[
          kind
        ];
        remove.setAttribute('aria-label', `Remove loop ${id}, ${length.textContent}`);
      },
    };
  }
}
