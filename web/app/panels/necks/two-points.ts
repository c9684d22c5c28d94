// Between two points of the surface: the narrowest place that no way avoids, and the girth along the shortest path, or
// along one that is drawn.

import {
  type GirthViewer,
  type ViewerState,
  formatLength,
  make,
  mostPathPoints,
  writePath,
} from '../../../src/element/index.js';
import type { Bottleneck, Profile, SurfacePoint } from '../../../src/kernel/index.js';
import type { PageState } from '../../state/address-state.js';
import { AlongPlot } from '../../widgets/along-plot.js';
import { formatArea } from '../../widgets/area-words.js';
import { failureWords } from '../../widgets/failure-words.js';
import type { PagePlot } from '../../export/page-plot.js';
import { PanelSearch } from '../../widgets/panel-search.js';
import { PathDrawing } from './path-drawing.js';
import { PlaceList } from '../../widgets/place-list.js';
import { stemOf } from '../../export/save-file.js';
import { SurfaceHint } from '../../widgets/surface-hint.js';
import { type Table, columnOf } from '../../widgets/table-text.js';
import { byDevice } from '../../widgets/device.js';

type Question = 'bottleneck' | 'profile';
type Answer = { bottleneck: Bottleneck } | { profile: Profile };

const kindWords = {
  neck: 'a neck between the points',
  pass: 'a narrow place between the points, no neck',
  end: 'at one of the points: no neck is between them',
} as const;
const promiseWords = {
  shortest: ' No path of its class is shorter.',
  local: '',
  shorter: ' It can be drawn tighter.',
} as const;
/** A path through more points than these has only its ends marked. */
const mostMarked = 12;

export interface TwoPointsEvents {
  /** The loop of a bottleneck was chosen; `byHand`: the camera is to go there. */
  chosen(bottleneck: Bottleneck, byHand: boolean): void;
  /** The loop of a bottleneck is pointed at, or no longer. */
  attended(bottleneck: Bottleneck | undefined): void;
  /** Two points are to be chosen, or there is another answer. */
  changed(): void;
  /** Something else is asked, by hand. */
  asked(): void;
}

/** Whether two are the same place. */
const isSame = (one: SurfacePoint, other: SurfacePoint): boolean =>
  JSON.stringify(one) === JSON.stringify(other);

/** The vertices of the face that a point lies in, with its shares of them. */
function corners(point: SurfacePoint, indices: ArrayLike<number>): [number, number][] {
  if (typeof point === 'number') return [[point, 1]];
  return point.weights.map((share, i) => [indices[3 * point.face + i]!, share]);
}

export class TwoPoints {
  readonly element: HTMLElement;
  readonly #buttons = {
    bottleneck: make('button', { type: 'button', class: 'plain' }, 'Bottleneck'),
    profile: make('button', { type: 'button', class: 'plain' }, 'Profile'),
  };
  readonly #draw = make('button', { type: 'button', class: 'plain' }, 'Draw a path');
  readonly #drawing: PathDrawing;
  readonly #search: PanelSearch<Answer>;
  readonly #hint = new SurfaceHint(() => this.stop());
  readonly #list = new PlaceList('Bottleneck');
  readonly #plot: AlongPlot;
  readonly #other = make('button', { type: 'button', class: 'more' });
  readonly #tighten = make('button', { type: 'button', class: 'more' }, 'Draw the path tight');
  /** How long the path was before it was drawn tight. */
  #tightWords = '';
  #question: Question = 'bottleneck';
  #points: SurfacePoint[] = [];
  /** Whether the question was asked here, not by a link, which has a camera of its own. */
  #isByHand = false;
  #choosing: AbortController | undefined;
  /** Each vertex near the path, with its distance along the path. */
  #places = new Map<number, number>();
  readonly #viewer: GirthViewer;
  readonly #events: TwoPointsEvents;

  constructor(viewer: GirthViewer, events: TwoPointsEvents) {
    this.#viewer = viewer;
    this.#events = events;
    this.#search = new PanelSearch<Answer>(viewer, {
      again: 'Measure',
      pending: 'The answer follows as soon as the girth is computed …',
      // About the girth itself, whatever persistence is shown.
      parameters: () => [this.#question, this.#points],
      stopped: 'Not measured.',
      failed: 'Not measured: ',
      search: async (watch) => {
        if (this.#question === 'profile') {
          return { profile: await viewer.profile(this.#points, watch('Measuring along the path')) };
        }
        const [from, to] = this.#points as [SurfacePoint, SurfacePoint];
        return {
          bottleneck: await viewer.bottleneck(from, to, watch('Looking for the bottleneck')),
        };
      },
      found: (answer) => {
        this.#show();
        const shown = 'bottleneck' in answer ? this.#list : this.#plot;
        if (this.#isByHand) shown.element.scrollIntoView({ block: 'nearest' });
        if ('bottleneck' in answer) events.chosen(answer.bottleneck, this.#isByHand);
        return this.#tightWords;
      },
    });
    for (const question of ['bottleneck', 'profile'] as const) {
      const button = this.#buttons[question];
      button.addEventListener('click', () => void this.#ask(question));
      // The surface has the keys while a point is asked for.
      button.addEventListener('keydown', (event) => {
        if (this.#choosing && event.key === 'Enter' && viewer.press(event)) event.preventDefault();
      });
    }
    this.#drawing = new PathDrawing(viewer, {
      drawn: (points, polyline) => {
        this.#points = [...points];
        this.mark(true);
        viewer.showPath({ polyline });
      },
      ended: (points) => this.#drawn(points),
    });
    this.#draw.addEventListener('click', () => this.#startDrawing());
    this.#draw.addEventListener('keydown', (event) => {
      const isPoint = this.#drawing.isDrawing && event.key === 'Enter';
      if (isPoint && viewer.press(event)) event.preventDefault();
    });
    this.#plot = new AlongPlot(
      viewer,
      {
        label: 'Girth along the path from the first point',
        way: 'along the surface',
        from: 'from the first point',
      },
      {
        moved: (station) => this.#follow(station),
        chosen: (station) => this.#pin(station),
        table: () => this.table,
        fileName: () => `${stemOf(viewer.info?.name ?? 'model')}-profile.csv`,
      },
    );
    this.#other.addEventListener('click', () => {
      const ends = [this.#points[0]!, this.#points.at(-1)!];
      if (this.#question === 'profile') this.#points = ends;
      this.#answer(this.#question === 'bottleneck' ? 'profile' : 'bottleneck');
    });
    this.#tighten.addEventListener('click', () => void this.#drawTight());
    this.element = make(
      'section',
      { class: 'between', 'aria-label': 'Between two points' },
      make('h3', {}, 'Between two points'),
      make(
        'p',
        { class: 'hint' },
        'The bottleneck is the narrowest place on the widest way; the profile is the girth along the shortest path, or along one that you draw.',
      ),
      make('p', { class: 'buttons' }, this.#buttons.bottleneck, this.#buttons.profile, this.#draw),
      this.#search.element,
      this.#list.element,
      this.#plot.element,
      this.#tighten,
      this.#other,
    );
    viewer.addEventListener('hover', ({ detail: { vertex } }) => this.#point(vertex));
    this.clear();
  }

  /** Another model. */
  clear(): void {
    this.stop();
    this.#search.clear();
    this.#points = [];
    this.#tightWords = '';
    this.#show();
  }

  /** The question and its points, as the state has them. */
  get asked(): Pick<PageState, Question> {
    const isWhole = this.#points.length >= 2 && !this.#drawing.isDrawing;
    return isWhole ? { [this.#question]: [...this.#points] } : {};
  }

  /** The question and its points as attributes of an element. */
  get attributes(): ViewerState {
    const { bottleneck, profile } = this.asked;
    return {
      ...(bottleneck ? { bottleneck: writePath(bottleneck) } : {}),
      ...(profile ? { profile: writePath(profile) } : {}),
    };
  }

  /** Asks the question of a link; an answer that is there stays. `isShown`: answer at once. */
  apply({ bottleneck, profile }: PageState, isShown: boolean): void {
    const question: Question = profile && !bottleneck ? 'profile' : 'bottleneck';
    const points = bottleneck ?? profile ?? [];
    const asked = points.length >= 2 ? { [question]: points } : {};
    if (JSON.stringify(asked) === JSON.stringify(this.asked)) return;
    this.clear();
    this.#points = points;
    this.#question = question;
    this.#isByHand = false;
    this.#show();
    if (!isShown) return;
    this.mark(true);
    this.answer();
  }

  /** No point is asked for any more. */
  stop(): void {
    this.#choosing?.abort();
    this.#drawing.stop();
  }

  /** The girth is computed: what waits for it goes on. */
  girthIsThere(): void {
    this.answer();
  }

  /** Answers what is asked, unless that is done or under way. */
  answer(): void {
    const isAsked = this.#choosing !== undefined || this.#drawing.isDrawing;
    if (this.#points.length >= 2 && !isAsked) this.#search.start();
  }

  /** The path of the profile. */
  get path(): Pick<Profile, 'polyline'> | undefined {
    return this.#profile;
  }

  /** The points that were chosen are marked, or no longer. */
  mark(isShown: boolean): void {
    if (this.#viewer.info) this.#viewer.showPoints(isShown ? this.#marked : []);
  }

  /** The points that are marked: of a drawn line its ends. */
  get #marked(): SurfacePoint[] {
    const points = this.#points;
    return points.length > mostMarked ? [points[0]!, points.at(-1)!] : points;
  }

  /** Marks the bottleneck as the chosen loop, or no longer. */
  select(isChosen: boolean): void {
    this.#list.select(isChosen ? 0 : undefined);
  }

  get plots(): PagePlot[] {
    return [{ word: 'profile', svg: (width) => this.#plot.svg(width) }];
  }

  /** The profile as spreadsheets have it, in the unit that is shown. */
  get table(): Table {
    const { unit, scale } = this.#viewer.lengthFormat;
    return [
      [columnOf('distance', unit), columnOf('girth', unit), 'kind', 'face or vertex'],
      ...(this.#profile?.stations ?? []).map(({ distance, girth, kind, place }) => [
        distance * scale,
        girth * scale,
        kind,
        typeof place === 'number' ? `vertex ${place}` : `face ${place.face}`,
      ]),
    ];
  }

  /** Words and numbers in the present unit. */
  refresh(): void {
    const format = this.#viewer.lengthFormat;
    const [bottleneck, profile] = [this.bottleneck, this.#profile];
    this.#list.show(
      bottleneck
        ? [
            {
              lead: '',
              main: formatLength(bottleneck.girth, format),
              detail: [
                kindWords[bottleneck.kind],
                ...(bottleneck.points.length > 0
                  ? [`area ${formatArea(bottleneck.area, format)}`]
                  : []),
              ].join(' · '),
              choose: () => this.#events.chosen(bottleneck, true),
              attend: (isAttended) => this.#events.attended(isAttended ? bottleneck : undefined),
            },
          ]
        : [],
    );
    this.#plot.show(profile);
  }

  /** The bottleneck between the points, once it is found. */
  get bottleneck(): Bottleneck | undefined {
    const { found } = this.#search;
    return found && 'bottleneck' in found ? found.bottleneck : undefined;
  }

  get #profile(): Profile | undefined {
    const { found } = this.#search;
    return found && 'profile' in found ? found.profile : undefined;
  }

  /** Two points are chosen on the surface, and the question is about them. */
  async #ask(question: Question): Promise<void> {
    const wasAsked = this.#choosing !== undefined && this.#question === question;
    this.stop();
    if (wasAsked || !this.#viewer.info) return;
    const choosing = new AbortController();
    this.#choosing = choosing;
    this.#question = question;
    this.#search.clear();
    this.#points = [];
    this.#show();
    const { signal } = choosing;
    const points: SurfacePoint[] = [];
    try {
      this.#search.say(
        byDevice(
          'Click the surface, or move the probe with Shift and arrows, then Enter. Escape ends it.',
          'Tap the surface twice.',
        ),
      );
      while (points.length < 2) {
        this.#hint.show(`Choose the ${points.length === 0 ? 'first' : 'second'} point`);
        const point = await this.#viewer.choosePoint({ signal });
        // A place is no way from itself.
        if (points.every((one) => !isSame(one, point))) points.push(point);
        this.#points = points;
        this.mark(true);
      }
      this.#choosing = undefined;
      // The pointer rests where the last point is: its loop would stay while the camera flies.
      this.#viewer.showLoop();
      this.#answer(question);
    } catch {
      // A choice that was begun since has points of its own.
      if (this.#choosing !== choosing) return;
      this.#points = [];
      this.mark(true);
      this.#search.say('Not measured.');
    } finally {
      if (this.#choosing === choosing || this.#choosing === undefined) {
        this.#choosing = undefined;
        this.#hint.show(undefined);
        this.#showButtons();
      }
    }
  }

  /** A path is drawn on the surface; asked again, it ends. */
  #startDrawing(): void {
    const wasDrawing = this.#drawing.isDrawing;
    this.stop();
    if (wasDrawing || !this.#viewer.info) return;
    this.#question = 'profile';
    this.#search.clear();
    this.#points = [];
    this.#show();
    this.#search.say(
      byDevice(
        'Click points of the path, or drag over the surface; outside it a drag turns. Delete removes the last point, Escape ends the path.',
        'Tap points of the path, or draw it with a finger; beside the surface a finger turns it.',
      ),
    );
    void this.#drawing.start();
    this.#showButtons();
  }

  #drawn(points: SurfacePoint[] | undefined): void {
    this.#showButtons();
    this.#points = points ?? [];
    if (this.#viewer.info) this.#viewer.showLoop();
    if (points) {
      this.#answer('profile');
      return;
    }
    this.mark(true);
    this.#events.changed();
    this.#search.say('Not measured.');
  }

  /** The path is moved over the surface, with its ends fixed, to where it is straight. */
  async #drawTight(): Promise<void> {
    const [points, viewer] = [this.#points, this.#viewer];
    try {
      const tight = await (await viewer.mesh).tighten({ points });
      if (this.#points !== points) return;
      if (tight.kind === 'point') {
        this.#search.say('Drawn tight, the path shrinks to a point.');
        return;
      }
      const last = tight.points.length - 1;
      // A link holds fewer points than a long path crosses edges.
      const kept = Math.min(last, mostPathPoints - 1);
      this.#points = Array.from(
        { length: kept + 1 },
        (_, i) => tight.points[Math.round((i * last) / kept)]!,
      );
      const [before, after] = [tight.lengthBefore, tight.length].map((length) =>
        formatLength(length, viewer.lengthFormat),
      );
      this.mark(true);
      this.#answer(
        'profile',
        `Drawn tight: ${after} long, before ${before}.${promiseWords[tight.promise]}`,
      );
    } catch (error) {
      if (this.#points === points) this.#search.say(`Not drawn tight: ${failureWords(error)}.`);
    }
  }

  /** Answers a question about the points that there are. */
  #answer(question: Question, tightWords = ''): void {
    this.#tightWords = tightWords;
    this.#question = question;
    this.#isByHand = true;
    this.#search.clear();
    this.#show();
    this.#events.asked();
    this.#search.start();
  }

  #showButtons(): void {
    for (const question of ['bottleneck', 'profile'] as const) {
      const isAsked = this.#choosing !== undefined && this.#question === question;
      this.#buttons[question].setAttribute('aria-pressed', String(isAsked));
    }
    this.#draw.setAttribute('aria-pressed', String(this.#drawing.isDrawing));
  }

  /** Shows the answer that there is. */
  #show(): void {
    const profile = this.#profile;
    this.#other.hidden = this.#search.found === undefined;
    this.#tighten.hidden = !profile || this.#points.length === 2 || this.#tightWords !== '';
    this.#other.textContent =
      this.#question === 'bottleneck'
        ? 'Profile between these points'
        : this.#points.length === 2
          ? 'Bottleneck of these points'
          : 'Bottleneck of its ends';
    this.#places = new Map();
    const shares = new Map<number, number>();
    for (const { place, distance } of profile?.stations ?? []) {
      for (const [vertex, share] of corners(place, this.#viewer.geometry.indices)) {
        if (share < (shares.get(vertex) ?? 0)) continue;
        shares.set(vertex, share);
        this.#places.set(vertex, distance);
      }
    }
    this.#showButtons();
    this.refresh();
    this.#events.changed();
  }

  /** The cursor of the plot has moved: the point is marked, and its loop shown. */
  #follow(station: number | undefined): void {
    const at = station === undefined ? undefined : this.#profile?.stations[station];
    if (!this.#viewer.info) return;
    this.#viewer.showPoints(at ? [...this.#marked, at.place] : this.#marked);
    this.#viewer.showLoop(at?.place);
  }

  /** The pointer is at a vertex of the surface: the cursor goes there, where that is on the path. */
  #point(vertex: number | undefined): void {
    const profile = this.#profile;
    if (!profile) return;
    this.#plot.mark(vertex === undefined ? undefined : this.#places.get(vertex));
  }

  #pin(station: number): void {
    const at = this.#profile?.stations[station];
    if (at) void this.#viewer.pin(at.place).catch(() => undefined);
  }
}
