// Files of earlier visits, with their pictures: opened again, forgotten, and what is said where nothing can be kept.

import { zipSync } from 'fflate';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { complaintsIn } from './axe.js';
import { box, torus } from './meshes.js';
import { builtPage, drop, fragment, modelIs, screensInBoth, showOn } from './page-support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();
const ring = { name: 'ring.obj', bytes: Buffer.from(torus(40, 20)) };
const cube = { name: 'cube.obj', bytes: Buffer.from(box(2, 2, 2)) };

const rows = (page: Page): Promise<string[]> =>
  page.locator('#recent li b').evaluateAll((names) => names.map((name) => name.textContent));

/** The share of each picture that something is drawn on. */
const drawnShares = (page: Page): Promise<number[]> =>
  page.locator('#recent canvas').evaluateAll((all: HTMLCanvasElement[]) =>
    all.map((canvas) => {
      const { data } = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
      return data.filter((alpha, i) => i % 4 === 3 && alpha > 100).length / (data.length / 4);
    }),
  );

async function openTwo() {
  const opened = await openBuilt('model=cup', { viewport: { width: 1440, height: 900 } });
  const { page, viewer } = opened;
  await modelIs(page, 'cup.glb');
  for (const file of [ring, cube]) {
    await drop(page, file);
    await modelIs(page, file.name);
    await fieldComplete(viewer);
    await expect.poll(async () => (await rows(page))[0]).toBe(file.name);
    // Whoever goes on before the picture is there has none.
    await expect.poll(async () => (await drawnShares(page))[0]).toBeGreaterThan(0.1);
  }
  expect(await rows(page)).toEqual(['cube.obj', 'ring.obj']);
  await expect
    .poll(async () => (await drawnShares(page)).every((share) => share > 0.1 && share < 0.95))
    .toBe(true);
  return opened;
}

test('on the next visit files are there with their pictures, and are opened by the keyboard alone', async () => {
  const { page } = await openTwo();
  // A model from elsewhere is none of them.
  await page.locator('#examples button', { hasText: 'Octopus' }).click();
  await modelIs(page, 'octopus.glb');
  await expect.poll(() => fragment(page)).toBe('model=octopus');
  await page.reload();
  await modelIs(page, 'octopus.glb');
  const foot = page.getByRole('group', { name: 'Recent files' });
  expect(await foot.locator('button').allTextContents()).toEqual(['cube.obj', 'ring.obj']);
  await expect.poll(async () => (await drawnShares(page)).every((share) => share > 0.1)).toBe(true);
  await foot.getByRole('button', { name: 'ring.obj' }).focus();
  await page.keyboard.press('Enter');
  await modelIs(page, 'ring.obj');
  expect(await foot.isVisible()).toBe(false);
  await expect.poll(() => rows(page)).toEqual(['ring.obj', 'cube.obj']);
  await page.locator('#recent-open').focus();
  await page.keyboard.press('Enter');
  expect(await page.locator('#recent small').allTextContents()).toEqual([
    expect.stringMatching(/^today · \d+ kB · a copy$/),
    'today · 1 kB · a copy',
  ]);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  // Also while a picture comes, with which the list is made anew.
  const focused = (): Promise<string | null> =>
    page.evaluate(
      () => document.activeElement?.closest('li')?.querySelector('b')?.textContent ?? null,
    );
  expect(await focused()).toBe('cube.obj');
  await page.keyboard.press('Enter');
  await modelIs(page, 'cube.obj');
  expect(await page.locator('#recent').isVisible()).toBe(false);
  // It is a command, too.
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).waitFor();
  await page.keyboard.type('recent ring');
  await page.keyboard.press('Enter');
  await modelIs(page, 'ring.obj');
});

test('one is forgotten, then all; nothing of them stays', async () => {
  const { page } = await openTwo();
  await page.locator('#recent-open').click();
  await page.getByRole('button', { name: 'Forget ring.obj' }).click();
  await expect.poll(() => rows(page)).toEqual(['cube.obj']);
  await page.getByRole('button', { name: 'Forget all' }).click();
  await expect.poll(() => rows(page)).toEqual([]);
  expect(await page.locator('#recent-open').isVisible()).toBe(false);
  await page.reload();
  await page.locator('#missing').waitFor();
  expect(await rows(page)).toEqual([]);
});

test.each([
  ['no room', 'QuotaExceededError', /no room left/],
  ['nothing may be kept', 'InvalidStateError', /keeps no files/],
])('%s: a word in the menu, and the model is there', async (_, name, words) => {
  const { page, viewer } = await openBuilt('model=cup');
  await modelIs(page, 'cup.glb');
  await page.evaluate((name) => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException('not now', name);
    };
  }, name);
  await drop(page, cube);
  await modelIs(page, 'cube.obj');
  await fieldComplete(viewer);
  await page.locator('#recent-open').click();
  expect(await page.locator('#recent [role=status]').textContent()).toMatch(words);
});

test('a handle is read again, as the file is now; one that is gone is said to be', async () => {
  const { page } = await openBuilt('model=cup');
  await modelIs(page, 'cup.glb');
  // Handles of the page's own private files can be kept as those of the disk can.
  const write = (text: string | undefined): Promise<void> =>
    page.evaluate(async (text) => {
      const root = await navigator.storage.getDirectory();
      if (text === undefined) return root.removeEntry('mine.obj');
      const writable = await (
        await root.getFileHandle('mine.obj', { create: true })
      ).createWritable();
      await writable.write(text);
      await writable.close();
    }, text);
  await write(box(2, 2, 2));
  await page.evaluate(async () => {
    const root = await navigator.storage.getDirectory();
    const handle = await root.getFileHandle('mine.obj');
    Object.assign(DataTransferItem.prototype, {
      getAsFileSystemHandle: () => Promise.resolve(handle),
    });
  });
  await drop(page, { name: 'mine.obj', bytes: Buffer.from(box(2, 2, 2)) });
  await modelIs(page, 'mine.obj');
  await expect
    .poll(() => page.locator('#recent small').allTextContents())
    .toEqual(['today · 1 kB · read again']);
  await write(torus(12, 8));
  await page.reload();
  await page.locator('#recent-open').click();
  await page.locator('#recent li button').first().click();
  await page.locator('#model', { hasText: '192 faces' }).waitFor();
  await write(undefined);
  await page.locator('#recent-open').click();
  await page.locator('#recent li button').first().click();
  await expect
    .poll(() => page.locator('#recent [role=status]').textContent())
    .toBe('mine.obj could not be read again: it was moved or deleted.');
});

test.each([
  ['a file', cube],
  ['a zip', { name: 'cube.zip', bytes: Buffer.from(zipSync({ 'cube.obj': cube.bytes })) }],
])('%s that is dropped before the page is ready is opened when it is', async (_, dropped) => {
  const { page } = await openBuilt('model=cup');
  let goOn = (): void => undefined;
  const held = new Promise<void>((done) => (goOn = done));
  await page.route(/assets\/main-.*\.js$/, async (route) => {
    await held;
    await route.continue();
  });
  await page.reload({ waitUntil: 'commit' });
  await page.waitForFunction(() => document.documentElement.dataset['scheme'] !== undefined);
  await drop(page, dropped);
  goOn();
  await modelIs(page, 'cube.obj');
});

test('no complaint of axe at two sizes, and pictures', async () => {
  const { page } = await openTwo();
  await page.reload();
  await page.getByRole('group', { name: 'Recent files' }).waitFor();
  for (const screen of screensInBoth) {
    const keep = await showOn(page, screen);
    const shown = `${screen.scheme}, ${screen.width}`;
    expect(await complaintsIn(screen.scheme, page), shown).toEqual([]);
    await keep('recent-foot');
    await page.locator('#recent-open').click();
    await page.locator('#recent').waitFor();
    expect(await complaintsIn(screen.scheme, page), shown).toEqual([]);
    await keep('recent');
    await page.keyboard.press('Escape');
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(overflow).toBe(0);
  }
});
