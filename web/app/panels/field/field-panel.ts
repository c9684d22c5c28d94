// Which field colours the surface, its distribution, and how it is coloured.

import {
  type ColormapName,
  type CombinedName,
  type GirthViewer,
  type ShownName,
  type ShownPlaces,
  type ValuesName,
  colormapNames,
  combinationOf,
  derivedNames,
  fieldNames,
  fieldTitle,
  formatCount,
  formatLength,
  formatNumber,
  girthKinds,
  girthStates,
  isFieldName,
  isForAllEyes,
  isGivenName,
  isShownName,
  make,
  partKinds,
  placeIn,
} from '../../../src/element/index.js';
import { type RefinedGirth, fieldListTitles } from '../../../src/kernel/index.js';
import {
  type DistributionKind,
  DistributionPlot,
  extent,
  placesWithin,
  quantile,
  shareWithin,
  colourAt,
} from '../../../src/element/plots.js';
import type { Store } from '../../state/store.js';
import { axisNumber } from '../../widgets/axis-number.js';
import { CategoryShares } from './category-shares.js';
import type { ComputedFields } from '../../model/computed-fields.js';
import { byId } from '../../widgets/dom.js';
import { Draft } from '../../widgets/draft.js';
import { MethodChoice } from './method-choice.js';
import type { PagePlot } from '../../export/page-plot.js';
import { PersistenceChoice } from './persistence-choice.js';
import { RangeSliders } from './range-sliders.js';
import { readValue } from '../../widgets/length-input.js';
import { SecondField } from './second-field.js';
import { SignatureChoice } from './signature-choice.js';
import { explains } from '../../help/term.js';
import type { TermName } from '../../help/terms.js';

/** Names of all that can colour the surface. */
const shownNames: readonly ShownName[] = [...fieldNames, ...derivedNames, 'none'];
/** Names in the list that differ from those in the legend. */
const listWords: Partial<Record<ShownName, string>> = {
  ...fieldListTitles,
  tips: 'Tip persistence',
  parts: 'Tubes and plates',
  none: 'None',
};
/** The term that explains each choice of the list. */
const fieldTerms: Partial<Record<ShownName, TermName>> = {
  igf: 'girth',
  sdf: 'sdf',
  thickness: 'thickness',
  kind: 'loop',
  tips: 'tip',
  parts: 'tube',
};
const wordsFor = (name: ShownName): string => listWords[name] ?? fieldTitle(name);
const ranges: [string, string][] = [
  ['', 'auto'],
  ['0% 100%', 'full range'],
  ['1% 99%', '1 to 99 %'],
  ['5% 95%', '5 to 95 %'],
];
const ownRange = 'own';
const isolineCounts = [0, 5, 10, 20, 40];
/** Milliseconds between two pictures while values arrive. */
const interval = 200;
/** The least time between two pictures, in times that one picture took. */
const rest = 15;

/** The page, as far as the panel needs it. */
export interface FieldPage {
  /** The kinds of the present parts; undefined where there are none. */
  partKinds(): Uint8Array | undefined;
  /** How far the girth rises at the tip that each vertex is in, 0 elsewhere; undefined as above. */
  tipRises(): Float64Array | undefined;
}

export class FieldPanel {
  readonly #field = make('select', { id: 'field-name', 'aria-label': 'Field' });
  readonly #kindButtons: Record<DistributionKind, HTMLButtonElement>;
  readonly #plot = new DistributionPlot({
    brushed: (range) => this.#brushed(range),
  });
  readonly #categories = new CategoryShares();
  readonly #second: SecondField;
  readonly #ofFile = make('optgroup', { label: 'From the file', hidden: '' });
  /** The option that only a refined girth has. */
  readonly #states: HTMLOptionElement;
  readonly #signature: SignatureChoice;
  readonly #method: MethodChoice;
  readonly #persistence: PersistenceChoice;
  readonly #log = make('input', { id: 'log', type: 'checkbox' });
  #fault = '';
  readonly #sliders = new RangeSliders({
    moved: (low, high) => this.#setRange(`${low} ${high}`),
    read: (text) => readValue(text, this.#format),
    wrong: (why) => {
      this.#fault = why;
      this.refresh();
    },
  });
  readonly #rangeChoice = make('select', {
    id: 'range',
    'aria-label': 'Range of the colours',
  });
  readonly #caption = make('p', { class: 'caption' });
  readonly #captionWords = make('span');
  readonly #clearBrush = make('button', { type: 'button', 'aria-label': 'Mark nothing' }, '✕');
  readonly #colormap = make('select', { id: 'colormap', 'aria-label': 'Colours' });
  readonly #isolines = make('select', { id: 'isolines' });
  readonly #fieldDraft: Draft;
  readonly #rangeDraft: Draft;
  readonly #colormapDraft: Draft;
  readonly #isolinesDraft: Draft;
  #kind: DistributionKind = 'histogram';
  #areas: Float64Array | undefined;
  #places: ShownPlaces | undefined;
  /** The name that coloured the surface before a panel wanted something else. */
  #before: ShownName | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** The range of values that is marked. */
  #brush: [number, number] | undefined;
  /** The frame in which it may be marked again; 0 for none. */
  #marking = 0;
  /** Milliseconds that the last picture took. */
  #took = 0;
  readonly #viewer: GirthViewer;
  readonly #computed: ComputedFields;
  readonly #store: Store;
  readonly #page: FieldPage;

  constructor(viewer: GirthViewer, computed: ComputedFields, store: Store, page: FieldPage) {
    this.#viewer = viewer;
    this.#store = store;
    this.#computed = computed;
    this.#page = page;
    const [field, plot] = [this.#field, this.#plot];
    field.append(...shownNames.map((name) => make('option', { value: name }, wordsFor(name))));
    this.#states = field.querySelector<HTMLOptionElement>('[value=state]')!;
    field.append(this.#ofFile);
    this.#fieldDraft = new Draft(field, {
      committed: (name) => this.choose(this.#second.instead(name as ShownName)),
    });
    this.#second = new SecondField(viewer, wordsFor, (name) => this.choose(name));
    const kindButton = (kind: DistributionKind, words: string): HTMLButtonElement => {
      const button = make(
        'button',
        { type: 'button', 'aria-pressed': 'false', 'aria-label': words, title: words },
        icon(kind),
      );
      button.addEventListener('click', () => this.#setKind(kind));
      return button;
    };
    this.#kindButtons = {
      histogram: kindButton('histogram', 'Histogram'),
      cdf: kindButton('cdf', 'Cumulative distribution'),
    };
    this.#signature = new SignatureChoice(viewer, store);
    this.#method = new MethodChoice(viewer, store);
    this.#persistence = new PersistenceChoice(viewer, store);
    plot.element.id = 'distribution';
    this.#rangeChoice.append(
      ...ranges.map(([value, words]) => make('option', { value }, words)),
      make('option', { value: ownRange, hidden: '' }, 'own range'),
    );
    this.#rangeDraft = new Draft(this.#rangeChoice, {
      committed: (range) => this.#setRange(range),
    });
    const option = (name: ColormapName) => make('option', { value: name }, name);
    const some = make('optgroup', { label: 'Not for colour-blind eyes' });
    some.append(...colormapNames.filter((name) => !isForAllEyes(name)).map(option));
    this.#colormap.append(...colormapNames.filter(isForAllEyes).map(option), some);
    this.#log.addEventListener('change', () => {
      store.choose({ log: this.#log.checked });
      this.#paint();
    });
    this.#colormapDraft = new Draft(this.#colormap, {
      committed: (name) => {
        store.choose({ colormap: name });
        this.#paint();
      },
    });
    this.#isolines.append(
      ...isolineCounts.map((count) =>
        make('option', { value: String(count) }, count === 0 ? 'no lines' : `${count} lines`),
      ),
    );
    this.#isolinesDraft = new Draft(this.#isolines, {
      committed: (count) => {
        store.choose({ isolines: Number(count) || undefined });
      },
    });
    const kinds = make(
      'div',
      { class: 'switch', role: 'group', 'aria-label': 'Distribution' },
      ...Object.values(this.#kindButtons),
    );
    byId('field').append(
      make('div', { class: 'row first' }, field, kinds),
      plot.element,
      this.#categories.element,
      this.#sliders.element,
      make('div', { class: 'ends' }, this.#sliders.low, this.#rangeChoice, this.#sliders.high),
      this.#caption,
      this.#signature.element,
      this.#method.element,
      this.#persistence.element,
      this.#second.element,
      make(
        'div',
        { class: 'row' },
        this.#colormap,
        this.#isolines,
        make('label', { class: 'check' }, this.#log, ' log'),
      ),
    );
    this.#caption.append(this.#captionWords);
    this.#clearBrush.addEventListener('click', () => this.#setBrush(undefined));
    this.#isolines.setAttribute('aria-label', 'Lines of equal value');
    this.#setKind('histogram');
    store.watch(
      [
        ...([
          'field',
          'colormap',
          'range',
          'isolines',
          'log',
          'time',
          'energy',
          'component',
        ] as const),
        ...(['method', 'persistence'] as const),
      ],
      () => this.#follow(),
    );
    this.#follow();

    viewer.addEventListener('progress', ({ detail: { name } }) => {
      // The others have no values before all are there.
      if (name !== 'igf' || this.#method.method === 'exact') this.#refreshSoon();
    });
    for (const event of ['field', 'fieldchange'] as const) {
      viewer.addEventListener(event, () => this.#refreshNext());
    }
    viewer.addEventListener('unit', () => this.refresh());
    viewer.addEventListener('view', () => this.refresh());
    viewer.addEventListener('hover', (event) => {
      const { vertex } = event.detail;
      const name = this.name;
      this.#plot.markValue(vertex === undefined ? undefined : this.#valuesOf(name)[vertex]);
    });
  }

  /** The histogram of the values that colour the surface. */
  get plots(): PagePlot[] {
    const format = (value: number): string => axisNumber(value, this.#format);
    const { unit } = this.#format;
    const title = fieldTitle(this.name);
    const below = { label: unit === '' ? title : `${title}, ${unit}`, format };
    return [{ word: 'histogram', svg: (width) => this.#plot.svg(width, below) }];
  }

  get name(): ShownName {
    const name = this.#viewer.getAttribute('field');
    return isShownName(name) ? name : 'igf';
  }

  /** Colours the surface otherwise; for other panels too. */
  choose(name: ShownName): void {
    if (name === this.name) return;
    this.#setBrush(undefined);
    const { range } = this.#store.shown;
    this.#store.choose({
      field: name === 'igf' ? undefined : name,
      // Values of one field mean nothing for another; shares do.
      range: range?.includes('%') ? range : undefined,
    });
  }

  /** Places colour the surface in place of the field, or no longer. */
  showPlaces(places: ShownPlaces | undefined): void {
    this.#places = places;
    this.refresh();
  }

  /** Another model: an empty plot. */
  clear(): void {
    const viewer = this.#viewer;
    this.#areas = undefined;
    this.#setBrush(undefined);
    const own = viewer.given.map((name) => make('option', { value: name }, wordsFor(name)));
    this.#ofFile.replaceChildren(...own);
    this.#ofFile.hidden = own.length === 0;
    this.#method.clear();
    const { info } = viewer;
    void viewer.areas().then(
      (areas) => {
        if (viewer.info !== info) return;
        this.#areas = areas;
        this.refresh();
      },
      () => undefined,
    );
  }

  /** Colours the surface as an open panel wants it, and afterwards as it was. */
  colourForPanel(name: ShownName, wanted: boolean): void {
    if (wanted) {
      this.#before = this.name;
      this.choose(name);
    } else if (this.name === name) {
      this.choose(this.#before ?? 'igf');
      this.#before = undefined;
    }
  }

  /** Shows what the state has. */
  #follow(): void {
    const { log = false, isolines } = this.#store.shown;
    this.#log.checked = log;
    const count = String(isolines ?? 0);
    if (![...this.#isolines.options].some(({ value }) => value === count)) {
      this.#isolines.append(make('option', { value: count }, `${count} lines`));
    }
    this.#isolinesDraft.show(count);
    // A field without numbers has no bars to paint.
    this.#showColours();
    this.refresh();
  }

  #valuesOf(name: ShownName): Float64Array {
    const viewer = this.#viewer;
    const none = new Float64Array();
    if (name === 'tips') return this.#page.tipRises() ?? none;
    return viewer.info && isOfNumbers(name) ? viewer.values(name) : none;
  }

  #setKind(kind: DistributionKind): void {
    this.#kind = kind;
    for (const [one, button] of Object.entries(this.#kindButtons)) {
      button.setAttribute('aria-pressed', String(one === kind));
    }
    this.refresh();
  }

  #refreshSoon(): void {
    this.#timer ??= setTimeout(() => this.refresh(), Math.max(interval, rest * this.#took));
  }

  /** Once after several events, and not in their task, which may have coloured a large surface. */
  #refreshNext(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.refresh());
  }

  refresh(): void {
    const from = performance.now();
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.#show();
    this.#took = performance.now() - from;
  }

  #show(): void {
    const [plot, sliders] = [this.#plot, this.#sliders];
    const { name } = this;
    const first = combinationOf(name)?.first ?? name;
    this.#fieldDraft.show(first);
    explains(this.#field, fieldTerms[first]);
    this.#second.show(name);
    this.#signature.show(first);
    this.#method.show(first);
    this.#states.hidden = this.#method.method !== 'refined';
    this.#persistence.show(first);
    const places = this.#viewer.shown ? undefined : this.#places;
    const isNumeric = !places && (isOfNumbers(name) || name === 'tips');
    const values = this.#valuesOf(name);
    const reach = places ? undefined : extent(values);
    plot.element.hidden = !isNumeric;
    this.#categories.element.hidden = isNumeric;
    for (const button of Object.values(this.#kindButtons)) button.disabled = !isNumeric;
    sliders.disabled = !reach;
    this.#rangeChoice.disabled = !reach;
    if (places) this.#categories.show(places.categories, places.kinds, this.#areas);
    else if (!isNumeric) this.#showShares();
    if (!reach) {
      sliders.show(undefined, undefined, String);
      plot.element.setAttribute('aria-label', 'Distribution: no values yet');
      this.#writeInCaption('', false);
      if (isNumeric) {
        plot.show({
          kind: this.#kind,
          series: [],
          range: [0, 1],
          colourOf: () => ({ colour: 'transparent', faint: true }),
          format: String,
        });
      }
      return;
    }
    const format = (value: number): string => formatLength(value, this.#format);
    // Values that are the same but for rounding are one bar, in the middle.
    const least = 1e-6 * Math.abs(reach[1]);
    const widen = reach[1] - reach[0] < least ? least : 0;
    plot.show({
      kind: this.#kind,
      series: [{ values, weights: this.#areas, colour: getComputedStyle(plot.element).color }],
      range: [reach[0] - widen, reach[1] + widen],
      colourOf: (value) => this.#colourOf(value),
      format,
    });
    const middle = quantile(values, this.#areas, 0.5);
    plot.element.setAttribute(
      'aria-label',
      `Distribution of ${isFieldName(name) ? wordsFor(name) : fieldTitle(name)} from ${format(reach[0])} to ${format(reach[1])}, median ` +
        `${format(middle)}. Arrows mark a range.`,
    );
    this.#paint(reach);
    this.#writeCaption(values, reach, middle);
  }

  #showShares(): void {
    const [viewer, categories, areas] = [this.#viewer, this.#categories, this.#areas];
    const { name } = this;
    if (name === 'parts') categories.show(partKinds, this.#page.partKinds() ?? [], areas);
    else if (name === 'none') categories.clear();
    else {
      const words = name === 'state' ? girthStates : girthKinds;
      categories.show(words, [], areas);
      if (!this.#computed.has('igf')) return;
      const { info } = viewer;
      void viewer.fieldOf('igf').then((igf) => {
        if (viewer.info !== info || this.name !== name) return;
        const { states = [] } = igf as Partial<RefinedGirth>;
        categories.show(words, name === 'state' ? states : igf.kinds, this.#areas);
      });
    }
  }

  get #format() {
    const viewer = this.#viewer;
    const { name } = this;
    return viewer.info ? viewer.formatOf(name) : viewer.lengthFormat;
  }

  /** The range that the colours span, once they are those of the chosen field. */
  get #ends(): readonly [number, number] | undefined {
    const { shown } = this.#viewer;
    return shown?.name === this.name ? shown.range : undefined;
  }

  #colourOf(value: number): { colour: string; faint: boolean } {
    const { colormap = 'viridis', log = false } = this.#viewer.shown ?? {};
    const [low, high] = this.#ends ?? [0, 1];
    return {
      colour: colourAt(colormap, placeIn([low, high], log, value)),
      faint: value < low || value > high,
    };
  }

  /** The colours that were chosen; without a choice those of the surface. */
  #showColours(): void {
    this.#colormapDraft.show(
      this.#store.shown.colormap ?? this.#viewer.shown?.colormap ?? 'viridis',
    );
  }

  /** Colours of the bars, and the ends of the range. */
  #paint(reach = extent(this.#valuesOf(this.name))): void {
    const [viewer, plot, sliders] = [this.#viewer, this.#plot, this.#sliders];
    const range = viewer.getAttribute('range') ?? '';
    const offered = ranges.some(([value]) => value === range);
    this.#rangeDraft.show(offered ? range : ownRange);
    this.#showColours();
    plot.recolour((value) => this.#colourOf(value));
    sliders.show(reach, this.#ends, (value) => formatLength(value, this.#format));
  }

  #setRange(range: string): void {
    this.#store.choose({ range: range || undefined });
    this.#paint();
  }

  #setBrush(range: [number, number] | undefined): void {
    this.#plot.brush = range;
    this.#brushed(range);
  }

  #brushed(range: [number, number] | undefined): void {
    this.#brush = range;
    if (this.#marking) return;
    // A marked range shows in the next frame; a finger moves more often than frames come.
    if (range) this.#mark();
    this.#marking = requestAnimationFrame(() => {
      this.#marking = 0;
      if (!range || this.#brush !== range) this.#mark();
    });
  }

  /** Marks on the surface what is marked on the plot. */
  #mark(): void {
    const viewer = this.#viewer;
    if (!viewer.info) return;
    const [range, values] = [this.#brush, this.#valuesOf(this.name)];
    viewer.mark(range && placesWithin(values, range));
    const reach = extent(values);
    if (reach) this.#writeCaption(values, reach);
  }

  #writeCaption(values: Float64Array, reach: readonly [number, number], middle?: number): void {
    if (this.#fault) {
      this.#writeInCaption(`${this.#fault}.`, false);
      return;
    }
    const range = this.#plot.brush;
    const format = (value: number): string => formatLength(value, this.#format);
    if (!range) {
      const without = values.reduce((count, value) => count + (Number.isFinite(value) ? 0 : 1), 0);
      const isWhole = !isFieldName(this.name) || this.#computed.has(this.name);
      this.#writeInCaption(
        `median ${format(middle ?? quantile(values, this.#areas, 0.5))}` +
          (without > 0 && isWhole ? ` · no value at ${formatCount(without)} vertices` : ''),
        false,
      );
      return;
    }
    const low = Math.max(range[0], reach[0]);
    const high = Math.min(range[1], reach[1]);
    const share = 100 * shareWithin(values, this.#areas, range);
    const percent = share > 0 && share < 0.1 ? '<\u202f0.1' : share.toFixed(1);
    this.#writeInCaption(
      `${formatNumber(low, this.#format)} to ${format(high)}: ${percent}\u202f% of the area`,
      true,
    );
  }

  #writeInCaption(words: string, isOfBrush: boolean): void {
    this.#caption.title = isOfBrush ? 'Share of the area with these values' : '';
    this.#captionWords.textContent = words;
    if (isOfBrush) this.#caption.append(this.#clearBrush);
    else this.#clearBrush.remove();
  }
}

/** Whether a name is of numbers at every vertex that the element has. */
const isOfNumbers = (name: ShownName): name is ValuesName | CombinedName =>
  isFieldName(name) || isGivenName(name) || combinationOf(name) !== undefined;

/** A small picture of a kind of plot. */
function icon(kind: DistributionKind): SVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const picture = document.createElementNS(space, 'svg');
  picture.setAttribute('viewBox', '0 0 18 14');
  const path = document.createElementNS(space, 'path');
  path.setAttribute(
    'd',
    kind === 'histogram' ? 'M3 14V8M7 14V3M11 14V6M15 14V10' : 'M1 13C7 13 6 2 17 2',
  );
  picture.append(path);
  return picture;
}
