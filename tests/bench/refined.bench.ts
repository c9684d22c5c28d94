// The refined girth of 800,000 triangles on the page, from the file to the last value: how long, in how much memory, and
// whether the page answers meanwhile. The surface is a model of the corpus (GIRTH_DATA) with each triangle cut into sixteen.
// Drawing is left out: see `long-tasks.ts`. Some ten minutes.

import { join } from 'node:path';
import { afterAll, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import type { RefinedGirth } from '../../web/src/kernel/index.js';
import { withoutDrawing } from '../browser/long-tasks.js';
import { chromiumForTests, repository, requireBuilt, serve } from '../browser/support.js';
import { placeOnSurface } from '../browser/viewer-page.js';
import { dividedOff } from './divided.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';
import { openServed } from './opening.js';
import { watchMemory } from './renderer-memory.js';
import { longestTasks, recordTasks } from './tasks.js';

const goals = { colours: 15, task: 50, length: 50, memory: 1500, minutes: 10, equal: 1 };
const corpus = process.env['GIRTH_DATA'];
const moves = 24;
/** Milliseconds from one move of the pointer to the next. */
const pause = 400;

const chromium = chromiumForTests();
const figures: Figure[] = [];
afterAll(() => printFigures(figures));

test.skipIf(!corpus)('a divided dancer, refined', { timeout: 1_800_000 }, async () => {
  requireBuilt('build/page/index.html', 'build:page');
  const model = dividedOff(join(corpus!, 'models/dancer_49996f_g1.off'), 2);
  const pages = { '/divided.obj': model };
  const server = await serve(join(repository, 'build/page'), { isolated: true, pages });
  const { page, browser } = await chromium('about:blank');
  await withoutDrawing(page);
  await page.goto(server.url);
  const complete = page.locator('html[data-field=complete]');
  await complete.waitFor({ state: 'attached', timeout: 120_000 });
  const held = await watchMemory(browser);
  const recorded = await recordTasks(browser, page);

  const from = performance.now();
  await openServed(page, 'divided.obj');
  await complete.waitFor({ state: 'attached', timeout: 120_000 });
  const colours = (performance.now() - from) / 1000;
  figures.push(figure('file to the girth of few triangles', 's', colours, goals.colours));
  figures.push(...longestTasks('until then', await recorded(), goals.task));
  const takeTasks = await watchTasks();

  const viewer = page.locator('girth-viewer');
  const begun = performance.now();
  await page.getByLabel('Girth', { exact: true }).selectOption('refined');
  await addLengths('while it is refined');
  const audit = await viewer.evaluate(async (element: GirthViewer) => {
    return ((await element.fieldOf('igf')) as RefinedGirth).audit;
  });
  const minutes = (performance.now() - begun) / 60_000;
  figures.push(figure('refined', 'min', minutes, goals.minutes));
  figures.push(figure('audited: equal', '', audit.equal / audit.vertices, goals.equal));
  await addTasks('while it is refined');
  await addLengths('once it is');
  await addTasks('pointing at it');
  figures.push(figure('memory of the page and its workers', 'MB', held() / 1e6, goals.memory));
  await server.close();

  /** A function that takes the tasks of more than 50 ms of the page's own thread since it was called last. */
  async function watchTasks(): Promise<() => Promise<number[]>> {
    await page.evaluate(() => {
      const tasks: number[] = [];
      Object.assign(globalThis, { tasks });
      new PerformanceObserver((list) => {
        tasks.push(...list.getEntries().map(({ duration }) => duration));
      }).observe({ type: 'longtask' });
    });
    return () =>
      page.evaluate(() => (globalThis as unknown as { tasks: number[] }).tasks.splice(0));
  }

  async function addTasks(when: string): Promise<void> {
    const tasks = await takeTasks();
    figures.push(figure(`longest task, ${when}`, 'ms', Math.max(0, ...tasks), goals.task));
  }

  /** The time from a move of the pointer until the length there is in words. */
  async function addLengths(when: string): Promise<void> {
    await viewer.evaluate((element: GirthViewer) => {
      const readout = element.shadowRoot!.querySelector<HTMLElement>('.readout')!;
      const waits: number[] = [];
      Object.assign(globalThis, { waits });
      let moved: number | undefined;
      element.addEventListener('pointermove', ({ timeStamp }) => (moved = timeStamp));
      new MutationObserver(() => {
        if (moved === undefined || readout.hidden) return;
        waits.push(performance.now() - moved);
        moved = undefined;
      }).observe(readout, { attributes: true });
    });
    for (let i = 0; i < moves; ++i) {
      const across = 0.3 + 0.4 * ((i * 0.618) % 1);
      const place = await placeOnSurface(viewer, across, 0.3 + (0.5 * i) / moves);
      await page.mouse.move(place.x, place.y);
      await page.waitForTimeout(pause);
    }
    const waits = await page.evaluate(() => (globalThis as unknown as { waits: number[] }).waits);
    figures.push(figure(`pointer to length, ${when}`, 'ms', quantile(waits, 0.5), goals.length));
    figures.push(figure(`95%, of ${waits.length}`, 'ms', quantile(waits, 0.95), goals.length));
  }
});
