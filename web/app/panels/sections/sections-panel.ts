// Sections: a plane by its height, the curves in which it cuts the surface, and their measures. It is fetched when the panel
// is opened.

import {
  type GirthViewer,
  formatLength,
  formatNumber,
  make,
  parseSection,
} from '../../../src/element/index.js';
import type { Section, SectionCurve } from '../../../src/kernel/index.js';
import type { Store } from '../../state/store.js';
import type { Draft } from '../../widgets/draft.js';
import type { LengthInput } from '../../widgets/length-input.js';
import type { Panel } from '../../widgets/panel.js';
import type { TableActions } from '../../widgets/table-actions.js';
import type { Table } from '../../widgets/table-text.js';
import type { PanelKit } from '../../widgets/panel-kit.js';
import { PinnedSections } from './pinned-sections.js';

type Direction = readonly [number, number, number];

/** A plane across a direction: which share of the surface lies below it, and where that is along the direction. */
interface Plane {
  /** As the attribute `section` has it: 'z', '-x', '0.5,0.2,0.8'. */
  across: string;
  normal: Direction;
  share: number;
  low: number;
  high: number;
}

const axes = ['x', 'y', 'z'] as const;
/** The plane's place at first, as a share of the surface. */
const middle = 0.5;
/** Steps of the slider. */
const steps = 1000;
/** Digits of a share in percent: those of a typed height. */
const digits = 9;
/** More curves than these are only counted. */
const mostRows = 40;

/** The number behind a curve, and what it is beside a closed outline. */
const kindOf = ({ closed, hole }: SectionCurve): string =>
  closed ? (hole ? 'a hole' : '') : 'open: it ends at the boundary';

export class SectionsPanel {
  readonly #across = make('select', { id: 'section-across' });
  readonly #acrossDraft: Draft;
  readonly #height: LengthInput;
  readonly #place = make('input', {
    id: 'section-place',
    type: 'range',
    min: '0',
    max: String(steps),
    'aria-label': 'Height of the plane',
  });
  readonly #placeDraft: Draft;
  readonly #words = make('p', { class: 'said', role: 'status' });
  readonly #caption = make('caption');
  readonly #body = make('tbody');
  readonly #table: HTMLTableElement;
  readonly #more = make('p', { class: 'hint' });
  readonly #actions: TableActions;
  readonly #pinned: PinnedSections;
  #plane: Plane | undefined;
  /** The section that is shown, and of which plane. */
  #section: Section | undefined;
  /** A plane is being asked for: the one that came last is asked for next. */
  #isAsking = false;
  #isStale = false;
  /** The hand moves the plane: nothing is said before it rests. */
  #isMoving = false;
  /** Whether curves of the section are on the surface now: lines of others stay. */
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
    this.#acrossDraft = new kit.Draft(this.#across, {
      committed: (across) => this.#choose(`${across} ${100 * (this.#plane?.share ?? middle)}%`),
    });
    this.#placeDraft = new kit.Draft(this.#place, {
      edited: (step) => this.#slide(step, true),
      committed: (step) => this.#slide(step, false),
    });
    this.#actions = new kit.TableActions({
      table: () => this.table,
      fileName: () => `${kit.stemOf(viewer.info?.name ?? 'model')}-section.csv`,
    });
    this.#height = new kit.LengthInput('section-height', 'at', {
      changed: (height) => this.#goTo(height),
      wrong: (why) => (this.#words.textContent = why),
    });
    for (const axis of axes) this.#across.append(make('option', { value: axis }, axis));
    const heads = ['Tape', 'Perimeter', 'Area', 'Widths'].map((name) =>
      make('th', { scope: 'col', class: 'number' }, name),
    );
    this.#table = make(
      'table',
      { class: 'loops limbs' },
      this.#caption,
      make(
        'thead',
        {},
        make('tr', {}, make('th', { scope: 'col', 'aria-label': 'Curve' }, '#'), ...heads),
      ),
      this.#body,
    );
    this.#pinned = new PinnedSections(viewer, kit);
    panel.body.append(
      make(
        'p',
        { class: 'hint' },
        'A plane cuts the surface in curves. The perimeter follows each into its hollows; a tape spans them.',
      ),
      make(
        'p',
        { class: 'row' },
        make('label', { for: 'section-across' }, 'Across'),
        this.#across,
        this.#height.label,
      ),
      this.#place,
      this.#words,
      this.#table,
      this.#more,
      this.#actions.element,
      this.#pinned.element,
    );
    panel.onToggle((isOpen) => {
      // Lines are drawn after another panel has taken its own away.
      queueMicrotask(() => this.#draw());
      if (isOpen) this.#follow();
      this.#pinned.refresh(isOpen);
    });
    new MutationObserver(() => this.#follow()).observe(viewer, { attributeFilter: ['section'] });
    for (const event of ['load', 'unit'] as const) {
      viewer.addEventListener(event, () => {
        if (event === 'load') this.#section = undefined;
        this.#show();
        this.#follow();
      });
    }
    for (const event of ['load', 'unit', 'pick'] as const) {
      viewer.addEventListener(event, () => this.#pinned.refresh(panel.isOpen));
    }
    this.#show();
    this.#follow();
    this.#pinned.refresh(panel.isOpen);
  }

  /** The table for spreadsheets, in the unit that is shown. */
  get table(): Table {
    const { unit, scale } = this.#viewer.lengthFormat;
    const { columnOf } = this.#kit;
    const area = columnOf('area', unit && `${unit}²`);
    const lengths = ['tape', 'perimeter'].map((name) => columnOf(name, unit));
    const widths = ['least width', 'greatest width'].map((name) => columnOf(name, unit));
    const section = this.#section;
    const rows = section?.curves.map((curve, i) => [
      i,
      ...[curve.tape, curve.perimeter].map((length) => length * scale),
      curve.area * scale * scale,
      ...[curve.leastWidth, curve.greatestWidth].map((length) => length * scale),
      kindOf(curve),
    ]);
    return [['curve', ...lengths, area, ...widths, 'kind'], ...(rows ?? [])];
  }

  /** The plane that the attribute asks for; across the way up at half the height where there is none. */
  get #asked(): Plane | undefined {
    const viewer = this.#viewer;
    if (!viewer.info) return undefined;
    const text = viewer.getAttribute('section') || `${viewer.upAxis?.name ?? 'z'} ${100 * middle}%`;
    const wish = parseSection(text);
    if (!wish) return undefined;
    const length = Math.hypot(...wish.direction);
    const normal = wish.direction.map((part) => part / length) as unknown as Direction;
    const [a, b, c] = normal;
    const { positions, origin } = viewer.geometry;
    let [low, high] = [Infinity, -Infinity];
    for (let i = 0; i < positions.length; i += 3) {
      const at = a * positions[i]! + b * positions[i + 1]! + c * positions[i + 2]!;
      if (at < low) low = at;
      if (at > high) high = at;
    }
    const base = a * origin[0] + b * origin[1] + c * origin[2];
    const across = text.trim().split(/\s+/)[0]!;
    return { across, normal, share: wish.share, low: low + base, high: high + base };
  }

  /** A typed height. */
  #goTo(height: number | undefined): void {
    const plane = this.#plane;
    if (height === undefined || !plane) return;
    const { low, high } = plane;
    const format = this.#viewer.lengthFormat;
    if (!(height >= low && height <= high)) {
      const [from, to] = [low, high].map((length) => formatLength(length, format));
      this.#words.textContent = `The surface reaches from ${from} to ${to}.`;
      return;
    }
    const percent = ((100 * (height - low)) / (high - low || 1)).toFixed(digits);
    this.#choose(`${plane.across} ${Number(percent)}%`);
  }

  #slide(step: string, isMoving: boolean): void {
    if (this.#plane)
      this.#choose(`${this.#plane.across} ${(100 * Number(step)) / steps}%`, isMoving);
  }

  #choose(section: string, isMoving = false): void {
    this.#isMoving = isMoving;
    if (isMoving) this.#viewer.setAttribute('section', section);
    else this.#store.choose({ section });
    this.#follow();
  }

  /** Shows the plane that is asked for, and asks for its section. */
  #follow(): void {
    if (!this.#panel.isOpen) return;
    const plane = this.#asked;
    this.#plane = plane;
    this.#place.disabled = this.#across.disabled = !plane;
    if (!plane) return;
    const { across, share, low, high } = plane;
    if (![...this.#across.options].some(({ value }) => value === across)) {
      const words = across.startsWith('-') ? across : 'the view';
      this.#across.append(make('option', { value: across }, words));
    }
    this.#acrossDraft.show(across);
    this.#placeDraft.show(String(Math.round(share * steps)));
    const height = low + share * (high - low);
    this.#place.setAttribute('aria-valuetext', formatLength(height, this.#viewer.lengthFormat));
    this.#height.show(height, this.#viewer.lengthFormat);
    this.#isStale = true;
    if (!this.#isAsking) void this.#ask();
  }

  async #ask(): Promise<void> {
    const viewer = this.#viewer;
    this.#isAsking = true;
    while (this.#isStale && this.#plane) {
      this.#isStale = false;
      const { normal, share, low, high } = this.#plane;
      const { info } = viewer;
      try {
        const mesh = await viewer.mesh;
        const offsets = [low + share * (high - low)];
        const { sections } = await mesh.sections({ normal, offsets });
        if (viewer.info !== info) continue;
        this.#section = sections[0];
        this.#show();
      } catch (error) {
        if (viewer.info === info)
          this.#words.textContent = `No section: ${this.#kit.failureWords(error)}.`;
      }
    }
    this.#isAsking = false;
  }

  /** Rows for the section, in the present unit. */
  #show(): void {
    const format = this.#viewer.lengthFormat;
    const curves = this.#section?.curves ?? [];
    this.#caption.textContent = format.unit
      ? `Lengths in ${format.unit}, areas in ${format.unit}²`
      : '';
    this.#body.replaceChildren(...curves.slice(0, mostRows).map((curve, i) => this.#row(curve, i)));
    const hidden = curves.length - mostRows;
    this.#more.textContent = hidden > 0 ? `and ${hidden} more, in the table to copy` : '';
    this.#table.hidden = this.#actions.element.hidden = curves.length === 0;
    this.#actions.forget();
    this.#panel.summary = this.#section ? String(curves.length) : '';
    // Said once, when the hand rests: a live region speaks whenever it changes.
    const words = this.#isMoving ? '' : this.#wordsOf(this.#section);
    if (this.#words.textContent !== words) this.#words.textContent = words;
    this.#draw();
  }

  #row(curve: SectionCurve, i: number): HTMLElement {
    const format = this.#viewer.lengthFormat;
    const [least, greatest] = [curve.leastWidth, curve.greatestWidth].map((width) =>
      formatNumber(width, format),
    );
    const cells = [
      formatNumber(curve.tape, format),
      formatNumber(curve.perimeter, format),
      curve.closed ? formatNumber(curve.area * format.scale, format) : '–',
    ].map((text) => make('td', { class: 'number' }, text));
    // Beside each other they would be wider than the panel.
    cells.push(make('td', { class: 'number' }, `${least} ×`, make('br'), `${greatest}`));
    const kind = kindOf(curve);
    const head = make('th', { scope: 'row' }, String(i + 1));
    if (kind) head.append(make('span', { class: 'quiet', title: kind }, curve.hole ? ' ○' : ' ⌒'));
    return make('tr', {}, head, ...cells);
  }

  #wordsOf(section: Section | undefined): string {
    if (!section) return '';
    const format = this.#viewer.lengthFormat;
    const { curves, perimeter, tape } = section;
    if (curves.length === 0) return 'The plane only touches the surface.';
    if (curves.length === 1) return `One curve: tape ${formatLength(tape, format)}.`;
    const around = `one tape round all of them ${formatLength(tape, format)}`;
    return `${curves.length} curves: together ${formatLength(perimeter, format)}, ${around}.`;
  }

  #draw(): void {
    const viewer = this.#viewer;
    if (!viewer.info || (!this.#panel.isOpen && !this.#isDrawn)) return;
    this.#isDrawn = this.#panel.isOpen;
    const curves = this.#isDrawn ? (this.#section?.curves ?? []) : [];
    viewer.showCurves(curves.map(({ polyline }) => polyline));
  }
}
