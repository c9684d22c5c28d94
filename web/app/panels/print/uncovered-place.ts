// A place of a list is looked at; where the surface hides it, a section plane in front of it cuts away what does.

import type { GirthViewer } from '../../../src/element/index.js';
import type { Store } from '../../state/store.js';

/** Points of a place that are looked for on the canvas. */
const sampled = 24;

/** Milliseconds after which the camera is at rest, also where it had not to move. */
const longestFlight = 1500;

/** The section that leaves a place, and cuts away all that lies nearer to the eye: an attribute's words. */
export function sectionBefore(
  positions: ArrayLike<number>,
  vertices: ArrayLike<number>,
  towardsEye: readonly [number, number, number],
): string {
  const along = (v: number): number =>
    towardsEye.reduce((sum, part, axis) => sum + part * positions[3 * v + axis]!, 0);
  let [low, high, front] = [Infinity, -Infinity, -Infinity];
  for (let v = 0; v < positions.length / 3; v++) {
    low = Math.min(low, along(v));
    high = Math.max(high, along(v));
  }
  for (let i = 0; i < vertices.length; i++) front = Math.max(front, along(vertices[i]!));
  // Rounded up: the place itself stays.
  const percent = Math.min(100, Math.ceil((1000 * (front - low)) / (high - low) + 1) / 10);
  const direction = towardsEye.map((part) => Number(part.toFixed(3)));
  return `${direction.join(',')} ${percent}%`;
}

export class UncoveredPlace {
  readonly #viewer: GirthViewer;
  readonly #store: Store;
  /** The section that was set for a place, until it is taken back. */
  #section: string | undefined;
  #turn = 0;

  constructor(viewer: GirthViewer, store: Store) {
    this.#viewer = viewer;
    this.#store = store;
  }

  /** Flies to a place. A section that this has set for another place goes. */
  async lookAt(vertices: ArrayLike<number>): Promise<void> {
    const viewer = this.#viewer;
    const turn = ++this.#turn;
    const { info } = viewer;
    if (this.#section !== undefined && this.#store.shown.section === this.#section) {
      this.#store.choose({ section: undefined });
    }
    this.#section = undefined;
    const rests = new Promise<void>((resolve) => {
      viewer.addEventListener('camera', () => resolve(), { once: true });
      setTimeout(resolve, longestFlight);
    });
    viewer.flyTo({ vertices });
    await rests;
    const { geometry, towardsEye } = viewer;
    if (turn !== this.#turn || viewer.info !== info || !geometry || !towardsEye) return;
    const step = Math.max(1, Math.ceil(vertices.length / sampled));
    let [seen, hidden] = [0, 0];
    for (let i = 0; i < vertices.length; i += step) {
      if (viewer.screenPosition(vertices[i]!).visible) seen++;
      else hidden++;
    }
    if (hidden <= seen) return;
    this.#section = sectionBefore(geometry.positions, vertices, towardsEye);
    this.#store.choose({ section: this.#section });
  }
}
