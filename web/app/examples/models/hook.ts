import { plate, smoothUnion, sphere, tube } from '../implicit.ts';
import { Tube } from '../tube.ts';
import type { Model } from './model.ts';

// A hook to be printed, as large as a thumb. Its arm is thinnest just above the foot, where the load bends it most.
const foot = plate(
  (x, z) => Math.hypot(x, z) - 0.022,
  () => 0.003,
  0.006,
);
const arm = tube(
  new Tube([
    [0, 0.0085, 0, 0.0056],
    [0, 0.015, 0, 0.0036],
    [0, 0.023, 0, 0.0046],
    [0, 0.032, 0, 0.0051],
    [0.001, 0.041, 0, 0.0055],
    [0.009, 0.051, 0, 0.0059],
    [0.021, 0.053, 0, 0.0063],
    [0.031, 0.045, 0, 0.0066],
    [0.034, 0.034, 0, 0.0069],
  ]),
);
const end = sphere([0.034, 0.032, 0], 0.0082);

export const hook: Model = {
  name: 'hook',
  title: 'Hook',
  about: 'A part to be printed: the shortest band is where the arm is thinnest, and would break.',
  genus: 0,
  faces: 3200,
  solid: smoothUnion(0.005, foot, arm, end),
  box: { min: [-0.025, -0.003, -0.025], max: [0.045, 0.063, 0.025] },
  cell: 0.0011,
};
