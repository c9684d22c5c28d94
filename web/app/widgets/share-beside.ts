// How narrow a narrow place is, as a share of the girth beside it.

import type { LoopKind } from '../../src/kernel/index.js';

/** '50% of the girth beside it'. */
export const shareWords = (share: number): string =>
  `${Math.round(100 * share)}% of the girth beside it`;

/**
 * The least girth along a way as a share of the girth beside it: of the greatest on either side, the lesser. Undefined
 * where it is at an end of the way, or less than 1% is missing.
 */
export function shareBeside(
  stations: readonly { girth: number; kind: LoopKind }[],
): number | undefined {
  const girths = stations.filter(({ kind }) => kind === 'loop').map(({ girth }) => girth);
  const least = Math.min(...girths);
  const at = girths.indexOf(least);
  const beside = Math.min(Math.max(...girths.slice(0, at)), Math.max(...girths.slice(at + 1)));
  const share = least / beside;
  return share > 0 && share < 0.99 ? share : undefined;
}
