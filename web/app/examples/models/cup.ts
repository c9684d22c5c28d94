import { smoothMin, tube, type Implicit } from '../implicit.ts';
import { Tube, type Station } from '../tube.ts';
import type { Model } from './model.ts';

const wall = 0.0056;
const height = 0.096;
const corner = 0.014;

/** Radius of the middle of the wall at a height: a slight belly and a slightly open rim. */
function wallRadius(y: number): number {
  const t = y / height;
  return 0.0385 + 0.004 * Math.sin(Math.PI * (0.1 + 0.75 * t)) + 0.002 * t * t;
}

/** The middle of floor and wall as a curve in the plane through the axis, with the thickness along it. */
function profile(): Station[] {
  const floor = wall / 2 + 0.0006;
  const turning = wallRadius(floor + corner) - corner;
  const stations: Station[] = [];
  for (const r of [-0.02, -0.01, 0, 0.01, 0.018]) stations.push([r, floor, 0, wall / 2 + 0.0006]);
  for (let i = 0; i <= 3; ++i) {
    const angle = (i / 3) * (Math.PI / 2);
    const r = turning + corner * Math.sin(angle);
    stations.push([r, floor + corner * (1 - Math.cos(angle)), 0, wall / 2 + 0.0006 - 0.0002 * i]);
  }
  for (const share of [0.3, 0.45, 0.6, 0.75, 0.88, 1]) {
    const y = share * height - wall / 2;
    stations.push([wallRadius(y), y, 0, wall / 2]);
  }
  return stations;
}

const walls = tube(new Tube(profile()));

const ear = tube(
  new Tube([
    [0.036, 0.077, 0, 0.0062],
    [0.05, 0.08, 0, 0.0054],
    [0.064, 0.077, 0, 0.005],
    [0.0725, 0.064, 0, 0.0048],
    [0.0715, 0.046, 0, 0.0048],
    [0.061, 0.03, 0, 0.005],
    [0.048, 0.0225, 0, 0.0055],
    [0.036, 0.02, 0, 0.0062],
  ]),
);

/** How much wider the ear is than thick. */
const width = 1.35;

const mug: Implicit = (x, y, z) => {
  const r = Math.hypot(x, z);
  // The ear ends in the middle of the wall, so that it does not come out inside.
  const outside = Math.max(ear(x, y, z / width), wallRadius(y) - r);
  return smoothMin(walls(r, y, 0), outside, 0.009);
};

export const cup: Model = {
  name: 'cup',
  title: 'Cup',
  about: 'The ear has a short girth all along, and even from the wall the band hooks round it.',
  genus: 1,
  faces: 5000,
  solid: mug,
  box: { min: [-0.052, -0.006, -0.052], max: [0.086, 0.104, 0.052] },
  cell: 0.00135,
};
