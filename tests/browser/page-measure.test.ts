// Two loops of a model measured, named and taken to a spreadsheet, from the page alone.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { clicksOn } from './clicks.js';
import { builtPage, drop, fragment, modelIs, picture } from './page-support.js';
import { repository } from './support.js';
import { placeOnSurface } from './viewer-page.js';

const openBuilt = builtPage();
/** A square prism in metres, 2 × 2 × 20. */
const prism = {
  name: 'prism.glb',
  bytes: readFileSync(join(repository, 'tests/data/prism_seams.glb')),
};

/** A cube of side 2: vertex k is where the bits of k say. */
const cube = [
  ...[0, 1, 2, 3, 4, 5, 6, 7].map((k) => `v ${k & 2 ? 2 : 0} ${k & 1 ? 2 : 0} ${k & 4 ? 2 : 0}`),
  ...['1 2 4 3', '5 7 8 6', '1 5 6 2', '3 4 8 7', '1 3 7 5', '2 6 8 4'].map((face) => `f ${face}`),
].join('\n');

/** The file that a click brings. */
async function downloaded(page: Page, click: () => Promise<void>) {
  const coming = page.waitForEvent('download');
  await click();
  const download = await coming;
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), 'utf8') };
}

test('two loops are named, copied as a table, and written as files of different names', async () => {
  const { page, viewer } = await openBuilt();
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await modelIs(page, 'chair.glb');
  await drop(page, prism);
  await modelIs(page, 'prism.glb');
  const places = [await placeOnSurface(viewer, 0.5, 0.4), await placeOnSurface(viewer, 0.5, 0.6)];
  const clicks = await clicksOn(page);
  const rows = page.locator('#loops tbody tr');
  for (const [i, { x, y }] of places.entries()) {
    await page.mouse.click(x, y);
    await rows.nth(i).waitFor();
  }
  const names = page.getByRole('textbox', { name: /^Name of loop/ });
  for (const [i, name] of ['neck', 'left, leg'].entries()) {
    await names.nth(i).click();
    await page.keyboard.type(name);
  }
  await page.getByRole('button', { name: 'Copy table' }).click();
  // A click for each loop, one for each name, one for the table.
  expect(await clicks()).toBe(5);
  await page.getByText('Copied: 2 rows.').waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  const lengths = await viewer.evaluate((element: GirthViewer) =>
    element.pinned.map(({ loop }) => loop.length),
  );
  const cells = copied.split('\n').map((row) => row.split('\t'));
  expect(cells[0]).toEqual(['loop', 'name', 'girth (m)', 'kind', 'at']);
  expect(cells.slice(1, 3).map(([, name]) => name)).toEqual(['neck', 'left, leg']);
  cells.slice(1, 3).forEach((row, i) => expect(Number(row[2])).toBeCloseTo(lengths[i]!, 10));
  expect(await page.locator('#loops thead').textContent()).toContain('Girth, m');
  for (const name of ['neck', 'left, leg']) {
    expect(await viewer.locator('.tag', { hasText: name }).count()).toBe(1);
  }

  const panel = page.locator('#loops-panel');
  const csv = await downloaded(page, () => panel.getByRole('button', { name: 'CSV' }).click());
  expect(csv.name).toBe('prism-loops.csv');
  expect(csv.text.split('\n')[2]).toMatch(/^2,"left, leg",[\d.]+,/);
  const files = [csv.name];
  for (const format of ['obj', 'json', 'glb', 'csv']) {
    await page.getByRole('button', { name: 'Export' }).click();
    const file = await downloaded(page, () =>
      page.locator(`#export-loops [data-format=${format}]`).click(),
    );
    files.push(file.name);
    if (format !== 'json') continue;
    const { loops } = JSON.parse(file.text) as { loops: { name: string; length: number }[] };
    expect(loops.map(({ name }) => name)).toEqual(['neck', 'left, leg']);
    expect(loops.map(({ length }) => length)).toEqual(lengths);
  }
  expect(files).toEqual([
    'prism-loops.csv',
    'prism-loops-obj.zip',
    'prism-loops.json',
    'prism-loops-glb.zip',
    'prism-loops.csv',
  ]);
  await picture(page, 'page-loops-table.png');
  expect(await complaintsOfAxe(page)).toEqual([]);

  // Both names are in the link, and come back with the model.
  await expect.poll(() => fragment(page)).toContain('names=neck,left%2C%20leg');
  const link = page.url();
  await page.goto('about:blank');
  await page.goto(link);
  const card = page.getByRole('region', { name: 'prism.glb' });
  await card.waitFor();
  expect(await card.locator('tbody tr').allTextContents()).toEqual([
    expect.stringMatching(/^1neck8\.00 m$/),
    expect.stringMatching(/^2left, leg8\.00 m$/),
  ]);
  expect(await viewer.evaluate((element: GirthViewer) => element.info)).toBeUndefined();
  await picture(page, 'page-missing-model.png');
  expect(await complaintsOfAxe(page)).toEqual([]);
  await drop(page, prism);
  await expect
    .poll(() => names.evaluateAll((inputs) => inputs.map((one) => (one as HTMLInputElement).value)))
    .toEqual(['neck', 'left, leg']);
});

test('where the clipboard is denied, the table stands there to be copied by hand', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await page.evaluate(() => {
    Object.defineProperty(navigator.clipboard, 'writeText', {
      value: () => Promise.reject(new DOMException('denied', 'NotAllowedError')),
    });
  });
  await viewer.evaluate((element: GirthViewer) => element.pin(0));
  await page.getByRole('button', { name: 'Copy table' }).click();
  const text = page.getByRole('textbox', { name: 'Table to copy' });
  await text.waitFor();
  expect(await text.inputValue()).toMatch(/^loop\tname\tgirth \(\w+\)\tkind\tat\n1\t\t[\d.]+\t/);
  const selected = await text.evaluate((area) => {
    const { selectionStart, selectionEnd, value } = area as HTMLTextAreaElement;
    return selectionEnd - selectionStart === value.length;
  });
  expect(selected).toBe(true);
});

test('two pinned points: how far they are apart, straight and along the surface', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'cube.obj', bytes: Buffer.from(cube) });
  await modelIs(page, 'cube.obj');
  const distance = page.getByRole('region', { name: 'Distance of two points' });
  const words = distance.getByRole('status');
  await viewer.evaluate(async (element: GirthViewer) => {
    element.setAttribute('unit', 'cm');
    await element.pin(0);
  });
  expect(await distance.isVisible()).toBe(false);
  // The corners at both ends of the cube's diagonal, over two faces; then of an edge.
  await viewer.evaluate((element: GirthViewer) => element.pin(7));
  const diagonal = `${Math.sqrt(12).toFixed(3)}\u202fcm straight, ${Math.sqrt(20).toFixed(3)}\u202fcm along the surface`;
  await expect.poll(() => words.textContent()).toBe(diagonal);
  // The way is a line on the surface while it is pointed at, and in no picture otherwise.
  const picture = () =>
    viewer.evaluate(async (element: GirthViewer) =>
      new Uint8Array(await (await element.snapshot()).arrayBuffer()).join(),
    );
  const bare = await picture();
  await distance.hover();
  expect(await picture()).not.toBe(bare);
  await page.mouse.move(1, 1);
  expect(await picture()).toBe(bare);
  await viewer.evaluate((element: GirthViewer) => element.pin(1));
  await expect.poll(() => words.textContent()).not.toBe(diagonal);
  await page.getByRole('combobox', { name: 'From' }).selectOption('1');
  await expect
    .poll(() => words.textContent())
    .toBe('2.000\u202fcm straight, 2.000\u202fcm along the surface');
  await page.getByRole('textbox', { name: 'Name of loop 1' }).fill('corner');
  await page.keyboard.press('Enter');
  await expect
    .poll(() => distance.locator('option:checked').allTextContents())
    .toEqual(['1 corner', '3']);
  // A script's name is in the lists, too.
  await viewer.evaluate((element: GirthViewer) => element.nameLoop(3, 'edge'));
  await page.getByRole('textbox', { name: 'Name of loop 3' }).waitFor();
  expect(await page.getByRole('textbox', { name: 'Name of loop 3' }).inputValue()).toBe('edge');
  await expect
    .poll(() => distance.locator('option:checked').allTextContents())
    .toEqual(['1 corner', '3 edge']);
});
