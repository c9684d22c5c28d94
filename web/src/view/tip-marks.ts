// The lines that cut off a shape's tips, the tips' apexes, and the lines that cut none off.

import { Group } from 'three';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import type { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { ContourLine } from '../kernel/types/types.js';
import { type Dot, type Dots, type Overlay, makeDots, strokeMaterial } from './fat-lines.js';

/** The marks to be drawn; places are x, y, z. */
export interface TipMarksContent {
  /** Lines that cut off a tip. */
  contours: readonly ContourLine[];
  /** Lines that cut off the selected tip. */
  selected: readonly ContourLine[];
  /** Lines that cut no tip off: drawn dashed. */
  arcs: readonly ContourLine[];
  apexes: readonly ArrayLike<number>[];
  selectedApex: ArrayLike<number> | undefined;
  /** Length of a dash and the gap behind it, in model units. */
  dash: number;
}

const ink = '#101216';
const paper = '#ffffff';
const accent = '#ff7a45';
/** Drawn before loops, which begin with 2. */
const order = 1.5;
/** Stencil number: none of a loop's. */
const once = 64;

export class TipMarks implements Overlay {
  readonly object = new Group();
  readonly #geometries: LineSegmentsGeometry[] = [];
  readonly #materials: LineMaterial[] = [];
  readonly #dots: Dots[] = [];

  constructor({ contours, selected, arcs, apexes, selectedApex, dash }: TipMarksContent) {
    this.#addLines(contours, paper, 2.2, undefined);
    this.#addLines(arcs, paper, 2.2, dash);
    this.#addLines(selected, accent, 3.4, undefined);
    this.#addDots(
      apexes.map((place) => ({ place, size: 11 })),
      paper,
    );
    if (selectedApex) this.#addDots([{ place: selectedApex, size: 16 }], accent);
  }

  setPixelRatio(ratio: number): void {
    for (const dots of this.#dots) dots.material.uniforms['pixelRatio']!.value = ratio;
  }

  dispose(): void {
    for (const geometry of this.#geometries) geometry.dispose();
    for (const material of this.#materials) material.dispose();
    for (const dots of this.#dots) {
      dots.geometry.dispose();
      dots.material.dispose();
    }
    this.object.removeFromParent();
  }

  /** A light line in a dark casing; faint where the surface hides it. */
  #addLines(
    lines: readonly ContourLine[],
    colour: string,
    width: number,
    dash: number | undefined,
  ): void {
    const segments = segmentsOf(lines);
    if (segments.length === 0) return;
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(segments);
    this.#geometries.push(geometry);
    const strokes = [
      { colour: ink, width: width + 0.4, opacity: 0.2, hidden: true, dashed: false, once },
      {
        colour: ink,
        width: width + 2.8,
        opacity: 0.92,
        hidden: false,
        dashed: false,
        once: once + 1,
      },
      { colour, width, opacity: 1, hidden: false, dashed: dash !== undefined },
    ];
    strokes.forEach((stroke, i) => {
      const material = strokeMaterial(stroke);
      const object = new LineSegments2(geometry, material);
      if (dash !== undefined) {
        material.dashScale = 1 / dash;
        material.dashSize = 0.55;
        material.gapSize = 0.45;
        object.computeLineDistances();
      }
      object.renderOrder = order + 0.1 * i;
      object.frustumCulled = false;
      this.#materials.push(material);
      this.object.add(object);
    });
  }

  #addDots(dots: readonly Dot[], colour: string): void {
    if (dots.length === 0) return;
    const made = makeDots(dots, colour, order + 0.4);
    this.#dots.push(made);
    this.object.add(made);
  }
}

/** The two ends of every piece of the lines, x, y, z each. */
export function segmentsOf(lines: readonly ContourLine[]): Float32Array {
  const pieces = ({ closed, polyline }: ContourLine): number =>
    Math.max(0, polyline.length / 3 - (closed ? 0 : 1));
  const segments = new Float32Array(6 * lines.reduce((sum, line) => sum + pieces(line), 0));
  let at = 0;
  for (const line of lines) {
    const count = line.polyline.length / 3;
    for (let i = 0; i < pieces(line); ++i) {
      const next = (i + 1) % count;
      segments.set(line.polyline.subarray(3 * i, 3 * i + 3), at);
      segments.set(line.polyline.subarray(3 * next, 3 * next + 3), at + 3);
      at += 6;
    }
  }
  return segments;
}
