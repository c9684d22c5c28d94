import { smoothUnion, sphere, tube } from '../implicit.ts';
import { Tube } from '../tube.ts';
import type { Model } from './model.ts';

const large = sphere([-0.13, 0.1, 0], 0.1);
const small = sphere([0.16, 0.1, 0], 0.075);
const neck = tube(
  new Tube([
    [-0.1, 0.1, 0, 0.026],
    [0.035, 0.1, 0, 0.021],
    [0.13, 0.1, 0, 0.026],
  ]),
);

export const dumbbell: Model = {
  name: 'dumbbell',
  title: 'Dumbbell',
  about:
    'Round the neck the band is short; on the balls it either slips to the neck or spans the whole shape.',
  genus: 0,
  faces: 3200,
  solid: smoothUnion(0.05, large, small, neck),
  box: { min: [-0.25, -0.02, -0.12], max: [0.255, 0.22, 0.12] },
  cell: 0.004,
};
