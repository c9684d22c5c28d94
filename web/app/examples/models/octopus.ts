import { ellipsoid, smoothMin, smoothUnion, sphere, tube, type Implicit } from '../implicit.ts';
import { Tube, type Station } from '../tube.ts';
import type { Model } from './model.ts';

/** One arm: a curve over the ground whose heading turns, ever faster towards the tip. */
interface Arm {
  /** Heading at the body, in degrees from the x axis towards the z axis; z is where the eyes look. */
  heading: number;
  length: number;
  /** How far the heading swings to one side on the way, in degrees. */
  sway: number;
  /** How far the tip curls, in degrees; negative to the other side. */
  curl: number;
  /** How high the tip is lifted. */
  lift: number;
}

const arms: Arm[] = [
  { heading: 24, length: 0.4, sway: -24, curl: 320, lift: 0.01 },
  { heading: 66, length: 0.36, sway: 14, curl: -300, lift: 0.05 },
  { heading: 114, length: 0.38, sway: -14, curl: 280, lift: 0 },
  { heading: 156, length: 0.41, sway: -20, curl: -330, lift: 0.02 },
  { heading: 202, length: 0.37, sway: -26, curl: 300, lift: 0.06 },
  { heading: 247, length: 0.4, sway: 18, curl: -250, lift: 0 },
  { heading: 291, length: 0.38, sway: -18, curl: -280, lift: 0.01 },
  { heading: 336, length: 0.37, sway: 22, curl: -310, lift: 0.05 },
];

const root = 0.03;
const tip = 0.0095;
const steps = 28;

function arm({ heading, length, sway, curl, lift }: Arm): Implicit {
  const stations: Station[] = [];
  let x = 0.04 * Math.cos((heading * Math.PI) / 180);
  let z = 0.04 * Math.sin((heading * Math.PI) / 180);
  for (let i = 0; i <= steps; ++i) {
    const t = i / steps;
    const radius = tip + (root - tip) * (1 - t) ** 1.15;
    const y =
      radius + 0.075 * Math.max(1 - t / 0.42, 0) ** 2 + lift * smoothStep((t - 0.45) / 0.55);
    stations.push([x, y, z, radius]);
    const degrees =
      heading + sway * Math.sin(1.6 * Math.PI * t) + curl * Math.max((t - 0.4) / 0.6, 0) ** 2.4;
    x += (length / steps) * Math.cos((degrees * Math.PI) / 180);
    z += (length / steps) * Math.sin((degrees * Math.PI) / 180);
  }
  return tube(new Tube(stations.filter((_, i) => i % 2 === 0)));
}

function smoothStep(t: number): number {
  const s = Math.min(Math.max(t, 0), 1);
  return s * s * (3 - 2 * s);
}

/** Body upright and leaning back, drawn in its own axes. */
const lean = 0.6;
const mantle = ellipsoid([0, 0.095, 0], [0.084, 0.118, 0.082]);
const leaning: Implicit = (x, y, z) => {
  const u = y - 0.125;
  const w = z + 0.005;
  return mantle(
    x,
    u * Math.cos(lean) - w * Math.sin(lean),
    w * Math.cos(lean) + u * Math.sin(lean),
  );
};
const head = ellipsoid([0, 0.105, 0.01], [0.058, 0.05, 0.055]);
const body = smoothUnion(0.05, leaning, head);
const limbs = smoothUnion(0.022, arm(arms[0]!), ...arms.slice(1).map(arm));
const eyes = smoothUnion(
  0.004,
  sphere([0.043, 0.148, 0.046], 0.019),
  sphere([-0.043, 0.148, 0.046], 0.019),
);

export const octopus: Model = {
  name: 'octopus',
  title: 'Octopus',
  about:
    'Along an arm the band shrinks towards the tip, and the field jumps where it would slip off.',
  genus: 0,
  faces: 10000,
  solid: (x, y, z) =>
    smoothMin(smoothMin(body(x, y, z), limbs(x, y, z), 0.045), eyes(x, y, z), 0.012),
  box: { min: [-0.42, -0.012, -0.42], max: [0.42, 0.36, 0.42] },
  cell: 0.004,
};
