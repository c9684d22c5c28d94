// The shadow on the ground under a model that stands upright, made in slices of time.

import {
  GroundShadow,
  type Rotation,
  type Surface,
  inSlices,
  splatShadow,
  uprightPositions,
} from '../../view/index.js';
import type { Mesh } from '../../kernel/types/types.js';

export async function groundUnder(
  mesh: Mesh,
  { bounds }: Surface,
  upright: Rotation,
  signal: AbortSignal,
): Promise<GroundShadow> {
  const { indices } = mesh.geometry;
  const positions = uprightPositions(mesh.geometry.positions, upright);
  const { radius } = bounds;
  const centre = bounds.center.clone().applyQuaternion(upright);
  let [ground, top] = [Infinity, -Infinity];
  for (let i = 1; i < positions.length; i += 3) {
    ground = Math.min(ground, positions[i]!);
    top = Math.max(top, positions[i]!);
  }
  const halfWidth = 1.5 * radius;
  const grid = await inSlices(
    splatShadow(positions, indices, [centre.x, centre.z], ground, halfWidth, top - ground),
    signal,
  );
  return new GroundShadow(grid, centre.setY(ground - 0.004 * radius), upright, halfWidth);
}
