// The page after its first visit, without a network: all of it, with threads where there were threads; and its next version.

import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterEach, beforeAll, beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { writeFileList } from '../../web/scripts/offline.mjs';
import { complaintsOfAxe } from './axe.js';
import { box } from './meshes.js';
import { drop, modelIs, openPanel, picture, site } from './page-support.js';
import { smallExamples } from './small-examples.js';
import {
  type OpenPage,
  type StaticServer,
  chromiumForTests,
  requireBuilt,
  serve,
  strictPolicy,
} from './support.js';
import { fieldComplete } from './viewer-page.js';

const openPage = chromiumForTests({ whole: true });
/** A copy of the page that may be changed. */
let folder: string;
let server: StaticServer;
let opened: OpenPage | undefined;

beforeAll(() => requireBuilt('build/page/service-worker.js', 'build:page'));
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'girth-offline-'));
  const notDocs = (from: string): boolean => !from.startsWith(join(site, 'docs'));
  cpSync(site, folder, { recursive: true, filter: notDocs });
  cpSync(smallExamples, join(folder, 'examples'), { recursive: true });
  writeFileList(folder);
});
afterEach(async () => {
  await opened?.context.close();
  opened = undefined;
  await server.close().catch(() => undefined);
  rmSync(folder, { recursive: true });
});

async function visit(isolated = true): Promise<OpenPage> {
  server = await serve(folder, { isolated, policy: strictPolicy });
  opened = await openPage(`${server.url}/#model=cup`, {
    serviceWorkers: 'allow',
    reducedMotion: 'reduce',
  });
  const { page } = opened;
  await modelIs(page, 'cup.glb');
  await worksOffline(page);
  return opened;
}

/** Makes the first page another one. */
function change(edition: string): void {
  const path = join(folder, 'index.html');
  const meta = `<meta name="edition" content="${edition}" /></head>`;
  writeFileSync(path, readFileSync(path, 'utf8').replace('</head>', meta));
}
const editions = (page: Page): Promise<string[]> =>
  page
    .locator('meta[name=edition]')
    .evaluateAll((metas: HTMLMetaElement[]) => metas.map(({ content }) => content));

/** Waits until the page says that it can do without a network. */
async function worksOffline(page: Page): Promise<void> {
  await expect.poll(() => page.locator('#offline').textContent()).toMatch(/works offline/);
}

test.each([
  ['with threads', true],
  ['without the headers that threads need', false],
])('after one visit all works offline, %s', async (_, isolated) => {
  const { page, complaints } = await visit(isolated);
  await server.close();
  await page.reload();
  const viewer = page.locator('girth-viewer');
  await modelIs(page, 'cup.glb');
  await fieldComplete(viewer);
  expect(await page.evaluate(() => crossOriginIsolated)).toBe(isolated);
  // Another example, a file of one's own, a field of the second module, and a picture of a term.
  await page.locator('#examples button', { hasText: 'Octopus' }).click();
  await modelIs(page, 'octopus.glb');
  await drop(page, { name: 'cube.obj', bytes: Buffer.from(box(2, 2, 2)) });
  await modelIs(page, 'cube.obj');
  await fieldComplete(viewer);
  await page.locator('#field-name').selectOption('hks');
  await expect
    .poll(() => viewer.evaluate((element: GirthViewer) => element.shareOf('hks')), {
      timeout: 60_000,
    })
    .toBe(1);
  await openPanel(page, 'print');
  await page.keyboard.press('Control+k');
  await page.locator('#palette').waitFor();
  await page.keyboard.press('Escape');
  // The page for frames, too.
  await page.goto(`${server.url}/embed.html#src=${server.url}/examples/chair.glb`);
  await modelInFrame(page, 'chair.glb');
  expect(complaints).toEqual([]);
});

test('what was read of the documentation can be read again, and searched', async () => {
  const { page } = await visit();
  const documentation = `${server.url}/docs`;
  for (const name of ['site', 'images', 'choosing.html', 'girth.html']) {
    cpSync(join(site, 'docs', name), join(folder, 'docs', name), { recursive: true });
  }
  await page.goto(`${documentation}/choosing.html`);
  const isKept = (name: string) =>
    page.evaluate(
      async (address) => (await caches.match(address)) !== undefined,
      `${documentation}/${name}`,
    );
  for (const name of ['choosing.html', 'site/page.css', 'site/minisearch.js', 'site/search.json']) {
    await expect.poll(() => isKept(name), { message: name }).toBe(true);
  }
  await server.close();
  await page.reload();
  expect(await page.locator('h1').textContent()).toMatch(/^Which field, which method/);
  await page.locator('form.search input').fill('handles');
  await expect
    .poll(() => page.locator('form.search [role=status]').textContent())
    .toMatch(/^\d+ places$/);
  // A page that was not read is not there.
  await expect(page.goto(`${documentation}/girth.html`)).rejects.toThrow();
});

const modelInFrame = (page: Page, name: string): Promise<unknown> =>
  expect
    .poll(() =>
      page.locator('girth-viewer').evaluate((element: GirthViewer) => element.info?.name ?? ''),
    )
    .toBe(name);

test('a new version is fetched by what has changed, offered, and there after a reload', async () => {
  const { page } = await visit();
  await page.reload();
  await modelIs(page, 'cup.glb');
  expect(await page.locator('.note').isVisible()).toBe(false);
  change('next');
  writeFileList(folder);
  server.requests.length = 0;
  await page.reload();
  const note = page.locator('.note');
  await note.waitFor();
  expect(await note.textContent()).toContain('A new version is available.');
  // All else is as it was.
  expect(server.requests.filter((path) => path !== '/service-worker.js')).toEqual(['/']);
  expect(await editions(page)).toEqual([]);
  expect(await complaintsOfAxe(page)).toEqual([]);
  await picture(page, 'new-version.png');
  await note.getByRole('button', { name: 'Later' }).click();
  expect(await note.isVisible()).toBe(false);
  await page.reload();
  await note.waitFor();
  await Promise.all([
    page.waitForEvent('load'),
    note.getByRole('button', { name: 'Reload' }).click(),
  ]);
  await modelIs(page, 'cup.glb');
  expect(await editions(page)).toEqual(['next']);
  expect(await note.isVisible()).toBe(false);
  // Only one version is kept.
  const kept = await page.evaluate(async () => {
    const keys = await Promise.all(
      (await caches.keys()).map(async (name) => (await caches.open(name)).keys()),
    );
    return keys.flat().map(({ url }) => new URL(url).pathname);
  });
  expect(kept.filter((path, i) => kept.indexOf(path) !== i)).toEqual([]);
  expect(kept).toContain('/index.html');
});

test('a version that comes only in part is none: the page stays as it was', async () => {
  const { page } = await visit();
  await page.reload();
  change('half');
  writeFileList(folder);
  change('not what is listed');
  await page.reload();
  await modelIs(page, 'cup.glb');
  const states = await page.evaluate(async () => {
    const registration = (await navigator.serviceWorker.getRegistration())!;
    await registration.update().catch(() => undefined);
    const coming = registration.installing;
    if (coming && coming.state !== 'redundant')
      await new Promise((done) => coming.addEventListener('statechange', done));
    return [registration.waiting === null, registration.active?.state];
  });
  expect(states).toEqual([true, 'activated']);
  await server.close();
  await page.reload();
  await modelIs(page, 'cup.glb');
  expect(await editions(page)).toEqual([]);
});

test('where a service worker is refused, all is as without', async () => {
  server = await serve(folder, { isolated: true, policy: strictPolicy });
  opened = await openPage(
    `${server.url}/#model=cup`,
    { serviceWorkers: 'allow', reducedMotion: 'reduce' },
    (page) =>
      page.addInitScript(() => {
        ServiceWorkerContainer.prototype.register = () =>
          Promise.reject(new DOMException('denied', 'SecurityError'));
      }),
  );
  const { page, complaints } = opened;
  await modelIs(page, 'cup.glb');
  await fieldComplete(page.locator('girth-viewer'));
  expect(await page.locator('#offline').textContent()).toBe('');
  expect(complaints).toEqual([]);
});

test('the manifest can be installed: its icons are as large as it says, its formats are those of the page', async () => {
  const { page, context } = await visit();
  const session = await context.newCDPSession(page);
  const { installabilityErrors } = (await session.send('Page.getInstallabilityErrors')) as {
    installabilityErrors: { errorId: string }[];
  };
  // Contexts of tests are incognito windows, and nothing else is against it.
  expect(installabilityErrors.map(({ errorId }) => errorId)).toEqual(['in-incognito']);
  const manifest = JSON.parse(readFileSync(join(folder, 'manifest.webmanifest'), 'utf8')) as {
    icons: { src: string; sizes: string }[];
    file_handlers: { accept: Record<string, string[]> }[];
  };
  for (const { src, sizes } of manifest.icons) {
    const size = await page.evaluate(async (src) => {
      const image = new Image();
      image.src = src;
      await image.decode();
      return `${image.naturalWidth}x${image.naturalHeight}`;
    }, src);
    expect(size, src).toBe(sizes);
  }
  const accepted = Object.values(manifest.file_handlers[0]!.accept).flat();
  const chosen = (await page.locator('#file').getAttribute('accept'))!.split(',');
  // Files that are no models by themselves are not opened by themselves.
  expect(accepted.sort()).toEqual(chosen.filter((one) => !/bin|zip/.test(one)).sort());
});

test('a file that the system opens with the page', async () => {
  server = await serve(folder, { isolated: true, policy: strictPolicy });
  opened = await openPage(server.url, { reducedMotion: 'reduce' }, (page) =>
    page.addInitScript(
      (text) => {
        const files = [
          { kind: 'file', getFile: () => Promise.resolve(new File([text], 'launched.obj')) },
          {
            kind: 'file',
            getFile: () => Promise.reject(new DOMException('gone', 'NotFoundError')),
          },
        ];
        Object.defineProperty(window, 'launchQueue', {
          value: { setConsumer: (take: (launch: object) => void) => take({ files }) },
        });
      },
      box(2, 2, 2),
    ),
  );
  await modelIs(opened.page, 'launched.obj');
  expect(opened.complaints).toEqual([]);
});
