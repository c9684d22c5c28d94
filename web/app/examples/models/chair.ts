import { mirrored, plate, smoothMin, smoothUnion, tube, type Implicit } from '../implicit.ts';
import { Tube, type Station } from '../tube.ts';
import type { Model } from './model.ts';

// The chair looks along z. Parts with x > 0 stand for both sides.

/** Rounded, wider in front than at the back. */
function seatOutline(x: number, z: number): number {
  const corner = 0.1;
  const u = Math.abs(x) / (1 + 0.35 * z) - (0.215 - corner);
  const w = Math.abs(z) - (0.205 - corner);
  return Math.hypot(Math.max(u, 0), Math.max(w, 0)) + Math.min(Math.max(u, w), 0) - corner;
}

/** Hollowed a little for sitting, more towards the back. */
function seatHeight(x: number, z: number): number {
  return 0.45 - 0.016 * Math.exp(-((x / 0.15) ** 2 + ((z + 0.03) / 0.14) ** 2));
}

const seat = plate(seatOutline, seatHeight, 0.034);

const round = (...stations: Station[]): Implicit => tube(new Tube(stations));

const frontLeg = round(
  [0.14, 0.442, 0.13, 0.0196],
  [0.158, 0.32, 0.151, 0.0236],
  [0.178, 0.17, 0.174, 0.0218],
  [0.198, 0.014, 0.198, 0.0149],
);
const backLeg = round(
  [0.12, 0.442, -0.13, 0.0196],
  [0.136, 0.32, -0.154, 0.0236],
  [0.154, 0.17, -0.183, 0.0218],
  [0.174, 0.014, -0.216, 0.0149],
);
const sideBar = round(
  [0.178, 0.175, 0.173, 0.0126],
  [0.17, 0.175, -0.005, 0.0167],
  [0.153, 0.175, -0.182, 0.0126],
);
const crossBar = round(
  [0.172, 0.175, -0.005, 0.0126],
  [0, 0.175, -0.005, 0.0167],
  [-0.172, 0.175, -0.005, 0.0126],
);

const post = round(
  [0.158, 0.44, -0.152, 0.0184],
  [0.168, 0.56, -0.176, 0.019],
  [0.184, 0.72, -0.218, 0.0172],
  [0.198, 0.85, -0.262, 0.0167],
);
const spindle = (share: number): Implicit =>
  round(
    [0.15 * share, 0.44, -0.152 - 0.022 * (1 - share * share), 0.0132],
    [0.162 * share, 0.6, -0.19 - 0.024 * (1 - share * share), 0.0149],
    [0.176 * share, 0.76, -0.236 - 0.025 * (1 - share * share), 0.0132],
    [0.184 * share, 0.85, -0.262 - 0.026 * (1 - share * share), 0.0121],
  );

/** The top rail: a bent bar, drawn out upwards by this much to either side. */
const railHalfHeight = 0.022;
const bar = round(
  [-0.222, 0, -0.254, 0.014],
  [-0.12, 0, -0.279, 0.0165],
  [0, 0, -0.288, 0.0175],
  [0.12, 0, -0.279, 0.0165],
  [0.222, 0, -0.254, 0.014],
);
const rail: Implicit = (x, y, z) => {
  const up = y - 0.862 + 0.5 * x * x;
  return bar(x, Math.max(Math.abs(up) - railHalfHeight, 0), z + 0.25 * up);
};

const sides = mirrored(0.02, smoothUnion(0.02, frontLeg, backLeg, sideBar, post, spindle(0.5)));
const middle = smoothUnion(0.02, crossBar, spindle(0));

export const chair: Model = {
  name: 'chair',
  title: 'Chair',
  about: 'Legs and bars stand out by their small girth, the seat plate by bands round its rim.',
  genus: 7,
  faces: 10000,
  solid: (x, y, z) => {
    const frame = smoothMin(sides(x, y, z), middle(x, y, z), 0.02);
    return smoothMin(smoothMin(frame, rail(x, y, z), 0.02), seat(x, y, z), 0.025);
  },
  box: { min: [-0.27, -0.02, -0.34], max: [0.27, 0.95, 0.26] },
  cell: 0.00525,
};
