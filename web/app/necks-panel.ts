// Necks, handles and tunnels: their loops as lists and on the surface, and the surface cut along them.

import { type GirthViewer, formatLength, make } from '../src/element/index.js';
import type {
  Cut,
  CutFormat,
  Handle,
  Handles,
  Neck,
  Necks,
  SurfacePoint,
} from '../src/kernel/index.js';
import { formatArea, formatVolume } from './area-words.js';
import { failureWords } from './failure-words.js';
import { LengthInput } from './length-input.js';
import { plural } from './model-words.js';
import { Panel } from './panel.js';
import { PlaceList, type PlaceRow } from './place-list.js';
import { stemOf } from './save-file.js';
import { term } from './terms.js';
import { saveFiles } from './zip-files.js';

/** The largest parts of a cut have a colour each, the others the last one. */
const partColours = ['#cfd0d3', '#0072b2', '#e69f00', '#d55e00'] as const;
const handleWords = { handle: 'handle', tunnel: 'tunnel', unknown: 'handle or tunnel' } as const;
const formats: Record<CutFormat, string> = {
  glb: 'one file, a node for each part',
  stl: 'a file for each part',
  obj: 'one file, an object for each part',
  json: 'what they measure',
};

/** A loop that is listed. */
type Listed = { kind: 'neck'; loop: Neck } | { kind: 'handle'; loop: Handle };

export class NecksPanel {
  readonly panel = new Panel('necks-panel');
  readonly #words = make('span', { class: 'hint', role: 'status' });
  readonly #cancel = make('button', { type: 'button', class: 'plain', hidden: '' }, 'Cancel');
  readonly #resume = make('button', { type: 'button', class: 'plain', hidden: '' }, 'Search');
  readonly #least: LengthInput;
  readonly #neckTitle = make('h3');
  readonly #necks = new PlaceList('Necks');
  readonly #handleTitle = make('h3');
  readonly #handles = new PlaceList('Handles and tunnels');
  readonly #chosenWords = make('p', { class: 'hint' });
  readonly #cap = make('input', { id: 'cut-cap', type: 'checkbox' });
  readonly #cutHere = make('button', { type: 'button', class: 'plain' }, 'Cut here');
  readonly #cutAll = make('button', { type: 'button', class: 'plain' });
  readonly #cutting = make('div', { class: 'cutting' });
  readonly #parts = make('ol', { class: 'cut-parts', 'aria-label': 'Parts of the cut' });
  readonly #cutWords = make('p', { class: 'hint', role: 'status' });
  readonly #whole = make('button', { type: 'button', class: 'plain' }, 'Show it whole');
  readonly #files = make('p', { class: 'buttons' });
  #found: { necks: Necks; handles: Handles } | undefined;
  #running: AbortController | undefined;
  #chosen: Listed | undefined;
  #cut: { curves: SurfacePoint[][]; cap: boolean; parts: Cut['parts'] } | undefined;
  #cutTurn = 0;
  readonly #viewer: GirthViewer;

  constructor(viewer: GirthViewer, changed: () => void) {
    this.#viewer = viewer;
    this.#least = new LengthInput('neck-prominence', 'Necks that stand out by', {
      changed: () => {
        this.#choose(undefined);
        this.#refresh();
      },
      wrong: (why) => (this.#words.textContent = `${why}.`),
    });
    this.#cap.checked = true;
    this.#cancel.addEventListener('click', () => this.#running?.abort());
    this.#resume.addEventListener('click', () => void this.compute());
    this.#cutHere.addEventListener('click', () => {
      if (this.#chosen) void this.#cutAlong([this.#chosen.loop.points]);
    });
    this.#cutAll.addEventListener('click', () => {
      void this.#cutAlong(this.#shownNecks.map(({ points }) => points));
    });
    this.#whole.addEventListener('click', () => this.#mend());
    for (const [format, about] of Object.entries(formats)) {
      const words = format.toUpperCase();
      const attributes = { type: 'button', class: 'plain', title: about, 'data-format': format };
      const button = make('button', attributes, words);
      button.addEventListener('click', () => void this.#save(format as CutFormat));
      this.#files.append(button);
    }
    this.#cutting.append(
      this.#chosenWords,
      make('p', { class: 'buttons' }, this.#cutHere, this.#cutAll),
      make('label', { class: 'check' }, this.#cap, ' Close the cuts'),
    );
    this.panel.body.append(
      make(
        'p',
        { class: 'hint' },
        'A neck is narrower than all around it: its ',
        term('loop', 'loop'),
        ' cannot be slipped off without stretching. A handle goes round material, a tunnel round a hole.',
      ),
      make('p', { class: 'working' }, this.#words, this.#cancel, this.#resume),
      this.#neckTitle,
      this.#least.label,
      this.#necks.element,
      this.#handleTitle,
      this.#handles.element,
      this.#cutting,
      this.#cutWords,
      this.#parts,
      this.#files,
      this.#whole,
    );
    this.panel.onToggle((isOpen) => {
      if (isOpen) void this.compute();
      else {
        this.#choose(undefined);
        if (this.#cut) this.#mend();
      }
      this.#drawAll();
      changed();
    });
    viewer.addEventListener('unit', () => this.#refresh());
    this.clear();
  }

  /** Another model. */
  clear(): void {
    this.#running?.abort();
    this.#running = undefined;
    this.#found = undefined;
    this.#chosen = undefined;
    this.#cut = undefined;
    ++this.#cutTurn;
    this.#words.textContent = this.#cutWords.textContent = '';
    this.#resume.hidden = this.#cancel.hidden = true;
    this.#least.discard();
    if (this.#viewer.info) this.#least.show(undefined, this.#viewer.lengthFormat);
    this.#refresh();
  }

  /** The girth is computed: what waits for it goes on. */
  girthIsThere(): void {
    if (this.panel.isOpen) void this.compute();
  }

  /** Searches, once the girth is there. */
  async compute(): Promise<void> {
    const viewer = this.#viewer;
    const { info } = viewer;
    if (!info || this.#found || this.#running) return;
    const running = new AbortController();
    this.#running = running;
    this.#resume.hidden = true;
    const say = (words: string): void => {
      if (this.#running === running) this.#words.textContent = words;
    };
    const watched = (words: string) => ({
      signal: running.signal,
      onProgress: (share: number) => say(`${words} … ${Math.round(100 * share)}\u202f%`),
    });
    try {
      if (viewer.shareOf('igf') < 1) say('Necks follow as soon as the girth is computed …');
      await viewer.fieldOf('igf');
      if (this.#running !== running) return;
      this.#cancel.hidden = false;
      const necks = await viewer.necks(watched('Looking for necks'));
      const handles = await viewer.handles(watched('Looking for handles'));
      if (this.#running !== running) return;
      this.#found = { necks, handles };
      this.#words.textContent = '';
      this.#refresh();
      this.#drawAll();
    } catch (error) {
      if (this.#running !== running) return;
      say(running.signal.aborted ? 'Not searched to the end.' : `${failureWords(error)}.`);
      this.#resume.hidden = false;
    } finally {
      if (this.#running === running) {
        this.#running = undefined;
        this.#cancel.hidden = true;
      }
    }
  }

  get #shownNecks(): Neck[] {
    const least = this.#least.length ?? 0;
    return (this.#found?.necks.necks ?? []).filter(({ prominence }) => prominence >= least);
  }

  #refresh(): void {
    const viewer = this.#viewer;
    const found = this.#found;
    for (const element of [this.#neckTitle, this.#handleTitle, this.#least.label]) {
      element.hidden = !found;
    }
    const necks = this.#shownNecks;
    const handles = found?.handles.handles ?? [];
    this.panel.summary = found ? String(necks.length + handles.length) : '';
    if (viewer.info) this.#least.show(this.#least.length, viewer.lengthFormat);
    if (found) {
      const all = found.necks.necks.length;
      this.#neckTitle.textContent =
        all === 0
          ? 'No neck: no loop is shorter than all around it'
          : necks.length === all
            ? plural(all, 'neck', 'necks')
            : `${necks.length} of ${plural(all, 'neck', 'necks')}`;
      this.#least.label.hidden = all === 0;
      this.#handleTitle.textContent =
        handles.length === 0 ? 'No handle and no tunnel' : this.#handleCount(handles);
    }
    this.#necks.show(necks.map((loop) => this.#row({ kind: 'neck', loop })));
    this.#handles.show(handles.map((loop) => this.#row({ kind: 'handle', loop })));
    this.#cutting.hidden = necks.length + handles.length === 0;
    this.#cutAll.hidden = necks.length < 2;
    this.#cutAll.textContent = `Cut at all ${necks.length} necks`;
    this.#showChosen();
    this.#showParts();
  }

  #handleCount(handles: readonly Handle[]): string {
    const count = (kind: Handle['kind']) => handles.filter((one) => one.kind === kind).length;
    return [
      plural(count('handle'), 'handle', 'handles'),
      plural(count('tunnel'), 'tunnel', 'tunnels'),
      ...(count('unknown') > 0 ? [`${count('unknown')} of one or the other`] : []),
    ].join(', ');
  }

  #row(listed: Listed): PlaceRow {
    const format = this.#viewer.lengthFormat;
    const { loop } = listed;
    let detail: string;
    if (listed.kind === 'handle') detail = handleWords[listed.loop.kind];
    else {
      const { prominence } = listed.loop;
      const out = Number.isFinite(prominence)
        ? `stands out ${formatLength(prominence, format)}`
        : 'the narrowest';
      detail = `${out} · area ${formatArea(loop.area, format)}`;
    }
    return {
      main: formatLength(loop.length, format),
      detail,
      choose: () => this.#choose(listed),
      attend: (isAttended) => this.#draw(isAttended ? listed : this.#chosen),
    };
  }

  /** A loop is the one to cut along; the camera goes there. */
  #choose(listed: Listed | undefined): void {
    this.#chosen = listed;
    if (!listed) {
      this.#necks.select(undefined);
      this.#handles.select(undefined);
    } else (listed.kind === 'neck' ? this.#handles : this.#necks).select(undefined);
    this.#draw(listed);
    this.#showChosen();
    if (listed && this.#viewer.info) this.#viewer.flyTo({ polyline: listed.loop.polyline });
  }

  #showChosen(): void {
    const format = this.#viewer.lengthFormat;
    const chosen = this.#chosen;
    this.#cutHere.disabled = !chosen;
    this.#chosenWords.textContent = '';
    if (!chosen) {
      this.#chosenWords.textContent = 'Choose a loop to cut along it.';
      return;
    }
    const { loop } = chosen;
    const words = [`Chosen: ${formatLength(loop.length, format)} long`];
    if (chosen.kind === 'neck') {
      const { sides, measuresGirth } = chosen.loop;
      if (sides.length === 2) {
        const [one, other] = sides.map(({ area, volume }) =>
          Number.isNaN(volume)
            ? `an area of ${formatArea(area, format)}`
            : `an area of ${formatArea(area, format)}, volume ${formatVolume(volume, format)},`,
        );
        words.push(`it separates ${one} from ${other}`.replace(/,$/, ''));
      } else words.push('it separates nothing');
      if (!measuresGirth) words.push('shorter loops go through some of its points');
    }
    this.#chosenWords.textContent = `${words.join('; ')}.`;
  }

  #draw(listed: Listed | undefined): void {
    if (this.#viewer.info) this.#viewer.showPath(listed?.loop);
  }

  /** All loops of the lists, while the panel is open. */
  #drawAll(): void {
    const viewer = this.#viewer;
    if (!viewer.info) return;
    const handles = this.#found?.handles.handles ?? [];
    viewer.showCurves(
      this.panel.isOpen ? [...this.#shownNecks, ...handles].map(({ polyline }) => polyline) : [],
    );
  }

  async #cutAlong(curves: SurfacePoint[][]): Promise<void> {
    const viewer = this.#viewer;
    const { info } = viewer;
    const turn = ++this.#cutTurn;
    const cap = this.#cap.checked;
    this.#cutWords.textContent = 'Cutting …';
    try {
      const { parts } = await viewer.cut(curves, { cap });
      if (turn !== this.#cutTurn || viewer.info !== info) return;
      this.#cut = { curves, cap, parts };
      this.#cutWords.textContent =
        parts.length === 1
          ? 'Cut, and still one part: the loop separates nothing.'
          : `Cut into ${parts.length} parts.`;
      this.#colour();
    } catch (error) {
      if (turn !== this.#cutTurn || viewer.info !== info) return;
      this.#cutWords.textContent = `Not cut: ${failureWords(error)}.`;
    }
    this.#showParts();
  }

  /** The surface is shown as it was before. */
  #mend(): void {
    ++this.#cutTurn;
    this.#cut = undefined;
    this.#cutWords.textContent = '';
    if (this.#viewer.info) this.#viewer.showPlaces(undefined);
    this.#showParts();
  }

  #showParts(): void {
    const format = this.#viewer.lengthFormat;
    const parts = this.#cut?.parts ?? [];
    this.#parts.hidden = this.#files.hidden = this.#whole.hidden = parts.length === 0;
    this.#parts.replaceChildren(
      ...parts.map(({ area, volume, genus }, i) => {
        const swatch = make('em', { class: 'swatch' });
        swatch.style.background = partColours[Math.min(i, partColours.length - 1)]!;
        const words = [
          `area ${formatArea(area, format)}`,
          Number.isNaN(volume) ? 'open' : `volume ${formatVolume(volume, format)}`,
          ...(genus > 0 ? [plural(genus, 'handle', 'handles')] : []),
        ];
        return make('li', {}, swatch, make('b', {}, `part ${i + 1}`), ` ${words.join(' · ')}`);
      }),
    );
  }

  /** Each vertex has the colour of the part that its faces are in. */
  #colour(): void {
    const viewer = this.#viewer;
    const { parts } = this.#cut!;
    const kinds = new Uint8Array(viewer.info!.vertexCount);
    parts.forEach(({ vertices }, part) => {
      const kind = Math.min(part, partColours.length - 1);
      for (const vertex of vertices) if (vertex < kinds.length) kinds[vertex] = kind;
    });
    const count = Math.min(parts.length, partColours.length);
    const isRest = (i: number): boolean =>
      i === partColours.length - 1 && parts.length > partColours.length;
    viewer.showPlaces({
      title: 'Parts of the cut',
      kinds,
      categories: partColours.slice(0, count).map((colour, i) => ({
        name: isRest(i) ? 'all others' : `part ${i + 1}`,
        colour,
        hatched: false,
      })),
    });
  }

  async #save(format: CutFormat): Promise<void> {
    const viewer = this.#viewer;
    const cut = this.#cut;
    if (!cut) return;
    try {
      const files = await viewer.exportCut(cut.curves, format, { cap: cut.cap });
      const stem = `${stemOf(viewer.info?.name ?? 'model')}-parts`;
      await saveFiles(
        files.map((content) => ({ content })),
        stem,
        format,
      );
    } catch (error) {
      this.#cutWords.textContent = `That could not be written: ${failureWords(error)}.`;
    }
  }
}
