// Fifty elements on one page: each is drawn when it is in view, none goes blank, and few contexts do it.

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { GirthViewer } from '../../../web/src/element/index.js';
import { packed } from '../../web/package/packed.js';
import { glbWith } from '../glb.js';
import { box } from '../meshes.js';
import { allPixels, chromiumForTests, serve, strictPolicy, type StaticServer } from '../support.js';

const count = 50;
const mostContexts = 8;

const site = mkdtempSync(join(tmpdir(), 'girth-many-'));
const element = '<girth-viewer src="heat.glb" style="width: 300px"></girth-viewer>';
const pages = {
  '/many.html': `<!doctype html><meta charset="utf-8"><title>many</title><link rel="icon" href="data:,">
    <script type="module" src="girth/dist/girth-viewer.js"></script>
    <style>main { display: grid; grid-template-columns: repeat(3, 300px); gap: 8px }</style>
    <main>${element.repeat(count)}</main>`,
};

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;
let complaints: string[];

beforeAll(async () => {
  writeFileSync(join(site, 'heat.glb'), glbWith(box(6, 4, 4), { _HEAT: (vertex) => vertex }));
  const folders = { '/girth/': packed().folder };
  server = await serve(site, { policy: strictPolicy, pages, folders });
});

afterAll(async () => {
  await server?.close();
  rmSync(site, { recursive: true });
});

afterEach(() => page.context().close());

/** Counts the contexts that are made and lost. */
async function countContexts(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const contexts = new Set<WebGL2RenderingContext>();
    let most = 0;
    const own = Object.getOwnPropertyDescriptor(HTMLCanvasElement.prototype, 'getContext')!
      .value as (...args: unknown[]) => unknown;
    const alive = () => [...contexts].filter((context) => !context.isContextLost()).length;
    Object.assign(HTMLCanvasElement.prototype, {
      getContext(this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
        const context = own.apply(this, [kind, ...rest]);
        if (kind === 'webgl2' && context) contexts.add(context as WebGL2RenderingContext);
        most = Math.max(most, alive());
        return context;
      },
    });
    Object.assign(globalThis, { contexts: () => ({ alive: alive(), most }) });
  });
}

const contexts = () =>
  page.evaluate(() =>
    (globalThis as unknown as { contexts: () => { alive: number; most: number } }).contexts(),
  );

/** So many different colours are seen where an element is. */
async function coloursOf(number: number): Promise<number> {
  const viewer = page.locator('girth-viewer').nth(number);
  const picture = (await viewer.screenshot()).toString('base64');
  return page.evaluate(async (picture) => {
    const bytes = Uint8Array.from(atob(picture), (char) => char.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes]));
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
    pen.drawImage(bitmap, 0, 0);
    // Beside the legend.
    const { data } = pen.getImageData(60, 20, bitmap.width - 80, bitmap.height - 110);
    const colours = new Set<number>();
    for (let i = 0; i < data.length; i += 4) {
      colours.add((data[i]! << 16) | (data[i + 1]! << 8) | data[i + 2]!);
    }
    return colours.size;
  }, picture);
}

test('fifty are scrolled through: none is blank, and eight contexts suffice', async () => {
  ({ page, complaints } = await openPage(`${server.url}/many.html`, allPixels, countContexts));
  const isDrawn = (number: number) =>
    page
      .locator('girth-viewer')
      .nth(number)
      .evaluate((viewer: GirthViewer) => !!viewer.shown);
  // Elements that nobody has come near have nothing but their small script.
  await expect.poll(() => isDrawn(0)).toBe(true);
  expect(await isDrawn(count - 1)).toBe(false);
  for (let number = 0; number < count; number += 6) {
    await page.locator('girth-viewer').nth(number).scrollIntoViewIfNeeded();
    await expect.poll(() => isDrawn(number)).toBe(true);
  }
  await page.locator('girth-viewer').last().scrollIntoViewIfNeeded();
  await expect.poll(() => isDrawn(count - 1)).toBe(true);
  await expect.poll(() => coloursOf(count - 1)).toBeGreaterThan(200);
  // Elements that gave their context away are drawn again.
  for (const number of [0, 25]) {
    await page.locator('girth-viewer').nth(number).scrollIntoViewIfNeeded();
    await expect.poll(() => coloursOf(number)).toBeGreaterThan(200);
  }
  const { alive, most } = await contexts();
  console.info(`fifty elements: at most ${most} contexts`);
  expect(most).toBeLessThanOrEqual(mostContexts);
  expect(alive).toBeGreaterThan(0);
  expect(complaints).toEqual([]);

  // All nine and more that are in view at a time have their pictures.
  await page.setViewportSize({ width: 1024, height: 1400 });
  await page.evaluate(() => scrollTo(0, 0));
  for (const number of [0, 4, 8, 11, 14]) {
    await expect.poll(() => coloursOf(number)).toBeGreaterThan(200);
  }
  expect((await contexts()).most).toBeLessThanOrEqual(mostContexts);

  await page.evaluate(() => document.querySelector('main')!.replaceChildren());
  await expect.poll(async () => (await contexts()).alive).toBe(0);
  expect(complaints).toEqual([]);
});
