// Where a surface is in the scene: of radius 1 round the origin, so that the camera, its limits and the
// shaders' 32-bit numbers meet the same sizes whether a file counts in micrometres or in kilometres.

import { Group, type Sphere, type Vector3 } from 'three';

/** The surface's own coordinates within the scene's. */
export class SurfaceSpace {
  /** What is added here is in the surface's coordinates. */
  readonly group = new Group();

  /** The space of a surface with these bounds. */
  fit({ center, radius }: Sphere): void {
    this.group.scale.setScalar(1 / radius);
    this.group.position.copy(center).divideScalar(-radius);
    this.group.updateMatrixWorld();
  }

  /** A point of the surface in the scene's coordinates; a new vector. */
  toScene(point: Vector3): Vector3 {
    return point.clone().applyMatrix4(this.group.matrixWorld);
  }

  /** Turns a point of the scene into the surface's coordinates, in place. */
  toSurface(point: Vector3): Vector3 {
    return point.sub(this.group.position).divide(this.group.scale);
  }
}
