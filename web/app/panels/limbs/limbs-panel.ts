// The limbs: how long each is and how thick, as a table, with a plot of the girth along it whose cursor moves
// the loop over the surface.

import { type GirthViewer, formatLength, formatNumber, make } from '../../../src/element/index.js';
import type { GirthStation, Limb, LimbEnd, Limbs } from '../../../src/kernel/index.js';
import { ProfilePlot } from '../../../src/element/plots.js';
import type { Store } from '../../state/store.js';
import { longestName } from '../../state/address-state.js';
import { axisNumber } from '../../widgets/axis-number.js';
import { LimbAxisProfile } from './limb-axis.js';
import { Draft } from '../../widgets/draft.js';
import { plural } from '../../model/model-words.js';
import type { PagePlot } from '../../export/page-plot.js';
import type { Panel } from '../../widgets/panel.js';
import { PanelSearch } from '../../widgets/panel-search.js';
import { stemOf } from '../../export/save-file.js';
import { TableActions } from '../../widgets/table-actions.js';
import { type Table, columnOf } from '../../widgets/table-text.js';
import { term } from '../../help/term.js';
import { byDevice } from '../../widgets/device.js';

/** The words that follow 'Limb 3 ends ...'. */
const endWords: Record<LimbEnd, string> = {
  spreads: 'where it spreads into a thicker part',
  slips: 'where loops slip off to other parts',
  splits: 'where it splits',
  handle: 'at a handle',
  boundary: 'at the boundary of the surface',
  whole: 'nowhere: it is the whole shape',
};
/** The lengths that are listed for a limb. */
const measures = ['length', 'narrowest', 'median', 'middle', 'base'] as const;
const measureWords = {
  length: 'Length',
  narrowest: 'Narrowest',
  median: 'Median',
  middle: 'Middle',
  base: 'Base',
};
/** More limbs than these are only counted. */
const mostRows = 40;
/** Room above the thickest place of a plot. */
const headroom = 1.12;

interface Row {
  limb: Limb;
  number: number;
  elements: HTMLElement[];
  plot: ProfilePlot;
  choose: HTMLButtonElement;
  words: HTMLElement;
  axis: HTMLButtonElement;
  name: Draft;
  /** The cell, as wide as the table, of the plot along the limb. */
  wide: HTMLElement;
  cells: HTMLElement[];
}

export class LimbsPanel {
  readonly panel: Panel;
  readonly #caption = make('caption');
  readonly #body = make('tbody');
  readonly #table: HTMLTableElement;
  readonly #more = make('p', { class: 'hint' });
  readonly #actions = new TableActions({
    table: () => this.table,
    fileName: () => `${stemOf(this.#viewer.info?.name ?? 'model')}-limbs.csv`,
  });
  readonly #search: PanelSearch<Limbs>;
  readonly #axis: LimbAxisProfile;
  #rows: Row[] = [];
  #selected: Row | undefined;
  /** For each vertex the row of its shortest limb, and its distance from the limb's apex. */
  #places: Map<number, { row: Row; distance: number }> = new Map();
  readonly #viewer: GirthViewer;
  readonly #store: Store;

  constructor(viewer: GirthViewer, store: Store, panel: Panel) {
    this.panel = panel;
    this.#viewer = viewer;
    this.#store = store;
    const heads = measures.map((name) =>
      make('th', { scope: 'col', class: 'number' }, measureWords[name]),
    );
    const head = make('tr', {}, make('th', { scope: 'col', 'aria-label': 'Limb' }, '#'), ...heads);
    this.#table = make(
      'table',
      { class: 'loops limbs' },
      this.#caption,
      make('thead', {}, head),
      this.#body,
    );
    this.#search = new PanelSearch(viewer, {
      again: 'Measure',
      pending: 'Limbs follow as soon as the girth is computed …',
      parameters: () => [store.shown.persistence, store.shown.method],
      stopped: 'Not measured.',
      failed: 'No limbs: ',
      search: (watch) => viewer.limbs(watch('Measuring limbs')),
      found: ({ limbs }) => {
        this.#show();
        this.#showAxis();
        return limbs.length === 0 ? 'No limb before a tip is longer than thick.' : '';
      },
    });
    this.panel.body.append(
      make(
        'p',
        { class: 'hint' },
        'A limb ends in a ',
        term('tip', 'tip'),
        ': a finger, an arm, a leg. Move along a plot to slide its ',
        term('loop', 'loop'),
        `${byDevice('; click to pin it', '')}. Solid: the least girth there, dashed: the median.`,
      ),
      this.#search.element,
      this.#table,
      this.#more,
      this.#actions.element,
    );
    this.#axis = new LimbAxisProfile(viewer);
    this.panel.onToggle((isOpen) => {
      if (isOpen) this.#search.start();
      else this.#select(undefined);
      this.#showNames();
      // The axis is drawn after another panel has taken its own lines away.
      queueMicrotask(() => this.#axis.draw(this.panel.isOpen));
      this.#showAxis();
    });
    store.watch(['axis'], () => this.#showAxis());
    store.watch(['limbNames'], () => this.#showNames());
    store.watch(['persistence', 'method'], () => {
      // Another girth has other limbs.
      if (this.#search.found && !this.#search.isCurrent) this.clear();
      if (this.panel.isOpen) this.#search.start();
    });
    viewer.addEventListener('unit', () => {
      this.#refresh();
      this.#axis.refresh();
    });
    viewer.addEventListener('hover', (event) => {
      const { vertex } = event.detail;
      this.#point(vertex);
    });
    this.clear();
    if (panel.isOpen) this.#search.start();
  }

  /** Another model, or another girth, to be measured anew. */
  clear(): void {
    this.#search.clear();
    this.#selected = undefined;
    this.#axis.clear();
    this.#show();
  }

  /** The girth is computed: what waits for it goes on. */
  girthIsThere(): void {
    if (this.panel.isOpen) this.#search.start();
  }

  /** The table for spreadsheets, in the unit that is shown. */
  get table(): Table {
    const { unit, scale } = this.#viewer.lengthFormat;
    return [
      [
        'limb',
        ...['length', 'narrowest', 'narrowest at', 'median', 'middle', 'base'].map((name) =>
          columnOf(name, unit),
        ),
        'ends',
        'apex vertex',
      ],
      ...(this.#search.found?.limbs ?? []).map((limb, i) => [
        this.#nameOf(i + 1) || i + 1,
        limb.length * scale,
        limb.narrowest * scale,
        limb.narrowestDistance * scale,
        limb.median * scale,
        limb.middle * scale,
        limb.base * scale,
        limb.end,
        limb.apex,
      ]),
    ];
  }

  get plots(): PagePlot[] {
    const rows = this.#rows.map(({ plot, number }) => ({
      word: `limb-${number}`,
      svg: (width?: number) => plot.svg(width),
    }));
    return [...rows, ...this.#axis.plots];
  }

  /** All profiles, a row for each station; they are measured first unless they are there. */
  async profiles(): Promise<Table> {
    const { limbs } = this.#search.found ?? (await this.#viewer.limbs());
    const { unit, scale } = this.#viewer.lengthFormat;
    return [
      [
        'limb',
        ...['distance', 'least girth', 'median girth', 'ring'].map((name) => columnOf(name, unit)),
      ],
      ...limbs.flatMap(({ profile }, i) =>
        profile.map(({ distance, least, median, ring }) => [
          this.#nameOf(i + 1) || i + 1,
          ...[distance, least, median, ring].map((length) => length * scale),
        ]),
      ),
    ];
  }

  /** Rows for what was found. */
  #show(): void {
    for (const { plot } of this.#rows) plot.dispose();
    const limbs = this.#search.found?.limbs ?? [];
    this.#rows = limbs.slice(0, mostRows).map((limb, i) => this.#row(limb, i + 1));
    this.#body.replaceChildren(...this.#rows.flatMap(({ elements }) => elements));
    this.#places = new Map();
    // Longest first, so that a vertex in several goes to the shortest.
    for (const row of this.#rows) {
      row.limb.vertices.forEach((vertex, k) =>
        this.#places.set(vertex, { row, distance: row.limb.distances[k]! }),
      );
    }
    const hidden = limbs.length - this.#rows.length;
    this.#more.textContent =
      hidden > 0
        ? `and ${plural(hidden, 'shorter one', 'shorter ones')}, in the table to copy`
        : '';
    this.#table.hidden = this.#actions.element.hidden = limbs.length === 0;
    this.#actions.forget();
    this.panel.summary = this.#search.found ? String(limbs.length) : '';
    this.#showNames();
    this.#refresh();
  }

  #row(limb: Limb, number: number): Row {
    const store = this.#store;
    const choose = make('button', { type: 'button', 'aria-pressed': 'false' }, String(number));
    const cells = measures.map(() => make('td', { class: 'number' }));
    const words = make('p', { class: 'hint' });
    const plot = new ProfilePlot({
      moved: (station) => this.#follow(row, station),
      chosen: (station) => void this.#pin(number, limb.profile[station]!).catch(() => undefined),
    });
    const axis = make('button', { type: 'button', class: 'plain' }, 'Profile along the axis');
    const input = make('input', {
      type: 'text',
      placeholder: 'Name',
      maxlength: String(longestName),
      'aria-label': `Name of limb ${number}`,
    });
    const name = new Draft(input, { committed: (text) => this.#rename(number, text) });
    const line = make('p', { class: 'buttons' }, input, axis);
    const wide = make('td', { colspan: String(1 + measures.length) }, plot.element, words, line);
    const elements = [
      make('tr', {}, make('th', { scope: 'row' }, choose), ...cells),
      make('tr', { class: 'along' }, wide),
    ];
    const row: Row = { limb, number, elements, plot, choose, words, axis, name, wide, cells };
    axis.setAttribute('aria-label', `Profile along the axis of limb ${number}`);
    axis.addEventListener('click', () => {
      store.choose({ axis: store.shown.axis === number ? undefined : number });
    });
    plot.element.setAttribute('aria-label', `Girth along limb ${number}, from its tip to its base`);
    choose.addEventListener('click', () => {
      this.#select(this.#selected === row ? undefined : row);
    });
    return row;
  }

  /** Numbers, plots and words in the present unit. */
  #refresh(): void {
    const format = this.#viewer.lengthFormat;
    this.#caption.textContent = format.unit ? `Lengths and girths in ${format.unit}` : '';
    this.#actions.forget();
    for (const { limb, number, plot, choose, cells, words } of this.#rows) {
      measures.forEach((name, i) => {
        const value = limb[name];
        cells[i]!.textContent = Number.isNaN(value) ? '–' : formatNumber(value, format);
      });
      choose.setAttribute(
        'aria-label',
        `Limb ${number}, ${formatLength(limb.length, format)} long: show it`,
      );
      words.textContent = this.#endOf(limb);
      const { profile } = limb;
      const known = profile.map(({ least, median }) => (Number.isNaN(least) ? NaN : median));
      const least = profile.map((station) => station.least);
      // Near the tip the median is that of loops which have slipped off: far above what is of interest.
      const base = profile.at(-1)!;
      const highest = Math.max(...[...least, base.median].filter((value) => !Number.isNaN(value)));
      plot.show({
        at: profile.map(({ distance }) => distance),
        lines: [
          { y: known, colour: '#8a8f99', dash: [3, 3] },
          { y: least, colour: '#e2571e' },
        ],
        high: highest > 0 ? headroom * highest : 1,
        format: (value) => axisNumber(value, format),
        words: (station) => this.#wordsOf(profile[station]!),
      });
    }
  }

  #endOf({ end }: Limb): string {
    return `Ends ${endWords[end]}.`;
  }

  #wordsOf({ distance, least, median }: GirthStation): string {
    const format = this.#viewer.lengthFormat;
    const from = `${formatLength(distance, format)} from the tip`;
    return Number.isNaN(least)
      ? `${from}: no loop goes round`
      : `${from}: girth ${formatLength(least, format)}, median ${formatLength(median, format)}`;
  }

  /** The cursor of a plot has moved: the loop goes with it. */
  #follow(row: Row, station: number | undefined): void {
    const at = station === undefined ? undefined : row.limb.profile[station];
    for (const other of this.#rows) if (other !== row) this.#write(other, undefined);
    row.words.textContent = at ? this.#wordsOf(at) : this.#endOf(row.limb);
    if (this.#viewer.info) this.#viewer.showLoop(at?.place);
  }

  /** Pins the loop at a station, which is called as the limb is. */
  async #pin(number: number, { place }: GirthStation): Promise<void> {
    if (place === undefined) return;
    const { id } = await this.#viewer.pin(place);
    this.#viewer.nameLoop(id, this.#nameOf(number) || `limb ${number}`);
  }

  /** The name that somebody gave a limb; '' for none. */
  #nameOf(number: number): string {
    return this.#store.shown.limbNames?.[number - 1] ?? '';
  }

  #rename(number: number, text: string): void {
    const names = this.#rows.map((row) => this.#nameOf(row.number));
    names[number - 1] = text.trim();
    this.#store.choose({ limbNames: names.some((name) => name !== '') ? names : [] });
  }

  /** Numbers or names, in the list and on the surface while the panel is open. */
  #showNames(): void {
    for (const { number, name } of this.#rows) name.show(this.#nameOf(number));
    this.#actions.forget();
    if (!this.#viewer.info) return;
    const shown = this.panel.isOpen ? this.#rows : [];
    this.#viewer.showNumbers(
      shown.map(({ limb, number }) => ({
        point: middleOf(limb),
        text: this.#nameOf(number) || String(number),
      })),
    );
  }

  /** The pointer is at a vertex of the surface: the cursor of its limb goes there. */
  #point(vertex: number | undefined): void {
    if (!this.panel.isOpen) return;
    const at = vertex === undefined ? undefined : this.#places.get(vertex);
    for (const row of this.#rows) this.#write(row, row === at?.row ? at.distance : undefined);
    this.#axis.mark(at?.row.number === this.#axis.number ? at?.distance : undefined);
    at?.row.elements[1]!.scrollIntoView({ block: 'nearest' });
  }

  /** Puts the cursor of a row to a distance from its tip, or nowhere. */
  #write(row: Row, distance: number | undefined): void {
    row.plot.markPlace(distance);
    const [first, last] = row.elements;
    for (const element of [first!, last!])
      element.classList.toggle('pointed', distance !== undefined);
    const station =
      distance === undefined
        ? undefined
        : row.limb.profile.reduce((best, one) =>
            Math.abs(one.distance - distance) < Math.abs(best.distance - distance) ? one : best,
          );
    row.words.textContent = station ? this.#wordsOf(station) : this.#endOf(row.limb);
  }

  /** The girth along the axis that is asked for, once the limbs are there. */
  #showAxis(): void {
    const row = this.#rows.find(({ number }) => number === this.#store.shown.axis);
    for (const { axis, number } of this.#rows) {
      axis.setAttribute('aria-pressed', String(number === row?.number));
    }
    if (!row) {
      this.#axis.clear();
      return;
    }
    if (row.number === this.#axis.number || !this.panel.isOpen) return;
    row.wide.append(this.#axis.element);
    this.#axis.show(row.number, row.limb);
  }

  /** Shows one limb as it is and fades the rest of the surface; undefined: no longer. */
  #select(row: Row | undefined): void {
    if (row === this.#selected) return;
    this.#selected = row;
    for (const one of this.#rows) one.choose.setAttribute('aria-pressed', String(one === row));
    const viewer = this.#viewer;
    if (!viewer.info) return;
    viewer.mark(row?.limb.vertices);
    if (row) viewer.flyTo({ vertices: row.limb.vertices });
  }
}

/** The vertex of a limb that is nearest to half of its length. */
function middleOf({ apex, vertices, distances, length }: Limb): number {
  let middle = apex;
  let least = Infinity;
  distances.forEach((distance, i) => {
    const away = Math.abs(distance - length / 2);
    if (away >= least) return;
    least = away;
    middle = vertices[i]!;
  });
  return middle;
}
