// The print check: what is too thin for a printer, listed, pictured and reported.

import { type GirthViewer, formatLength, make, sentence } from '../src/element/index.js';
import type { MeshInfo, PrintLimits, WeakPlace } from '../src/kernel/index.js';
import { formatArea } from './area-words.js';
import { Draft } from './draft.js';
import { failureWords } from './failure-words.js';
import { LengthInput, noLength } from './length-input.js';
import { modelFacts, plural } from './model-words.js';
import { Panel } from './panel.js';
import { PlaceList } from './place-list.js';
import {
  type PrintReport,
  type ReportedPlace,
  answerWords,
  measureName,
  placeName,
  printReportHtml,
} from './print-report.js';
import { saveFile, stemOf } from './save-file.js';
import { explains } from './terms.js';

/** Units that a printed thing may be given in. */
const units = ['mm', 'cm', 'm', 'in'];
/** Places that get a picture in the list, and in the report. */
const picturedPlaces = 12;
const reportedPlaces = 60;

interface Check {
  limits: PrintLimits;
  places: WeakPlace[];
  pictures: Map<WeakPlace, ReportedPlace>;
  /** The pictures as the list has them. */
  images: Map<WeakPlace, HTMLImageElement>;
}

export class PrintPanel {
  readonly panel = new Panel('print-panel');
  readonly #unit = make('select', { id: 'print-unit' });
  readonly #unitDraft: Draft;
  readonly #unitWords = make('span', { class: 'said' });
  readonly #tube = new LengthInput('min-tube', 'Tube diameter ≥');
  readonly #wall = new LengthInput('min-wall', 'Wall thickness ≥');
  readonly #answer = make('p', { class: 'answer', role: 'status' });
  readonly #cautions = make('ul', { class: 'cautions' });
  readonly #list = new PlaceList('Places that are too thin');
  readonly #reports: HTMLElement;
  #check: Check | undefined;
  /** What is to be known of the thickness. */
  #note = '';
  #asked = 0;
  readonly #viewer: GirthViewer;

  constructor(viewer: GirthViewer, changed: () => void) {
    this.#viewer = viewer;
    const unit = this.#unit;
    unit.append(
      make('option', { value: '' }, 'choose'),
      ...units.map((name) => make('option', { value: name }, name)),
    );
    this.#unitDraft = new Draft(unit, { committed: (name) => viewer.setAttribute('unit', name) });
    explains(this.#tube.label, 'tube');
    explains(this.#wall.label, 'plate');
    const submit = make('button', { class: 'plain', id: 'check' }, 'Check');
    const form = make(
      'form',
      {},
      make(
        'p',
        { class: 'length' },
        make('label', { for: 'print-unit' }, 'Unit of the file'),
        unit,
        this.#unitWords,
      ),
      this.#tube.label,
      this.#wall.label,
      make('p', {}, submit),
    );
    form.noValidate = true;
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.#run();
    });
    const html = make('button', { type: 'button', class: 'plain' }, 'Report (HTML)');
    html.addEventListener('click', () => void this.#save('html'));
    const json = make('button', { type: 'button', class: 'plain' }, 'JSON');
    json.addEventListener('click', () => void this.#save('json'));
    this.#reports = make('p', { class: 'buttons' }, html, json);
    this.panel.body.append(form, this.#answer, this.#cautions, this.#reports, this.#list.element);
    this.panel.onToggle((isOpen) => {
      if (isOpen) this.#refresh();
      else if (viewer.info) viewer.mark(undefined);
      changed();
    });
    viewer.addEventListener('unit', () => {
      // The numbers stay as they were typed, and count in the unit that is now beside them.
      for (const input of [this.#tube, this.#wall]) input.setUnit(viewer.lengthFormat);
      this.#forget();
    });
    this.clear();
  }

  clear(): void {
    for (const input of [this.#tube, this.#wall]) {
      input.discard();
      input.show(undefined, this.#viewer.lengthFormat);
    }
    this.#forget();
  }

  #forget(): void {
    ++this.#asked;
    this.#check = undefined;
    this.#note = '';
    this.#answer.textContent = '';
    this.#answer.className = 'answer';
    this.panel.summary = '';
    this.#refresh();
  }

  #refresh(): void {
    const viewer = this.#viewer;
    const { info } = viewer;
    const said = info?.unit ?? '';
    this.#unit.hidden = said !== '';
    this.#unitWords.textContent = said === '' ? '' : said;
    const isListed = [...this.#unit.options].some(({ value }) => value === viewer.unit);
    if (!isListed && said === '') {
      this.#unit.append(make('option', { value: viewer.unit }, viewer.unit));
    }
    this.#unitDraft.show(said === '' ? viewer.unit : '');
    for (const input of [this.#tube, this.#wall]) input.show(input.length, viewer.lengthFormat);
    this.#cautions.replaceChildren(...this.#words().map((line) => make('li', {}, line)));
    this.#reports.hidden = !this.#check;
    this.#list.element.hidden = !this.#check?.places.length;
  }

  /** What stands in the way of trusting the answer. */
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
    return words;
  }

  async #run(): Promise<void> {
    const [viewer, tube, wall] = [this.#viewer, this.#tube, this.#wall];
    const { info } = viewer;
    // What was typed counts, whether or not the field has been left.
    const wrong = [tube, wall].filter((input) => !input.commit())[0];
    if (wrong || (!tube.length && !wall.length)) {
      this.#answer.className = 'answer';
      this.#answer.textContent = wrong
        ? noLength
        : 'Type a least tube diameter, a least wall thickness, or both.';
      (wrong ?? tube).input.focus();
      return;
    }
    if (!info) return;
    const limits = { tubeDiameter: tube.length ?? 0, wallThickness: wall.length ?? 0 };
    const asked = ++this.#asked;
    this.#answer.className = 'answer';
    this.#answer.textContent = 'Checking …';
    try {
      const sdf = await viewer.fieldOf('sdf');
      if (asked !== this.#asked || viewer.info !== info) return;
      this.#note = sentence(sdf.note);
      this.#refresh();
      const places = await viewer.weakPlaces(limits);
      if (asked !== this.#asked || viewer.info !== info) return;
      this.#check = { limits, places, pictures: new Map(), images: new Map() };
      this.#show();
      for (const place of places.slice(0, picturedPlaces)) {
        await this.#picture(this.#check, place);
        if (asked !== this.#asked || viewer.info !== info) return;
        this.#show();
      }
    } catch (error) {
      if (asked !== this.#asked || viewer.info !== info) return;
      this.#answer.textContent = `Not checked: ${failureWords(error)}.`;
    }
  }

  #show(): void {
    const [check, viewer] = [this.#check, this.#viewer];
    if (!check) return;
    const { places, pictures } = check;
    const format = viewer.lengthFormat;
    this.#answer.className = `answer ${places.length > 0 ? 'fails' : 'passes'}`;
    this.#answer.textContent = answerWords(places.length);
    this.panel.summary = places.length > 0 ? `${places.length} ✕` : '✓';
    this.#refresh();
    this.#list.show(
      places.map((place) => {
        const made = pictures.get(place);
        const loop = made?.loop === undefined ? '' : ` · loop ${formatLength(made.loop, format)}`;
        return {
          main: `${measureName(place)} ${formatLength(place.least, format)}`,
          detail: `${placeName(place)}${loop} · area ${formatArea(place.area, format)}`,
          picture:
            made?.picture === undefined ? undefined : this.#image(check, place, made.picture),
          choose: () => this.#choose(place),
        };
      }),
    );
  }

  #image({ images }: Check, place: WeakPlace, src: string): HTMLImageElement {
    const image = images.get(place) ?? make('img', { src, alt: '' });
    images.set(place, image);
    return image;
  }

  #choose(place: WeakPlace): void {
    this.#viewer.mark(place.vertices);
    this.#viewer.flyTo({ vertices: place.vertices });
  }

  /** The loop at a place, where it is a tube, and a picture of both. */
  async #picture({ pictures }: Check, place: WeakPlace): Promise<ReportedPlace> {
    const viewer = this.#viewer;
    const known = pictures.get(place);
    if (known) return known;
    const loop =
      place.kind === 'tube' && place.thinnest >= 0 ? await viewer.loop(place.thinnest) : undefined;
    const picture = await viewer.snapshotOf({
      vertices: place.vertices,
      ...(loop ? { loop } : {}),
    });
    const made = { place, loop: loop?.length, picture: await dataAddress(picture) };
    pictures.set(place, made);
    return made;
  }

  /** The whole shape, as it is coloured now. */
  async #overview({ vertexCount }: MeshInfo): Promise<string> {
    const vertices = Uint32Array.from({ length: vertexCount }, (_, vertex) => vertex);
    return dataAddress(await this.#viewer.snapshotOf({ vertices, width: 960, height: 640 }));
  }

  async #save(ending: 'html' | 'json'): Promise<void> {
    const [check, viewer] = [this.#check, this.#viewer];
    const { info } = viewer;
    if (!check || !info) return;
    const name = `${stemOf(info.name)}-print-check.${ending}`;
    try {
      if (ending === 'json') {
        saveFile(await viewer.exportWeakPlaces(check.limits, 'json'), name);
        return;
      }
      const places: ReportedPlace[] = [];
      for (const place of check.places.slice(0, reportedPlaces)) {
        places.push(await this.#picture(check, place));
      }
      const [, ...facts] = modelFacts(info);
      const report: PrintReport = {
        model: info.name,
        facts: facts.join(' · '),
        cautions: this.#words(),
        limits: check.limits,
        format: viewer.lengthFormat,
        places,
        more: check.places.length - places.length,
        overview: await this.#overview(info),
        date: new Date().toISOString().slice(0, 10),
      };
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
