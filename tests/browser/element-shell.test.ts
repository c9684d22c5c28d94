// The element before it draws: what it fetches and when, what stands in its place, and what it keeps when it is moved.

import { copyFileSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { ErrorDetail, GirthViewer } from '../../web/src/element/index.js';
import { packed } from '../web/package/packed.js';
import { chromiumForTests, repository, serve, strictPolicy, type StaticServer } from './support.js';

/** Bytes, packed by gzip, of what a page fetches for an element that nobody looks at yet. */
const mostOfShell = 15_400;

const site = mkdtempSync(join(tmpdir(), 'girth-shell-'));
const head =
  '<!doctype html><meta charset="utf-8"><title>shell</title><link rel="icon" href="data:,">';
const script = '<script type="module" src="girth/dist/girth-viewer.js"></script>';
/** A red square. */
const picture =
  'data:image/svg+xml,%3Csvg xmlns=%22http://www.w3.org/2000/svg%22 viewBox=%220 0 4 3%22%3E%3Cpath fill=%22red%22 d=%22M0 0h4v3H0z%22/%3E%3C/svg%3E';

const pages = {
  '/lazy.html': `${head}${script}<p style="height: 300vh"></p>
    <girth-viewer src="prism.obj" loading="lazy"></girth-viewer>`,
  '/eager.html': `${head}${script}<p style="height: 300vh"></p><girth-viewer src="prism.obj"></girth-viewer>`,
  '/poster.html': `${head}${script}
    <girth-viewer src="prism.obj" field="none" poster="${picture}" style="width: 400px">
      <span slot="caption">A prism</span>
    </girth-viewer>
    <girth-viewer id="slotted" field="none" style="width: 400px">
      <img slot="poster" src="${picture}" alt="a square" />
    </girth-viewer>
    <girth-viewer id="inline" style="width: 400px; display: inline-block"></girth-viewer>`,
  '/move.html': `${head}${script}<div id="there"></div>
    <girth-viewer src="prism.obj" loop="0" style="width: 400px"></girth-viewer>`,
};

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;
let complaints: string[];

beforeAll(async () => {
  copyFileSync(join(repository, 'tests/data/prism.obj'), join(site, 'prism.obj'));
  server = await serve(site, {
    policy: strictPolicy,
    pages,
    folders: { '/girth/': packed().folder },
  });
});

afterAll(async () => {
  await server?.close();
  rmSync(site, { recursive: true });
});

afterEach(() => page.context().close());

async function open(path: string, prepare?: (page: Page) => Promise<unknown>): Promise<void> {
  ({ page, complaints } = await openPage(server.url + path, {}, prepare));
}

/** Files of the package that have been asked for since a request. */
const fetchedSince = (first: number): string[] =>
  server.requests.slice(first).filter((path) => path.startsWith('/girth/'));

const packedSize = (path: string): number =>
  gzipSync(readFileSync(join(packed().folder, path.slice('/girth/'.length)))).length;

const isShown = (viewer: GirthViewer): boolean => viewer.info !== undefined;

test('loading="lazy": nothing but a small script comes before the element is near the view', async () => {
  const before = server.requests.length;
  await open('/lazy.html');
  const viewer = page.locator('girth-viewer');
  await expect
    .poll(() => viewer.evaluate((element: GirthViewer) => element.shadowRoot !== null))
    .toBe(true);
  await page.waitForLoadState('networkidle');
  const shell = fetchedSince(before);
  const bytes = shell.reduce((sum, path) => sum + packedSize(path), 0);
  console.info(`shell: ${bytes} bytes by gzip in ${shell.length} files`);
  expect(shell[0]).toBe('/girth/dist/girth-viewer.js');
  expect(bytes).toBeLessThanOrEqual(mostOfShell);
  expect(server.requests.slice(before)).not.toContain('/prism.obj');

  await viewer.evaluate((element) => element.scrollIntoView());
  await expect.poll(() => viewer.evaluate(isShown)).toBe(true);
  expect(fetchedSince(before).length).toBeGreaterThan(shell.length);
  expect(complaints).toEqual([]);
});

test('by default the script that draws comes at once, and only the model waits', async () => {
  const before = server.requests.length;
  await open('/eager.html');
  await expect
    .poll(() => fetchedSince(before).some((path) => path.includes('viewer-core')))
    .toBe(true);
  await page.waitForLoadState('networkidle');
  expect(server.requests.slice(before)).not.toContain('/prism.obj');
});

test('a picture stands in for the surface until that is drawn; the caption is below', async () => {
  await open('/poster.html');
  const viewer = page.locator('girth-viewer').first();
  await expect.poll(() => viewer.evaluate(isShown)).toBe(true);
  await expect.poll(() => viewer.locator('.poster').isVisible()).toBe(false);
  const boxes = await viewer.evaluate((element: GirthViewer) => {
    const of = (one: Element) => one.getBoundingClientRect().toJSON() as DOMRect;
    const root = element.shadowRoot!;
    return {
      host: of(element),
      canvas: of(root.querySelector('canvas')!),
      caption: of(element.querySelector('[slot=caption]')!),
    };
  });
  expect(boxes.host.height).toBe(300);
  expect(boxes.caption.top).toBeGreaterThanOrEqual(boxes.canvas.bottom - 1);
  expect(boxes.caption.bottom).toBeLessThanOrEqual(boxes.host.bottom);
  expect(boxes.canvas.height).toBeGreaterThan(200);

  // Without a model the picture stays; it fills the element.
  const slotted = page.locator('#slotted');
  const size = await slotted.locator('[slot=poster]').evaluate((image: HTMLImageElement) => {
    const { width, height } = image.getBoundingClientRect();
    return { width, height, isThere: image.checkVisibility() };
  });
  expect(size).toEqual({ width: 400, height: 300, isThere: true });
  // Whatever a page makes of it, there is room for the surface.
  const inline = page.locator('#inline');
  const frame = await inline
    .locator('.frame')
    .evaluate((one) => one.getBoundingClientRect().height);
  expect(frame).toBe(300);
  expect(complaints).toEqual([]);
});

test('without WebGL the picture stays, and the reason is sent and not written over it', async () => {
  await open('/poster.html', (page) =>
    page.addInitScript(() => {
      const own = Object.getOwnPropertyDescriptor(HTMLCanvasElement.prototype, 'getContext')!
        .value as (...args: unknown[]) => unknown;
      Object.assign(HTMLCanvasElement.prototype, {
        getContext(this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
          return kind.startsWith('webgl') ? null : own.apply(this, [kind, ...rest]);
        },
      });
      const codes: string[] = [];
      Object.assign(globalThis, { codes });
      addEventListener(
        'error',
        (event) => codes.push((event as Event as CustomEvent<ErrorDetail>).detail?.code),
        true,
      );
    }),
  );
  const [first, slotted, bare] = [
    page.locator('girth-viewer').first(),
    page.locator('#slotted'),
    page.locator('#inline'),
  ];
  await bare.getByRole('alert').waitFor();
  expect(await bare.getByRole('alert').textContent()).toContain('WebGL');
  await expect
    .poll(() => page.evaluate(() => (globalThis as unknown as { codes: string[] }).codes))
    .toEqual(['NO_WEBGL', 'NO_WEBGL', 'NO_WEBGL']);
  for (const viewer of [first, slotted]) {
    expect(await viewer.getByRole('alert').isVisible()).toBe(false);
  }
  expect(await first.locator('.poster').isVisible()).toBe(true);
  expect(await slotted.locator('[slot=poster]').isVisible()).toBe(true);
  expect(complaints.filter((text) => text.startsWith('uncaught'))).toEqual([]);
});

test('where the script that draws cannot be had, the element says so and what helps', async () => {
  await open('/eager.html', (page) => page.route('**/*viewer-core*', (route) => route.abort()));
  const viewer = page.locator('girth-viewer');
  const code = await viewer.evaluate(async (element: GirthViewer) => {
    await customElements.whenDefined('girth-viewer');
    return element.load('prism.obj').then(
      () => '',
      (error: { code: string }) => error.code,
    );
  });
  expect(code).toBe('PROGRAM_NOT_LOADED');
  const message = viewer.getByRole('alert');
  expect(await message.textContent()).toContain('check the connection');
  expect(complaints.filter((text) => text.startsWith('uncaught'))).toEqual([]);
});

test('an element that is moved keeps its model, its view and its loops; one that is removed lets go', async () => {
  const first = server.requests.length;
  await open('/move.html');
  const viewer = page.locator('girth-viewer');
  await expect
    .poll(() => viewer.evaluate((element: GirthViewer) => element.pinned?.length ?? 0))
    .toBe(1);
  const requests = server.requests.length;
  const kept = await viewer.evaluate(async (element: GirthViewer) => {
    element.camera = { ...element.camera!, azimuth: 1.25 };
    const before = element.info;
    document.querySelector('#there')!.append(element);
    await new Promise((done) => setTimeout(done, 100));
    const isSame = element.info === before;
    return { isSame, azimuth: element.camera.azimuth, pinned: element.pinned.length };
  });
  expect(kept).toEqual({ isSame: true, azimuth: expect.closeTo(1.25, 9) as number, pinned: 1 });
  // Scripts that are asked for without haste may come after the loop: but nothing comes twice.
  const earlier = new Set(server.requests.slice(first, requests));
  expect(server.requests.slice(requests).filter((path) => earlier.has(path))).toEqual([]);
  const gone = await viewer.evaluate(async (element: GirthViewer) => {
    element.remove();
    await Promise.resolve();
    const after = element.info;
    document.body.append(element);
    return { isGone: after === undefined, pinned: element.pinned.length };
  });
  expect(gone).toEqual({ isGone: true, pinned: 0 });
  // Back on the page it begins anew.
  await expect
    .poll(() =>
      page.evaluate(() => document.querySelector<GirthViewer>('girth-viewer')!.pinned.length),
    )
    .toBe(1);
  expect(complaints).toEqual([]);
});
