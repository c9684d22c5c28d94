// The pinned loops as a table: each with a name that can be changed, its length and a cross.

import {
  type GirthViewer,
  type PinnedLoop,
  formatLength,
  formatNumber,
  make,
} from '../../../src/element/index.js';
import type { Loop } from '../../../src/kernel/index.js';
import { type PageState, longestName } from '../../state/address-state.js';
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
  /** By the loops' numbers: a row stays the same element for as long as its loop is pinned. */
  readonly #known = new Map<number, Row>();
  readonly #barcode: PointBarcode;
  readonly #distance: PointDistance;
  readonly #viewer: GirthViewer;
  readonly #changed: () => void;

  constructor(viewer: GirthViewer, changed: () => void) {
    this.#viewer = viewer;
    this.#changed = changed;
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
      changed();
    });
    const refresh = (): void => this.#refresh();
    for (const event of ['load', 'unit', 'field', 'pick']) viewer.addEventListener(event, refresh);
    viewer.addEventListener('pick', changed);
    refresh();
  }

  /** As files and spreadsheets have it, in the unit that is shown. */
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

  /** Their lengths as they are shown. */
  get values(): string[] {
    const { pinned, lengthFormat } = this.#viewer;
    return pinned.map(({ loop }) => formatLength(loop.length, lengthFormat).replace('\u202f', ' '));
  }

  read(): PageState {
    const { pinned } = this.#viewer;
    if (pinned.length === 0) return {};
    const loops = pinned.map(({ loop }) => loop.base);
    const names = pinned.map(({ name }) => name);
    return names.some((name) => name !== '') ? { loops, names } : { loops };
  }

  /** Pins what is missing, names it, and removes what is too much. */
  async apply({ loops = [], names = [] }: PageState): Promise<void> {
    const viewer = this.#viewer;
    const wanted = new Map(loops.map((base, i) => [JSON.stringify(base), names[i] ?? '']));
    for (const { id, loop } of viewer.pinned) {
      const key = JSON.stringify(loop.base);
      const name = wanted.get(key);
      if (!wanted.delete(key)) viewer.unpin(id);
      else viewer.nameLoop(id, name!);
    }
    const { info } = viewer;
    for (const base of loops) {
      if (viewer.info !== info) return;
      const name = wanted.get(JSON.stringify(base));
      if (name === undefined) continue;
      wanted.delete(JSON.stringify(base));
      // A place that this model does not have is no reason to complain.
      const pin = await viewer.pin(base).catch(() => undefined);
      if (pin) viewer.nameLoop(pin.id, name);
    }
    this.#refresh();
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
      this.#changed();
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
