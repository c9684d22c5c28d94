// Between the canvas and the surface: which point of the surface is under a point of the window, and where a
// point of the surface is on the canvas.

import { type PerspectiveCamera, Raycaster, Vector2, type Vector3 } from 'three';
import type { FacePoint } from '../kernel/types/types.js';
import type { Surface } from './surface.js';
import type { SurfaceSpace } from './surface-space.js';

/** A point of the surface on the canvas, in CSS pixels from its top left corner. */
export interface ScreenPoint {
  /** To the right. */
  x: number;
  /** Downwards. */
  y: number;
  /** False where the surface hides the point or it is outside of the canvas. */
  visible: boolean;
}

export class Picker {
  readonly #canvas: HTMLCanvasElement;
  readonly #camera: PerspectiveCamera;
  readonly #space: SurfaceSpace;
  readonly #raycaster = new Raycaster();

  constructor(canvas: HTMLCanvasElement, camera: PerspectiveCamera, space: SurfaceSpace) {
    this.#canvas = canvas;
    this.#camera = camera;
    this.#space = space;
  }

  /** The point of the surface under a point of the window; undefined beside the surface. */
  pick(surface: Surface, clientX: number, clientY: number): FacePoint | undefined {
    const box = this.#canvas.getBoundingClientRect();
    const place = new Vector2(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
    );
    this.#raycaster.setFromCamera(place, this.#camera);
    const { ray } = this.#raycaster;
    this.#space.toSurface(ray.origin);
    this.#space.directionToSurface(ray.direction);
    return surface.pick(ray);
  }

  /** Where a point is on a canvas of that size, hidden or not. */
  place(point: Vector3, width: number, height: number): { x: number; y: number } {
    const { x, y } = this.#space.toScene(point).project(this.#camera);
    return { x: (0.5 + 0.5 * x) * width, y: (0.5 - 0.5 * y) * height };
  }

  /** Where the camera is, in the surface's coordinates. */
  get eye(): Vector3 {
    return this.#space.toSurface(this.#camera.position.clone());
  }

  /** Where a point is on a canvas of that size, in CSS pixels; without a surface nothing hides it. */
  project(
    surface: Surface | undefined,
    point: Vector3,
    width: number,
    height: number,
  ): ScreenPoint {
    const { x, y, z } = this.#space.toScene(point).project(this.#camera);
    const inside = Math.abs(x) <= 1 && Math.abs(y) <= 1 && z > -1 && z < 1;
    return {
      x: (0.5 + 0.5 * x) * width,
      y: (0.5 - 0.5 * y) * height,
      visible: inside && !surface?.hides(point, this.eye),
    };
  }
}
