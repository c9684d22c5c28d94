// Rivals of the tips: other ways to find where a shape ends, as in the paper's Figure 13.

import { type GirthViewer, fieldTitle, formatLength, make } from '../../../src/element/index.js';
import type { Maximum } from '../../../src/kernel/index.js';
import { Draft } from '../../widgets/draft.js';
import { failureWords } from '../../widgets/failure-words.js';
import { plural } from '../../model/model-words.js';
import { PlaceList } from '../../widgets/place-list.js';
import { Resource } from '../../results/resource.js';
import { plainNumber } from '../../widgets/table-text.js';

/** `sdf` colours the surface; the others are points. */
const rivals = [
  ['', 'nothing'],
  ['heat', 'heat maxima'],
  ['geoaverage', 'GeoAverage'],
  ['sdf', 'shape diameter'],
] as const;
type Rival = (typeof rivals)[number][0];
const most = 50;

/** A maximum or a minimum, and where it stands among all of both kinds. */
interface Extremum extends Maximum {
  isMinimum: boolean;
}

export interface RivalsPage {
  /** Colours the surface by shape diameter, or as before. */
  colour(bySdf: boolean): void;
}

export class TipRivals {
  readonly element = make('div', { class: 'rivals' });
  readonly #choice = make('select', { id: 'rival' });
  readonly #count = make('input', {
    id: 'rival-count',
    type: 'number',
    min: '1',
    max: String(most),
  });
  readonly #choiceDraft: Draft;
  readonly #countDraft: Draft;
  readonly #countLine: HTMLElement;
  readonly #words = make('p', { class: 'hint', role: 'status' });
  readonly #list = new PlaceList('Points beside the tips');
  readonly #extrema: Resource<Extremum[]>;
  /** Whether the surface is coloured by shape diameter for this comparison. */
  #isColoured = false;
  readonly #viewer: GirthViewer;
  readonly #page: RivalsPage;

  constructor(viewer: GirthViewer, page: RivalsPage) {
    this.#viewer = viewer;
    this.#page = page;
    const [choice, count] = [this.#choice, this.#count];
    choice.append(...rivals.map(([value, words]) => make('option', { value }, words)));
    this.#choiceDraft = new Draft(choice, { committed: () => this.#choose() });
    this.#extrema = new Resource<Extremum[]>({
      find: () => this.#find(),
      changed: () => this.#draw(),
    });
    this.#countDraft = new Draft(count, {
      edited: () => this.#draw(),
      ended: () => this.#draw(),
    });
    this.#countLine = make(
      'p',
      { class: 'length' },
      make('label', { for: 'rival-count' }, 'Points shown, most persistent first'),
      count,
    );
    this.element.append(
      make('div', { class: 'row' }, make('label', { for: 'rival' }, 'Compare with'), choice),
      this.#words,
      this.#countLine,
      this.#list.element,
    );
    this.clear(0);
  }

  /** Another model, or the panel is closed; `tips`: so many points are as many as the tips. */
  clear(tips: number): void {
    this.#extrema.drop();
    this.#colour(false);
    this.#choiceDraft.discard();
    this.#choiceDraft.show('');
    this.#countDraft.discard();
    this.expect(tips);
    this.#draw();
  }

  /** Begins with as many points as there are tips. */
  expect(tips: number): void {
    this.#countDraft.show(String(Math.min(most, Math.max(1, tips))));
  }

  #colour(bySdf: boolean): void {
    if (bySdf === this.#isColoured) return;
    this.#isColoured = bySdf;
    this.#page.colour(bySdf);
  }

  get #rival(): Rival {
    return this.#choiceDraft.text as Rival;
  }

  #choose(): void {
    const rival = this.#rival;
    this.#extrema.drop();
    this.#draw();
    this.#colour(rival === 'sdf');
    if (rival !== '' && rival !== 'sdf') this.#extrema.want([this.#viewer.info, rival]);
  }

  async #find(): Promise<Extremum[]> {
    const viewer = this.#viewer;
    const extrema =
      this.#rival === 'geoaverage'
        ? [
            ...ofKind(await viewer.maxima('geoaverage'), false),
            ...ofKind(await viewer.maxima('geoaverage', { minima: true }), true),
          ]
        : ofKind(await viewer.heatMaxima(), false);
    return extrema.sort((a, b) => b.persistence - a.persistence);
  }

  get #said(): string {
    const { status } = this.#extrema;
    if (status.is === 'pending') return 'Computing the points …';
    if (status.is === 'failed') return `Not found: ${failureWords(status.error)}.`;
    return status.is === 'done' ? inAll(status.found) : '';
  }

  #draw(): void {
    const [{ found }, viewer] = [this.#extrema, this.#viewer];
    const wanted = Math.min(most, Math.max(0, Math.floor(Number(this.#countDraft.text)) || 0));
    const shown = found?.slice(0, wanted) ?? [];
    if (viewer.info) viewer.showPoints(shown.map(({ vertex }) => vertex));
    this.#countLine.hidden = !found;
    this.#words.textContent = this.#said;
    const words = ({ persistence }: Maximum): string =>
      this.#rival === 'geoaverage'
        ? formatLength(persistence, viewer.formatOf('geoaverage'))
        : plainNumber(persistence, 3);
    this.#list.show(
      shown.map((maximum) => ({
        main: `persistence ${words(maximum)}`,
        detail: `${maximum.isMinimum ? 'minimum' : 'maximum'} at vertex ${maximum.vertex}`,
        choose: () => viewer.flyTo({ vertex: maximum.vertex }),
      })),
    );
    this.#list.element.setAttribute(
      'aria-label',
      this.#rival === 'geoaverage' ? `Extrema: ${fieldTitle('geoaverage')}` : 'Heat maxima',
    );
  }
}

const ofKind = (maxima: readonly Maximum[], isMinimum: boolean): Extremum[] =>
  maxima.map((maximum) => ({ ...maximum, isMinimum }));

function inAll(extrema: readonly Extremum[]): string {
  const minima = extrema.filter(({ isMinimum }) => isMinimum).length;
  const counts = [plural(extrema.length - minima, 'maximum', 'maxima')];
  if (minima > 0) counts.push(plural(minima, 'minimum', 'minima'));
  return `${counts.join(' and ')} in all, as diamonds on the surface.`;
}
