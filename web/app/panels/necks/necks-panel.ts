// Necks, bottlenecks, handles and tunnels: their loops as lists and on the surface, and the surface cut along them.

import {
  type GirthViewer,
  type ViewerState,
  formatLength,
  make,
} from '../../../src/element/index.js';
import type {
  Bottleneck,
  Handle,
  HandleRemoval,
  Handles,
  Loop,
  Neck,
  Necks,
  SurfacePoint,
} from '../../../src/kernel/index.js';
import { type CutWish, type PageState, cutAt, girthOfCut } from '../../state/address-state.js';
import { formatArea, formatVolume } from '../../widgets/area-words.js';
import { type CutCurves, CutParts } from './cut-parts.js';
import { HandleRemovalForm } from './handle-removal.js';
import { LengthInput } from '../../widgets/length-input.js';
import { plural } from '../../model/model-words.js';
import type { PagePlot } from '../../export/page-plot.js';
import { Panel } from '../../widgets/panel.js';
import { PanelSearch } from '../../widgets/panel-search.js';
import { PlaceList, type PlaceRow } from '../../widgets/place-list.js';
import { shareWords } from '../../widgets/share-beside.js';
import { term } from '../../help/term.js';
import type { Store } from '../../state/store.js';
import { TwoPoints } from './two-points.js';

const handleWords = { handle: 'handle', tunnel: 'tunnel', unknown: 'handle or tunnel' } as const;

/** How finely prominence is known, as a share of a neck's length (`necks.h`): less may be the triangles' doing. */
const knownShare = 0.01;

/** A loop that is listed, or was found between two points. */
type Listed =
  | { kind: 'neck'; loop: Neck }
  | { kind: 'handle'; loop: Handle }
  | { kind: 'bottleneck'; loop: Bottleneck };

const lengthOf = (listed: Listed): number =>
  listed.kind === 'bottleneck' ? listed.loop.girth : listed.loop.length;

export class NecksPanel {
  readonly panel = new Panel('necks-panel');
  readonly #search: PanelSearch<{ necks: Necks; handles: Handles }>;
  readonly #least: LengthInput;
  readonly #leastWords = make('p', { class: 'hint' });
  readonly #neckTitle = make('h3');
  readonly #necks = new PlaceList('Necks');
  readonly #handleTitle = make('h3');
  readonly #handles = new PlaceList('Handles and tunnels');
  readonly #removal: HandleRemovalForm;
  readonly #between: TwoPoints;
  readonly #chosenWords = make('p', { class: 'hint' });
  readonly #cap = make('input', { id: 'cut-cap', type: 'checkbox' });
  readonly #cutHere = make('button', { type: 'button', class: 'plain' }, 'Cut here');
  readonly #cutAll = make('button', { type: 'button', class: 'plain' });
  readonly #cutPinned = make('button', { type: 'button', class: 'plain' });
  readonly #girth: LengthInput;
  readonly #girthForm = make('form', { class: 'length-form' });
  readonly #girthWords = make('p', { class: 'hint' });
  readonly #cutting = make('div', { class: 'cutting' });
  readonly #parts: CutParts;
  readonly #oneSided = make('p', { class: 'hint' });
  #chosen: Listed | undefined;
  /** Along what the surface is shown cut, or will be as soon as that is found. */
  #cut: CutWish | undefined;
  /** The panel is being brought to what the state says. */
  #isFollowing = false;
  readonly #viewer: GirthViewer;
  readonly #store: Store;

  /** `removeHandles` shows the surface without its handles and tunnels that are shorter than a length, in model units. */
  constructor(
    viewer: GirthViewer,
    store: Store,
    removeHandles: (length: number) => Promise<HandleRemoval | undefined>,
  ) {
    this.#viewer = viewer;
    this.#store = store;
    this.#search = new PanelSearch(viewer, {
      again: 'Search',
      pending: 'Necks follow as soon as the girth is computed …',
      parameters: () => [store.shown.persistence, store.shown.method],
      stopped: 'Not searched to the end.',
      failed: '',
      search: async (watch) => ({
        necks: await viewer.necks(watch('Looking for necks')),
        handles: await viewer.handles(watch('Looking for handles')),
      }),
      found: () => {
        this.#refresh();
        this.#drawAll();
        this.#cutAsWished();
        return '';
      },
    });
    this.#removal = new HandleRemovalForm(viewer, removeHandles);
    this.#between = new TwoPoints(viewer, {
      chosen: (loop, byHand) => {
        this.#choose({ kind: 'bottleneck', loop }, byHand);
        this.#cutAsWished();
      },
      attended: (loop) => this.#draw(loop ? { kind: 'bottleneck', loop } : this.#chosen),
      changed: () => {
        if (this.#chosen?.kind === 'bottleneck') this.#choose(undefined);
        else this.#draw(this.#chosen);
      },
      asked: () => this.#keep(),
    });
    this.#least = new LengthInput('neck-prominence', 'Prominence from', {
      changed: () => {
        this.#choose(undefined);
        this.#refresh();
        this.#drawAll();
        // The segments follow what they are cut at.
        if (this.#cut === 'necks' && this.#shownNecks.length > 0) this.#cutAlong('necks');
        else if (this.#cut === 'necks') this.#parts.mend();
        this.#keep();
      },
      wrong: (why) => this.#search.say(`${why}.`),
    });
    this.#cap.checked = true;
    this.#parts = new CutParts(viewer, () => {
      if (!this.#parts.isShown) this.#cut = undefined;
      this.#keep();
    });
    this.#cutHere.addEventListener('click', () => {
      if (this.#chosen) this.#cutAlong(this.#nameOf(this.#chosen));
    });
    this.#cutAll.addEventListener('click', () => this.#cutAlong('necks'));
    this.#cutPinned.addEventListener('click', () => this.#cutAlong('pin'));
    this.#girth = new LengthInput('cut-girth', 'Cut at a girth of', {
      changed: () => (this.#girthWords.textContent = ''),
      wrong: (why) => (this.#girthWords.textContent = `${why}.`),
    });
    this.#girthForm.append(
      this.#girth.label,
      make('button', { type: 'submit', class: 'plain' }, 'Cut at this girth'),
    );
    this.#girthForm.addEventListener('submit', (event) => {
      event.preventDefault();
      if (!this.#girth.commit()) return;
      const { length } = this.#girth;
      if (length !== undefined && length > 0) this.#cutAlong(cutAt(length));
      else this.#girthWords.textContent = 'Type a length: the cut runs where the girth has it.';
    });
    viewer.addEventListener('pick', (event) => {
      const { action } = event.detail;
      if (action === 'pin' || action === 'unpin') this.#pinsChanged();
    });
    this.#cutting.append(
      make('h3', {}, 'Cut'),
      this.#chosenWords,
      make('p', { class: 'buttons' }, this.#cutHere, this.#cutAll, this.#cutPinned),
      this.#girthForm,
      this.#girthWords,
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
      this.#oneSided,
      this.#search.element,
      this.#neckTitle,
      this.#least.label,
      this.#leastWords,
      this.#necks.element,
      this.#handleTitle,
      this.#handles.element,
      this.#removal.element,
      this.#between.element,
      this.#cutting,
      this.#parts.element,
    );
    this.panel.onToggle((isOpen) => {
      if (isOpen) {
        this.#search.start();
        this.#between.answer();
        this.#cutAsWished();
      } else {
        this.#between.stop();
        this.#choose(undefined);
        this.#parts.mend();
        this.#cut = undefined;
      }
      this.#between.mark(isOpen);
      this.#draw(this.#chosen);
      this.#drawAll();
      this.#keep();
    });
    store.watch(['persistence', 'method'], () => {
      // Another girth has other necks.
      if (this.#search.found && !this.#search.isCurrent) this.#forget();
      if (this.panel.isOpen) this.#search.start();
    });
    store.watch(['bottleneck', 'profile', 'prominence', 'cut', 'rims'], (state) => {
      this.#isFollowing = true;
      this.#follow(state);
      this.#isFollowing = false;
    });
    viewer.addEventListener('unit', () => this.#refresh());
    this.clear();
  }

  get plots(): PagePlot[] {
    return this.#between.plots;
  }

  /** The listed necks and handles, and the bottleneck; each is missing until it is found. */
  get listed(): { necks?: Necks; handles?: Handles; bottleneck?: Bottleneck } {
    const { found } = this.#search;
    const { bottleneck } = this.#between;
    return {
      ...(found && { necks: { ...found.necks, necks: this.#shownNecks }, handles: found.handles }),
      ...(bottleneck && { bottleneck }),
    };
  }

  /** Puts into the state what is shown by hand now. */
  #keep(): void {
    if (this.#isFollowing) return;
    this.#store.choose({
      ...{ bottleneck: undefined, profile: undefined, ...this.#between.asked },
      prominence: this.#least.length,
      cut: this.#cut,
      rims: this.#cut !== undefined && !this.#cap.checked,
    });
  }

  /** The question between points as attributes of an element. */
  get attributes(): ViewerState {
    return this.#between.attributes;
  }

  /** Shows what the state asks for. */
  #follow(state: PageState): void {
    const { prominence, cut, rims } = state;
    const viewer = this.#viewer;
    const isAnotherCut = cut !== this.#cut || prominence !== this.#least.length;
    if (viewer.info && prominence !== this.#least.length) {
      this.#least.discard();
      this.#least.show(prominence, viewer.lengthFormat);
      this.#choose(undefined);
      this.#refresh();
      this.#drawAll();
    }
    if (cut) this.#cap.checked = rims !== true;
    const girth = girthOfCut(cut);
    if (viewer.info && girth !== undefined) {
      this.#girth.discard();
      this.#girth.show(girth, viewer.lengthFormat);
    }
    if (isAnotherCut) {
      if (this.#parts.isShown) this.#parts.mend();
      this.#cut = cut;
    }
    this.#between.apply(state, this.panel.isOpen);
    if (isAnotherCut) this.#cutAsWished();
  }

  /** Another model. */
  clear(): void {
    this.#forget();
    this.#cut = undefined;
    this.#between.clear();
    this.#removal.clear();
    this.#girthWords.textContent = '';
    for (const input of [this.#least, this.#girth]) {
      input.discard();
      if (this.#viewer.info) input.show(undefined, this.#viewer.lengthFormat);
    }
    this.#refresh();
  }

  /** Another girth is to be searched anew; what is between two points is about the girth itself, and stays. */
  #forget(): void {
    this.#search.clear();
    this.#chosen = undefined;
    if (this.#parts.isShown) this.#cut = undefined;
    this.#parts.clear();
    this.#between.select(false);
    this.#refresh();
  }

  /** The girth is computed: what waits for it goes on. */
  girthIsThere(): void {
    if (this.panel.isOpen) this.#search.start();
    this.#between.girthIsThere();
  }

  get #shownNecks(): Neck[] {
    const least = this.#least.length;
    return (this.#search.found?.necks.necks ?? []).filter(
      ({ prominence, length }) => prominence >= (least ?? knownShare * length),
    );
  }

  #refresh(): void {
    const viewer = this.#viewer;
    const { found } = this.#search;
    this.#leastWords.textContent = '';
    for (const element of [this.#neckTitle, this.#handleTitle, this.#least.label]) {
      element.hidden = !found;
    }
    const necks = this.#shownNecks;
    const handles = found?.handles.handles ?? [];
    this.panel.summary = found ? String(necks.length + handles.length) : '';
    const cutEdges = viewer.info?.report.oneSidedEdges ?? 0;
    this.#oneSided.textContent =
      cutEdges > 0
        ? `The surface has one side only and was cut along ${plural(cutEdges, 'edge', 'edges')}, which no loop or path crosses.`
        : '';
    this.#oneSided.hidden = cutEdges === 0;
    for (const input of [this.#least, this.#girth]) {
      if (viewer.info) input.show(input.length, viewer.lengthFormat);
    }
    if (found) {
      const all = found.necks.necks.length;
      this.#neckTitle.textContent =
        all === 0
          ? 'No neck: no loop is shorter than all around it'
          : necks.length === all
            ? plural(all, 'neck', 'necks')
            : `${necks.length} of ${plural(all, 'neck', 'necks')}`;
      this.#least.label.hidden = all === 0;
      this.#leastWords.textContent =
        all > necks.length && this.#least.length === undefined
          ? 'Empty: a hundredth of the length, since triangles may cause less. 0 lists all.'
          : '';
      this.#handleTitle.textContent =
        handles.length === 0 ? 'No handle and no tunnel' : this.#handleCount(handles);
    }
    this.#necks.show(necks.map((loop) => this.#row({ kind: 'neck', loop })));
    this.#handles.show(handles.map((loop) => this.#row({ kind: 'handle', loop })));
    this.#removal.show(handles);
    this.#between.refresh();
    this.#cutAll.hidden = necks.length < 2;
    this.#cutAll.textContent = `Cut at ${necks.length} necks`;
    this.#showChosen();
    this.#parts.refresh();
  }

  #handleCount(handles: readonly Handle[]): string {
    const count = (kind: Handle['kind']) => handles.filter((one) => one.kind === kind).length;
    return [
      plural(count('handle'), 'handle', 'handles'),
      plural(count('tunnel'), 'tunnel', 'tunnels'),
      ...(count('unknown') > 0 ? [`${count('unknown')} of one or the other`] : []),
    ].join(', ');
  }

  #row(listed: Exclude<Listed, { kind: 'bottleneck' }>): PlaceRow {
    const format = this.#viewer.lengthFormat;
    const { loop } = listed;
    let detail: string;
    if (listed.kind === 'handle') detail = handleWords[listed.loop.kind];
    else {
      const { prominence } = listed.loop;
      const beside = loop.length + prominence;
      const out = Number.isFinite(prominence)
        ? `prominence ${formatLength(prominence, format)}, ${shareWords(loop.length / beside)}`
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

  /** A loop is the one to cut along; the camera goes there, unless it was not asked for by hand. */
  #choose(listed: Listed | undefined, byHand = true): void {
    this.#chosen = listed;
    if (listed?.kind !== 'neck') this.#necks.select(undefined);
    if (listed?.kind !== 'handle') this.#handles.select(undefined);
    this.#between.select(listed?.kind === 'bottleneck');
    this.#draw(listed);
    this.#showChosen();
    const { polyline } = listed?.loop ?? {};
    if (byHand && polyline && polyline.length > 0 && this.#viewer.info) {
      this.#viewer.flyTo({ polyline });
    }
  }

  get #hasHandles(): boolean {
    return (this.#search.found?.handles.handles.length ?? 0) > 0;
  }

  #showChosen(): void {
    const format = this.#viewer.lengthFormat;
    const chosen = this.#chosen;
    const isCurve = (chosen?.loop.points.length ?? 0) > 0;
    const isAny = chosen !== undefined || this.#shownNecks.length > 0 || this.#hasHandles;
    this.#cutting.hidden = !this.#viewer.info;
    this.#cutHere.hidden = !isAny;
    this.#cutHere.disabled = !isCurve;
    const pinned = this.#pinnedLoops.length;
    this.#cutPinned.disabled = pinned === 0;
    this.#cutPinned.textContent =
      pinned > 1 ? `Cut along the ${pinned} pinned loops` : 'Cut along the pinned loop';
    if (!chosen) {
      this.#chosenWords.textContent = isAny
        ? 'Choose a loop to cut along it, or pin one.'
        : 'Pin a loop to cut along it.';
      return;
    }
    const words = [`Chosen: ${formatLength(lengthOf(chosen), format)} long`];
    if (chosen.kind === 'neck' || (chosen.kind === 'bottleneck' && chosen.loop.kind === 'neck')) {
      const { sides } = chosen.loop;
      if (sides.length === 2) {
        const [one, other] = sides.map(({ area, volume }) =>
          Number.isNaN(volume)
            ? `an area of ${formatArea(area, format)}`
            : `an area of ${formatArea(area, format)}, volume ${formatVolume(volume, format)},`,
        );
        words.push(`it separates ${one} from ${other}`.replace(/,$/, ''));
      } else words.push('it separates nothing');
      if (chosen.kind === 'neck' && !chosen.loop.measuresGirth)
        words.push('shorter loops go through some of its points');
    }
    if (chosen.kind === 'handle' && chosen.loop.mayBeShorterBy > 0) {
      const most = formatLength(chosen.loop.mayBeShorterBy, format);
      words.push(`another one may be shorter, by at most ${most}`);
    }
    this.#chosenWords.textContent = `${words.join('; ')}.`;
  }

  #draw(listed: Listed | undefined): void {
    if (!this.#viewer.info) return;
    this.#viewer.showPath(this.panel.isOpen ? (listed?.loop ?? this.#between.path) : undefined);
  }

  /** All loops of the lists, while the panel is open. */
  #drawAll(): void {
    const viewer = this.#viewer;
    if (!viewer.info) return;
    const handles = this.#search.found?.handles.handles ?? [];
    viewer.showCurves(
      this.panel.isOpen ? [...this.#shownNecks, ...handles].map(({ polyline }) => polyline) : [],
    );
  }

  /** How links name a loop. */
  #nameOf({ kind, loop }: Listed): CutWish {
    if (kind === 'bottleneck') return kind;
    const { necks, handles } = this.#search.found!;
    const all: readonly object[] = kind === 'neck' ? necks.necks : handles.handles;
    return `${kind}:${1 + all.indexOf(loop)}`;
  }

  /** The pinned loops that go round. */
  get #pinnedLoops(): Loop[] {
    const { info, pinned } = this.#viewer;
    return info ? pinned.map(({ loop }) => loop).filter(({ kind }) => kind === 'loop') : [];
  }

  /** A loop was pinned or let go: a cut along what is pinned follows. */
  #pinsChanged(): void {
    this.#showChosen();
    if (this.#cut !== 'pin') return;
    if (this.#pinnedLoops.length > 0) this.#cutAlong('pin');
    else {
      this.#parts.mend();
      this.#cut = undefined;
    }
  }

  /** The curves to cut along; undefined where they are absent, or not found yet. */
  #curvesOf(wish: CutWish): CutCurves | Promise<CutCurves> | undefined {
    const girth = girthOfCut(wish);
    if (girth !== undefined) return this.#level(girth);
    if (wish === 'pin') return this.#pinnedLoops.length > 0 ? this.#pinnedCurves() : undefined;
    const loops = this.#loopsOf(wish);
    return loops.length > 0
      ? { curves: loops.map(({ loop }) => loop.points), are: 'necks' }
      : undefined;
  }

  async #level(girth: number): Promise<CutCurves> {
    const curves = await this.#viewer.levelCurves(girth);
    return { curves: curves.map(({ points }) => points), are: 'loops' };
  }

  /** Loops that a project was opened with have no points. */
  async #pinnedCurves(): Promise<CutCurves> {
    const curves = this.#pinnedLoops.map(async ({ points, base }): Promise<SurfacePoint[]> => {
      return points.length > 0 ? points : (await this.#viewer.loop(base)).points;
    });
    return { curves: await Promise.all(curves), are: 'loops' };
  }

  /** The loops of lists that are meant, most prominent first; none where they are not there, or not yet. */
  #loopsOf(wish: CutWish): readonly Listed[] {
    if (wish === 'bottleneck') return this.#chosen?.kind === wish ? [this.#chosen] : [];
    if (wish === 'necks') return this.#shownNecks.map((loop) => ({ kind: 'neck', loop }));
    const { necks, handles } = this.#search.found ?? {};
    const [kind, number] = wish.split(':') as [string, string];
    const at = Number(number) - 1;
    const [neck, handle] = [necks?.necks[at], handles?.handles[at]];
    if (kind === 'neck') return neck ? [{ kind, loop: neck }] : [];
    return kind === 'handle' && handle ? [{ kind, loop: handle }] : [];
  }

  /** Shows the surface cut: at all necks that are listed these are the segments of the body. */
  #cutAlong(wish: CutWish): void {
    const curves = this.#curvesOf(wish);
    if (!curves) return;
    this.#cut = wish;
    void this.#parts.show(curves, this.#cap.checked);
  }

  /** Cuts as a link asks, as soon as what it names is there. */
  #cutAsWished(): void {
    const wish = this.#cut;
    if (!wish || !this.panel.isOpen || this.#parts.isShown) return;
    const [loop] = this.#loopsOf(wish);
    if (loop && wish !== 'necks') {
      this.#choose(loop, false);
      if (loop.kind === 'handle') this.#handles.select(Number(wish.split(':')[1]) - 1);
      if (loop.kind === 'neck') this.#necks.select(this.#shownNecks.indexOf(loop.loop));
    }
    this.#cutAlong(wish);
  }
}
