// A surface cut along as many of several curves as do not cross: where two cross, the earlier one counts.

import type { Cut, SurfacePoint } from '../../../src/kernel/index.js';

export interface UncrossedCut {
  cut: Cut;
  /** Along which it was cut, by their places among the curves, in rising order. */
  used: number[];
}

/** Cuts: rejected with INVALID_OPTION where curves cross. */
type Cutter = (curves: SurfacePoint[][]) => Promise<Cut>;

/**
 * Cuts along the curves in their order and passes over those that cross one before them. Time: a cut, and for each
 * curve that is passed over twice as many as its place can be halved.
 */
export async function cutUncrossed(
  curves: readonly SurfacePoint[][],
  cutAlong: Cutter,
): Promise<UncrossedCut> {
  const used: number[] = [];
  let cut: Cut | undefined;
  const tryAll = async (from: number, to: number): Promise<void> => {
    const more = Array.from({ length: to - from }, (_, i) => from + i);
    try {
      cut = await cutAlong([...used, ...more].map((i) => curves[i]!));
      used.push(...more);
    } catch (error) {
      const isCrossing =
        error instanceof Error && 'code' in error && error.code === 'INVALID_OPTION';
      // A single one that crosses itself is not passed over: nothing would be cut.
      if (!isCrossing || curves.length === 1) throw error;
      if (more.length === 1) return;
      const middle = (from + to) >> 1;
      await tryAll(from, middle);
      await tryAll(middle, to);
    }
  };
  await tryAll(0, curves.length);
  return { cut: cut ?? (await cutAlong([])), used };
}
