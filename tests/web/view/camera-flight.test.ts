import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { bestDirection, eased, viewBetween } from '../../../web/src/view/camera-flight.js';
import type { CameraView } from '../../../web/src/view/camera-view.js';

const from: CameraView = { polar: 1, azimuth: 3, distance: 8, target: [0, 0, 0] };
const to: CameraView = { polar: 2, azimuth: -3, distance: 2, target: [1, -1, 2] };

test('a flight begins and ends where it should, slowly', () => {
  expect(viewBetween(from, to, 0)).toEqual({ ...from, distance: expect.closeTo(8) as number });
  const end = viewBetween(from, to, 1);
  expect(end.polar).toBe(2);
  expect(end.distance).toBeCloseTo(2);
  expect(end.target).toEqual([1, -1, 2]);
  expect([eased(-1), eased(0), eased(0.5), eased(1), eased(9)]).toEqual([0, 0, 0.5, 1, 1]);
  expect(eased(0.01)).toBeLessThan(0.001);
});

test('it turns the shorter way and comes nearer by equal factors', () => {
  const half = viewBetween(from, to, 0.5);
  expect(Math.cos(half.azimuth)).toBeCloseTo(-1);
  expect(half.distance).toBeCloseTo(4);
});

test('a place that is seen is looked at from where one is', () => {
  const present = new Vector3(0, 0, 1);
  expect(bestDirection(present, new Vector3(1, 0, 0), () => 1)).toBe(present);
});

test('a place that is hidden is looked at from where it is seen, outwards if that will do', () => {
  const present = new Vector3(0, 0, 1);
  const outwards = new Vector3(-1, 0, 0);
  const behind = ({ z }: Vector3): number => (z < 0 ? 1 : 0);
  expect(bestDirection(present, undefined, behind).z).toBeLessThan(0);
  const only = (direction: Vector3): number => (direction === outwards ? 1 : 0);
  expect(bestDirection(present, outwards, only)).toBe(outwards);
});

test('rather from above than from below the ground', () => {
  const below = new Vector3(0, -1, 0);
  expect(bestDirection(below, undefined, () => 1).y).toBeGreaterThan(-0.2);
});
