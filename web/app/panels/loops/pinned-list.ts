// The pinned loops as a table: each with a name that can be changed, its length and a cross.

import {
  type GirthViewer,
  type PinnedLoop,
  formatLength,
  formatNumber,
  make,
} from '../../../src/element/index.js';
import type { Loop, SurfacePoint } from '../../../src/kernel/index.js';
import { pinnedOf } from '../../state/actions.js';
import { type PageState, longestName } from '../../state/address-state.js';
import type { Store } from '../../state/store.js';
import { byId } from '../../widgets/dom.js';
import { Draft } from '../../widgets/draft.js';
import { Panel } from '../../widgets/panel.js';
import { PointBarcode } from './point-barcode.js';
import { PointDistance } from './point-distance.js';
import { stemOf } from '../../export/save-file.js';
import { TableActions } from '../../widgets/table-actions.js';
import { type Table, columnOf } from '../../widgets/table-text.js';

const kindNames = { loop: 'loop', antipodal: 'there and back', unresolved: 'at least' } as const;

function placeOf({ base }: Loop): string {
  return typeof base === 'number' ? `vertex ${base}` : `face ${base.face}`;
}

const keyOf = (point: SurfacePoint): string => JSON.stringify(point);

interface Row {
  element: HTMLElement;
  show(loop: PinnedLoop): void;
}

export class PinnedList {
  readonly panel = new Panel('loops-panel');
  readonly #table = byId('loops');
  readonly #rows = make('tbody');
  readonly #unit = make('th', { scope: 'col', class: 'number' });
  readonly #hint = byId('no-loops');
  readonly #actions = new TableActions({
    table: () => this.table,
    fileName: () => `${stemOf(this.#viewer.info?.name ?? 'model')}-loops.csv`,
  });
  /** Rows by their loops' numbers: a row stays the same element as long as its loop is pinned. */
  readonly #known = new Map<number, Row>();
  readonly #barcode: PointBarcode;
  readonly #distance: PointDistance;
  readonly #viewer: GirthViewer;
  readonly #store: Store;
  /** Loops of a project that are being pinned: none of them is computed. */
  #adopting: Promise<unknown> = Promise.resolve();
  /** Loops of the state that are being computed, by their places. */
  #coming = new Map<string, { point: SurfacePoint; name: string }>();
  #isPinning = false;
  /** The surface is being made as the state says. */
  #isFollowing = false;

  constructor(viewer: GirthViewer, store: Store) {
    this.#viewer = viewer;
    this.#store = store;
    const head = make(
      'tr',
      {},
      make('th', { scope: 'col', 'aria-label': 'Number' }, '#'),
      make('th', { scope: 'col' }, 'Name'),
      this.#unit,
      make('th', { scope: 'col' }, 'At'),
      make('td'),
    );
    this.#table.append(make('thead', {}, head), this.#rows);
    this.#barcode = new PointBarcode(viewer);
    this.#distance = new PointDistance(viewer);
    const { element: barcode } = this.#barcode;
    const { element: distance } = this.#distance;
    const parts = [this.#hint, this.#table, this.#actions.element, barcode, distance];
    this.panel.body.append(...parts);
    this.panel.onToggle((isOpen) => {
      this.#barcode.refresh(isOpen);
      this.#distance.refresh(isOpen);
    });
    const refresh = (): void => this.#refresh();
    for (const event of ['load', 'unit', 'field', 'pick']) viewer.addEventListener(event, refresh);
    viewer.addEventListener('pick', () => this.#keep());
    refresh();
  }

  /** The table for files and spreadsheets, in the unit that is shown. */
  get table(): Table {
    const { lengthFormat, pinned } = this.#viewer;
    const { unit, scale } = lengthFormat;
    return [
      ['loop', 'name', columnOf('girth', unit), 'kind', 'at'],
      ...pinned.map(({ id, name, loop }) => [
        id,
        name,
        loop.length * scale,
        kindNames[loop.kind],
        placeOf(loop),
      ]),
    ];
  }

  /** The lengths of the loops as they are shown. */
  get values(): string[] {
    const { pinned, lengthFormat } = this.#viewer;
    return pinned.map(({ loop }) => formatLength(loop.length, lengthFormat).replace('\u202f', ' '));
  }

  /** Takes note of loops that are being pinned: they come before any that the state asks for. */
  adopting(work: Promise<unknown>): void {
    this.#adopting = work;
  }

  /** Puts pinned loops into the state; loops that it asks for stay there until they are pinned. */
  #keep(): void {
    if (this.#isFollowing) return;
    const { loops = [], names = [] } = this.#store.shown;
    const pins = new Map(
      this.#viewer.pinned.map(({ loop: { base: point }, name }) => [keyOf(point), { point, name }]),
    );
    const kept = loops.flatMap((point, i) => {
      const key = keyOf(point);
      const pin = pins.get(key);
      pins.delete(key);
      if (this.#coming.has(key)) return [{ point, name: names[i] ?? '' }];
      return pin ? [pin] : [];
    });
    this.#store.choose(pinnedOf([...kept, ...pins.values()]));
  }

  /** Removes what is too much, names the others, and pins what is missing. */
  follow({ loops = [], names = [] }: PageState): void {
    const viewer = this.#viewer;
    const missing = new Map(
      loops.map((point, i) => [keyOf(point), { point, name: names[i] ?? '' }]),
    );
    this.#isFollowing = true;
    for (const { id, name, loop } of viewer.pinned) {
      const key = keyOf(loop.base);
      const wanted = missing.get(key);
      missing.delete(key);
      if (!wanted) viewer.unpin(id);
      else if (name !== wanted.name && !this.#coming.has(key)) viewer.nameLoop(id, wanted.name);
    }
    this.#isFollowing = false;
    this.#coming = missing;
    if (missing.size > 0) void this.#pinComing();
  }

  /** One after another: a hand that moves over the surface comes in between. */
  async #pinComing(): Promise<void> {
    const viewer = this.#viewer;
    if (this.#isPinning) return;
    this.#isPinning = true;
    await this.#adopting.catch(() => undefined);
    for (let next = this.#next; next; next = this.#next) {
      const { info } = viewer;
      const key = keyOf(next.point);
      // A place that this model does not have is no reason to complain.
      const pin =
        viewer.pinned.find(({ loop }) => keyOf(loop.base) === key) ??
        (await viewer.pin(next.point).catch(() => undefined));
      // Another model has loops of its own.
      if (viewer.info !== info) continue;
      const wanted = this.#coming.get(key);
      if (pin && !wanted) viewer.unpin(pin.id);
      else if (pin) viewer.nameLoop(pin.id, wanted!.name);
      this.#coming.delete(key);
    }
    this.#isPinning = false;
    this.#keep();
    this.#refresh();
  }

  get #next(): { point: SurfacePoint; name: string } | undefined {
    return this.#coming.values().next().value;
  }

  #refresh(): void {
    const { pinned, lengthFormat } = this.#viewer;
    this.#unit.textContent = lengthFormat.unit ? `Girth, ${lengthFormat.unit}` : 'Girth';
    for (const [id, { element }] of this.#known) {
      if (pinned.some((one) => one.id === id)) continue;
      element.remove();
      this.#known.delete(id);
      this.#actions.forget();
    }
    for (const one of pinned) {
      const row = this.#known.get(one.id) ?? this.#row(one.id);
      row.show(one);
      if (row.element.isConnected) continue;
      this.#known.set(one.id, row);
      this.#rows.append(row.element);
      this.#actions.forget();
    }
    this.#hint.hidden = pinned.length > 0;
    this.#table.hidden = this.#actions.element.hidden = pinned.length === 0;
    this.panel.summary = pinned.length > 0 ? String(pinned.length) : '';
    this.#barcode.refresh(this.panel.isOpen);
    this.#distance.refresh(this.panel.isOpen);
  }

  #row(id: number): Row {
    const viewer = this.#viewer;
    const remove = make('button', { type: 'button', title: 'Remove' }, '✕');
    remove.addEventListener('click', () => {
      viewer.unpin(id);
      this.#keep();
    });
    const name = make('input', {
      type: 'text',
      placeholder: 'name',
      autocomplete: 'off',
      maxlength: String(longestName),
      'aria-label': `Name of loop ${id}`,
    });
    const draft = new Draft(name, {
      committed: (text) => {
        viewer.nameLoop(id, text.trim());
        this.#actions.forget();
      },
    });
    const [length, place] = [make('td', { class: 'number' }), make('td', { class: 'quiet' })];
    const element = make(
      'tr',
      {},
      make('th', { scope: 'row' }, String(id)),
      make('td', {}, name),
      length,
      place,
      make('td', {}, remove),
    );
    return {
      element,
      show: ({ name: now, loop }) => {
        draft.show(now);
        length.textContent = formatNumber(loop.length, viewer.lengthFormat);
        place.textContent = {
          loop: placeOf(loop),
          antipodal: 'there and back',
          unresolved: 'or more',
        }[loop.kind];
        place.title = placeOf(loop);
        remove.setAttribute('aria-label', `Remove loop ${id}, ${length.textContent}`);
      },
    };
  }
}
