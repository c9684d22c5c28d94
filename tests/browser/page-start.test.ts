// Whatever keeps a module of the page from starting ends in words, and what need not end it does not.

import { join } from 'node:path';
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { drop, modelIs, site } from './page-support.js';
import {
  chromiumForTests,
  repository,
  requireBuilt,
  serve,
  strictPolicy,
  type StaticServer,
} from './support.js';

const openPage = chromiumForTests();
let server: StaticServer;

beforeAll(async () => {
  requireBuilt('build/page/index.html', 'build:page');
  server = await serve(site, { isolated: true, policy: strictPolicy });
});
afterAll(() => server.close());

const openAfter = (prepare: (page: Page) => Promise<unknown>) => openPage(server.url, {}, prepare);

test('a language that is none, as under LANG=C, keeps nothing from working', async () => {
  const { page, complaints } = await openAfter((page) =>
    page.addInitScript(() => {
      Object.defineProperty(Navigator.prototype, 'language', { get: () => 'C' });
    }),
  );
  await modelIs(page, 'chair.glb');
  await page.locator('#distribution canvas').waitFor();
  expect(await page.locator('.start').allTextContents()).toHaveLength(1);
  expect(await page.locator('#start-failure').isVisible()).toBe(false);
  expect(complaints).toEqual([]);
});

test('a file that is chosen before anybody listens is opened', async () => {
  let release = (): void => undefined;
  const released = new Promise<void>((done) => (release = done));
  const { page, complaints } = await openPage('about:blank', {}, (page) =>
    page.route('**/assets/*.js', async (route) => {
      await released;
      await route.continue();
    }),
  );
  await page.goto(server.url, { waitUntil: 'commit' });
  await page.locator('#file').setInputFiles(join(repository, 'tests/data/prism.obj'));
  release();
  await modelIs(page, 'prism.obj');
  expect(await page.locator('#file').inputValue()).toBe('');
  expect(complaints).toEqual([]);
});

test('a module that throws while it starts ends in words', async () => {
  const { page, complaints } = await openAfter((page) =>
    page.addInitScript(() => {
      Intl.NumberFormat = class {
        constructor() {
          throw new RangeError('no such locale.');
        }
      } as unknown as typeof Intl.NumberFormat;
    }),
  );
  const words = page.locator('#start-failure');
  await words.waitFor();
  expect(await words.textContent()).toMatch(
    /Girth could not start: no such locale\. Reload the page/,
  );
  expect(await page.locator('#invitation').isVisible()).toBe(false);
  expect(complaints).toEqual([]);
});

test('a module that cannot be fetched ends in words', async () => {
  const { page } = await openAfter((page) =>
    page.route(/assets\/main-.*\.js$/, (route) => route.fulfill({ status: 404, body: '' })),
  );
  await page.locator('#start-failure').waitFor();
  expect(await page.locator('#start-failure').textContent()).toMatch(/Girth could not start: .+\./);
});

test('where the first script cannot be fetched, a line appears by itself', async () => {
  const { page } = await openAfter((page) =>
    page.route(/assets\/index-.*\.js$/, (route) => route.fulfill({ status: 404, body: '' })),
  );
  const line = page.locator('#not-started');
  await line.waitFor({ state: 'attached' });
  expect(await line.isVisible()).toBe(false);
  await page.evaluate(() => document.getAnimations().forEach((animation) => animation.finish()));
  expect(await line.isVisible()).toBe(true);
});

test('without the list of examples a model of one’s own can still be dropped', async () => {
  const { page } = await openAfter((page) =>
    page.route('**/examples/index.json', (route) => route.fulfill({ status: 503, body: '' })),
  );
  const strip = page.locator('#examples');
  await expect.poll(() => strip.textContent()).toMatch(/could not be fetched: .* 503/);
  const bytes = readFileSync(join(repository, 'tests/data/prism.obj'));
  await drop(page, { name: 'prism.obj', bytes });
  await modelIs(page, 'prism.obj');
});
