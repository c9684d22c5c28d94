// The girth along a way as a plot, with what is at its cursor in words, and as a table.

import { type GirthViewer, formatLength, make } from '../../src/element/index.js';
import type { LoopKind } from '../../src/kernel/index.js';
import { ProfilePlot } from '../../src/element/plots.js';
import { axisNumber } from './axis-number.js';
import { shareBeside, shareWords } from './share-beside.js';
import { TableActions, type TableSource } from './table-actions.js';
import { byDevice } from './device.js';

/** The girth at one place of the way. */
export interface AlongStation {
  /** The distance from the beginning of the way, in model units. */
  distance: number;
  girth: number;
  kind: LoopKind;
}

export interface Along {
  /** The length of the way, in model units. */
  length: number;
  stations: readonly AlongStation[];
}

export interface AlongWords {
  /** The name of the plot for those who do not see it. */
  label: string;
  /** The course of the way: 'along the surface'. */
  way: string;
  /** The start of distances: 'from the first point'. */
  from: string;
}

export interface AlongEvents extends TableSource {
  /** The cursor is at a station, or nowhere any more. */
  moved(station: number | undefined): void;
  /** A station was clicked, or Enter was pressed there. */
  chosen(station: number): void;
}

const kindWords = { loop: '', antipodal: ', there and back', unresolved: ' at least' } as const;
/** Room above the widest place of the plot. */
const headroom = 1.12;

export class AlongPlot {
  readonly element: HTMLElement;
  readonly #caption = make('p', { class: 'hint' });
  readonly #plot: ProfilePlot;
  readonly #words = make('p', { class: 'station' });
  readonly #actions: TableActions;
  #along: Along | undefined;
  readonly #viewer: GirthViewer;
  readonly #said: AlongWords;

  constructor(viewer: GirthViewer, said: AlongWords, events: AlongEvents) {
    this.#viewer = viewer;
    this.#said = said;
    this.#actions = new TableActions(events);
    this.#plot = new ProfilePlot({
      moved: (station) => {
        this.#write(station);
        events.moved(station);
      },
      chosen: (station) => events.chosen(station),
    });
    this.#plot.element.setAttribute('aria-label', said.label);
    this.element = make(
      'div',
      { class: 'along-path' },
      this.#caption,
      this.#plot.element,
      this.#words,
      this.#actions.element,
    );
    this.show(undefined);
  }

  /** Shows the girth along a way, or nothing; in the present unit. */
  show(along: Along | undefined): void {
    this.#along = along;
    this.element.hidden = !along;
    this.#actions.forget();
    if (!along) return;
    const format = this.#viewer.lengthFormat;
    const { length, stations } = along;
    const girths = stations.map(({ girth, kind }) => (kind === 'unresolved' ? NaN : girth));
    const known = girths.filter((girth) => !Number.isNaN(girth));
    const [least, greatest] = [Math.min(...known), Math.max(...known)];
    // Where no loop goes round, the way there and back is far longer than any: it leaves the plot.
    const loops = stations.filter(({ kind }) => kind === 'loop');
    const highest = Math.max(...(loops.length > 0 ? loops.map(({ girth }) => girth) : known));
    const way = `${formatLength(length, format)} ${this.#said.way}`;
    const share = shareBeside(stations);
    const narrow = share === undefined ? '' : ` Narrowest: ${shareWords(share)}.`;
    this.#caption.textContent =
      known.length === 0
        ? `${way}; no girth is known there.`
        : `${way}; girth ${formatLength(least, format)} to ${formatLength(greatest, format)}.${narrow}`;
    this.#plot.show({
      at: stations.map(({ distance }) => distance),
      lines: [{ y: girths, colour: '#e2571e' }],
      high: highest > 0 ? headroom * highest : 1,
      format: (value) => axisNumber(value, format),
      words: (station) => this.#wordsOf(stations[station]!),
    });
    this.#write(undefined);
  }

  /** Puts the cursor to the station at a distance, or nowhere, without an event. */
  mark(distance: number | undefined): void {
    this.#plot.markPlace(distance);
    const at = this.#along?.stations.findIndex((station) => station.distance === distance) ?? -1;
    this.#write(at < 0 ? undefined : at);
  }

  /** The plot as a file's content; undefined where nothing is shown. */
  svg(width?: number): string | undefined {
    return this.element.hidden ? undefined : this.#plot.svg(width);
  }

  #wordsOf({ distance, girth, kind }: AlongStation): string {
    const format = this.#viewer.lengthFormat;
    const words = kindWords[kind];
    const value = formatLength(girth, format);
    return `${formatLength(distance, format)} ${this.#said.from}: girth${
      kind === 'unresolved' ? `${words} ${value}` : ` ${value}${words}`
    }`;
  }

  #write(station: number | undefined): void {
    this.#words.textContent =
      station === undefined
        ? byDevice(
            'Move along the plot to see the loop there; click to pin it.',
            'Slide along the plot to see the loop there.',
          )
        : this.#wordsOf(this.#along!.stations[station]!);
  }
}
