// The field of the same mesh natively and as WebAssembly in Chromium, by threads and by a pool of
// workers: two of each. Taken in turns, the best of several, since the machine has other things to do.

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, test } from 'vitest';
import type { Kernel, Mesh } from '../../web/src/kernel/index.js';
import type { KernelPage } from '../browser/kernel-page.js';
import { buildKernelSite, kernelHtml, kernelSite } from '../browser/kernel-site.js';
import { chromiumForTests, command, repository, serve } from '../browser/support.js';
import { figure, printFigures, type Figure } from './figures.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const workers = 2;
const turns = 3;
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

const cheapest = (a: Cost, b: Cost): Cost => ({
  clock: Math.min(a.clock, b.clock),
  processor: Math.min(a.processor, b.processor),
});
const unknown: Cost = { clock: Infinity, processor: Infinity };

/** The seconds of processor time of a run of the command, with its output. */
function runCommand(args: string[]): { output: string; processor: number } {
  const text = execFileSync('sh', ['-c', '"$@"; times', 'sh', command, ...args], {
    encoding: 'utf8',
  });
  const lines = text.trim().split('\n');
  // The shell's own times, then its children's: user and system.
  const seconds = [...lines.at(-1)!.matchAll(/(\d+)m([\d.]+)s/g)].map(
    ([, minutes, rest]) => 60 * Number(minutes) + Number(rest),
  );
  return {
    output: lines.slice(0, -2).join('\n'),
    processor: seconds.reduce((sum, part) => sum + part, 0),
  };
}

/** The field by the command, reading left out. */
function natively(model: string): Cost {
  const threads = ['--threads', String(workers)];
  const { output, processor } = runCommand(['igf', model, ...threads, '--json', '--stats']);
  const { seconds } = JSON.parse(output) as { seconds: number };
  return { clock: seconds, processor: processor - runCommand(['info', model]).processor };
}

async function inChromium(page: Page, browser: Browser, model: string): Promise<Cost> {
  const session = await browser.newBrowserCDPSession();
  const processor = async () => {
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    return processInfo
      .filter(({ type }) => type === 'renderer')
      .reduce((sum, { cpuTime }) => sum + cpuTime, 0);
  };
  await page.evaluate(
    async ({ base64, workers }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const kernel = await girth.createKernel({ threads: workers });
      const mesh = await kernel.load({ bytes: bytes.buffer, name: 'model.glb' });
      // Once for the compiler and for handing the surface to the workers.
      await mesh.field('igf');
      Object.assign(globalThis, { kernel, mesh });
    },
    { base64: readFileSync(model).toString('base64'), workers },
  );
  const before = await processor();
  const clock = await page.evaluate(async () => {
    const { mesh } = globalThis as unknown as { mesh: Mesh };
    const from = performance.now();
    await mesh.field('igf');
    return (performance.now() - from) / 1000;
  });
  const cost = { clock, processor: (await processor()) - before };
  await page.evaluate(() => (globalThis as unknown as { kernel: Kernel }).kernel.dispose());
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
      await opened.page.waitForFunction('globalThis.girth');
      return { mode, server, ...opened, best: unknown };
    }),
  );
  let native = unknown;
  for (let turn = 0; turn < turns; ++turn) {
    native = cheapest(native, natively(model));
    for (const mode of modes) {
      mode.best = cheapest(mode.best, await inChromium(mode.page, mode.browser, model));
    }
  }
  console.log(`${name}: natively, ${workers} threads, in seconds:`, native);
  for (const { mode, best, context, server } of modes) {
    for (const key of ['clock', 'processor'] as const) {
      figures.push(figure(`${name}: ${mode}, ${key}`, 's', best[key], goal * native[key]));
    }
    await context.close();
    await server.close();
  }
});
