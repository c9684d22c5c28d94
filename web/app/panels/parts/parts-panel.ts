// Tubes and plates: girth against shape diameter with the two thresholds, and the parts that they make.

import {
  type GirthViewer,
  formatLength,
  make,
  sentence,
  partKinds,
} from '../../../src/element/index.js';
import type { Field, Part, PartKind, Parts, PartThresholds } from '../../../src/kernel/index.js';
import { ScatterPlot } from '../../../src/element/plots.js';
import type { PageState } from '../../state/address-state.js';
import type { Store } from '../../state/store.js';
import { formatArea } from '../../widgets/area-words.js';
import { Draft } from '../../widgets/draft.js';
import { failureWords } from '../../widgets/failure-words.js';
import { LengthInput } from '../../widgets/length-input.js';
import { plural } from '../../model/model-words.js';
import type { PagePlot } from '../../export/page-plot.js';
import { Panel } from '../../widgets/panel.js';
import { PlaceList } from '../../widgets/place-list.js';
import { plainNumber } from '../../widgets/table-text.js';
import { explains, term } from '../../help/term.js';
import { ThresholdSlider } from '../../widgets/threshold-slider.js';

/** The weights that a vertex's neighbourhood may have against its own. */
const smoothings: [number, string][] = [
  [0, 'unsmoothed'],
  [0.5, 'smoothed, weight 0.5'],
  [1, 'smoothed, weight 1'],
  [2, 'smoothed, weight 2'],
];

/** The page, as far as the panel needs it. */
export interface PartsPage {
  /** Other parts than before were found. */
  found(): void;
  /** The surface is to be coloured by parts, or no longer. */
  colour(byParts: boolean): void;
}

export class PartsPanel {
  readonly panel = new Panel('parts-panel');
  readonly #plot = new ScatterPlot({
    moved: (thresholds, settled) => {
      this.#discardDrafts();
      this.#setThresholds(thresholds, settled);
    },
  });
  readonly #log = make('input', { id: 'parts-log', type: 'checkbox' });
  readonly #inputs: Record<keyof PartThresholds, LengthInput>;
  readonly #sliders: Record<keyof PartThresholds, ThresholdSlider>;
  readonly #smoothing = make('select', { id: 'smoothing', 'aria-label': 'Smoothing' });
  readonly #smoothingDraft: Draft;
  readonly #words = make('p', { class: 'hint', role: 'status' });
  readonly #tubes = new PlaceList('Tubes');
  readonly #plates = new PlaceList('Plates');
  readonly #titles = { tube: make('h3'), plate: make('h3') };
  readonly #controls: HTMLElement;
  #fields: { igf: Field; sdf: Field; areas: Float64Array } | undefined;
  #thresholds: PartThresholds | undefined;
  #found: Parts | undefined;
  /** Whether the thresholds are those that are suggested. */
  #isSuggested = true;
  #asked = 0;
  readonly #viewer: GirthViewer;
  readonly #store: Store;
  readonly #page: PartsPage;

  constructor(viewer: GirthViewer, store: Store, page: PartsPage) {
    this.#viewer = viewer;
    this.#store = store;
    this.#page = page;
    const [plot, log] = [this.#plot, this.#log];
    log.checked = true;
    log.addEventListener('change', () => this.#drawPlot());
    const input = (name: keyof PartThresholds, words: string): LengthInput =>
      new LengthInput(`parts-${name}`, words, {
        changed: (length) => {
          this.#writeNote();
          if (length === undefined || !this.#thresholds) return this.#write();
          this.#setThresholds({ ...this.#thresholds, [name]: length }, true);
        },
        wrong: (why) => (this.#words.textContent = `${why}.`),
      });
    this.#inputs = {
      girth: input('girth', 'Tubes: girth below'),
      shapeDiameter: input('shapeDiameter', 'Shape diameter below'),
    };
    const slider = (name: keyof PartThresholds, label: string): ThresholdSlider =>
      new ThresholdSlider(label, (length, settled) => {
        this.#discardDrafts(name);
        this.#setThresholds({ ...this.#thresholds!, [name]: length }, settled);
      });
    this.#sliders = {
      girth: slider('girth', 'Girth below which thin parts are tubes'),
      shapeDiameter: slider('shapeDiameter', 'Shape diameter below which parts are thin'),
    };
    for (const [weight, words] of smoothings) {
      this.#smoothing.append(make('option', { value: String(weight) }, words));
    }
    this.#smoothingDraft = new Draft(this.#smoothing, { committed: () => void this.#find() });
    const automatic = make(
      'button',
      { type: 'button', class: 'plain', id: 'automatic' },
      'Automatic',
    );
    automatic.addEventListener('click', () => void this.#suggest());
    this.#controls = make(
      'div',
      { class: 'controls' },
      plot.element,
      make('label', { class: 'check' }, log, ' Logarithmic'),
      this.#inputs.girth.label,
      this.#sliders.girth.element,
      this.#inputs.shapeDiameter.label,
      this.#sliders.shapeDiameter.element,
      make('div', { class: 'row' }, this.#smoothing, automatic),
    );
    explains(this.#titles.tube, 'tube');
    explains(this.#titles.plate, 'plate');
    explains(this.#inputs.girth.label, 'girth');
    explains(this.#inputs.shapeDiameter.label, 'sdf');
    this.panel.body.append(
      make(
        'p',
        { class: 'hint' },
        term('tube', 'Tubes'),
        ' and ',
        term('plate', 'plates'),
        ' are thin by the ',
        term('sdf', 'SDF'),
        ' and distinguished by their girth.',
      ),
      make(
        'div',
        { class: 'results' },
        this.#words,
        this.#titles.tube,
        this.#tubes.element,
        this.#titles.plate,
        this.#plates.element,
      ),
      this.#controls,
    );
    this.panel.onToggle((isOpen) => {
      if (isOpen) void this.compute();
      else page.colour(false);
    });
    store.watch(['girth', 'diameter', 'smoothing'], (state) => this.#follow(state));
    // Only by hand: a link states itself what colours the surface.
    this.panel.onChosen(() => page.colour(true));
    viewer.addEventListener('unit', () => this.#refresh());
    this.clear();
  }

  get plots(): PagePlot[] {
    return [{ word: 'parts', svg: (width) => this.#plot.svg(width) }];
  }

  /** The kind of each vertex, by the present parts; undefined where there are none yet. */
  get kinds(): Uint8Array | undefined {
    return this.#found?.kinds;
  }

  /** The thresholds and the smoothing, as exports need them. */
  get choice(): (PartThresholds & { smoothing: number }) | undefined {
    return this.#thresholds && { ...this.#thresholds, smoothing: Number(this.#smoothing.value) };
  }

  clear(): void {
    ++this.#asked;
    this.#fields = undefined;
    this.#thresholds = undefined;
    this.#found = undefined;
    this.#discardDrafts();
    this.#smoothingDraft.show('0');
    this.#controls.hidden = true;
    this.#refresh();
    this.#words.textContent = '';
  }

  /** The choice as the state has it. */
  get #chosen(): Pick<PageState, 'girth' | 'diameter' | 'smoothing'> {
    const { girth, shapeDiameter, smoothing } = this.choice!;
    const own = this.#isSuggested ? undefined : { girth, diameter: shapeDiameter };
    return { girth: own?.girth, diameter: own?.diameter, smoothing: smoothing || undefined };
  }

  /** Shows the thresholds of the state. */
  #follow(state: PageState): void {
    if (this.#fields) {
      const { girth, diameter, smoothing } = this.choice ? this.#chosen : {};
      const isShown =
        girth === state.girth && diameter === state.diameter && smoothing === state.smoothing;
      if (!this.choice || !isShown) void this.#show(state);
    } else if (this.panel.isOpen) void this.compute();
  }

  /** Computes what thresholds divide, where it is not there yet. */
  async compute(): Promise<void> {
    const viewer = this.#viewer;
    const { info } = viewer;
    if (!info || this.#fields) return;
    this.#words.textContent = 'Parts follow as soon as girth and shape diameter are computed …';
    try {
      const [igf, sdf, areas] = await Promise.all([
        viewer.fieldOf('igf'),
        viewer.fieldOf('sdf'),
        viewer.areas(),
      ]);
      if (viewer.info !== info || this.#fields) return;
      this.#fields = { igf, sdf, areas };
      this.#words.textContent = sentence(sdf.note);
      if (!this.#drawPlot()) {
        this.#words.textContent =
          `${sentence(sdf.note)} No vertex has both a girth and a shape diameter.`.trim();
        return;
      }
      await this.#show(this.#store.shown);
    } catch (error) {
      if (viewer.info !== info) return;
      this.#words.textContent = `No parts: ${failureWords(error)}.`;
    }
  }

  async #show({ girth, diameter, smoothing = 0 }: PageState): Promise<void> {
    const asked = ++this.#asked;
    const suggested = await this.#viewer.suggestedThresholds();
    if (asked !== this.#asked) return;
    const weight = String(smoothing);
    if (![...this.#smoothing.options].some(({ value }) => value === weight)) {
      this.#smoothing.append(make('option', { value: weight }, `smoothed, weight ${weight}`));
    }
    this.#smoothingDraft.show(weight);
    const chosen = {
      girth: girth ?? suggested.girth,
      shapeDiameter: diameter ?? suggested.shapeDiameter,
    };
    this.#setThresholds(chosen, true, girth === undefined && diameter === undefined);
  }

  async #suggest(): Promise<void> {
    this.#discardDrafts();
    const asked = ++this.#asked;
    const suggested = await this.#viewer.suggestedThresholds();
    if (asked !== this.#asked) return;
    this.#setThresholds(suggested, true, true);
  }

  /** Drops typed texts: somebody has set their thresholds in another way. */
  #discardDrafts(...names: (keyof PartThresholds)[]): void {
    const all = names.length > 0 ? names : (['girth', 'shapeDiameter'] as const);
    for (const name of all) this.#inputs[name].discard();
    this.#writeNote();
  }

  #writeNote(): void {
    this.#words.textContent = sentence(this.#fields?.sdf.note ?? '');
  }

  #drawPlot(): boolean {
    const [fields, viewer] = [this.#fields, this.#viewer];
    if (!fields) return false;
    const { igf, sdf, areas } = fields;
    const format = viewer.lengthFormat;
    const [body, tube, plate] = partKinds.map(({ colour }) => bytesOf(colour));
    const unit = format.unit ? `, ${format.unit}` : '';
    const isShown = this.#plot.show({
      girth: igf.values,
      shapeDiameter: sdf.values,
      weights: areas,
      log: this.#log.checked,
      colours: { body: darker(body!), tube: tube!, plate: plate! },
      format: (length) => plainNumber(length * format.scale, 2),
      unit: format.unit,
      labels: { girth: `Girth${unit}`, shapeDiameter: `Shape diameter${unit}` },
    });
    if (this.#thresholds) this.#plot.setThresholds(this.#thresholds);
    return isShown;
  }

  #setThresholds(thresholds: PartThresholds, settled: boolean, isSuggested = false): void {
    this.#isSuggested = isSuggested;
    this.#thresholds = { ...thresholds };
    // Not before: a control that has nothing to change would lose what is done with it.
    this.#controls.hidden = false;
    this.#plot.setThresholds(thresholds);
    this.#viewer.setThresholds(thresholds);
    this.#write();
    if (settled) void this.#find();
  }

  /** The parts by the present thresholds. */
  async #find(): Promise<void> {
    const viewer = this.#viewer;
    const { choice } = this;
    if (!choice) return;
    const asked = ++this.#asked;
    try {
      const found = await viewer.parts(choice);
      if (asked !== this.#asked) return;
      this.#found = found;
      this.#refresh();
      this.#page.found();
    } catch (error) {
      if (asked !== this.#asked) return;
      this.#words.textContent = `${failureWords(error)}.`;
    }
    this.#store.choose(this.#chosen);
  }

  #write(): void {
    const [thresholds, fields] = [this.#thresholds, this.#fields];
    const format = this.#viewer.lengthFormat;
    for (const name of ['girth', 'shapeDiameter'] as const) {
      this.#inputs[name].show(thresholds?.[name], format);
      const field = name === 'girth' ? fields?.igf : fields?.sdf;
      this.#sliders[name].show(field?.range, thresholds?.[name], (length) =>
        formatLength(length, format),
      );
    }
  }

  #refresh(): void {
    const [found, viewer] = [this.#found, this.#viewer];
    this.#write();
    if (this.#fields) this.#drawPlot();
    const format = viewer.lengthFormat;
    const of = (kind: PartKind): Part[] => found?.parts.filter((part) => part.kind === kind) ?? [];
    const [tubes, plates] = [of('tube'), of('plate')];
    this.panel.summary = found
      ? `${plural(tubes.length, 'tube', 'tubes')}, ${plural(plates.length, 'plate', 'plates')}`
      : '';
    this.#titles.tube.textContent = `Tubes: ${tubes.length}`;
    this.#titles.plate.textContent = `Plates: ${plates.length}`;
    for (const title of Object.values(this.#titles)) title.hidden = !found;
    const fly = ({ vertices }: Part): void => viewer.flyTo({ vertices });
    this.#tubes.show(
      tubes.map((part) => ({
        colour: partKinds[1]!.colour,
        main: `radius ${formatLength(part.equivalentRadius, format)}`,
        detail: `girth ${formatLength(part.medianGirth, format)} · area ${formatArea(part.area, format)}`,
        choose: () => fly(part),
      })),
    );
    this.#plates.show(
      plates.map((part) => ({
        colour: partKinds[2]!.colour,
        main: `shape diameter ${formatLength(part.medianShapeDiameter, format)}`,
        detail: `girth ${formatLength(part.medianGirth, format)} · area ${formatArea(part.area, format)}`,
        choose: () => fly(part),
      })),
    );
  }
}

function bytesOf(colour: string): [number, number, number] {
  const code = Number.parseInt(colour.slice(1), 16);
  return [code >> 16, (code >> 8) & 255, code & 255];
}

/** The body's light grey would not be seen as points on paper. */
function darker([r, g, b]: readonly number[]): [number, number, number] {
  return [0.62 * r!, 0.62 * g!, 0.62 * b!];
}
