// Three answers to 'how thick here' at each pinned point: its loop, and the perimeter and the tape of the section across the
// limb there.

import { type GirthViewer, formatNumber, make } from '../../../src/element/index.js';
import type { Mesh, SurfacePoint } from '../../../src/kernel/index.js';
import type { TableActions } from '../../widgets/table-actions.js';
import type { Table } from '../../widgets/table-text.js';
import type { PanelKit } from '../../widgets/panel-kit.js';

interface Around {
  perimeter: number;
  tape: number;
}

const none: Around = { perimeter: NaN, tape: NaN };

async function aroundOf(mesh: Mesh, point: SurfacePoint): Promise<Around> {
  const landmarks = (['section', 'tape'] as const).map((how) => {
    return { name: how, point, how, across: true };
  });
  try {
    const { measures } = await mesh.measureLandmarks({ landmarks });
    return { perimeter: measures[0]!.length, tape: measures[1]!.length };
  } catch {
    // No loop there goes round anything.
    return none;
  }
}

export class PinnedSections {
  readonly element: HTMLElement;
  readonly #body = make('tbody');
  readonly #caption = make('caption');
  readonly #actions: TableActions;
  /** Perimeters and tapes on the shown surface, by the point. */
  #known = new Map<string, Around>();
  #surface: object | undefined;
  #isMeasuring = false;
  readonly #viewer: GirthViewer;
  readonly #kit: PanelKit;

  constructor(viewer: GirthViewer, kit: PanelKit) {
    this.#viewer = viewer;
    this.#kit = kit;
    this.#actions = new kit.TableActions({
      table: () => this.table,
      fileName: () => `${kit.stemOf(viewer.info?.name ?? 'model')}-measures.csv`,
    });
    const heads = ['Loop', 'Perimeter', 'Tape'].map((name) =>
      make('th', { scope: 'col', class: 'number' }, name),
    );
    const head = make('tr', {}, make('th', { scope: 'col' }, 'Name'), ...heads);
    this.element = make(
      'section',
      { 'aria-label': 'At pinned loops' },
      make('h3', {}, 'At pinned loops'),
      make(
        'p',
        { class: 'hint' },
        'The loop is the shortest way round on the surface; perimeter and tape are of the plane across the limb there.',
      ),
      make('table', { class: 'loops' }, this.#caption, make('thead', {}, head), this.#body),
      this.#actions.element,
    );
    this.element.hidden = true;
  }

  /** The table for spreadsheets, in the unit that is shown. */
  get table(): Table {
    const { lengthFormat, pinned } = this.#viewer;
    const { unit, scale } = lengthFormat;
    return [
      ['name', ...['loop', 'perimeter', 'tape'].map((name) => this.#kit.columnOf(name, unit))],
      ...pinned.map(({ id, name, loop }) => {
        const { perimeter, tape } = this.#known.get(JSON.stringify(loop.base)) ?? none;
        return [
          name || `loop ${id}`,
          ...[loop.length, perimeter, tape].map((length) => length * scale),
        ];
      }),
    ];
  }

  /** The pinned loops, their names, or the unit have changed. */
  refresh(isOpen: boolean): void {
    const viewer = this.#viewer;
    if (viewer.info !== this.#surface) {
      this.#surface = viewer.info;
      this.#known = new Map();
    }
    const { pinned, lengthFormat } = viewer;
    this.element.hidden = pinned.length === 0;
    this.#caption.textContent = lengthFormat.unit ? `Lengths in ${lengthFormat.unit}` : '';
    const rows = pinned.map(({ id, name, loop }) => {
      const around = this.#known.get(JSON.stringify(loop.base));
      const lengths = [loop.length, around?.perimeter, around?.tape].map((length) => {
        const text = length === undefined ? '…' : formatNumber(length, lengthFormat);
        return make('td', { class: 'number' }, Number.isNaN(length) ? '–' : text);
      });
      return make('tr', {}, make('th', { scope: 'row' }, name || `loop ${id}`), ...lengths);
    });
    this.#body.replaceChildren(...rows);
    this.#actions.forget();
    if (isOpen && !this.#isMeasuring) void this.#measure();
  }

  /** One point after another: a hand that moves over the surface comes in between. */
  async #measure(): Promise<void> {
    const viewer = this.#viewer;
    this.#isMeasuring = true;
    const next = (): SurfacePoint | undefined =>
      viewer.pinned.find(({ loop }) => !this.#known.has(JSON.stringify(loop.base)))?.loop.base;
    for (let point = next(); point !== undefined; point = next()) {
      const known = this.#known;
      const mesh = await viewer.mesh.catch(() => undefined);
      if (!mesh) break;
      known.set(JSON.stringify(point), await aroundOf(mesh, point));
      this.refresh(false);
    }
    this.#isMeasuring = false;
  }
}
