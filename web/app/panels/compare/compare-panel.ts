// Several models by their fields: distributions over each other, distances, and who is most alike.

import type { Field, FieldName, Kernel } from '../../../src/kernel/index.js';
import { fieldTitle, formatCount, make } from '../../../src/element/index.js';
import { DistributionPlot, extent } from '../../../src/element/plots.js';
import { ComparedModel } from './compared-model.js';
import { DistanceMatrix, distanceWords } from './distance-matrix.js';
import { once } from '../../widgets/dom.js';
import { Draft } from '../../widgets/draft.js';
import { failureWords } from '../../widgets/failure-words.js';
import { kernel } from '../../model/kernel.js';
import type { PagePlot } from '../../export/page-plot.js';
import type { Panel } from '../../widgets/panel.js';
import { PlaceList } from '../../widgets/place-list.js';
import { stemOf } from '../../export/save-file.js';
import { type Opened, isSameModel } from '../../model/session.js';
import { TableActions } from '../../widgets/table-actions.js';
import { type Table, plainNumber } from '../../widgets/table-text.js';
import { term } from '../../help/term.js';
import type { thumbnail } from './thumbnail.js';

/** More models than these are too many for workers that keep them all. */
export const mostModels = 24;
/** Fields that models are compared by: the difference of their distributions (equation 1) … */
const comparedFields = ['igf', 'sdf', 'geoaverage', 'geofarthest'] as const;
/** … and the paper's other descriptors, which have distances but no single distribution. */
const descriptors: Record<string, string> = {
  'igf-sdf': 'Girth and shape diameter (IGF-SDF)',
  'igf-ms': 'Girth by fast marching (IGF-MS)',
  hks: 'Heat kernel (HKS)',
  sihks: 'Scale-invariant heat kernel (SIHKS)',
  wks: 'Wave kernel (WKS)',
};
/** Models are distinguished by colour and by dashes: 35 pairs of both. */
const colours = ['#c2410c', '#0072b2', '#009e73', '#8a6d00', '#56b4e9', '#a0529c', '#6b7280'];
const dashes = [[], [8, 3], [2, 2], [9, 3, 2, 3], [14, 4]] as const;

type Button = 'keep' | 'gallery' | 'cancel' | 'resume' | 'show' | 'beside' | 'remove' | 'clear';

export interface ComparePage {
  /** The model that is on the page, and its name. */
  present(): { opened: Opened; name: string } | undefined;
  /** The built-in examples. */
  gallery(): { opened: Opened; name: string }[];
  /** A field of a model that the page shows, where the page has it or computes it itself. */
  fieldOf(opened: Opened, name: FieldName): Promise<Field> | undefined;
  /** Shows a model on the page. */
  show(opened: Opened): void;
  /** Shows it beside the model that is on the page. */
  showBeside(opened: Opened): void;
}

export class ComparePanel {
  readonly panel: Panel;
  readonly #field = make('select', { id: 'compare-field', 'aria-label': 'Compare by' });
  readonly #choice: Draft;
  readonly #plot = new DistributionPlot();
  readonly #matrix = new DistanceMatrix((row) => this.#ask(row));
  readonly #ranking = new PlaceList('Ranking');
  readonly #rankingTitle = make('h3');
  readonly #words = make('span', { class: 'hint', role: 'status' });
  readonly #alike = make('p', { class: 'answer', role: 'status' });
  readonly #meaning = make('p', { class: 'hint' });
  readonly #actions = new TableActions({
    table: () => this.#table,
    fileName: () => `distances-${this.#descriptor}.csv`,
  });
  readonly #results: HTMLElement;
  readonly #buttons: Record<Button, HTMLButtonElement>;
  #models: ComparedModel[] = [];
  #query: ComparedModel | undefined;
  readonly #distances = new Map<string, number>();
  readonly #pictures = new Map<string, HTMLCanvasElement>();
  #thumbnail: typeof thumbnail | undefined;
  readonly #fetchThumbnail = once(async () => {
    this.#thumbnail = (await import('./thumbnail.js')).thumbnail;
    this.#refresh();
  });
  /** Numbers of the models, which are parts of keys. */
  readonly #numbers = new Map<ComparedModel, number>();
  #comparing = new AbortController();
  #isRunning = false;
  #isCancelled = false;
  #timer: ReturnType<typeof setTimeout> | undefined;
  readonly #page: ComparePage;

  constructor(panel: Panel, page: ComparePage) {
    this.panel = panel;
    this.#page = page;
    this.#field.append(
      ...comparedFields.map((name) => make('option', { value: name }, fieldTitle(name))),
      ...Object.entries(descriptors).map(([value, words]) => make('option', { value }, words)),
    );
    this.#choice = new Draft(this.#field, {
      committed: () => {
        this.#cancel();
        this.#computeAll();
      },
    });
    const button = (words: string, act: () => void): HTMLButtonElement => {
      const made = make('button', { type: 'button', class: 'plain' }, words);
      made.addEventListener('click', act);
      return made;
    };
    this.#buttons = {
      keep: button('Add this model', () => {
        const present = page.present();
        if (present) this.add([present]);
      }),
      gallery: button('Add the examples', () => this.add(page.gallery())),
      cancel: button('Cancel', () => this.#cancel()),
      resume: button('Go on', () => this.#computeAll()),
      show: button('Show it', () => this.#query && page.show(this.#query.opened)),
      beside: button('Side by side', () => this.#showBeside()),
      remove: button('Remove it', () => this.#query && this.#remove(this.#query)),
      clear: button('Remove all', () => this.#clear()),
    };
    this.#plot.element.classList.add('compared');
    this.#results = make(
      'div',
      {},
      this.#alike,
      make('div', { class: 'row' }, this.#field),
      this.#plot.element,
      this.#matrix.element,
      this.#meaning,
      this.#actions.element,
      this.#rankingTitle,
      this.#ranking.element,
      make(
        'p',
        { class: 'buttons' },
        this.#buttons.show,
        this.#buttons.beside,
        this.#buttons.remove,
        this.#buttons.clear,
      ),
    );
    this.panel.body.append(
      make('p', { class: 'working' }, this.#words, this.#buttons.cancel, this.#buttons.resume),
      this.#results,
      make(
        'p',
        { class: 'hint' },
        'Keep models here, or drop several, to see which are similar, by the ',
        term('emd', 'EMD'),
        ' of their fields.',
      ),
      make('p', { class: 'buttons' }, this.#buttons.keep, this.#buttons.gallery),
    );
    this.panel.onToggle(() => this.#refresh());
    this.#refresh();
  }

  /** Takes models in; those that are there already are not taken twice. */
  add(some: readonly { opened: Opened; name: string }[]): void {
    let left = mostModels - this.#models.length;
    for (const { opened, name } of some) {
      if (this.#models.some((one) => isSameModel(one.opened, opened))) continue;
      if (--left < 0) break;
      const host = {
        fieldOf: (wanted: FieldName) => this.#page.fieldOf(opened, wanted),
        changed: () => this.#refreshSoon(),
      };
      this.#models.push(new ComparedModel(opened, name, host));
    }
    this.#words.textContent =
      left < 0 ? `No more than ${mostModels} are compared; remove some first.` : '';
    this.#query ??= this.#models[0];
    this.#computeAll();
  }

  /** The field whose values are drawn. */
  get plots(): PagePlot[] {
    return [{ word: 'compared', svg: (width) => this.#plot.svg(width) }];
  }

  get #name(): FieldName {
    const descriptor = this.#descriptor;
    return comparedFields.find((name) => name === descriptor) ?? 'igf';
  }

  /** The name of the field or descriptor that the distances are made of. */
  get #descriptor(): string {
    return this.#choice.text;
  }

  /** Stops computing; what there is stays. */
  #cancel(): void {
    this.#isCancelled = true;
    this.#comparing.abort();
    for (const model of this.#models) model.cancel();
  }

  #remove(model: ComparedModel): void {
    model.dispose();
    this.#models = this.#models.filter((one) => one !== model);
    if (this.#query === model) this.#query = this.#models[0];
    this.#words.textContent = '';
    this.#refresh();
  }

  /** Beside what the page shows: what is asked about, or where that is the same, the first of the others. */
  #showBeside(): void {
    const present = this.#page.present()?.opened;
    const isOther = (model: ComparedModel): boolean =>
      !present || !isSameModel(present, model.opened);
    const asked = this.#query && isOther(this.#query) ? this.#query : undefined;
    const model = asked ?? this.#models.find(isOther) ?? this.#query;
    if (model) this.#page.showBeside(model.opened);
  }

  #clear(): void {
    for (const model of this.#models) model.dispose();
    this.#models = [];
    this.#query = undefined;
    this.#distances.clear();
    this.#pictures.clear();
    this.#words.textContent = '';
    this.#refresh();
  }

  #ask(number: number): void {
    this.#query = this.#models[number];
    this.#refresh();
  }

  #computeAll(): void {
    this.#isCancelled = false;
    this.#refresh();
    void this.#computeMissing();
  }

  /** One model after another: each uses all workers by itself. */
  async #computeMissing(): Promise<void> {
    if (this.#isRunning) return;
    this.#isRunning = true;
    this.#refresh();
    try {
      const own = await kernel;
      for (;;) {
        if (this.#isCancelled) break;
        // The choice is read anew each time: the latest wish comes first.
        const [name, descriptor] = [this.#name, this.#descriptor];
        const pair = name === descriptor ? this.#unmeasured(name) : undefined;
        const next = this.#models.find((model) => !model.failure && !model.fieldOf(name));
        if (pair) await this.#measure(...pair, name);
        else if (next) await next.compute(own, name);
        else if (!(await this.#compareBy(own, descriptor))) break;
        this.#refreshSoon();
      }
    } catch (error) {
      this.#words.textContent = `${failureWords(error)}.`;
    } finally {
      this.#isRunning = false;
      this.#refresh();
    }
  }

  /** Two models whose fields are there, and their distance not yet. */
  #unmeasured(name: FieldName): [ComparedModel, ComparedModel] | undefined {
    const models = this.#models.filter((model) => !model.failure && model.fieldOf(name));
    for (const [i, a] of models.entries()) {
      const b = models.slice(0, i).find((one) => !this.#distances.has(this.#keyOf(a, one, name)));
      if (b) return [a, b];
    }
    return undefined;
  }

  /** The distance of two models by a field; cancelled ones stay unmeasured. */
  async #measure(a: ComparedModel, b: ComparedModel, name: FieldName): Promise<void> {
    this.#comparing = new AbortController();
    const { signal } = this.#comparing;
    try {
      this.#distances.set(this.#keyOf(a, b, name), await a.differenceTo(b, name, signal));
    } catch {
      if (!signal.aborted) this.#distances.set(this.#keyOf(a, b, name), NaN);
    }
  }

  /** The distances by a descriptor that is no field; false where there is nothing to be done. */
  async #compareBy(own: Kernel, descriptor: string): Promise<boolean> {
    if (!Object.hasOwn(descriptors, descriptor)) return false;
    const models = this.#models.filter(({ mesh, failure }) => mesh && !failure);
    const isMissing = models.some((a, i) =>
      models.some((b, j) => j > i && !this.#distances.has(this.#keyOf(a, b, descriptor))),
    );
    if (!isMissing) return false;
    this.#comparing = new AbortController();
    const { signal } = this.#comparing;
    try {
      const { matrices } = await own.compare(
        models.map(({ mesh }) => mesh!),
        {
          descriptors: [descriptor],
          signal,
          onProgress: (share) => {
            this.#words.textContent = `Comparing, ${Math.floor(100 * share)}\u202f%`;
          },
        },
      );
      models.forEach((a, i) =>
        models.forEach((b, j) => {
          const distance = matrices[0]!.distances[i * models.length + j]!;
          if (j > i) this.#distances.set(this.#keyOf(a, b, descriptor), distance);
        }),
      );
      this.#words.textContent = '';
    } catch (error) {
      if (!signal.aborted) throw error;
      this.#words.textContent = '';
    }
    return true;
  }

  #keyOf(a: ComparedModel, b: ComparedModel, name: string): string {
    const numberOf = (model: ComparedModel): number => {
      const number = this.#numbers.get(model) ?? this.#numbers.size;
      this.#numbers.set(model, number);
      return number;
    };
    const [i, j] = [numberOf(a), numberOf(b)];
    return `${name} ${Math.min(i, j)} ${Math.max(i, j)}`;
  }

  #distance(a: ComparedModel, b: ComparedModel): number | undefined {
    if (a === b) return a.fieldOf(this.#name) ? 0 : undefined;
    if (a.failure || b.failure) return NaN;
    return this.#distances.get(this.#keyOf(a, b, this.#descriptor));
  }

  #refreshSoon(): void {
    this.#timer ??= setTimeout(() => this.#refresh(), 200);
  }

  #refresh(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    const [models, query, buttons] = [this.#models, this.#query, this.#buttons];
    this.panel.summary = models.length > 0 ? formatCount(models.length) : '';
    this.#results.hidden = models.length === 0;
    buttons.cancel.hidden = !this.#isRunning;
    buttons.resume.hidden = this.#isRunning || !this.#isCancelled || models.length === 0;
    buttons.show.disabled = buttons.beside.disabled = buttons.remove.disabled = !query;
    if (!this.panel.isOpen || !query) return;
    this.#showPlot();
    this.#showRanking(query);
    this.#showAlike();
    this.#actions.element.hidden = models.length < 2;
    this.#matrix.element.hidden = models.length < 3;
    this.#matrix.show(
      models.map(({ name }) => name),
      models.map((a) => models.map((b) => this.#distance(a, b))),
      models.indexOf(query),
    );
  }

  /** The pair that is nearest, once all distances are there, and what such a number means. */
  #showAlike(): void {
    const models = this.#models.filter(({ failure }) => !failure);
    const pairs = models.flatMap((a, i) =>
      models.slice(i + 1).map((b) => ({ a, b, distance: this.#distance(a, b) })),
    );
    const known = pairs.filter(
      (pair): pair is typeof pair & { distance: number } =>
        pair.distance !== undefined && Number.isFinite(pair.distance),
    );
    const isReady = known.length > 0 && pairs.every(({ distance }) => distance !== undefined);
    known.sort((one, other) => one.distance - other.distance);
    const [first, last] = [known[0], known.at(-1)];
    const words =
      isReady && first
        ? `Most alike: ${stemOf(first.a.name)} and ${stemOf(first.b.name)} (${distanceWords(first.distance)})`
        : '';
    // Said once: a live region speaks whenever it changes.
    if (this.#alike.textContent !== words) this.#alike.textContent = words;
    this.#meaning.hidden = words === '';
    if (!last) return;
    const range =
      known.length > 1
        ? ` Here it goes from ${distanceWords(first!.distance)} to ${distanceWords(last.distance)}.`
        : '';
    this.#meaning.textContent =
      this.#name === this.#descriptor
        ? 'The number is how far values must move, on average, to turn one curve into the other, as a ' +
          `share of the square root of the surface’s area: 0.01 is 1%, 0 is the same curve.${range}`
        : `The number has no unit: 0 is the same, and only numbers of one descriptor can be compared.${range}`;
  }

  /** The distances as files and spreadsheets have them. */
  get #table(): Table {
    const models = this.#models;
    return [
      [`distance by ${this.#descriptor}`, ...models.map(({ name }) => name)],
      ...models.map((a) => [
        a.name,
        ...models.map((b) => (a === b ? 0 : (this.#distance(a, b) ?? NaN))),
      ]),
    ];
  }

  #colourOf(model: ComparedModel): string {
    return colours[this.#models.indexOf(model) % colours.length]!;
  }

  #dashOf(model: ComparedModel): readonly number[] {
    return dashes[this.#models.indexOf(model) % dashes.length]!;
  }

  #showPlot(): void {
    const hasDistribution = this.#name === this.#descriptor;
    const drawn = (hasDistribution ? this.#models : []).flatMap((model) => {
      const values = model.normalised(this.#name);
      return values ? [{ model, values }] : [];
    });
    const reaches = drawn.flatMap(({ values }) => extent(values) ?? []);
    this.#plot.element.hidden = reaches.length === 0;
    if (reaches.length === 0) return;
    const [low, high] = [Math.min(...reaches), Math.max(...reaches)];
    this.#plot.show({
      kind: 'cdf',
      series: drawn.map(({ model, values }) => ({
        values,
        weights: model.weights,
        colour: this.#colourOf(model),
        dash: this.#dashOf(model).length > 0 ? [...this.#dashOf(model)] : undefined,
      })),
      range: [low, high > low ? high : low + 1e-9],
      colourOf: () => ({ colour: 'transparent', faint: true }),
      format: (value) => plainNumber(value, 3),
      axes: { label: `${fieldTitle(this.#name)} / √area` },
    });
    this.#plot.element.setAttribute(
      'aria-label',
      `Cumulative distributions of ${drawn.map(({ model }) => model.name).join(', ')}`,
    );
  }

  #showRanking(query: ComparedModel): void {
    const [name, models] = [this.#name, this.#models];
    const rows = models.map((model) => ({ model, distance: this.#distance(query, model) }));
    const far = (distance: number | undefined): number =>
      distance === undefined || Number.isNaN(distance) ? Infinity : distance;
    rows.sort((a, b) =>
      a.model === query ? -1 : b.model === query ? 1 : far(a.distance) - far(b.distance),
    );
    this.#rankingTitle.textContent = `Most similar to ${query.name}`;
    this.#ranking.show(
      rows.map(({ model, distance }) => ({
        lead: String(models.indexOf(model) + 1),
        colour: this.#colourOf(model),
        dash: this.#dashOf(model),
        main: model.name,
        detail: this.#detail(model, query, distance),
        picture: this.#pictureOf(model, name),
        choose: () => {
          this.#query = model;
          this.#refresh();
        },
      })),
    );
    this.#ranking.select(0);
  }

  #detail(model: ComparedModel, query: ComparedModel, distance: number | undefined): string {
    if (model.failure) return model.failure;
    if (!model.fieldOf(this.#name)) {
      if (model.share > 0) return `computing, ${Math.floor(100 * model.share)}\u202f%`;
      return this.#isRunning ? 'pending' : 'not computed';
    }
    return model === query ? 'compared with the others' : `distance ${distanceWords(distance)}`;
  }

  #pictureOf(model: ComparedModel, name: FieldName): HTMLCanvasElement | undefined {
    if (!model.mesh) return undefined;
    if (!this.#thumbnail) {
      // Without the module, which the next change fetches again, rows have no pictures.
      this.#fetchThumbnail().catch(() => undefined);
      return undefined;
    }
    const field = model.fieldOf(name);
    const key = `${this.#keyOf(model, model, name)} ${field !== undefined}`;
    let picture = this.#pictures.get(key);
    if (!picture) {
      picture = this.#thumbnail(model.mesh, field, 'viridis');
      this.#pictures.set(key, picture);
    }
    return picture;
  }
}
