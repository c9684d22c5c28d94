// The field of the same mesh natively and as WebAssembly in Chromium, by threads and by a pool of
// workers: two of each. They take turns, and of the ratios within a turn the median counts: a
// machine with other things to do is slow for both sides of a ratio.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, test } from 'vitest';
import type { Mesh } from '../../web/src/kernel/index.js';
import type { KernelPage } from '../browser/kernel-page.js';
import { kernelSite, setup as buildKernelSite } from '../browser/build-kernel-site.js';
import { kernelHtml } from '../browser/kernel-site.js';
import { chromiumForTests, command, repository, serve } from '../browser/support.js';
import { figure, printFigures, quantile, type Figure } from './figures.js';
import { runProgram } from './processor-time.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const workers = 2;
const turns = 25;
/** Times of the native time. */
const goal = 1.5;

const openPage = chromiumForTests();
const figures: Figure[] = [];

beforeAll(buildKernelSite);
afterAll(() => printFigures(figures));

/** Seconds by the clock, and of processor time, which what else the machine does hardly changes. */
interface Cost {
  clock: number;
  processor: number;
}

/** The field by the command, reading left out. */
function natively(model: string): Cost {
  const threads = ['--threads', String(workers)];
  const { output, processor } = runProgram(command, [
    ...['igf', model, ...threads, '--json', '--stats'],
  ]);
  const { seconds } = JSON.parse(output) as { seconds: number };
  return { clock: seconds, processor: processor - runProgram(command, ['info', model]).processor };
}

/** A kernel that has the surface, and whose code the browser has had the time to compile. */
async function prepare(page: Page, model: string) {
  await page.waitForFunction('globalThis.girth');
  await page.evaluate(
    async ({ base64, workers }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const kernel = await girth.createKernel({ threads: workers });
      const mesh = await kernel.load({ bytes: bytes.buffer, name: 'model.glb' });
      for (let i = 0; i < 2; ++i) await mesh.field('igf');
      Object.assign(globalThis, { mesh });
    },
    { base64: readFileSync(model).toString('base64'), workers },
  );
}

/** The field in a page that is prepared. */
async function inChromium(page: Page, browser: Browser): Promise<Cost> {
  const session = await browser.newBrowserCDPSession();
  const processor = async () => {
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    return processInfo
      .filter(({ type }) => type === 'renderer')
      .reduce((sum, { cpuTime }) => sum + cpuTime, 0);
  };
  const before = await processor();
  const clock = await page.evaluate(async () => {
    const { mesh } = globalThis as unknown as { mesh: Mesh };
    const from = performance.now();
    await mesh.field('igf');
    return (performance.now() - from) / 1000;
  });
  const cost = { clock, processor: (await processor()) - before };
  await session.detach();
  return cost;
}

test.each(['chair', 'octopus', 'vessel'])('%s', async (name) => {
  const model = join(repository, 'web/app/public/examples', `${name}.glb`);
  const modes = await Promise.all(
    (['threads', 'pool'] as const).map(async (mode) => {
      const isolated = mode === 'threads';
      const server = await serve(kernelSite, { isolated, pages: { '/': kernelHtml } });
      const opened = await openPage(server.url);
      await prepare(opened.page, model);
      return { mode, server, ...opened, ratios: [] as Cost[] };
    }),
  );
  const seconds: number[] = [];
  for (let turn = 0; turn < turns; ++turn) {
    const native = natively(model);
    seconds.push(native.clock);
    for (const { page, browser, ratios } of modes) {
      const cost = await inChromium(page, browser);
      ratios.push({
        clock: cost.clock / native.clock,
        processor: cost.processor / native.processor,
      });
    }
  }
  console.log(
    `${name}: natively, ${workers} threads, seconds by the clock:`,
    quantile(seconds, 0.5),
  );
  for (const { mode, ratios, context, server } of modes) {
    for (const key of ['clock', 'processor'] as const) {
      const ratio = quantile(
        ratios.map((turn) => turn[key]),
        0.5,
      );
      figures.push(figure(`${name}: ${mode}, ${key}`, 'times native', ratio, goal));
    }
    await context.close();
    await server.close();
  }
});
