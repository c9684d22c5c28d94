// From one view of a surface to another, and from where a place of it is best seen.

import { Vector3 } from 'three';
import type { CameraView } from './camera-view.js';

/** Slow at both ends. */
export function eased(time: number): number {
  const t = Math.min(1, Math.max(0, time));
  return t * t * (3 - 2 * t);
}

/** The view at a share of the way; the camera turns the shorter way round. */
export function viewBetween(from: CameraView, to: CameraView, share: number): CameraView {
  const mix = (a: number, b: number): number => a + (b - a) * share;
  const turn = Math.atan2(Math.sin(to.azimuth - from.azimuth), Math.cos(to.azimuth - from.azimuth));
  return {
    polar: mix(from.polar, to.polar),
    azimuth: from.azimuth + turn * share,
    // By equal factors: coming nearer looks even.
    distance: Math.exp(mix(Math.log(from.distance), Math.log(to.distance))),
    target: from.target.map((x, i) => mix(x, to.target[i]!)) as [number, number, number],
  };
}

/** Directions spread evenly over the sphere (a Fibonacci lattice), away from straight up and down. */
function* directions(count: number): Generator<Vector3> {
  const golden = Math.PI * (3 - Math.sqrt(5));
  for (let i = 0; i < count; ++i) {
    const y = 0.92 * (1 - (2 * i + 1) / count);
    const across = Math.sqrt(1 - y * y);
    yield new Vector3(across * Math.cos(golden * i), y, across * Math.sin(golden * i));
  }
}

/**
 * The direction from a place towards an eye that sees most of it and is, of those that see as much, the
 * nearest to the present one. `seen` is the share of the place, in [0, 1], that can be seen from a direction.
 */
export function bestDirection(
  present: Vector3,
  outwards: Vector3 | undefined,
  seen: (direction: Vector3) => number,
): Vector3 {
  let best = present;
  let most = -Infinity;
  const offer = (direction: Vector3): void => {
    // Turning round counts as a fifth of the place out of sight, looking up from the ground as more.
    const fromBelow = Math.max(0, -direction.y);
    const worth = seen(direction) + 0.1 * direction.dot(present) - 0.4 * fromBelow;
    if (worth > most + 1e-9) [best, most] = [direction, worth];
  };
  offer(present);
  if (outwards) offer(outwards);
  for (const direction of directions(48)) offer(direction);
  return best;
}
