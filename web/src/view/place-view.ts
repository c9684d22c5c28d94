// From where a place of a surface is seen well, with what is round it.

import { Sphere, type Vector3 } from 'three';
import { bestDirection } from './camera-flight.js';
import { type CameraView, anglesOf, wholeDistance } from './camera-view.js';
import type { SurfaceSpace } from './surface-space.js';

/** The least reach that is seen round a small place, in radii of the surface. */
const leastReach = 0.28;
/** So many of a place's points are tested for being hidden. */
const sightings = 14;

/** A place of a surface to look at, in the surface's coordinates. */
export interface Place {
  points: readonly Vector3[];
  /** From where to look rather, if that is known: the mean normal. */
  outwards?: Vector3 | undefined;
}

/** A surface that can hide a point from an eye, both in the surface's coordinates. */
export interface Hiding {
  hides(point: Vector3, eye: Vector3): boolean;
}

/** The view of a place; `present` is the direction from which the camera looks now. */
export function viewOfPlace(
  { points, outwards }: Place,
  present: Vector3,
  surface: Hiding,
  space: SurfaceSpace,
): CameraView {
  const ball = new Sphere().setFromPoints(points.map((point) => space.toScene(point)));
  const reach = Math.min(1, Math.max(1.35 * ball.radius, leastReach));
  const distance = reach * wholeDistance;
  const step = Math.max(1, Math.floor(points.length / sightings));
  const looked = points.filter((_, i) => i % step === 0);
  const seen = (direction: Vector3): number => {
    const eye = space.toSurface(ball.center.clone().addScaledVector(direction, distance));
    return looked.filter((point) => !surface.hides(point, eye)).length / looked.length;
  };
  const direction = bestDirection(present, outwards && space.directionToScene(outwards), seen);
  return { ...anglesOf(direction), distance, target: ball.center.toArray() };
}
