// Points of a surface that are shown beside its tips, to be compared with them: diamonds.

import { type Dots, type Overlay, makeDots } from './fat-lines.js';

const colour = '#56b4e9';
const size = 16;
/** Drawn after the tips and before loops. */
const order = 1.95;

export class PointMarks implements Overlay {
  readonly object: Dots;

  /** x, y, z per point. */
  constructor(places: readonly ArrayLike<number>[]) {
    this.object = makeDots(
      places.map((place) => ({ place, size })),
      colour,
      order,
      'diamond',
    );
  }

  setPixelRatio(ratio: number): void {
    this.object.material.uniforms['pixelRatio']!.value = ratio;
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
    this.object.removeFromParent();
  }
}
