// The print check: places too thin for a printer, listed, pictured and reported.

import {
  type Category,
  type GirthViewer,
  type PlacePicture,
  type ShownPlaces,
  formatLength,
  make,
  sentence,
} from '../../../src/element/index.js';
import type { MeshInfo, PrintCheck, PrintLimits, WeakPlace } from '../../../src/kernel/index.js';
import { formatArea } from '../../widgets/area-words.js';
import { Draft } from '../../widgets/draft.js';
import type { PageState } from '../../state/address-state.js';
import { failureWords } from '../../widgets/failure-words.js';
import { LengthInput } from '../../widgets/length-input.js';
import { namedScale, scaleWords, tallWords } from '../../model/model-size.js';
import { modelFacts, plural } from '../../model/model-words.js';
import type { Panel } from '../../widgets/panel.js';
import { PlaceList } from '../../widgets/place-list.js';
import { printPresets } from './print-presets.js';
import type { PrintReport, ReportedPlace } from './print-report.js';
import { UncoveredPlace } from './uncovered-place.js';
import { answerWords, creaseWords, measureNames, uncheckedWords } from './print-words.js';
import { saveFile, stemOf } from '../../export/save-file.js';
import { type ModelScale, SizeChoice } from '../../model/size-choice.js';
import { explains } from '../../help/term.js';
import type { Store } from '../../state/store.js';

/** Places that get a picture in the list, and in the report. */
const picturedPlaces = 12;
const reportedPlaces = 60;
const listedCreases = 100;
/** The categories that colour the surface once it is checked. */
const kinds: readonly Category[] = [
  { name: 'thick enough', colour: '#cfd0d3', hatched: false },
  { name: 'thin tube', colour: '#d55e00', hatched: true },
  { name: 'thin wall', colour: '#0072b2', hatched: true },
  { name: 'narrow gap', colour: '#cc79a7', hatched: true },
];
const kindCodes = { tube: 1, wall: 2, gap: 3 } as const;

interface Checked {
  limits: PrintLimits;
  check: PrintCheck;
  pictures: Map<WeakPlace, ReportedPlace>;
  /** The pictures as the list has them. */
  images: Map<WeakPlace, HTMLImageElement>;
}

export class PrintPanel {
  readonly panel: Panel;
  readonly #size: SizeChoice;
  readonly #preset = make('select', { id: 'print-preset' });
  readonly #presetDraft: Draft;
  readonly #source = make('p', { class: 'hint', id: 'print-source' });
  readonly #tube: LengthInput;
  readonly #wall: LengthInput;
  readonly #gap: LengthInput;
  readonly #answer = make('p', { class: 'answer', role: 'status' });
  readonly #shareWords = make('span');
  readonly #shareBar = make('progress', { max: '1' });
  readonly #share = make('p', { class: 'awaited' }, this.#shareWords, this.#shareBar);
  /** The field that the answer waits for. */
  #awaited: 'thickness' | 'igf' | undefined;
  readonly #grow = make('button', { type: 'button', class: 'plain' });
  readonly #remedy = make('p', { class: 'buttons' }, this.#grow);
  readonly #cautions = make('ul', { class: 'cautions' });
  readonly #list = new PlaceList('Places that are too thin');
  readonly #creaseList = make('ul', { class: 'creases' });
  readonly #creaseCount = make('h3');
  readonly #creases = make(
    'div',
    { role: 'group', 'aria-label': 'Creases' },
    this.#creaseCount,
    make('p', { class: 'hint' }, 'No wall is thin there: creases do not fail.'),
    this.#creaseList,
  );
  readonly #reports: HTMLElement;
  #checked: Checked | undefined;
  /** A caution about the thickness; '' for none. */
  #note = '';
  #asked = 0;
  /** The model that is coloured by its places, and these. */
  #coloured: MeshInfo | undefined;
  #places: ShownPlaces | undefined;
  readonly #hasColoured: () => void;
  /** Checks again when the model is there in its other size. */
  #isToBeChecked = false;
  readonly #viewer: GirthViewer;
  readonly #store: Store;
  readonly #uncovered: UncoveredPlace;

  /** `panel`: what is drawn in. `coloured`: called when places colour the surface, or no longer. */
  constructor(
    viewer: GirthViewer,
    store: Store,
    panel: Panel,
    model: ModelScale,
    coloured: () => void,
  ) {
    this.panel = panel;
    this.#hasColoured = coloured;
    this.#viewer = viewer;
    this.#store = store;
    this.#uncovered = new UncoveredPlace(viewer, store);
    this.#size = new SizeChoice('print-', viewer, model);
    const ownNumbers = {
      changed: () => {
        this.#showSource('');
        this.#keep();
      },
    };
    this.#tube = new LengthInput('min-tube', 'Tube diameter ≥', ownNumbers);
    this.#wall = new LengthInput('min-wall', 'Wall thickness ≥', ownNumbers);
    this.#gap = new LengthInput('min-gap', 'Gap ≥', ownNumbers);
    explains(this.#tube.label, 'tube');
    explains(this.#wall.label, 'thickness');
    this.#preset.append(
      make('option', { value: '' }, 'own numbers'),
      ...printPresets.map(({ name }) => make('option', { value: name }, name)),
    );
    this.#presetDraft = new Draft(this.#preset, {
      committed: (name) => {
        this.#choosePreset(name);
        this.#keep();
      },
    });
    const submit = make('button', { class: 'plain', id: 'check' }, 'Check');
    const form = make(
      'form',
      {},
      this.#size.element,
      make(
        'p',
        { class: 'length' },
        make('label', { for: 'print-preset' }, 'Printer'),
        this.#preset,
      ),
      this.#tube.label,
      this.#wall.label,
      this.#gap.label,
      this.#source,
      make('p', {}, submit),
    );
    form.noValidate = true;
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.#run();
    });
    this.#grow.addEventListener('click', () => {
      const { passingScale = 1 } = this.#checked?.check ?? {};
      this.#isToBeChecked = true;
      model.rescale(model.scale * namedScale(passingScale));
    });
    const html = make('button', { type: 'button', class: 'plain' }, 'Report (HTML)');
    html.addEventListener('click', () => void this.#save('html'));
    const json = make('button', { type: 'button', class: 'plain' }, 'JSON');
    json.addEventListener('click', () => void this.#save('json'));
    this.#reports = make('p', { class: 'buttons' }, html, json);
    this.panel.body.append(
      this.#answer,
      this.#share,
      this.#remedy,
      this.#cautions,
      form,
      this.#reports,
      this.#list.element,
      this.#creases,
    );
    this.panel.onToggle((isOpen) => {
      if (isOpen) this.#refresh();
      this.#colour();
    });
    store.watch(['tube', 'wall', 'gap', 'printer'], (state) => this.#follow(state));
    viewer.addEventListener('unit', () => this.#changeUnit());
    viewer.addEventListener('progress', ({ detail: { name, fraction } }) => {
      if (name === this.#awaited) this.#shareBar.setAttribute('value', String(fraction));
    });
    this.clear(true);
    this.#follow(store.shown);
  }

  get #inputs(): readonly LengthInput[] {
    return [this.#tube, this.#wall, this.#gap];
  }

  /** The limits of the printer, as the state has them. */
  get #limits(): Pick<PageState, 'tube' | 'wall' | 'gap' | 'printer'> {
    return {
      tube: this.#tube.length || undefined,
      wall: this.#wall.length || undefined,
      gap: this.#gap.length || undefined,
      printer: printPresets.find(({ name }) => name === this.#presetDraft.text)?.key,
    };
  }

  #keep(): void {
    this.#store.choose(this.#limits);
  }

  /** Shows the limits of the state; limits that are there already stay, with their answer. */
  #follow({ tube, wall, gap, printer }: PageState): void {
    const now = this.#limits;
    if (now.tube === tube && now.wall === wall && now.gap === gap && now.printer === printer)
      return;
    this.#forget();
    this.#tube.show(tube, this.#viewer.lengthFormat);
    this.#wall.show(wall, this.#viewer.lengthFormat);
    this.#gap.show(gap, this.#viewer.lengthFormat);
    this.#showSource(printPresets.find(({ key }) => key === printer)?.name ?? '');
  }

  /** Another model, or the same one in another size, which keeps what can be printed. */
  clear(isAnother: boolean): void {
    if (isAnother) {
      for (const input of this.#inputs) {
        input.discard();
        input.show(undefined, this.#viewer.lengthFormat);
      }
      this.#showSource('');
      this.#isToBeChecked = false;
    }
    this.#unit = this.#viewer.unit;
    this.#size.clear();
    this.#forget();
    if (!this.#isToBeChecked) return;
    this.#isToBeChecked = false;
    void this.#run();
  }

  /** Numbers stay as they were typed, and count in the unit that is now beside them. */
  #changeUnit(): void {
    const { lengthFormat } = this.#viewer;
    const isSame = this.#unit === this.#viewer.unit;
    this.#unit = this.#viewer.unit;
    for (const input of this.#inputs) {
      // A length that is only shown in another unit remains what it is.
      if (isSame) input.show(input.length, lengthFormat);
      else input.setUnit(lengthFormat);
    }
    if (isSame) this.#show();
    else {
      this.#forget();
      this.#keep();
    }
  }

  /** The unit of the model that the limits are for. */
  #unit = '';

  #choosePreset(name: string): void {
    const preset = printPresets.find((one) => one.name === name);
    if (!preset) return this.#showSource('');
    const { tubeDiameter, wallThickness } = preset;
    const isTaken = this.#tube.type(tubeDiameter) && this.#wall.type(wallThickness);
    if (!isTaken) {
      this.#forget();
      this.#answer.textContent = 'First choose the unit of the file, above: these are millimetres.';
      for (const input of [this.#tube, this.#wall]) {
        input.discard();
        input.show(undefined, this.#viewer.lengthFormat);
      }
    }
    this.#showSource(isTaken ? name : '');
  }

  /** Whose numbers the limits are. */
  #showSource(name: string): void {
    const preset = printPresets.find((one) => one.name === name);
    this.#presetDraft.show(name);
    if (!preset) {
      // The hint takes the source's room, so that the button below stays where it is.
      this.#source.textContent = 'With or without a unit: 3, 3 mm, 0.1in.';
      return;
    }
    const { tubeDiameter, wallThickness, source } = preset;
    const link = make(
      'a',
      { href: source.address, target: '_blank', rel: 'noopener noreferrer' },
      source.title,
    );
    this.#source.replaceChildren(`${tubeDiameter} and ${wallThickness}: `, link);
  }

  #forget(): void {
    ++this.#asked;
    this.#await(undefined);
    this.#checked = undefined;
    this.#note = '';
    this.#answer.textContent = '';
    this.#answer.className = 'answer';
    this.panel.summary = '';
    this.#colour();
    this.#refresh();
  }

  /** All places that fail at once, with a legend, as long as the panel is open. */
  #colour(): void {
    const viewer = this.#viewer;
    const { info } = viewer;
    if (!info) return;
    if (!this.#checked || !this.panel.isOpen) {
      if (this.#coloured === info) viewer.showPlaces(undefined);
      this.#coloured = undefined;
      this.#hasColoured();
      return;
    }
    this.#coloured = info;
    const kindOf = new Uint8Array(info.vertexCount);
    for (const { kind, vertices } of this.#checked.check.places) {
      // Thin tubes and walls keep their kind, whatever else a vertex is in.
      for (const vertex of vertices) kindOf[vertex] ||= kindCodes[kind];
    }
    this.#places = { title: 'Print check', kinds: kindOf, categories: kinds };
    viewer.showPlaces(this.#places);
    this.#hasColoured();
  }

  /** The places that were found, where they colour the surface in place of a field. */
  get places(): ShownPlaces | undefined {
    const { info, shown } = this.#viewer;
    const isColouring = this.#coloured !== undefined && this.#coloured === info && !shown;
    return isColouring ? this.#places : undefined;
  }

  #refresh(): void {
    const viewer = this.#viewer;
    for (const input of this.#inputs) input.show(input.length, viewer.lengthFormat);
    this.#size.refresh();
    this.#cautions.replaceChildren(...this.#words().map((line) => make('li', {}, line)));
    this.#reports.hidden = !this.#checked;
    const { places = [], creases = [], passingScale = 0 } = this.#checked?.check ?? {};
    this.#list.element.hidden = places.length === 0;
    this.#creases.hidden = creases.length === 0;
    this.#remedy.hidden = places.length === 0 || !Number.isFinite(passingScale);
    this.#grow.textContent = `Make it ${scaleWords(passingScale)}${passingScale < 10 ? '' : ' as large'}`;
  }

  /** The reasons not to trust the answer, a sentence each. */
  #words(): string[] {
    const { info, unit } = this.#viewer;
    if (!info) return [];
    const words: string[] = [];
    if (!unit) {
      words.push(
        'The file does not state its unit. Choose it, or type lengths in the file’s own unit.',
      );
    }
    const holes = info.boundaries.reduce((sum, count) => sum + count, 0);
    if (holes > 0) {
      words.push(
        `The surface is open: it has ${plural(holes, 'hole', 'holes')}, and thickness near ${holes === 1 ? 'it' : 'them'} ` +
          'may be wrong. What can be printed is closed.',
      );
    }
    if (this.#note) words.push(this.#note);
    const isUnderWay = this.#awaited !== undefined;
    const unchecked = !isUnderWay && this.#checked && uncheckedWords(this.#checked.limits);
    if (unchecked) words.push(`Not checked: ${unchecked}.`);
    return words;
  }

  async #run(): Promise<void> {
    const [viewer, tube, wall, gap] = [this.#viewer, this.#tube, this.#wall, this.#gap];
    const { info } = viewer;
    // A typed text counts, whether or not its field has been left.
    const wrong = this.#inputs.filter((input) => !input.commit())[0];
    // An older answer is none to what is asked now.
    this.#forget();
    if (wrong || (!tube.length && !wall.length && !gap.length)) {
      this.#answer.textContent = wrong
        ? `${wrong.fault}.`
        : 'Type a least tube diameter, wall thickness or gap, or choose a printer.';
      (wrong ?? tube).input.focus();
      return;
    }
    if (!info) return;
    const limits = {
      tubeDiameter: tube.length ?? 0,
      wallThickness: wall.length ?? 0,
      gap: gap.length ?? 0,
    };
    const asked = ++this.#asked;
    const isStale = (): boolean => asked !== this.#asked || viewer.info !== info;
    // Walls and gaps do not wait for the girth.
    const waitsForGirth = limits.tubeDiameter > 0 && viewer.shareOf('igf') < 1;
    const isTwofold = waitsForGirth && (limits.wallThickness > 0 || limits.gap > 0);
    const first = isTwofold ? { ...limits, tubeDiameter: 0 } : limits;
    this.#answer.textContent = 'Checking …';
    try {
      const girth = first.tubeDiameter > 0 ? 'igf' : undefined;
      this.#await(first.wallThickness > 0 ? 'thickness' : girth);
      const note = limits.wallThickness > 0 ? (await viewer.fieldOf('thickness')).note : '';
      if (isStale()) return;
      this.#note = sentence(note);
      this.#refresh();
      this.#await(girth);
      const check = await viewer.printCheck(first);
      if (isStale()) return;
      const whole = isTwofold ? viewer.printCheck(limits) : undefined;
      this.#await(isTwofold ? 'igf' : undefined);
      this.#take({ limits: first, check, pictures: new Map(), images: new Map() });
      this.#answer.scrollIntoView({ block: 'nearest' });
      if (!whole) return;
      const found = await whole;
      if (isStale()) return;
      this.#await(undefined);
      this.#take({ limits, check: found, pictures: new Map(), images: new Map() });
    } catch (error) {
      if (isStale()) return;
      this.#await(undefined);
      const words = failureWords(error);
      if (!this.#checked) this.#answer.textContent = `Not checked: ${words}.`;
      else {
        this.#note = `Tubes are not checked: ${words}.`;
        this.#refresh();
      }
    }
  }

  /** Shows an answer, and pictures of its places as they are made. */
  #take(checked: Checked): void {
    this.#checked = checked;
    this.#show();
    void this.#picturePlaces(checked).catch(() => undefined);
  }

  async #picturePlaces(checked: Checked): Promise<void> {
    for (const place of checked.check.places.slice(0, picturedPlaces)) {
      await this.#picture(checked, place);
      if (this.#checked !== checked) return;
      this.#show();
    }
  }

  /** Shows how much there is of a field that the answer needs; undefined: nothing is missing. */
  #await(field: 'thickness' | 'igf' | undefined): void {
    this.#awaited = field;
    this.#share.hidden = field === undefined;
    if (!field) return;
    const words = field === 'igf' ? 'Girth, for tubes' : 'Thickness, for walls';
    this.#shareBar.setAttribute('aria-label', words);
    this.#shareWords.textContent = words;
    this.#shareBar.setAttribute('value', String(this.#viewer.shareOf(field)));
  }

  #show(): void {
    const [checked, viewer] = [this.#checked, this.#viewer];
    if (!checked) return;
    const { check, pictures } = checked;
    const { places, creases } = check;
    const format = viewer.lengthFormat;
    this.#answer.className = `answer ${places.length > 0 ? 'fails' : 'passes'}`;
    const words = answerWords(check, checked.limits);
    // Said once: a live region speaks whenever it changes.
    if (this.#answer.textContent !== words) this.#answer.textContent = words;
    this.panel.summary = places.length > 0 ? `${places.length} ✕` : '✓';
    if (pictures.size === 0) this.#colour();
    this.#refresh();
    this.#list.show(
      places.map((place) => {
        const made = pictures.get(place);
        const loop = made?.loop === undefined ? '' : ` · loop ${formatLength(made.loop, format)}`;
        return {
          main: `${measureNames[place.kind]} ${formatLength(place.least, format)}`,
          detail: `${place.kind}${loop} · area ${formatArea(place.area, format)}`,
          picture:
            made?.picture === undefined ? undefined : this.#image(checked, place, made.picture),
          choose: () => void this.#uncovered.lookAt(place.vertices),
        };
      }),
    );
    this.#creaseCount.textContent = plural(creases.length, 'crease', 'creases');
    this.#creaseList.replaceChildren(
      ...creases.slice(0, listedCreases).map(({ kind, length, vertices }) => {
        const words = `${creaseWords[kind]}, ${formatLength(length, format)} long`;
        const button = make('button', { type: 'button', class: 'more' }, words);
        button.addEventListener('click', () => void this.#uncovered.lookAt(vertices));
        return make('li', {}, button);
      }),
    );
  }

  #image({ images }: Checked, place: WeakPlace, src: string): HTMLImageElement {
    const image = images.get(place) ?? make('img', { src, alt: '' });
    images.set(place, image);
    return image;
  }

  /** The loop at a place, where it is a tube, and a picture of both. */
  async #picture({ pictures }: Checked, place: WeakPlace): Promise<ReportedPlace> {
    const viewer = this.#viewer;
    const known = pictures.get(place);
    if (known) return known;
    const loop = place.kind === 'tube' ? await viewer.loop(place.thinnest) : undefined;
    const picture = await this.#pictureOf({
      vertices: place.vertices,
      ...(loop ? { loop } : {}),
    });
    const made = { place, loop: loop?.length, picture };
    pictures.set(place, made);
    return made;
  }

  /** The whole shape, as it is coloured now. */
  #overview({ vertexCount }: MeshInfo): Promise<string | undefined> {
    const vertices = Uint32Array.from({ length: vertexCount }, (_, vertex) => vertex);
    return this.#pictureOf({ vertices, width: 960, height: 640 });
  }

  /** The picture as an address; undefined where the browser gives no 3D graphics. */
  async #pictureOf(wanted: PlacePicture): Promise<string | undefined> {
    try {
      return await dataAddress(await this.#viewer.snapshotOf(wanted));
    } catch (error) {
      if (error instanceof Error && 'code' in error && error.code === 'NO_WEBGL') return undefined;
      throw error;
    }
  }

  async #save(ending: 'html' | 'json'): Promise<void> {
    const [checked, viewer] = [this.#checked, this.#viewer];
    const { info } = viewer;
    if (!checked || !info) return;
    const { check, limits } = checked;
    const name = `${stemOf(info.name)}-print-check.${ending}`;
    try {
      if (ending === 'json') {
        saveFile(await viewer.exportWeakPlaces(limits, 'json'), name);
        return;
      }
      const places: ReportedPlace[] = [];
      for (const place of check.places.slice(0, reportedPlaces)) {
        places.push(await this.#picture(checked, place));
      }
      const [, ...facts] = modelFacts(info);
      const report: PrintReport = {
        model: info.name,
        facts: [tallWords(viewer.height, viewer.lengthFormat), ...facts].join(' · '),
        cautions: this.#words().filter((line) => !line.startsWith('Not checked')),
        limits,
        source: this.#presetDraft.text && (this.#source.textContent ?? ''),
        check,
        format: viewer.lengthFormat,
        places,
        overview: await this.#overview(info),
        date: new Date().toISOString().slice(0, 10),
      };
      const { printReportHtml } = await import('./print-report.js');
      saveFile(printReportHtml(report), name);
    } catch (error) {
      this.#answer.textContent = `That could not be written: ${failureWords(error)}.`;
    }
  }
}

function dataAddress(blob: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener('load', () => resolve(reader.result as string));
    reader.addEventListener('error', () => reject(reader.error ?? new Error('no picture')));
    reader.readAsDataURL(blob);
  });
}
