// The shadow on the ground under a model, made in slices of time.

import type { Mesh } from '../kernel/types.js';
import { GroundShadow, type Surface, inSlices, splatShadow } from '../view/index.js';

export async function groundUnder(
  mesh: Mesh,
  { bounds }: Surface,
  signal: AbortSignal,
): Promise<GroundShadow> {
  const { positions, indices } = mesh.geometry;
  const { center, radius } = bounds;
  let [ground, top] = [Infinity, -Infinity];
  for (let i = 1; i < positions.length; i += 3) {
    ground = Math.min(ground, positions[i]!);
    top = Math.max(top, positions[i]!);
  }
  const halfWidth = 1.5 * radius;
  const grid = await inSlices(
    splatShadow(positions, indices, [center.x, center.z], ground, halfWidth, top - ground),
    signal,
  );
  return new GroundShadow(grid, bounds, ground, halfWidth);
}
