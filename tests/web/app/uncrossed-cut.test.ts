import { expect, test } from 'vitest';
import { GirthError } from '../../../web/src/kernel/types/errors.js';
import type { Cut, SurfacePoint } from '../../../web/src/kernel/index.js';
import { cutUncrossed } from '../../../web/app/panels/necks/uncrossed-cut.js';

/** Curves stand for intervals, [from, to]; two cross where each has just one end of the other inside. */
const cross = ([a, b]: SurfacePoint[], [c, d]: SurfacePoint[]): boolean =>
  (a! < c! && c! < b! && b! < d!) || (c! < a! && a! < d! && d! < b!);
const fault = (code: 'INVALID_OPTION' | 'CANCELLED'): GirthError =>
  new GirthError({ code, element: -1, message: 'refused', hint: '' });
let cuts = 0;
const cutAlong = (curves: SurfacePoint[][]): Promise<Cut> => {
  ++cuts;
  const isCrossed = curves.some((one, i) => curves.slice(0, i).some((other) => cross(one, other)));
  if (isCrossed || curves.some(([a, b]) => a === b)) {
    return Promise.reject(fault('INVALID_OPTION'));
  }
  return Promise.resolve({ parts: curves.map(() => ({})) } as unknown as Cut);
};

test('of curves that cross those count that come first, whatever crosses what', async () => {
  let state = 1;
  const random = (below: number): number => {
    state = (state * 48271) % 2147483647;
    return state % below;
  };
  for (let round = 0; round < 200; ++round) {
    const curves = Array.from({ length: 1 + random(12) }, () => {
      const from = random(20);
      return [from, from + 1 + random(20)];
    });
    // One after the other, each beside those that are kept.
    const greedy: number[] = [];
    curves.forEach((curve, i) => {
      if (greedy.every((kept) => !cross(curves[kept]!, curve))) greedy.push(i);
    });
    const { used, cut } = await cutUncrossed(curves, cutAlong);
    expect(used).toEqual(greedy);
    expect(cut.parts.length).toBe(greedy.length);
  }
});

test('without crossings it is one cut; one curve that crosses itself, and other faults, are faults', async () => {
  cuts = 0;
  expect((await cutUncrossed([[0, 1], [2, 3], [4, 5]], cutAlong)).used).toEqual([0, 1, 2]); // oxfmt-ignore
  expect(cuts).toBe(1);
  await expect(cutUncrossed([[1, 1]], cutAlong)).rejects.toMatchObject({ code: 'INVALID_OPTION' });
  const broken = (): Promise<Cut> => Promise.reject(fault('CANCELLED'));
  await expect(cutUncrossed([[0, 1], [2, 3]], broken)).rejects.toMatchObject({ code: 'CANCELLED' }); // oxfmt-ignore
});
