// The page's speed in Chromium, with threads and with a pool of workers, beside its goals. Drawing is left
// out, but for the time to open: see `long-tasks.ts`.

import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, test } from 'vitest';
import { withoutDrawing } from '../browser/long-tasks.js';
import {
  chromiumForTests,
  repository,
  requireBuilt,
  serve,
  type StaticServer,
} from '../browser/support.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';
import { loopTimes } from './hover.js';
import { tasksOfOpening } from './opening.js';
import { longestTasks } from './tasks.js';

const site = join(repository, 'build/page');
const goals = { openedSeconds: 4, task: 50, hover: 16 };
const runs = 3;

const chromium = chromiumForTests();
const figures: Figure[] = [];

beforeAll(() => requireBuilt('build/page/index.html', 'build:page'));
afterAll(() => printFigures(figures));

const complete = (page: Page) =>
  page.locator('html[data-field=complete]').waitFor({ state: 'attached', timeout: 120_000 });

describe.each([
  ['threads', true],
  ['pool', false],
] as const)('%s', (mode, isolated) => {
  let server: StaticServer;
  beforeAll(async () => {
    server = await serve(site, { isolated });
  });
  afterAll(() => server.close());

  test('opening', async () => {
    const seconds: number[] = [];
    for (let run = 0; run < runs; ++run) {
      const { context, page } = await chromium(server.url);
      await complete(page);
      seconds.push((await page.evaluate(() => performance.now())) / 1000);
      await context.close();
    }
    const what = `${mode}: chair computed after opening, with drawing`;
    figures.push(figure(what, 's', quantile(seconds, 0.5), goals.openedSeconds));
  });

  test('blocking', async () => {
    for (const [phase, tasks] of await tasksOfOpening(chromium, server.url)) {
      figures.push(...longestTasks(`${mode}: ${phase}`, tasks, goals.task));
    }
  });

  test('hovering', async () => {
    const { context, page } = await chromium('about:blank');
    await withoutDrawing(page);
    await page.goto(server.url);
    const viewer = page.locator('girth-viewer');
    await complete(page);
    const shown = await loopTimes(viewer, 60);
    await context.close();
    for (const share of [0.5, 0.95]) {
      const what = `${mode}: pointer to frame with the loop, ${100 * share}% of ${shown.length}`;
      figures.push(figure(what, 'ms', quantile(shown, share), goals.hover));
    }
  });
});
