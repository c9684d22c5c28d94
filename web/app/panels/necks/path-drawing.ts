// A path that is drawn on the surface: by points that are clicked one after the other, by strokes, or by both.

import { type GirthViewer, make, mostPathPoints } from '../../../src/element/index.js';
import type { SurfacePoint } from '../../../src/kernel/index.js';
import { SurfaceHint } from '../../widgets/surface-hint.js';
import { byDevice } from '../../widgets/device.js';

export interface DrawingEvents {
  /** The path has other points now; `polyline` is about how it runs. */
  drawn(points: readonly SurfacePoint[], polyline: Float32Array): void;
  /** The drawing has ended; `points` is undefined where it has less than two, or was given up. */
  ended(points: SurfacePoint[] | undefined): void;
}

/** Points that came together, and how the path runs to them: with the point before, which is there twice. */
interface Piece {
  points: readonly SurfacePoint[];
  polyline: Float32Array;
}

/** Whether two are the same place. */
const isSame = (one: SurfacePoint, other: SurfacePoint): boolean =>
  JSON.stringify(one) === JSON.stringify(other);

/** Elements in which keys are for a text. */
const typing = 'input, select, textarea';

export class PathDrawing {
  readonly #undo = make('button', { type: 'button', class: 'plain' }, 'Undo point');
  readonly #hint: SurfaceHint;
  #pieces: Piece[] = [];
  /** Ends the drawing; its reason is whether the path is given up. */
  #running: AbortController | undefined;
  readonly #viewer: GirthViewer;
  readonly #events: DrawingEvents;

  constructor(viewer: GirthViewer, events: DrawingEvents) {
    this.#viewer = viewer;
    this.#events = events;
    this.#hint = new SurfaceHint(() => this.#end(), 'Done', this.#undo);
    this.#undo.addEventListener('click', () => this.#takeBack());
  }

  get isDrawing(): boolean {
    return this.#running !== undefined;
  }

  /** Whoever draws is asked for points until Escape, 'Done', or as many as a path may have. */
  async start(): Promise<void> {
    this.stop();
    const running = new AbortController();
    this.#running = running;
    const { signal } = running;
    const { info } = this.#viewer;
    this.#pieces = [];
    document.addEventListener('keydown', (event) => this.#key(event), { signal, capture: true });
    this.#show();
    try {
      while (this.#points.length < mostPathPoints) {
        const drawn = (points: readonly SurfacePoint[]): void => this.#preview(points);
        this.#add(await this.#viewer.chooseStroke({ signal, drawn }));
      }
    } catch {
      // Escape, or another model, which the path is not about.
      if (this.#running === running && this.#viewer.info !== info) this.stop();
    }
    if (this.#running === running) this.#end();
  }

  /** Gives the path up. */
  stop(): void {
    if (!this.#running) return;
    this.#pieces = [];
    this.#end();
  }

  get #points(): SurfacePoint[] {
    return this.#pieces.flatMap(({ points }) => points);
  }

  #end(): void {
    const running = this.#running;
    const points = this.#points;
    this.#running = undefined;
    this.#pieces = [];
    running?.abort();
    this.#hint.show(undefined);
    this.#events.ended(points.length < 2 ? undefined : points);
  }

  /** Points that are new: a place is no way from itself. */
  #new(points: readonly SurfacePoint[]): SurfacePoint[] {
    const all = this.#points;
    const last = all.at(-1);
    return points
      .filter((point, i) => {
        const before = i === 0 ? last : points[i - 1];
        return before === undefined || !isSame(before, point);
      })
      .slice(0, mostPathPoints - all.length);
  }

  #add(chosen: readonly SurfacePoint[]): void {
    const last = this.#points.at(-1);
    const points = this.#new(chosen);
    if (points.length === 0) return;
    const piece: Piece = { points, polyline: this.#straight(points) };
    this.#pieces.push(piece);
    this.#show();
    // A stroke is as it was drawn; from one click to the next the path is a shortest one.
    if (last === undefined || points.length > 1) return;
    void this.#viewer.path(last, points[0]!).then(
      ({ polyline }) => {
        piece.polyline = polyline;
        if (this.#pieces.includes(piece)) this.#show();
      },
      // The later answer says where no path leads to a point.
      () => undefined,
    );
  }

  #takeBack(): void {
    this.#pieces.pop();
    this.#show();
  }

  #key(event: KeyboardEvent): void {
    const [target] = event.composedPath();
    const isOther = event.ctrlKey || event.altKey || event.metaKey;
    if (isOther || !['Backspace', 'Delete'].includes(event.key)) return;
    if (target instanceof Element && target.closest(typing)) return;
    // The surface would take a pinned loop away.
    event.preventDefault();
    event.stopPropagation();
    this.#takeBack();
  }

  /** A line from the last point straight through more of them. */
  #straight(points: readonly SurfacePoint[]): Float32Array {
    const last = this.#points.at(-1);
    const { positions, indices } = this.#viewer.geometry;
    const place = (vertex: number, axis: number): number => positions[3 * vertex + axis]!;
    const coordinates = [...(last === undefined ? [] : [last]), ...points].flatMap((point) =>
      [0, 1, 2].map((axis) =>
        typeof point === 'number'
          ? place(point, axis)
          : point.weights.reduce(
              (sum, share, i) => sum + share * place(indices[3 * point.face + i]!, axis),
              0,
            ),
      ),
    );
    return Float32Array.from(coordinates);
  }

  /** A stroke that is still being drawn. */
  #preview(points: readonly SurfacePoint[]): void {
    const drawn = this.#new(points);
    this.#draw([...this.#pieces, { points: drawn, polyline: this.#straight(drawn) }]);
  }

  #show(): void {
    const count = this.#points.length;
    this.#hint.show(
      count === 0
        ? byDevice(
            'Click points of the path, or drag over the surface',
            'Tap points of the path, or draw it',
          )
        : count === 1
          ? byDevice('One point: click the next, or drag', 'One point: tap the next, or draw')
          : `${count} points; Escape ends it`,
    );
    this.#undo.hidden = count === 0;
    this.#draw(this.#pieces);
  }

  #draw(pieces: readonly Piece[]): void {
    this.#events.drawn(
      pieces.flatMap(({ points }) => points),
      Float32Array.from(pieces.flatMap(({ polyline }) => [...polyline])),
    );
  }
}
