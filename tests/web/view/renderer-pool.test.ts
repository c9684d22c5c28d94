// Stages and the contexts that they draw with, when there are fewer contexts than stages.

import { beforeEach, expect, test, vi } from 'vitest';
import { type Borrower, type Drawer, RendererPool } from '../../../web/src/view/renderer-pool.js';

interface Fake {
  drawer: Drawer;
  dispose: ReturnType<typeof vi.fn>;
  change: (graphics: Drawer['graphics']) => void;
}

let made: Fake[];
let pool: RendererPool;

function fake(changed: (drawer: Drawer) => void): Drawer {
  const dispose = vi.fn();
  const renderer = { dispose, forceContextLoss: () => undefined };
  const drawer = { renderer, canvas: {}, graphics: 'drawing' } as unknown as Drawer;
  const change = (graphics: Drawer['graphics']): void => {
    drawer.graphics = graphics;
    changed(drawer);
  };
  made.push({ drawer, dispose, change });
  return drawer;
}

class Stage implements Borrower {
  isResting = false;
  yielded = 0;
  graphicsChanged = vi.fn();
  yield(): void {
    ++this.yielded;
    pool.giveBack(this);
  }
}

beforeEach(() => {
  made = [];
  pool = new RendererPool(fake, 3);
});

const stages = (count: number): Stage[] => Array.from({ length: count }, () => new Stage());

test('each has its own as long as there are enough, and keeps it', () => {
  const [a, b, c] = stages(3) as [Stage, Stage, Stage];
  const drawers = [a, b, c].map((stage) => pool.lend(stage));
  expect(new Set(drawers).size).toBe(3);
  expect([a, b, c].map((stage) => pool.lend(stage))).toEqual(drawers);
  expect(made).toHaveLength(3);
});

test('a further one takes that of a stage that rests, otherwise of the one that drew longest ago', () => {
  const [a, b, c, d, e] = stages(5) as [Stage, Stage, Stage, Stage, Stage];
  const [first, second] = [a, b, c].map((stage) => pool.lend(stage));
  b.isResting = true;
  expect(pool.lend(d)).toBe(second);
  expect([a, b, c].map(({ yielded }) => yielded)).toEqual([0, 1, 0]);
  pool.lend(c);
  expect(pool.lend(e)).toBe(first);
  expect(a.yielded).toBe(1);
  expect(pool.size).toBe(3);
});

test('checking makes one, which the first stage gets', () => {
  pool.check();
  pool.check();
  expect(made).toHaveLength(1);
  expect(pool.lend(new Stage())).toBe(made[0]!.drawer);
});

test('what nobody needs is let go of; with the last stage all of it', () => {
  const all = stages(3) as [Stage, Stage, Stage];
  for (const stage of all) pool.lend(stage);
  pool.leave(all[0]);
  pool.leave(all[1]);
  expect(pool.size).toBe(2);
  pool.leave(all[2]);
  expect(pool.size).toBe(0);
  expect(made.map(({ dispose }) => dispose.mock.calls.length)).toEqual([1, 1, 1]);
});

test('a context that the browser took is not lent again; given back, its stage draws anew', () => {
  const [a, b] = stages(2) as [Stage, Stage];
  pool.lend(a);
  made[0]!.change('lost');
  made[0]!.change('drawing');
  expect(a.graphicsChanged).toHaveBeenCalledTimes(2);
  pool.giveBack(a);
  made[0]!.change('lost');
  expect(pool.lend(b)).not.toBe(made[0]!.drawer);
  expect(made[0]!.dispose).toHaveBeenCalled();
});
