// How far two pinned points are apart: through space and along the surface.

import { type GirthViewer, formatLength, make } from '../../../src/element/index.js';
import type { SurfacePath } from '../../../src/kernel/index.js';
import { failureWords } from '../../widgets/failure-words.js';
import { PointList } from './point-list.js';

export class PointDistance {
  readonly element: HTMLElement;
  readonly #from: PointList;
  readonly #to: PointList;
  readonly #words = make('p', { class: 'said', role: 'status' });
  /** Which two points the answer is for, by their loops' numbers. */
  #pair = '';
  #path: SurfacePath | undefined;
  /** Whether the section is pointed at or has the focus: only then is the way a line on the surface. */
  #isAttended = false;
  /** Whether the way is a line on the surface now: lines of others stay. */
  #isDrawn = false;
  readonly #viewer: GirthViewer;

  constructor(viewer: GirthViewer) {
    this.#viewer = viewer;
    this.#from = new PointList('distance-from', 'From', () => void this.#measure());
    this.#to = new PointList('distance-to', 'to', () => void this.#measure());
    this.element = make(
      'section',
      { class: 'distance', 'aria-label': 'Distance of two points' },
      make('h3', {}, 'Distance of two points'),
      make('p', { class: 'row' }, ...this.#from.parts, ...this.#to.parts),
      this.#words,
      make('p', { class: 'hint' }, 'Point here to see the way on the surface.'),
    );
    this.element.hidden = true;
    for (const [event, isAttended] of [
      ['pointerenter', true],
      ['pointerleave', false],
      ['focusin', true],
      ['focusout', false],
    ] as const) {
      this.element.addEventListener(event, () => {
        this.#isAttended = isAttended;
        this.#draw();
      });
    }
  }

  /** The points have changed, or only how lengths are written. The last two are measured at first. */
  refresh(isOpen: boolean): void {
    const viewer = this.#viewer;
    const { pinned } = viewer;
    const points = pinned.map(({ id, name }) => ({ id, name }));
    const isPossible = points.length > 1;
    this.element.hidden = !isPossible;
    if (!isPossible || !isOpen) {
      this.#pair = '';
      this.#path = undefined;
      this.#draw();
      this.#words.textContent = '';
      if (!isPossible) return;
    }
    this.#from.show(points, points.at(-2)!.id);
    this.#to.show(points, points.at(-1)!.id);
    if (isOpen) void this.#measure();
  }

  #draw(): void {
    const path = this.#isAttended ? this.#path : undefined;
    if (!this.#viewer.info || (!path && !this.#isDrawn)) return;
    this.#isDrawn = path !== undefined;
    this.#viewer.showPath(path);
  }

  async #measure(): Promise<void> {
    const viewer = this.#viewer;
    const { pinned, info } = viewer;
    const [from, to] = [this.#from, this.#to].map((list) =>
      pinned.find(({ id }) => String(id) === list.chosen),
    );
    if (!from || !to || !info) return;
    const pair = `${from.id} ${to.id}`;
    if (pair !== this.#pair) {
      this.#pair = pair;
      this.#path = undefined;
      this.#draw();
      this.#words.textContent = 'Measuring …';
      try {
        const path = await viewer.path(from.loop.base, to.loop.base);
        if (pair !== this.#pair || viewer.info !== info) return;
        this.#path = path;
        this.#draw();
      } catch (error) {
        if (pair === this.#pair && viewer.info === info) {
          this.#words.textContent = `Not measured: ${failureWords(error)}.`;
        }
        return;
      }
    }
    if (!this.#path) return;
    const { length, straight } = this.#path;
    const format = viewer.lengthFormat;
    const along = Number.isFinite(length)
      ? `${formatLength(length, format)} along the surface`
      : 'no way along the surface: they are on different parts';
    const words = `${formatLength(straight, format)} straight, ${along}`;
    // Said once: a live region speaks whenever it changes.
    if (this.#words.textContent !== words) this.#words.textContent = words;
  }
}
