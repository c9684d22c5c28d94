// A loop on the surface: a bright band with a soft shadow, its midpoint a dot.

import { Group } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import type { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { Loop } from '../kernel/types/types.js';
import { type Dots, type Overlay, makeDots, strokeMaterial } from './fat-lines.js';

/** The strokes of a band from the bottom up; widths in CSS pixels. */
const strokes = [
  { part: 'hidden', width: 3, opacity: 0.22 },
  { part: 'shadow', width: 16, opacity: 0.05 },
  { part: 'shadow', width: 13.5, opacity: 0.07 },
  { part: 'shadow', width: 11, opacity: 0.1 },
  { part: 'shadow', width: 8.5, opacity: 0.16 },
  { part: 'shadow', width: 6, opacity: 0.3 },
  { part: 'band', width: 3.6, opacity: 1 },
] as const;

export interface BandStyle {
  /** CSS colour of the band. */
  colour: string;
  /** Multiplies the widths. */
  weight: number;
}

export class LoopBand implements Overlay {
  readonly object = new Group();

  readonly #line: LineGeometry;
  readonly #materials: LineMaterial[];
  readonly #dots: Dots;

  constructor(loop: Pick<Loop, 'kind' | 'polyline' | 'midpoint'>, style: BandStyle) {
    const antipodal = loop.kind === 'antipodal';
    // A loop that was not found has only its base.
    const known = loop.polyline.length > 0;
    this.#line = new LineGeometry();
    if (known) this.#line.setPositions(loop.polyline);
    this.#materials = (known ? strokes : []).map(({ part, width, opacity }, order) => {
      const dashed = antipodal && part !== 'shadow';
      const material = strokeMaterial({
        colour: part === 'shadow' ? '#05060a' : style.colour,
        width: width * style.weight,
        opacity: antipodal && part === 'shadow' ? 0.6 * opacity : opacity,
        hidden: part === 'hidden',
        dashed,
        ...(part === 'band' ? {} : { once: order + 1 }),
      });
      if (dashed) {
        // Out and back may be one path: dashes symmetric about both its ends fall on each other.
        const dashes = 2 * Math.max(4, Math.round(strokesPerLoop / 2));
        material.dashScale = dashes / lengthOf(loop.polyline);
        material.dashSize = 0.6;
        material.gapSize = 0.4;
        material.dashOffset = 0.3;
      }
      const object = new Line2(this.#line, material);
      if (dashed) object.computeLineDistances();
      object.renderOrder = 2 + order;
      object.frustumCulled = false;
      this.object.add(object);
      return material;
    });
    // The base point is a small dot, the midpoint a larger one.
    const dots = [
      { place: known ? loop.polyline : loop.midpoint, size: 8 * style.weight },
      { place: loop.midpoint, size: 15 * style.weight },
    ];
    this.#dots = makeDots(dots, style.colour, 2 + strokes.length);
    this.object.add(this.#dots);
  }

  setPixelRatio(ratio: number): void {
    this.#dots.material.uniforms['pixelRatio']!.value = ratio;
  }

  dispose(): void {
    this.#line.dispose();
    for (const material of this.#materials) material.dispose();
    this.#dots.geometry.dispose();
    this.#dots.material.dispose();
    this.object.removeFromParent();
  }
}

/** Dashes of a there-and-back path. */
const strokesPerLoop = 72;

function lengthOf(polyline: Float32Array): number {
  let length = 0;
  for (let i = 3; i < polyline.length; i += 3) {
    length += Math.hypot(
      polyline[i]! - polyline[i - 3]!,
      polyline[i + 1]! - polyline[i - 2]!,
      polyline[i + 2]! - polyline[i - 1]!,
    );
  }
  return length || 1;
}
