// Values along a way, as lines, with a cursor that the pointer, a finger or the keyboard moves from
// station to station.

import { PlotFrame, type PlotLine, svgWidth } from './plot-frame.js';

/** The content of a plot. */
export interface ProfileContent {
  /** Where the stations are, ascending. */
  at: ArrayLike<number>;
  /** Values at the stations, one for each; what is no number is left out. */
  lines: readonly PlotLine[];
  /** The value at the upper end of the axis, whose lower end is 0. */
  high: number;
  /** Writes a value at an axis. */
  format: (value: number) => string;
  /** The values at a station, in words. */
  words: (station: number) => string;
}

/** The events of a plot. */
export interface ProfileEvents {
  /** The cursor is at a station, or nowhere any more. */
  moved(station: number | undefined): void;
  /** A station was clicked, or Enter was pressed there. */
  chosen(station: number): void;
}

/** Stations that a key moves; of a page key, a share of all. */
const keySteps: Record<string, number> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
};
const pageShare = 0.1;

/** A plot of values along a way. */
export class ProfilePlot {
  /** To be put into the page, with a label of its own. */
  readonly element = document.createElement('div');
  readonly #frame = new PlotFrame(this.element);
  readonly #mark = document.createElement('div');
  #content: ProfileContent | undefined;
  #station: number | undefined;
  /** Whether the click that has begun chooses. */
  #chooses = true;
  readonly #events: ProfileEvents;

  /** Makes an empty plot. */
  constructor(events: ProfileEvents) {
    this.#events = events;
    const { element } = this;
    const { over } = this.#frame;
    element.className = 'plot profile';
    element.tabIndex = 0;
    element.setAttribute('role', 'slider');
    element.setAttribute('aria-valuemin', '0');
    this.#mark.className = 'plot-mark';
    over.append(this.#mark);
    const point = (event: PointerEvent): void => this.#move(this.#stationAt(event));
    over.addEventListener('pointermove', point);
    // A finger cannot hover: its first tap moves the cursor, which stays, and a tap there chooses.
    over.addEventListener('pointerdown', (event) => {
      const before = this.#station;
      point(event);
      this.#chooses = event.pointerType !== 'touch' || this.#station === before;
    });
    over.addEventListener('pointerleave', ({ pointerType }) => {
      if (pointerType !== 'touch') this.#move(undefined);
    });
    over.addEventListener('click', () => {
      if (this.#chooses) this.#choose();
    });
    element.addEventListener('keydown', (event) => this.#key(event));
    element.addEventListener('blur', () => this.#move(undefined));
    this.#place();
  }

  /** Shows other content; the cursor is nowhere. */
  show(content: ProfileContent): void {
    this.#content = content;
    this.#station = undefined;
    const { at, lines, high, format } = content;
    const end = at[at.length - 1] ?? 1;
    this.#frame.show({
      x: { scale: { low: 0, high: end, log: false }, format },
      y: { scale: { low: 0, high, log: false }, format },
      at,
      lines,
    });
    this.element.setAttribute('aria-valuemax', String(Math.max(0, at.length - 1)));
    this.#place();
  }

  /** Puts the cursor to the station next to a place on the way, without an event; undefined: nowhere. */
  markPlace(place: number | undefined): void {
    this.#station = place === undefined ? undefined : this.#nearest(place);
    this.#place();
  }

  /**
   * The plot as it is now as an SVG file's content, with numbers as text, so many millimetres wide; undefined where nothing
   * is shown, or it is not on a page.
   */
  svg(width = svgWidth): string | undefined {
    return this.#frame.svg(width, this.element.getAttribute('aria-label') ?? '');
  }

  /** Takes the plot out of use. */
  dispose(): void {
    this.#frame.dispose();
  }

  #nearest(place: number): number | undefined {
    const at = this.#content?.at ?? [];
    let best: number | undefined;
    for (let i = 0; i < at.length; ++i) {
      if (best === undefined || Math.abs(at[i]! - place) < Math.abs(at[best]! - place)) best = i;
    }
    return best;
  }

  #stationAt({ clientX }: PointerEvent): number | undefined {
    const at = this.#content?.at ?? [];
    const { left, width } = this.#frame.over.getBoundingClientRect();
    return this.#nearest(((clientX - left) / width) * (at[at.length - 1] ?? 0));
  }

  #move(station: number | undefined): void {
    if (station === this.#station) return;
    this.#station = station;
    this.#place();
    this.#events.moved(station);
  }

  #choose(): void {
    if (this.#station !== undefined) this.#events.chosen(this.#station);
  }

  #key(event: KeyboardEvent): void {
    const count = this.#content?.at.length ?? 0;
    if (count === 0 || event.ctrlKey || event.altKey || event.metaKey) return;
    const page = Math.max(1, Math.round(pageShare * count));
    const step = { ...keySteps, PageUp: page, PageDown: -page }[event.key];
    const from = this.#station ?? (step !== undefined && step < 0 ? count : -1);
    const within = (station: number): number => Math.min(count - 1, Math.max(0, station));
    if (step !== undefined) this.#move(within(from + step));
    else if (event.key === 'Home') this.#move(0);
    else if (event.key === 'End') this.#move(count - 1);
    else if (event.key === 'Enter') this.#choose();
    else if (event.key === 'Escape') this.#move(undefined);
    else return;
    event.preventDefault();
  }

  /** Puts the cursor where it belongs. */
  #place(): void {
    const [mark, content, station] = [this.#mark, this.#content, this.#station];
    mark.hidden = station === undefined;
    this.element.setAttribute('aria-valuenow', String(station ?? 0));
    const words = content && station !== undefined ? content.words(station) : 'nowhere';
    this.element.setAttribute('aria-valuetext', words);
    if (!content || station === undefined) return;
    const { at } = content;
    mark.style.left = `${(100 * at[station]!) / at[at.length - 1]!}%`;
  }
}
