// The page with surfaces of 100,000 and 400,000 vertices: how long they take to open, whether anything holds up the page
// meanwhile, and whether thresholds that are dragged recolour the surface within a frame. Drawing is left out: see `long-tasks.ts`.

import { join } from 'node:path';
import { afterAll, beforeAll, test } from 'vitest';
import { withoutDrawing } from '../browser/long-tasks.js';
import { thinRing } from '../browser/meshes.js';
import {
  chromiumForTests,
  repository,
  requireBuilt,
  serve,
  type StaticServer,
} from '../browser/support.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';
import { openServed } from './opening.js';
import { longestTasks, recordTasks } from './tasks.js';

const goals = { openedSeconds: 6, task: 50, frame: 1000 / 60 };
/** Positions of the slider in one drag. */
const moves = 60;

const chromium = chromiumForTests();
const figures: Figure[] = [];
let server: StaticServer;

beforeAll(async () => {
  requireBuilt('build/page/index.html', 'build:page');
  const pages = { '/ring.obj': thinRing(5120, 20), '/large.obj': thinRing(20_480, 20) };
  server = await serve(join(repository, 'build/page'), { isolated: true, pages });
});
afterAll(async () => {
  await server?.close();
  printFigures(figures);
});

/** Opens a model on a page of its own, and waits for the girth of fewer triangles. */
async function openedModel(name: string, what: string) {
  const { context, page, browser } = await chromium('about:blank');
  await withoutDrawing(page);
  await page.goto(server.url);
  const complete = page.locator('html[data-field=complete]');
  await complete.waitFor({ state: 'attached', timeout: 120_000 });
  const recorded = await recordTasks(browser, page);
  const opened = await openServed(page, name);
  figures.push(figure(`${what} opened, an OBJ`, 's', opened, goals.openedSeconds));
  await complete.waitFor({ state: 'attached', timeout: 500_000 });
  const tasks = await recorded();
  figures.push(...longestTasks(`${what} meanwhile`, tasks, goals.task));
  return { context, page };
}

test('opening 400K vertices', async () => {
  const { context } = await openedModel('large.obj', '400K vertices');
  await context.close();
});

test('opening 100K vertices and dragging thresholds', async () => {
  const { context, page } = await openedModel('ring.obj', '100K vertices');
  await page.locator('#parts-panel summary').click();
  await page.locator('#parts-panel .controls').waitFor({ timeout: 120_000 });
  const [own, frames] = await page.evaluate(async (moves) => {
    const slider = document.querySelector<HTMLInputElement>('#parts-panel .threshold')!;
    const [own, frames]: [number[], number[]] = [[], []];
    const frame = () => new Promise<number>(requestAnimationFrame);
    let before = await frame();
    for (let i = 0; i < moves; ++i) {
      const begun = performance.now();
      slider.value = String(200 + 10 * i);
      slider.dispatchEvent(new Event('input'));
      own.push(performance.now() - begun);
      const now = await frame();
      frames.push(now - before);
      before = now;
    }
    return [own, frames] as const;
  }, moves);
  await context.close();
  for (const share of [0.5, 0.95]) {
    const what = `a threshold moved, ${100 * share}%`;
    figures.push(figure(`${what}: the page's work`, 'ms', quantile(own, share), goals.frame));
    figures.push(
      figure(`${what}: from frame to frame`, 'ms', quantile(frames, share), goals.frame),
    );
  }
});
