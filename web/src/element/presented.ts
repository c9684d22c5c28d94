// One model on a stage: its colours and legend, its loops and tips, what is marked, where one looks.

import { alsoNamed } from '../kernel/types/older-names.js';
import type {
  FieldName,
  Loop,
  PartThresholds,
  Parts,
  SurfacePoint,
} from '../kernel/types/types.js';
import {
  Latest,
  type LegendContent,
  type LengthFormat,
  LoopBand,
  type Place,
  PointMarks,
  type Stage,
  isFieldName,
  lengthFormat,
} from '../view/index.js';
import type { FieldState } from './model/fields.js';
import { LoopsOnSurface, type LoopsHost } from './surface/loops-on-surface.js';
import { NumbersOnSurface } from './surface/numbers-on-surface.js';
import type { Model } from './model/model.js';
import { Shading, type ShadingWishes, type ShownPlaces } from './surface/shading.js';
import { Standing } from './surface/standing.js';
import { TipsOnSurface } from './surface/tips-on-surface.js';

/** A place of the surface to look at: a vertex, a region, a line, or some of these together. */
export interface PlaceOnSurface {
  /** The vertices of the region. */
  vertices?: ArrayLike<number>;
  /** A single one. */
  vertex?: number;
  /** The points of the line: x, y, z of each, from `Mesh.geometry.origin`. */
  polyline?: Float32Array;
}

/** The content of a picture of a place; see `GirthViewer.snapshotOf`. */
export interface PlacePicture {
  /** Shown as they are, the rest of the surface faded. */
  vertices: ArrayLike<number>;
  /** Drawn as a band. */
  loop?: Loop;
  /** The width in pixels. Default: 480. */
  width?: number;
  /** The height in pixels. Default: 360. */
  height?: number;
}

/** Wished thresholds of parts, in model units. */
export interface PartsWish extends PartThresholds {
  /** The smoothing, as of `PartOptions`. Default: 0. */
  smoothing?: number;
}

/** Points of a region that suffice to find where it is. */
const enoughPoints = 300;
/** A line through more points than these has only its ends marked. */
const mostMarked = 12;
const pathStyle = { colour: '#3fd0ff', weight: 0.9 };
const curveStyle = { colour: '#e8c35a', weight: 0.6 };
const pictureStyle = { colour: '#ff7a45', weight: 1.1 };

export interface PresentedHost extends LoopsHost {
  /** The legend or the way in which lengths are written has changed. */
  relabelled(legend: LegendContent | undefined, format: LengthFormat): void;
}

export class Presented {
  readonly shading: Shading;
  readonly loops: LoopsOnSurface;
  readonly tips: TipsOnSurface;
  readonly numbers: NumbersOnSurface;
  readonly standing: Standing;
  readonly #smoother: Latest<PartsWish, Parts>;
  #points: PointMarks | undefined;
  #path: LoopBand | undefined;
  #curves: LoopBand[] = [];
  /** The points that the path and the curves are drawn of. */
  #pathLine: Float32Array | undefined;
  #curveLines: readonly Float32Array[] = [];
  #marked: ArrayLike<number> | undefined;
  #wished: PartsWish | undefined;
  #format: LengthFormat;
  readonly #stage: Stage;
  readonly model: Model;
  readonly #host: PresentedHost;

  constructor(
    stage: Stage,
    canvas: HTMLCanvasElement,
    model: Model,
    wishes: ShadingWishes,
    up: string | null,
    host: PresentedHost,
  ) {
    this.#stage = stage;
    this.model = model;
    this.#host = host;
    const { surface } = model;
    this.shading = new Shading(model, wishes);
    this.#format = lengthFormat(2 * surface.bounds.radius, wishes.unit, wishes.shownUnit);
    stage.show(surface);
    this.standing = new Standing(stage, model, up);
    this.loops = new LoopsOnSurface(stage, canvas, model, this.#format, host);
    this.tips = new TipsOnSurface(stage, model);
    this.numbers = new NumbersOnSurface(stage, model);
    this.#smoother = new Latest(
      (wish) => model.parts(wish),
      (wish, parts) => {
        if (wish === this.#wished) this.#showParts(wish, parts);
      },
      (_wish, error) => host.failed(error),
    );
  }

  /** How lengths are written everywhere but in the legend of another field: as fits the girth. */
  get lengthFormat(): LengthFormat {
    return this.#format;
  }

  /** Colours the surface anew with what there is. */
  paint(): void {
    this.shading.paint();
    this.#relabel();
    this.#stage.invalidate();
  }

  /** Once a frame: colours spread a little further. Returns whether some are still to come. */
  spread(): boolean {
    if (!this.shading.isSpreading) return false;
    const done = this.shading.spread();
    this.refresh();
    return !done;
  }

  /** Range, lines and words as they are wished for now. */
  refresh(): void {
    this.shading.refresh();
    this.#relabel();
    this.#stage.invalidate();
  }

  #relabel(): void {
    const { model, shading } = this;
    const state = model.fields.get('igf');
    const largest = (state?.field?.range ?? state?.preview?.range)?.[1];
    const { unit, shownUnit } = shading.wishes;
    const format = lengthFormat(largest ?? 2 * model.surface.bounds.radius, unit, shownUnit);
    if (JSON.stringify(format) !== JSON.stringify(this.#format)) {
      this.#format = format;
      this.loops.setFormat(format);
    }
    this.#host.relabelled(shading.legend, format);
  }

  /** The values that fields have at a vertex, of those that are computed there. */
  valuesAt(vertex: number): Partial<Record<FieldName, number>> {
    const { fields } = this.model;
    const computed = [...fields.all]
      .filter(({ field, preview }: FieldState) => field ?? preview?.isComputed(vertex))
      .map(({ name }) => name);
    const known = new Set([...fields.givenNames.filter(isFieldName), ...computed]);
    return Object.fromEntries([...known].map((name) => [name, fields.valuesOf(name)[vertex]!]));
  }

  get thresholds(): Required<PartsWish> | undefined {
    const { parts } = this.shading;
    if (!parts) return undefined;
    const { girth, shapeDiameter } = parts;
    const all = { girth, shapeDiameter, smoothing: this.#wished?.smoothing ?? 0 };
    return alsoNamed(all, { thickness: 'shapeDiameter' });
  }

  /** Plain thresholds at once; smoothed parts as soon as they are computed. */
  setThresholds(wish: PartsWish): void {
    const { girth, shapeDiameter, smoothing = 0 } = wish;
    for (const number of [girth, shapeDiameter, smoothing]) {
      if (!(number >= 0)) {
        throw new RangeError('thresholds and smoothing are numbers from 0 on, in model units');
      }
    }
    this.#wished = wish;
    this.#smoother.clear();
    this.#showParts(wish, undefined);
    if (smoothing > 0) this.#smoother.request(wish);
  }

  /** Forgets the thresholds, as if none had been chosen. */
  forgetThresholds(): void {
    this.#wished = undefined;
    this.#smoother.clear();
    this.shading.parts = undefined;
  }

  #showParts({ girth, shapeDiameter }: PartsWish, smoothed: Parts | undefined): void {
    this.shading.parts = { girth, shapeDiameter, smoothed };
    if (this.shading.wishes.name === 'parts') this.paint();
  }

  showPlaces(places: ShownPlaces | undefined): void {
    this.shading.places = places;
    this.paint();
  }

  mark(vertices: ArrayLike<number> | undefined): void {
    this.#marked = vertices;
    this.model.surface.mark(vertices);
    this.#stage.invalidate();
  }

  showPoints(points: ArrayLike<SurfacePoint>): void {
    if (this.#points) this.#stage.remove(this.#points);
    const { surface } = this.model;
    const places = Array.from(points, (point) => surface.positionOf(point).toArray());
    this.#points = places.length > 0 ? new PointMarks(places) : undefined;
    if (this.#points) this.#stage.add(this.#points);
  }

  showPath(polyline: Float32Array | undefined): void {
    if (this.#path) this.#stage.remove(this.#path);
    this.#pathLine = polyline;
    const midpoint = polyline && [...polyline.slice(-3)];
    this.#path =
      midpoint?.length === 3
        ? new LoopBand(
            { kind: 'loop', polyline: polyline!, midpoint: midpoint as [number, number, number] },
            pathStyle,
          )
        : undefined;
    if (this.#path) this.#stage.add(this.#path);
  }

  /** Shows a path with its points; of more than `mostMarked` only the ends. */
  showBetween(points: readonly SurfacePoint[], polyline: Float32Array | undefined): void {
    this.showPoints(points.length > mostMarked ? [points[0]!, points.at(-1)!] : points);
    this.showPath(polyline);
  }

  showCurves(polylines: readonly Float32Array[]): void {
    for (const band of this.#curves) this.#stage.remove(band);
    this.#curveLines = polylines;
    this.#curves = polylines
      .filter(({ length }) => length > 3)
      .map((polyline) => {
        const [x, y, z] = polyline;
        return new LoopBand({ kind: 'loop', polyline, midpoint: [x!, y!, z!] }, curveStyle);
      });
    for (const band of this.#curves) this.#stage.add(band);
  }

  /** The lines that are drawn on the surface but for its tips and the loop under the pointer, with their CSS colours. */
  get lines(): { polyline: Float32Array; colour: string }[] {
    const path = this.#pathLine ? [this.#pathLine] : [];
    return [
      ...this.#curveLines.map((polyline) => ({ polyline, colour: curveStyle.colour })),
      ...path.map((polyline) => ({ polyline, colour: pathStyle.colour })),
      ...this.loops.pinned.map(({ loop }) => ({
        polyline: loop.polyline,
        colour: pictureStyle.colour,
      })),
    ];
  }

  flyTo(place: PlaceOnSurface, atOnce: boolean): void {
    this.#stage.flyTo(this.#placeOf(place), atOnce);
  }

  /** A picture of a place, whatever is on the canvas. */
  pictureOf({ vertices, loop, width = 480, height = 360 }: PlacePicture): HTMLCanvasElement {
    const { surface } = this.model;
    const polyline = loop?.polyline;
    const place = this.#placeOf(polyline ? { vertices, polyline } : { vertices });
    const band = loop && new LoopBand(loop, pictureStyle);
    surface.mark(vertices);
    try {
      return this.#stage.pictureOf(place, band, width, height);
    } finally {
      surface.mark(this.#marked);
      band?.dispose();
      this.#stage.invalidate();
    }
  }

  #placeOf({ vertices = [], vertex, polyline }: PlaceOnSurface): Place {
    const { surface } = this.model;
    const chosen = vertex === undefined ? sampleOf(vertices) : [vertex, ...sampleOf(vertices)];
    const points = chosen.map((v) => surface.positionOf(v));
    const outwards = surface.bounds.center.clone().set(0, 0, 0);
    for (const v of chosen) outwards.add(surface.normalOf(v));
    for (let i = 0; polyline && i + 2 < polyline.length; i += 3) {
      points.push(surface.bounds.center.clone().fromArray(polyline, i));
    }
    const known = outwards.length() > 0.1 * chosen.length;
    return { points, outwards: known ? outwards.normalize() : undefined };
  }

  dispose(keepsMesh: boolean): void {
    this.#smoother.clear();
    this.standing.dispose();
    this.loops.dispose();
    this.tips.clear();
    this.numbers.element.remove();
    this.showPoints([]);
    this.showPath(undefined);
    this.showCurves([]);
    this.model.dispose(keepsMesh);
    this.#stage.show(undefined);
  }
}

/** So many of the numbers at most, evenly chosen: enough to show where a region is. */
function sampleOf(vertices: ArrayLike<number>): number[] {
  const step = Math.max(1, Math.ceil(vertices.length / enoughPoints));
  return Array.from({ length: Math.ceil(vertices.length / step) }, (_, i) => vertices[i * step]!);
}
