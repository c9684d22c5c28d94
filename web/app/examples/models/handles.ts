import { ellipsoid, smoothUnion, tube, type Implicit } from '../implicit.ts';
import { Tube, type Station } from '../tube.ts';
import type { Model } from './model.ts';

/** Shape of one handle; angles in radians round the vertical axis. */
interface Handle {
  /** Angles at which the handle leaves the body above and comes back below. */
  upper: number;
  lower: number;
  /** The farthest distance of the handle from the axis. */
  reach: number;
  top: number;
  bottom: number;
  radius: number;
}

function handle({ upper, lower, reach, top, bottom, radius }: Handle): Implicit {
  const station = (share: number, distance: number, y: number, thickness: number): Station => {
    const angle = upper + share * (lower - upper);
    return [distance * Math.cos(angle), y, distance * Math.sin(angle), thickness];
  };
  const drop = top - bottom;
  return tube(
    new Tube([
      station(0, 0.03, top - 0.1 * drop, 1.1 * radius),
      station(0.1, 0.45 * reach, top - 0.02 * drop, 1.05 * radius),
      station(0.3, 0.86 * reach, top - 0.12 * drop, radius),
      station(0.5, reach, top - 0.45 * drop, 0.95 * radius),
      station(0.7, 0.88 * reach, bottom + 0.2 * drop, radius),
      station(0.9, 0.5 * reach, bottom + 0.02 * drop, 1.05 * radius),
      station(1, 0.03, bottom + 0.05 * drop, 1.1 * radius),
    ]),
  );
}

const turn = (2 * Math.PI) / 3;

export const handles: Model = {
  name: 'handles',
  title: 'Three handles',
  about: 'A band cannot leave a handle: each of the three has the girth of its own cross-section.',
  genus: 3,
  faces: 8000,
  solid: smoothUnion(
    0.035,
    ellipsoid([0, 0.15, 0], [0.09, 0.15, 0.09]),
    handle({ upper: 0.3, lower: -0.35, reach: 0.215, top: 0.26, bottom: 0.06, radius: 0.03 }),
    handle({
      upper: turn - 0.3,
      lower: turn + 0.3,
      reach: 0.18,
      top: 0.245,
      bottom: 0.09,
      radius: 0.021,
    }),
    handle({
      upper: -turn - 0.35,
      lower: -turn + 0.3,
      reach: 0.2,
      top: 0.23,
      bottom: 0.04,
      radius: 0.014,
    }),
  ),
  box: { min: [-0.2, -0.02, -0.24], max: [0.28, 0.34, 0.24] },
  cell: 0.0045,
};
