// A plane that cuts a surface: what lies in front of it is neither drawn nor picked. It is fetched when it is first asked
// for, and so it brings nothing with it.

import type { Ray, Vector3 } from 'three';

/** x, y and z. */
type Numbers = readonly [number, number, number];

const along = ([x, y, z]: Numbers, point: Vector3): number =>
  x * point.x + y * point.y + z * point.z;

export class SectionPlane {
  /** Towards what is cut away; of length 1, in the surface's coordinates. */
  readonly normal: Numbers;
  /** How far along the normal the plane is. */
  readonly offset: number;

  constructor(normal: Numbers, offset: number) {
    this.normal = normal;
    this.offset = offset;
  }

  /** Whether a point is cut away. */
  cuts(point: Vector3): boolean {
    return along(this.normal, point) > this.offset;
  }

  /** From where to where a ray is in what is left, by its own length; the first is beyond the second where it never is. */
  reach({ origin, direction }: Ray): [near: number, far: number] {
    const above = along(this.normal, origin) - this.offset;
    const slope = along(this.normal, direction);
    if (slope === 0) return above > 0 ? [0, -1] : [0, Infinity];
    const crossing = -above / slope;
    return slope < 0 ? [Math.max(0, crossing), Infinity] : [0, crossing];
  }
}

/** The plane that leaves so large a share of a surface's extent along a direction, which is not 0. */
export function sectionAcross(
  surface: { eachPosition(see: (x: number, y: number, z: number) => void): void },
  direction: Numbers,
  share: number,
): SectionPlane {
  const length = Math.hypot(...direction);
  const [a, b, c] = direction.map((part) => part / length) as [number, number, number];
  let [low, high] = [Infinity, -Infinity];
  surface.eachPosition((x, y, z) => {
    const place = a * x + b * y + c * z;
    if (place < low) low = place;
    if (place > high) high = place;
  });
  return new SectionPlane([a, b, c], low + share * (high - low));
}
