// From where a surface is seen: numbers, whatever its size and place. The scene's unit is the surface's
// radius and its origin the middle of the surface.

import { type PerspectiveCamera, Vector3 } from 'three';
import type { StraightName } from './straight-names.js';

/** From where a surface is seen, which stands upright. */
export interface CameraView {
  /** Angle from straight above, in radians from 0 to π. */
  polar: number;
  /** Angle round the vertical axis from the front to the right, in radians from −π to π. */
  azimuth: number;
  /** From the camera to what it looks at, in radii of the surface. */
  distance: number;
  /** The point that it looks at, from the middle of the surface, in radii of the surface. */
  target: [number, number, number];
}

/** Radians, and shares of the distance, that are rounding. */
const rounding = 1e-9;

/** Whether two views are the same but for rounding. */
export function isSameView(one: CameraView, other: CameraView): boolean {
  const turn = Math.abs(one.azimuth - other.azimuth) % (2 * Math.PI);
  const near = rounding * other.distance;
  return (
    Math.abs(one.polar - other.polar) <= rounding &&
    Math.min(turn, 2 * Math.PI - turn) <= rounding &&
    Math.abs(one.distance - other.distance) <= near &&
    one.target.every((value, axis) => Math.abs(value - other.target[axis]!) <= near)
  );
}

/** Smallest of the two viewing angles, in degrees. */
export const viewingAngle = 28;
/** From how far something is seen whole, in its radii. */
export const wholeDistance = 1.08 / Math.sin((viewingAngle * Math.PI) / 360);

/** From where something is looked at, without how far. */
export type Direction = Pick<CameraView, 'polar' | 'azimuth'>;

/** The standard direction. */
export const homeDirection: Direction = {
  polar: (68 * Math.PI) / 180,
  azimuth: (32 * Math.PI) / 180,
};

/** Straight from the front, from the right and from above. */
export const straightDirections = {
  front: { polar: Math.PI / 2, azimuth: 0 },
  side: { polar: Math.PI / 2, azimuth: Math.PI / 2 },
  top: { polar: 0, azimuth: 0 },
} as const satisfies Record<StraightName, Direction>;

/** The vertical angle, in degrees, with which the standard angle fits into a width and the height. */
export function fovFor(width: number, height: number): number {
  const half = Math.tan((viewingAngle * Math.PI) / 360);
  return (360 / Math.PI) * Math.atan((half * height) / Math.min(width, height));
}

/** The angles of a direction from a target to the camera; `arm` need not have unit length. */
export function anglesOf(arm: Vector3): Pick<CameraView, 'polar' | 'azimuth'> {
  return {
    polar: Math.acos(Math.min(1, Math.max(-1, arm.y / arm.length()))),
    azimuth: Math.atan2(arm.x, arm.z),
  };
}

/** The angle from straight above, kept away from both poles: there the camera has no upright. */
export function keptFromPoles(polar: number): number {
  return Math.min(Math.PI - 0.01, Math.max(0.01, polar));
}

/** Places a camera that has no controls at a view. */
export function placeCamera(camera: PerspectiveCamera, view: CameraView): void {
  const target = new Vector3().fromArray(view.target);
  camera.position.setFromSphericalCoords(view.distance, view.polar, view.azimuth).add(target);
  camera.lookAt(target);
}

/** Brings the nearest and the farthest that a camera draws close to the surface, for the sake of depth. */
export function fitDepth(camera: PerspectiveCamera): void {
  const distance = camera.position.length();
  camera.near = Math.max(0.02, distance - 1.2);
  camera.far = distance + 3;
  camera.updateProjectionMatrix();
}
