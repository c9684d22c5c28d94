// Where a surface is in the scene: upright, and of radius 1 round the origin, so that the camera, its limits and the
// shaders' 32-bit numbers meet the same sizes whether a file counts in micrometres or in kilometres.

import { Group, Plane, Quaternion, type Sphere, Vector3 } from 'three';
import type { SectionPlane } from './section-plane.js';
import type { Rotation } from './up-axis.js';

/** The surface's own coordinates within the scene's. */
export class SurfaceSpace {
  /** A group whose members are in the surface's coordinates. */
  readonly group = new Group();
  readonly #back = new Quaternion();

  /** The space of a surface with these bounds, turned upright. */
  fit({ center, radius }: Sphere, upright: Rotation): void {
    this.group.scale.setScalar(1 / radius);
    this.group.quaternion.copy(upright);
    this.group.position.copy(center).divideScalar(-radius).applyQuaternion(upright);
    this.group.updateMatrixWorld();
    this.#back.copy(upright).invert();
  }

  /** Turns a direction of the surface's coordinates into one of the scene; a new vector. */
  directionToScene(direction: Vector3): Vector3 {
    return direction.clone().applyQuaternion(this.group.quaternion);
  }

  /** Turns a direction of the scene into the surface's coordinates, in place. */
  directionToSurface(direction: Vector3): Vector3 {
    return direction.applyQuaternion(this.#back);
  }

  /** A plane of the surface in the scene, as three.js has it: with what is left above it. */
  planeOf({ normal, offset }: SectionPlane): Plane {
    const direction = new Vector3(...normal);
    const point = this.toScene(direction.clone().multiplyScalar(offset));
    return new Plane().setFromNormalAndCoplanarPoint(
      this.directionToScene(direction).negate(),
      point,
    );
  }

  /** A point of the surface in the scene's coordinates; a new vector. */
  toScene(point: Vector3): Vector3 {
    return point.clone().applyMatrix4(this.group.matrixWorld);
  }

  /** Turns a point of the scene into the surface's coordinates, in place. */
  toSurface(point: Vector3): Vector3 {
    return point.sub(this.group.position).divide(this.group.scale).applyQuaternion(this.#back);
  }
}
