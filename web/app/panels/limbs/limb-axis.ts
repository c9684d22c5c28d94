// The girth along the axis of a limb, with the loop that is swept along it.

import { type GirthViewer, make } from '../../../src/element/index.js';
import type { Limb, LimbAxis } from '../../../src/kernel/index.js';
import { type AlongStation, AlongPlot } from '../../widgets/along-plot.js';
import type { PagePlot } from '../../export/page-plot.js';
import { PanelSearch } from '../../widgets/panel-search.js';
import { saveFile, stemOf } from '../../export/save-file.js';
import { failureWords } from '../../widgets/failure-words.js';
import { type Table, columnOf } from '../../widgets/table-text.js';

/** The loops as lines. */
const lineFormats = ['obj', 'glb'] as const;

export class LimbAxisProfile {
  readonly element: HTMLElement;
  readonly #search: PanelSearch<LimbAxis>;
  readonly #plot: AlongPlot;
  readonly #files = make('p', { class: 'buttons' });
  #limb: Limb | undefined;
  #number = 0;
  readonly #viewer: GirthViewer;

  constructor(viewer: GirthViewer) {
    this.#viewer = viewer;
    this.#search = new PanelSearch<LimbAxis>(viewer, {
      again: 'Measure',
      pending: '',
      parameters: () => [this.#limb],
      stopped: 'Not measured.',
      failed: 'Not measured: ',
      search: (watch) => viewer.axis(this.#limb!, watch('Sweeping a loop along the axis')),
      found: ({ loops }) => {
        this.refresh();
        this.draw(true);
        return loops.length === 0 ? 'No loop goes round it.' : '';
      },
    });
    this.#plot = new AlongPlot(
      viewer,
      {
        label: 'Girth along the axis of the limb, from its tip',
        way: 'along the axis',
        from: 'from its first loop',
      },
      {
        moved: (at) => {
          if (viewer.info) viewer.showLoop(at === undefined ? undefined : this.#baseOf(at));
        },
        chosen: (at) => void viewer.pin(this.#baseOf(at)).catch(() => undefined),
        table: () => this.table,
        fileName: () => `${this.#stem}.csv`,
      },
    );
    for (const format of lineFormats) {
      const attributes = { type: 'button', class: 'plain', title: 'the loops as lines' };
      const button = make('button', attributes, format.toUpperCase());
      button.addEventListener('click', () => void this.#save(format));
      this.#files.append(button);
    }
    this.element = make(
      'div',
      { class: 'limb-axis' },
      this.#search.element,
      this.#plot.element,
      this.#files,
    );
    this.clear();
  }

  /** Which limb it is of, from 1; 0 for none. */
  get number(): number {
    return this.#number;
  }

  /** Measures along the axis of a limb. */
  show(number: number, limb: Limb): void {
    this.clear();
    this.#number = number;
    this.#limb = limb;
    this.element.hidden = false;
    this.#search.start();
  }

  clear(): void {
    this.draw(false);
    this.#search.clear();
    this.#number = 0;
    this.#limb = undefined;
    this.element.hidden = true;
    this.refresh();
  }

  /** Draws the axis, or no longer. */
  draw(isShown: boolean): void {
    const { found } = this.#search;
    if (found && this.#viewer.info) this.#viewer.showCurves(isShown ? [found.polyline] : []);
  }

  /** Words and numbers in the present unit. */
  refresh(): void {
    const { found } = this.#search;
    const stations = found?.loops.map(({ distance, girth }): AlongStation => ({
      distance,
      girth,
      kind: 'loop',
    }));
    const isAny = stations !== undefined && stations.length > 0;
    this.#plot.show(isAny ? { length: found!.length, stations } : undefined);
    this.#files.hidden = !isAny;
  }

  /** Puts the cursor to the loop that is nearest to so far over the surface from the tip, or nowhere. */
  mark(along: number | undefined): void {
    const loops = this.#search.found?.loops ?? [];
    if (loops.length === 0) return;
    const away = (at: number): number => Math.abs(at - (along ?? 0));
    const nearest = loops.reduce((best, one) => (away(one.along) < away(best.along) ? one : best));
    this.#plot.mark(along === undefined ? undefined : nearest.distance);
  }

  get plots(): PagePlot[] {
    return [{ word: `axis-${this.#number}`, svg: (width) => this.#plot.svg(width) }];
  }

  /** The table of `girth profile --limb`, in the unit that is shown. */
  get table(): Table {
    const { unit, scale } = this.#viewer.lengthFormat;
    const area = unit === '' ? '' : `${unit}²`;
    return [
      [
        ...['distance', 'along', 'girth'].map((name) => columnOf(name, unit)),
        columnOf('area', area),
      ],
      ...(this.#search.found?.loops ?? []).map(({ distance, along, girth, area }) => [
        ...[distance, along, girth].map((length) => length * scale),
        area * scale * scale,
      ]),
    ];
  }

  get #stem(): string {
    return `${stemOf(this.#viewer.info?.name ?? 'model')}-axis-${this.#number}`;
  }

  #baseOf(at: number) {
    return this.#search.found!.loops[at]!.points[0]!;
  }

  async #save(format: (typeof lineFormats)[number]): Promise<void> {
    const { found } = this.#search;
    if (!found) return;
    const name = `${this.#stem}.${format}`;
    try {
      saveFile(await this.#viewer.exportProfile(found, format), name);
    } catch (error) {
      this.#search.say(`That could not be written: ${failureWords(error)}.`);
    }
  }
}
