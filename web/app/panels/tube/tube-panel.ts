// Tubes: where vessels, roots and pipes are narrower or wider than on both sides, and their diameters along the centreline. It
// is fetched when the panel is opened.

import { type GirthViewer, formatLength, make } from '../../../src/element/index.js';
import type { ProfilePlot } from '../../../src/element/plots.js';
import type {
  NoTube,
  TubeBranch,
  TubePlace,
  TubeReference,
  TubeStation,
  Tubes,
} from '../../../src/kernel/index.js';
import type { PagePlot } from '../../export/page-plot.js';
import type { Store } from '../../state/store.js';
import type { Draft } from '../../widgets/draft.js';
import type { Panel } from '../../widgets/panel.js';
import type { PanelKit } from '../../widgets/panel-kit.js';
import type { PanelSearch } from '../../widgets/panel-search.js';
import type { PlaceList } from '../../widgets/place-list.js';
import type { TableActions } from '../../widgets/table-actions.js';
import type { Table } from '../../widgets/table-text.js';

/** The diameters that degrees are measured against, in words. */
const references: Readonly<Record<TubeReference, string>> = {
  taper: 'the taper',
  mean: 'the mean',
  before: 'the side before',
  beyond: 'the side beyond',
};

/** The words that follow 'The surface'. */
const noTubeWords: Readonly<Record<NoTube, string>> = {
  handle: 'has a handle; cut it first',
  blunt: 'is less than 2.5 times as long as wide',
  flat: 'is more than four times as wide as thick',
  coarse: 'has no closed section across its line',
};

/** More branches than these have no plot: the table has all. */
const mostBranches = 100;
/** Room above the widest place of the plot. */
const headroom = 1.12;

const percent = (share: number): string => `${(100 * share).toFixed(1)}\u202f%`;

export class TubePanel {
  readonly #reference = make('select', { id: 'tube-reference' });
  readonly #referenceDraft: Draft;
  readonly #branch = make('select', { id: 'tube-branch' });
  readonly #branchDraft: Draft;
  readonly #branchLine: HTMLElement;
  readonly #search: PanelSearch<Tubes>;
  readonly #places: PlaceList;
  readonly #plot: ProfilePlot;
  readonly #along: HTMLElement;
  readonly #words = make('p', { class: 'station' });
  readonly #actions: TableActions;
  /** The number of the branch that the plot is of. */
  #shown = 0;
  /** Whether lines of the tube are on the surface now: lines of other panels stay. */
  #isDrawn = false;
  readonly #viewer: GirthViewer;
  readonly #store: Store;
  readonly #panel: Panel;
  readonly #kit: PanelKit;

  constructor(viewer: GirthViewer, store: Store, panel: Panel, kit: PanelKit) {
    this.#viewer = viewer;
    this.#store = store;
    this.#panel = panel;
    this.#kit = kit;
    this.#referenceDraft = new kit.Draft(this.#reference, {
      committed: (reference) =>
        store.choose({
          reference: reference === 'taper' ? undefined : (reference as TubeReference),
        }),
    });
    for (const [value, words] of Object.entries(references)) {
      this.#reference.append(make('option', { value }, words));
    }
    this.#branchDraft = new kit.Draft(this.#branch, {
      committed: (number) => this.#showBranch(Number(number)),
    });
    this.#places = new kit.PlaceList('Narrowings and widenings');
    this.#plot = new kit.ProfilePlot({
      moved: (station) => this.#follow(station),
      chosen: (station) => this.#pin(this.#stations[station]!),
    });
    this.#plot.element.setAttribute('aria-label', 'Diameter along the centreline');
    this.#actions = new kit.TableActions({
      table: () => this.table,
      fileName: () => `${kit.stemOf(viewer.info?.name ?? 'model')}-tube.csv`,
    });
    this.#search = new kit.PanelSearch<Tubes>(viewer, {
      again: 'Measure',
      pending: '',
      needsGirth: false,
      parameters: () => [store.shown.reference],
      stopped: 'Not measured.',
      failed: 'Not measured: ',
      search: async (watch) => {
        const reference = store.shown.reference ?? 'taper';
        return (await viewer.mesh).tubes({ reference, ...watch('Measuring the tube') });
      },
      found: (found) => {
        this.#shown = 0;
        this.#show();
        return wordsOf(found);
      },
    });
    this.#branchLine = make(
      'p',
      { class: 'row' },
      make('label', { for: 'tube-branch' }, 'Branch'),
      this.#branch,
    );
    this.#along = make(
      'div',
      { class: 'along-path' },
      this.#branchLine,
      this.#plot.element,
      this.#words,
      this.#actions.element,
    );
    panel.body.append(
      make(
        'p',
        { class: 'hint' },
        'A tube is a vessel, a root, a horn or a pipe. Its diameter is that of a circle with the area of the section across its centreline.',
      ),
      make(
        'p',
        { class: 'row' },
        make('label', { for: 'tube-reference' }, 'Compared with'),
        this.#reference,
      ),
      this.#search.element,
      this.#places.element,
      this.#along,
    );
    panel.onToggle((isOpen) => {
      if (isOpen) this.#start();
      // Lines are drawn after another panel has taken its own away.
      queueMicrotask(() => this.#draw());
    });
    store.watch(['reference'], () => this.#start());
    viewer.addEventListener('load', () => {
      this.#search.clear();
      this.#show();
      this.#start();
    });
    viewer.addEventListener('unit', () => this.#show());
    this.#show();
    this.#start();
  }

  /** The table for spreadsheets, in the unit that is shown. */
  get table(): Table {
    const { unit, scale } = this.#viewer.lengthFormat;
    const { columnOf } = this.#kit;
    const lengths = ['equivalent diameter', 'inscribed diameter', 'least width', 'greatest width'];
    return [
      [
        'branch',
        ...['distance', ...lengths, 'perimeter', 'girth'].map((name) => columnOf(name, unit)),
        columnOf('area', unit && `${unit}²`),
      ],
      ...(this.#search.found?.stations ?? []).map((one) => [
        one.branch,
        ...[one.distance, one.equivalentDiameter, one.inscribedDiameter, one.leastWidth].map(
          (length) => length * scale,
        ),
        ...[one.greatestWidth, one.perimeter, one.girth].map((length) => length * scale),
        one.area * scale * scale,
      ]),
    ];
  }

  get plots(): PagePlot[] {
    return this.#along.hidden
      ? []
      : [{ word: `tube-${this.#shown}`, svg: (width) => this.#plot.svg(width) }];
  }

  #start(): void {
    this.#referenceDraft.show(this.#store.shown.reference ?? 'taper');
    if (this.#panel.isOpen) this.#search.start();
  }

  get #branchShown(): TubeBranch | undefined {
    return this.#search.found?.branches[this.#shown];
  }

  /** The stations of the branch that the plot is of. */
  get #stations(): TubeStation[] {
    const branch = this.#branchShown;
    const all = this.#search.found?.stations ?? [];
    return branch ? all.slice(branch.firstStation, branch.endStation) : [];
  }

  /** Rows and plot of what was found, in the present unit. */
  #show(): void {
    const found = this.#search.found;
    const branches = (found?.branches ?? []).slice(0, mostBranches);
    this.#places.show((found?.places ?? []).map((place, i) => this.#row(place, i)));
    this.#along.hidden = branches.length === 0;
    this.#branchLine.hidden = branches.length < 2;
    this.#branch.replaceChildren(
      ...branches.map((branch, i) => make('option', { value: String(i) }, this.#nameOf(branch, i))),
    );
    this.#panel.summary = found ? String(found.places.length) : '';
    this.#showBranch(this.#shown);
    this.#draw();
  }

  #nameOf({ firstDistance, lastDistance, median }: TubeBranch, i: number): string {
    const format = this.#viewer.lengthFormat;
    const length = formatLength(lastDistance - firstDistance, format);
    return `${i + 1}: ${length} long, ${formatLength(median, format)} wide`;
  }

  #row(place: TubePlace, i: number): Parameters<PlaceList['show']>[0][number] {
    const format = this.#viewer.lengthFormat;
    const { change, degreeByDiameter, degreeByArea, equivalentDiameter, distance } = place;
    const { places } = this.#search.found!;
    const at = formatLength(distance, format);
    return {
      main: `${percent(degreeByDiameter)} ${change === 'narrowing' ? 'narrower' : 'wider'}`,
      detail: `${percent(degreeByArea)} by area; ${formatLength(equivalentDiameter, format)} wide at ${at}, ${formatLength(place.length, format)} long`,
      choose: () => {
        this.#showBranch(place.branch);
        this.#viewer.flyTo({ polyline: places[i]!.polyline });
      },
      attend: (isAttended) => this.#draw(isAttended ? [place.polyline] : []),
    };
  }

  /** The plot of one branch. */
  #showBranch(number: number): void {
    this.#shown = number;
    this.#branchDraft.show(String(number));
    this.#actions.forget();
    const format = this.#viewer.lengthFormat;
    const stations = this.#stations;
    if (stations.length === 0) return;
    const widest = Math.max(...stations.map(({ equivalentDiameter }) => equivalentDiameter));
    this.#plot.show({
      at: stations.map(({ distance }) => distance),
      lines: [
        { y: stations.map((one) => one.inscribedDiameter), colour: '#8a8f99', dash: [3, 3] },
        { y: stations.map((one) => one.equivalentDiameter), colour: '#e2571e' },
      ],
      high: widest > 0 ? headroom * widest : 1,
      format: (value) => this.#kit.axisNumber(value, format),
      words: (station) => this.#wordsOf(stations[station]!),
    });
    this.#write(undefined);
  }

  #wordsOf({ distance, equivalentDiameter, inscribedDiameter, girth }: TubeStation): string {
    const format = this.#viewer.lengthFormat;
    const [at, wide, inside] = [distance, equivalentDiameter, inscribedDiameter].map((length) =>
      formatLength(length, format),
    );
    const loop = Number.isNaN(girth) ? 'no loop' : formatLength(girth, format);
    return `${at} from the beginning: diameter ${wide}, largest circle inside ${inside}, girth ${loop}`;
  }

  #write(station: TubeStation | undefined): void {
    this.#words.textContent = station
      ? this.#wordsOf(station)
      : 'Solid: the diameter; dashed: of the largest circle inside. Move along the plot to see the section; click to pin the loop.';
  }

  /** The cursor of the plot has moved: the section goes with it. */
  #follow(at: number | undefined): void {
    const station = at === undefined ? undefined : this.#stations[at];
    this.#write(station);
    this.#draw(station ? [station.polyline] : []);
  }

  #pin({ place, girth }: TubeStation): void {
    if (!Number.isNaN(girth)) void this.#viewer.pin(place).catch(() => undefined);
  }

  /** Draws the outlines of all places, and others. */
  #draw(others: readonly Float32Array[] = []): void {
    const viewer = this.#viewer;
    if (!viewer.info || (!this.#panel.isOpen && !this.#isDrawn)) return;
    this.#isDrawn = this.#panel.isOpen;
    const places = this.#search.found?.places ?? [];
    viewer.showCurves(this.#isDrawn ? [...places.map(({ polyline }) => polyline), ...others] : []);
  }
}

function wordsOf({ branches, others, places }: Tubes): string {
  if (branches.length === 0) {
    const [first] = others;
    return first ? `The surface is no tube: it ${noTubeWords[first.reason]}.` : '';
  }
  const count = branches.length;
  const tubes = count === 1 ? 'One branch' : `${count} branches`;
  return places.length === 0 ? `${tubes}, without a narrowing or a bulge.` : `${tubes}.`;
}
