// The parts of a surface that was cut: as a list, as colours and as files.

import { type GirthViewer, make } from '../../../src/element/index.js';
import type { Cut, CutFormat, SurfacePoint, Tips } from '../../../src/kernel/index.js';
import { formatArea, formatVolume } from '../../widgets/area-words.js';
import { failureWords } from '../../widgets/failure-words.js';
import { plural } from '../../model/model-words.js';
import { colourParts, partColours } from './part-colours.js';
import { PlaceList } from '../../widgets/place-list.js';
import { stemOf } from '../../export/save-file.js';
import { saveFiles } from '../../export/zip-files.js';

const formats: Record<CutFormat, string> = {
  glb: 'one file, a node for each part',
  obj: 'one file, an object for each part',
  stl: 'a file for each part',
  ply: 'a file for each part, with the colours and values that the model’s file has',
  csv: 'the part of each face of the model’s file',
  json: 'what they measure',
};

/** More parts than these of one colour are not named in the legend. */
const mostNamed = 4;

/** A cut as it is shown. */
interface ShownCut {
  curves: SurfacePoint[][];
  cap: boolean;
  parts: Cut['parts'];
  /** For each part the number of its colour. */
  colours: number[];
  /** For each part the number of its tips. */
  tips: number[];
}

/** How many tips each part has: where their apexes are. */
function tipsIn(parts: Cut['parts'], { tips }: Tips): number[] {
  const apexes = new Set(tips.map(({ apex }) => apex));
  return parts.map(({ vertices }) => vertices.filter((vertex) => apexes.has(vertex)).length);
}

/** The curves that a surface is cut along. */
export interface CutCurves {
  /** Curves by rank: where two cross, the earlier one counts. */
  curves: SurfacePoint[][];
  /** The word for several of the curves; it decides what is said of one that is passed over. */
  are: 'necks' | 'loops';
}

const passing: Record<CutCurves['are'], string> = {
  necks: 'a more prominent one',
  loops: 'an earlier pinned one',
};

/** A sentence on the cut, where `used` of `wanted` loops were cut along. */
function cutWords(parts: number, wanted: number, used: number, are: CutCurves['are']): string {
  const crossing = wanted - used;
  const said =
    parts > 1
      ? `Cut into ${parts} parts.`
      : wanted === 1
        ? 'Cut, and still one part: the loop separates nothing.'
        : 'Cut, and still one part: the loops separate nothing.';
  if (crossing === 0) return said;
  const passed = crossing === 1 ? 'is passed over: it crosses' : 'are passed over: they cross';
  return `${said} ${crossing} of the ${wanted} ${are} ${passed} ${passing[are]}.`;
}

export class CutParts {
  readonly element: HTMLElement;
  readonly #words = make('p', { class: 'hint', role: 'status' });
  readonly #list = new PlaceList('Parts of the cut');
  readonly #files = make('p', { class: 'buttons' });
  readonly #whole = make('button', { type: 'button', class: 'plain' }, 'Show it whole');
  #cut: ShownCut | undefined;
  /** Counts up with each cut: only the last one counts. */
  #turn = 0;
  readonly #viewer: GirthViewer;
  readonly #changed: () => void;

  /** `changed`: the surface is shown cut, or whole again. */
  constructor(viewer: GirthViewer, changed: () => void) {
    this.#viewer = viewer;
    this.#changed = changed;
    this.#whole.addEventListener('click', () => this.mend());
    for (const [format, about] of Object.entries(formats)) {
      const words = format.toUpperCase();
      const attributes = { type: 'button', class: 'plain', title: about, 'data-format': format };
      const button = make('button', attributes, words);
      button.addEventListener('click', () => void this.#save(format as CutFormat));
      this.#files.append(button);
    }
    this.element = make(
      'div',
      {},
      this.#words,
      this.#list.element,
      this.#files,
      make('p', { class: 'buttons' }, this.#whole),
    );
    this.refresh();
  }

  /** Whether the surface is shown cut. */
  get isShown(): boolean {
    return this.#cut !== undefined;
  }

  /** Another model. */
  clear(): void {
    ++this.#turn;
    this.#cut = undefined;
    this.#words.textContent = '';
    this.refresh();
  }

  /** The surface is shown as it was before. */
  mend(): void {
    const wasShown = this.isShown;
    this.clear();
    if (!wasShown) return;
    if (this.#viewer.info) this.#viewer.showPlaces(undefined);
    this.#changed();
  }

  /** Shows the surface cut along curves as soon as they are found. */
  async show(found: CutCurves | Promise<CutCurves>, cap: boolean): Promise<void> {
    const viewer = this.#viewer;
    const { info } = viewer;
    const turn = ++this.#turn;
    const isPast = (): boolean => turn !== this.#turn || viewer.info !== info;
    this.#words.textContent = 'Cutting …';
    try {
      const { curves, are } = await found;
      if (isPast()) return;
      if (curves.length === 0) {
        this.mend();
        this.#words.textContent = 'Not cut: the girth never has this value.';
        this.#changed();
        return;
      }
      const { cutUncrossed } = await import('./uncrossed-cut.js');
      const cutAlong = (some: SurfacePoint[][]): Promise<Cut> => viewer.cut(some, { cap });
      const [{ cut, used }, tips] = await Promise.all([
        cutUncrossed(curves, cutAlong),
        viewer.tips(),
      ]);
      if (isPast()) return;
      const { parts } = cut;
      this.#cut = {
        curves: used.map((i) => curves[i]!),
        ...{ cap, parts, colours: colourParts(parts), tips: tipsIn(parts, tips) },
      };
      this.#words.textContent = cutWords(parts.length, curves.length, used.length, are);
      this.#colour();
      this.#changed();
    } catch (error) {
      if (isPast()) return;
      this.#words.textContent = `Not cut: ${failureWords(error)}.`;
    }
    this.refresh();
  }

  /** Words and numbers in the present unit. */
  refresh(): void {
    const format = this.#viewer.lengthFormat;
    const { parts = [], colours = [], tips = [] } = this.#cut ?? {};
    this.#files.hidden = this.#whole.hidden = parts.length === 0;
    this.#list.show(
      parts.map(({ area, volume, genus, vertices }, i) => ({
        colour: partColours[colours[i]!]!,
        main: `area ${formatArea(area, format)}`,
        detail: [
          Number.isNaN(volume) ? 'open' : `volume ${formatVolume(volume, format)}`,
          ...(tips[i]! > 0 ? [plural(tips[i]!, 'tip', 'tips')] : []),
          ...(genus > 0 ? [plural(genus, 'handle', 'handles')] : []),
        ].join(' · '),
        choose: () => this.#viewer.flyTo({ vertices: this.#present(vertices) }),
      })),
    );
  }

  /** The vertices of a part that the whole surface has, too. */
  #present(vertices: Uint32Array): Uint32Array {
    const { vertexCount } = this.#viewer.info!;
    return vertices.filter((vertex) => vertex < vertexCount);
  }

  /** Each vertex has the colour of the part that its faces are in. */
  #colour(): void {
    const { parts, colours } = this.#cut!;
    const kinds = new Uint8Array(this.#viewer.info!.vertexCount);
    parts.forEach(({ vertices }, part) => {
      for (const vertex of this.#present(vertices)) kinds[vertex] = colours[part]!;
    });
    const named = partColours.map((colour, kind) => {
      const numbers = colours.flatMap((one, part) => (one === kind ? [part + 1] : []));
      const list = numbers.slice(0, mostNamed).join(', ');
      const more = numbers.length > mostNamed ? ', …' : '';
      const name = `part${numbers.length > 1 ? 's' : ''} ${list}${more}`;
      return { name, colour, hatched: false, isUsed: numbers.length > 0 };
    });
    this.#viewer.showPlaces({
      title: 'Parts of the cut',
      kinds,
      categories: named.filter(({ isUsed }) => isUsed),
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
      this.#words.textContent = `That could not be written: ${failureWords(error)}.`;
    }
  }
}
