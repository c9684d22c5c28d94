import { ellipsoid, smoothUnion, tube } from '../implicit.ts';
import { Tube } from '../tube.ts';
import type { Model } from './model.ts';

// A piece of a dendrite, enlarged some hundred thousand times. Its shaft is thickest in the middle, so that it has no
// neck of its own; a spine like a mushroom stands on a thin neck, a stubby one has none.
const shaft = tube(
  new Tube([
    [-0.15, 0.05, 0, 0.041],
    [0, 0.052, 0.004, 0.051],
    [0.15, 0.05, 0, 0.04],
  ]),
);
const neck = tube(
  new Tube([
    [0.03, 0.075, 0, 0.016],
    [0.034, 0.115, 0.002, 0.0125],
    [0.042, 0.155, 0.002, 0.0115],
    [0.046, 0.19, 0, 0.016],
  ]),
);
const head = ellipsoid([0.046, 0.2, 0], [0.046, 0.034, 0.042]);
const stub = tube(
  new Tube([
    [-0.085, 0.07, 0.01, 0.03],
    [-0.09, 0.105, 0.014, 0.027],
  ]),
);

export const spine: Model = {
  name: 'spine',
  title: 'Spine',
  about:
    'A piece of a dendrite: the band is shortest on the neck that carries the mushroom’s head; the stub has no neck.',
  genus: 0,
  faces: 3200,
  solid: smoothUnion(0.02, shaft, neck, head, stub),
  box: { min: [-0.22, -0.02, -0.07], max: [0.22, 0.26, 0.07] },
  cell: 0.004,
};
