// The documentation in Chromium: its figures are live, or pictures where they cannot be; it can be searched, printed and
// read by everybody, and asks no one else for anything.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsIn, complaintsOfAxe } from './axe.js';
import {
  chromiumForTests,
  repository,
  requireBuilt,
  serve,
  strictPolicy,
  type StaticServer,
} from './support.js';
import { fieldComplete } from './viewer-page.js';

const openPage = chromiumForTests();
let server: StaticServer;

beforeAll(async () => {
  requireBuilt('build/page/docs/index.html', 'build:docs');
  server = await serve(join(repository, 'build/page'), { isolated: true, policy: strictPolicy });
});
afterAll(() => server?.close());

const start = () => `${server.url}/docs/`;

/** Addresses that a page asks for from now on. */
function asked(page: Page): string[] {
  const addresses: string[] = [];
  page.on('request', (request) => addresses.push(request.url()));
  return addresses;
}

test('a figure becomes live, and nothing comes from elsewhere', async () => {
  let addresses: string[] = [];
  const { page, complaints } = await openPage(start(), {}, async (page) => {
    addresses = asked(page);
    await page.emulateMedia({ reducedMotion: 'reduce' });
  });
  const figure = page.locator('figure.live').first();
  await figure.scrollIntoViewIfNeeded();
  await page.locator('figure.lives').first().waitFor({ timeout: 60_000 });
  expect(await figure.locator('img.poster').isVisible()).toBe(false);
  const share = await figure.locator('girth-viewer').evaluate((viewer: GirthViewer) => {
    const values = viewer.values('igf');
    return values.filter((value) => value > 0).length / values.length;
  });
  expect(share).toBe(1);
  expect(addresses.filter((address) => !/^(http:\/\/127\.0\.0\.1|blob:)/.test(address))).toEqual(
    [],
  );
  expect(complaints).toEqual([]);

  // On paper there are pictures.
  await page.emulateMedia({ media: 'print' });
  expect(await figure.locator('img.poster').isVisible()).toBe(true);
  expect(await page.locator('header').isVisible()).toBe(false);
});

test.each(['light', 'dark'] as const)('axe has no complaint: %s', async (colorScheme) => {
  const { page } = await openPage(start(), { colorScheme });
  for (const address of ['', 'girth.html', 'definitions.html', 'how-to/check-a-print.html']) {
    await page.goto(start() + address);
    expect(await complaintsIn(colorScheme, page), address).toEqual([]);
  }
});

test('the search finds words, by the keyboard alone', async () => {
  const { page, complaints } = await openPage(`${start()}decisions/index.html`);
  await page.locator('form.search').waitFor();
  await page.keyboard.press('/');
  await page.keyboard.type('persistence');
  await page.locator('.results a').first().waitFor();
  expect(await page.locator('.results [role=status]').textContent()).toMatch(/^\d+ places$/);
  expect(await complaintsOfAxe(page)).toEqual([]);
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await page.waitForURL(/\.html#.*persist/);
  expect(complaints).toEqual([]);
});

test('a block of code is copied by its button', async () => {
  const { page, complaints } = await openPage(`${start()}reference/command.html`);
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const block = page.locator('.copied').first();
  await block.getByRole('button', { name: 'Copy' }).click();
  await block.getByRole('button', { name: 'Copied' }).waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toBe(await block.locator('pre').textContent());
  expect(copied).toContain('Usage: girth COMMAND');
  expect(complaints).toEqual([]);
});

test('a reference leads back, and is dark where the site is', async () => {
  const { page } = await openPage(`${start()}reference/cpp/index.html`, {}, (page) =>
    page.emulateMedia({ colorScheme: 'dark' }),
  );
  expect(await page.evaluate(() => getComputedStyle(document.documentElement).filter)).toMatch(
    /invert/,
  );
  await page.getByRole('link', { name: '← Documentation of Girth' }).click();
  await page.waitForURL(`${start()}index.html`);
});

test('what the tutorial of the element says to write does what it says', async () => {
  const text = readFileSync(join(repository, 'web/docs/tutorials/element.md'), 'utf8');
  const [page = '', viewer = '', script = ''] = [...text.matchAll(/^```html\n([^]*?)^```$/gm)].map(
    ([, block = '']) => block,
  );
  const whole = page.replace('</body>', `${viewer}${script}</body>`);
  const docs = join(repository, 'build/page/docs');
  const host = await serve(join(docs, 'models'), {
    pages: { '/': whole },
    folders: { '/girth/': join(docs, 'girth') },
  });
  const { page: opened, complaints } = await openPage(host.url);
  const thinnest = opened.locator('#thinnest');
  await expect.poll(() => thinnest.textContent()).toBe('0.130 m');
  const second = opened.locator('girth-viewer').nth(1);
  await expect
    .poll(() => second.evaluate((element) => element.shadowRoot!.textContent))
    // Lengths have a digit less once the greatest girth is known.
    .toMatch(/Loop 1 pinned: 0\.1(299|30)\sm/);
  expect(complaints).toEqual([]);
  await host.close();
});

test('the element of README shows its model', async () => {
  const readme = readFileSync(join(repository, 'README.md'), 'utf8');
  const [, lines = ''] = /^```html\n([^]*?)^```$/m.exec(readme) ?? [];
  const docs = join(repository, 'build/page/docs');
  const icon = '<link rel="icon" href="data:," />';
  const host = await serve(join(docs, 'models'), {
    pages: { '/': `<!doctype html><html lang="en"><title>README</title>${icon}${lines}</html>` },
    folders: { '/girth/': join(docs, 'girth') },
  });
  const { page, complaints } = await openPage(host.url);
  const viewer = page.locator('girth-viewer');
  await fieldComplete(viewer);
  const range = await viewer.evaluate(
    async (element: GirthViewer) => (await element.fieldOf('igf')).range,
  );
  expect(range[0]).toBeCloseTo(0.0740848, 6);
  expect(complaints).toEqual([]);
  await host.close();
});

test('without WebGL figures are pictures, and the element is not fetched', async () => {
  let addresses: string[] = [];
  const { page, complaints } = await openPage(start(), {}, (page) => {
    addresses = asked(page);
    return page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
  });
  const poster = page.locator('figure.live img.poster').first();
  await poster.scrollIntoViewIfNeeded();
  await expect
    .poll(() => poster.evaluate((image: HTMLImageElement) => image.naturalWidth))
    .toBeGreaterThan(0);
  expect(addresses.some((address) => address.includes('girth-viewer'))).toBe(false);
  expect(complaints).toEqual([]);
});

test('without scripts it is read, and the list of pages opens on a phone', async () => {
  const { page } = await openPage(start(), {
    javaScriptEnabled: false,
    viewport: { width: 390, height: 800 },
  });
  expect(await page.locator('form.search').isVisible()).toBe(false);
  expect(await page.locator('figure.live img.poster').first().isVisible()).toBe(true);
  const list = page.locator('nav#contents');
  expect(await list.isVisible()).toBe(false);
  await page.locator('header .contents').click();
  await list.locator('a', { hasText: 'Definitions' }).click();
  await page.waitForURL(/definitions\.html$/);
  // Nothing is wider than the phone.
  expect(await page.locator('html').evaluate((html) => html.scrollWidth)).toBe(390);
});
