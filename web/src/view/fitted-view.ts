// The view from which a surface fills the picture: what is really seen of it, not the ball round it.
//
// A camera at distance D along the unit direction d from its target sees a point p within the half angle whose
// tangent is h where |(p − target)·right| ≤ h (D − p·d). This condition is linear in D and in the target's place along
// `right`, so the nearest such camera follows from the greatest values of ±p·right + h p·d, and likewise upwards.
// Linear in the points.

import { Vector3 } from 'three';
import type { CameraView, Direction } from './camera-view.js';

/** Tangents of the half angles that are free for the surface. */
export interface Room {
  across: number;
  up: number;
}

/** Calls back with each point, in the scene's coordinates. */
export type Points = (see: (x: number, y: number, z: number) => void) => void;

/** Shares of the room that the surface fills; at its sides are the legend and the bar. */
const filled = { across: 0.84, up: 0.9 };
/** Heights at which the outline of a turning surface is kept. */
const levels = 128;
/** Directions into which a turning surface is seen. */
const azimuths = 24;

/** Looks from a direction so that all points are seen, and no farther away than that takes. */
export function fittedView(points: Points, { polar, azimuth }: Direction, room: Room): CameraView {
  const towards = new Vector3().setFromSphericalCoords(1, polar, azimuth);
  const right = new Vector3(Math.cos(azimuth), 0, -Math.sin(azimuth));
  const up = towards.clone().cross(right);
  const [across, upwards] = [filled.across * room.across, filled.up * room.up];
  // The most on each of the four sides: right, left, top, bottom.
  const most = [-Infinity, -Infinity, -Infinity, -Infinity];
  points((x, y, z) => {
    const near = x * towards.x + y * towards.y + z * towards.z;
    const aside = x * right.x + y * right.y + z * right.z;
    const above = x * up.x + y * up.y + z * up.z;
    most[0] = Math.max(most[0]!, across * near + aside);
    most[1] = Math.max(most[1]!, across * near - aside);
    most[2] = Math.max(most[2]!, upwards * near + above);
    most[3] = Math.max(most[3]!, upwards * near - above);
  });
  const [first = 0, second = 0, third = 0, fourth = 0] = most;
  const distance = Math.max((first + second) / (2 * across), (third + fourth) / (2 * upwards));
  const target = right
    .multiplyScalar((first - second) / 2)
    .addScaledVector(up, (third - fourth) / 2);
  return { polar, azimuth, distance, target: target.toArray() };
}

/** The outline of a surface that turns about the vertical axis: its widest circles. */
export function turned(points: Points): Points {
  const widest = new Float64Array(levels).fill(-1);
  const lowest = new Float64Array(levels).fill(Infinity);
  const highest = new Float64Array(levels).fill(-Infinity);
  points((x, y, z) => {
    const level = Math.min(levels - 1, Math.max(0, Math.floor(((y + 1) / 2) * levels)));
    widest[level] = Math.max(widest[level]!, Math.hypot(x, z));
    lowest[level] = Math.min(lowest[level]!, y);
    highest[level] = Math.max(highest[level]!, y);
  });
  return (see) => {
    for (let level = 0; level < levels; ++level) {
      if (widest[level]! < 0) continue;
      for (let k = 0; k < azimuths; ++k) {
        const angle = (2 * Math.PI * k) / azimuths;
        const [x, z] = [widest[level]! * Math.cos(angle), widest[level]! * Math.sin(angle)];
        see(x, lowest[level]!, z);
        see(x, highest[level]!, z);
      }
    }
  };
}
