import { smoothUnion, tube } from '../implicit.ts';
import { Tube, type Station } from '../tube.ts';
import type { Model } from './model.ts';

// Where a vessel forks, the cross-sections of the branches add up to that of the stem, as they do, more
// or less, in arteries.
const stem = 0.019;
const [left, right] = fork(stem, 0.62);
const [leftUp, leftOut] = fork(left, 0.7);
const [rightUp, rightOut] = fork(right, 0.68);
const [twigUp, twigOut] = fork(leftUp, 0.62);

/** Radii of two branches of which the first takes `share` of the cross-section. */
function fork(radius: number, share: number): [number, number] {
  return [radius * Math.sqrt(share), radius * Math.sqrt(1 - share)];
}

const branches: Station[][] = [
  [
    [0.012, 0.0195, 0.006, stem],
    [0.004, 0.06, 0.002, stem],
    [0, 0.1, 0, stem],
    [-0.02, 0.142, 0.006, left],
    [-0.042, 0.178, 0.014, left],
    [-0.05, 0.215, 0.012, leftUp],
    [-0.044, 0.25, 0, leftUp],
    [-0.026, 0.285, -0.014, twigUp],
    [-0.018, 0.322, -0.02, twigUp],
    [-0.022, 0.355, -0.022, twigUp],
  ],
  [
    [0.001, 0.09, 0, 0.9 * right],
    [0.016, 0.128, -0.008, right],
    [0.044, 0.16, -0.022, right],
    [0.068, 0.195, -0.028, rightUp],
    [0.076, 0.238, -0.02, rightUp],
    [0.068, 0.278, -0.004, rightUp],
    [0.066, 0.31, 0.012, rightUp],
  ],
  [
    [-0.036, 0.168, 0.012, 0.9 * leftOut],
    [-0.064, 0.19, 0.034, leftOut],
    [-0.094, 0.212, 0.05, leftOut],
    [-0.112, 0.245, 0.052, leftOut],
    [-0.118, 0.285, 0.042, leftOut],
  ],
  [
    [-0.047, 0.24, 0.004, 0.9 * twigOut],
    [-0.06, 0.272, -0.014, twigOut],
    [-0.078, 0.3, -0.034, twigOut],
    [-0.086, 0.336, -0.046, twigOut],
  ],
  [
    [0.05, 0.165, -0.024, 0.9 * rightOut],
    [0.082, 0.178, -0.044, rightOut],
    [0.112, 0.196, -0.056, rightOut],
    [0.132, 0.228, -0.056, rightOut],
    [0.138, 0.262, -0.046, rightOut],
  ],
];

const [first, ...others] = branches.map((stations) => tube(new Tube(stations)));

export const vessel: Model = {
  name: 'vessel',
  title: 'Vessel',
  about: 'The girth follows the calibre from the stem to the twigs and drops at every fork.',
  genus: 0,
  faces: 8000,
  solid: smoothUnion(0.014, first!, ...others),
  box: { min: [-0.14, -0.01, -0.075], max: [0.16, 0.375, 0.075] },
  cell: 0.00225,
};
