// The view that a surface fills.

import { PerspectiveCamera, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { homeDirection, placeCamera } from '../../../web/src/view/camera-view.js';
import { fittedView, turned, type Points } from '../../../web/src/view/fitted-view.js';

const room = { across: 0.3, up: 0.2 };
const of =
  (...places: [number, number, number][]): Points =>
  (see) =>
    places.forEach((place) => see(...place));

/** Where points are in a picture of that room, from −1 to 1 in both directions. */
function seen(points: [number, number, number][], view: ReturnType<typeof fittedView>) {
  const camera = new PerspectiveCamera((360 / Math.PI) * Math.atan(room.up), room.across / room.up);
  placeCamera(camera, view);
  camera.updateMatrixWorld();
  return points.map((point) => new Vector3(...point).project(camera));
}

test('an upright rod: its height decides, from the front', () => {
  const rod: [number, number, number][] = [
    [0.3, -1, 0],
    [0.3, 1, 0],
  ];
  const { distance, target } = fittedView(of(...rod), { polar: Math.PI / 2, azimuth: 0 }, room);
  expect(distance).toBeCloseTo(1 / (0.9 * room.up), 10);
  expect(target[0]).toBeCloseTo(0.3, 10);
});

test('every point is seen, and the picture is filled', () => {
  const points: [number, number, number][] = [
    [0.1, -0.9, 0.2],
    [0.7, 0.1, -0.3],
    [-0.2, 0.4, 0.6],
    [0.5, 0.8, 0.1],
  ];
  const places = seen(points, fittedView(of(...points), homeDirection, room));
  for (const { x, y } of places) {
    expect(Math.abs(x)).toBeLessThan(0.84 + 1e-9);
    expect(Math.abs(y)).toBeLessThan(0.9 + 1e-9);
  }
  const [x, y] = [places.map((place) => place.x), places.map((place) => place.y)];
  const fills = [x, y].map((along) => Math.max(...along) - Math.min(...along));
  expect(Math.max(fills[0]! / 0.84, fills[1]! / 0.9)).toBeCloseTo(2, 9);
});

test('a surface that turns is seen from all sides', () => {
  const points: [number, number, number][] = [
    [0.9, -0.2, 0],
    [-0.1, 0.5, 0.3],
    [0, 0.2, -0.6],
  ];
  const view = fittedView(turned(of(...points)), homeDirection, room);
  for (let k = 0; k < 36; ++k) {
    const azimuth = (2 * Math.PI * k) / 36;
    for (const { x, y } of seen(points, { ...view, azimuth })) {
      expect(Math.max(Math.abs(x), Math.abs(y))).toBeLessThan(0.92);
    }
  }
});
