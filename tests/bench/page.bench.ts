// The page's speed in Chromium, with threads and with a pool of workers, beside its goals. Drawing is left
// out, but for the time to open: see `long-tasks.ts`.

import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { withoutDrawing } from '../browser/long-tasks.js';
import {
  chromiumForTests,
  repository,
  requireBuilt,
  serve,
  type StaticServer,
} from '../browser/support.js';
import { placeOnSurface } from '../browser/viewer-page.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';
import { recordTasks } from './tasks.js';

const site = join(repository, 'build/page');
const goals = { openedSeconds: 4, task: 50, hover: 30 };
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
    const { context, page, browser } = await chromium('about:blank');
    await withoutDrawing(page);
    const recorded = await recordTasks(browser, page);
    await page.goto(server.url);
    await complete(page);
    const from = await page.evaluate(() => {
      delete document.documentElement.dataset['field'];
      document.querySelector<HTMLButtonElement>('[data-example=octopus]')!.click();
      return performance.now();
    });
    await complete(page);
    const tasks = await recorded();
    await context.close();
    for (const [phase, inPhase] of [
      ['opening and the chair', tasks.filter(({ start }) => start < from)],
      ['loading and computing the octopus', tasks.filter(({ start }) => start >= from)],
    ] as const) {
      const longest = (key: 'wall' | 'processor') => Math.max(...inPhase.map((task) => task[key]));
      const what = `${mode}: longest task, ${phase}`;
      figures.push(figure(`${what}, by the clock`, 'ms', longest('wall'), goals.task));
      figures.push(figure(`${what}, processor`, 'ms', longest('processor'), goals.task));
      for (const { start, wall, processor, inside } of inPhase) {
        if (Math.max(wall, processor) < 0.6 * goals.task) continue;
        const sizes = `${wall.toFixed(0)} ms, processor ${processor.toFixed(0)} ms`;
        console.log(`${mode} at ${start.toFixed(0)} ms: ${sizes}: ${inside.join(', ')}`);
      }
    }
  });

  test('hovering', async () => {
    const { context, page } = await chromium('about:blank');
    await withoutDrawing(page);
    await page.goto(server.url);
    const viewer = page.locator('girth-viewer');
    await complete(page);
    await viewer.evaluate((element: GirthViewer) => {
      let moved = 0;
      const shown: number[] = [];
      Object.assign(globalThis, { shown });
      element.addEventListener('pointermove', (event) => (moved = event.timeStamp));
      element.addEventListener('pick', (event) => {
        if (event.detail.action !== 'hover') return;
        const asked = moved;
        // After the frame that has the loop.
        requestAnimationFrame(() => setTimeout(() => shown.push(performance.now() - asked)));
      });
    });
    for (let i = 0; i < 60; ++i) {
      const place = await placeOnSurface(
        viewer,
        0.3 + 0.4 * ((i * 0.618) % 1),
        0.3 + 0.5 * (i / 60),
      );
      await page.mouse.move(place.x, place.y);
      await page.waitForTimeout(120);
    }
    const shown = await page.evaluate(() => (globalThis as unknown as { shown: number[] }).shown);
    await context.close();
    for (const share of [0.5, 0.95]) {
      const what = `${mode}: pointer to frame with the loop, ${100 * share}% of ${shown.length}`;
      figures.push(figure(what, 'ms', quantile(shown, share), goals.hover));
    }
  });
});
