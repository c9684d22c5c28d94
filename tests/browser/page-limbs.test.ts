// How thick round is each finger: from the page alone, in four clicks; and loops that slide along a limb.

import { readFileSync } from 'node:fs';
import type { Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { clicksOn } from './clicks.js';
import { hand } from './meshes.js';
import { builtPage, drop, modelIs, picture } from './page-support.js';

const openBuilt = builtPage();
let page: Page;
let viewer: Locator;
let panel: Locator;

beforeEach(async () => {
  ({ page, viewer } = await openBuilt());
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'hand.obj', bytes: Buffer.from(hand([9, 6])) });
  await modelIs(page, 'hand.obj');
  panel = page.locator('#limbs-panel');
});

const rows = (): Locator => panel.locator('tbody tr:not(.along)');
const plots = (): Locator => panel.getByRole('slider');
const girths = () => viewer.evaluate(async (element: GirthViewer) => (await element.limbs()).limbs);

test('a row for each finger, in mm, to a spreadsheet in four clicks', async () => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const clicks = await clicksOn(page);
  // An OBJ file does not state its unit.
  await page.locator('#details-open').click();
  await page.locator('#details').getByLabel('Unit of the file').selectOption('mm');
  await page.keyboard.press('Escape');
  await panel.locator('summary').click();
  await rows().nth(1).waitFor();
  await panel.getByRole('button', { name: 'Copy table' }).click();
  // The details, the unit, the panel, the table.
  expect(await clicks()).toBe(4);
  await panel.getByText('Copied: 2 rows.').waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  const [head, ...cells] = copied
    .trim()
    .split('\n')
    .map((row) => row.split('\t'));
  expect(head!.slice(0, 3)).toEqual(['limb', 'length (mm)', 'narrowest (mm)']);
  expect(await panel.locator('caption').textContent()).toBe('Lengths and girths in mm');
  const limbs = await girths();
  cells.forEach((row, i) => {
    const { length, median, middle, base, end } = limbs[i]!;
    const [number, , narrowest] = row;
    expect([number, Number(narrowest).toFixed(6), row[7]]).toEqual([
      String(i + 1),
      '8.000000',
      end,
    ]);
    expect(Number(row[1])).toBeCloseTo(length, 9);
    expect(Number(row[4])).toBeCloseTo(median, 9);
    expect(Number(row[5])).toBeCloseTo(middle, 9);
    expect(Number(row[6])).toBeCloseTo(base, 9);
  });
  const { length, narrowest, median, middle, base } = limbs[0]!;
  expect(await rows().first().locator('td').allTextContents()).toEqual(
    [length, narrowest, median, middle, base].map((value) => value.toFixed(2)),
  );
  expect(await panel.locator('.count').textContent()).toBe('2');

  // Along the axis of the first finger: what the element measures, as a plot and as files, and in the link.
  const axis = panel.getByRole('button', { name: 'Profile along the axis of limb 1' });
  await axis.click();
  expect(await axis.getAttribute('aria-pressed')).toBe('true');
  const along = panel.getByRole('slider', { name: /^Girth along the axis of the limb/ });
  await along.waitFor();
  const measured = await viewer.evaluate(async (element: GirthViewer) => {
    const { length, loops } = await element.axis((await element.limbs()).limbs[0]!);
    return { length, girths: loops.map(({ girth }) => girth) };
  });
  expect(await along.getAttribute('aria-valuemax')).toBe(String(measured.girths.length - 1));
  const section = panel.locator('.limb-axis');
  await section.getByText(`${measured.length.toFixed(2)} mm along the axis`).waitFor();
  const saving = page.waitForEvent('download');
  await section.getByRole('button', { name: 'CSV' }).click();
  const saved = await saving;
  expect(saved.suggestedFilename()).toBe('hand-axis-1.csv');
  const lines = readFileSync(await saved.path(), 'utf8')
    .trim()
    .split(/\r?\n/);
  expect(lines[0]).toBe('distance (mm),along (mm),girth (mm),area (mm²)');
  expect(lines.slice(1).map((line) => Number(line.split(',')[2]))).toEqual(
    measured.girths.map((girth) => expect.closeTo(girth, 9) as number),
  );
  const lining = page.waitForEvent('download');
  await section.getByRole('button', { name: 'OBJ' }).click();
  expect((await lining).suggestedFilename()).toBe('hand-axis-1.obj');
  // The loop at the cursor is the swept one.
  await along.focus();
  await viewer.evaluate((element: GirthViewer) => {
    element.addEventListener('pick', ({ detail: { loop } }) => {
      element.dataset['swept'] = String(loop.length);
    });
  });
  await page.keyboard.press('Home');
  const swept = () => viewer.getAttribute('data-swept').then(Number);
  await expect.poll(swept).toBeCloseTo(measured.girths[0]!, 9);
  await expect.poll(() => page.url()).toContain('axis=1');
  await picture(page, 'page-axis.png');
  await axis.click();
  await along.waitFor({ state: 'hidden' });
  await expect.poll(() => page.url()).not.toContain('axis=1');

  // The whole, with every profile, as files.
  await page.getByRole('button', { name: 'Export' }).click();
  const coming = page.waitForEvent('download');
  await page.locator('#export-limbs [data-format=csv]').click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe('hand-limb-profiles.csv');
  const profile = readFileSync(await download.path(), 'utf8')
    .trim()
    .split('\n');
  expect(profile.length).toBe(1 + 2 * 64);
});

test('measuring is stopped at once, and begins again when asked', async () => {
  // As long as somebody lets it.
  await viewer.evaluate((element: GirthViewer) => {
    element.limbs = ({ signal, onProgress } = {}) => {
      onProgress?.(0.25);
      return new Promise((_, reject) => {
        signal!.addEventListener('abort', () => reject(new Error('cancelled')));
      });
    };
  });
  await panel.locator('summary').click();
  await panel.getByText('Measuring limbs … 25\u202f%').waitFor();
  await viewer.evaluate((element: GirthViewer) => delete (element as Partial<GirthViewer>).limbs);
  await panel.getByRole('button', { name: 'Cancel' }).click();
  await panel.getByText('Not measured.').waitFor();
  expect(await rows().count()).toBe(0);
  await panel.getByRole('button', { name: 'Measure' }).click();
  await expect.poll(() => rows().count()).toBe(2);
  expect(await panel.getByRole('button', { name: 'Cancel' }).isVisible()).toBe(false);
});

test('numbers stand on the surface, names that are typed take their place, and loops are called by them', async () => {
  const marks = viewer.locator('.number-mark');
  expect(await marks.count()).toBe(0);
  await panel.locator('summary').click();
  await rows().nth(1).waitFor();
  await expect.poll(() => marks.allTextContents()).toEqual(['1', '2']);
  const name = panel.getByRole('textbox', { name: 'Name of limb 2' });
  await name.fill('ring finger');
  await page.keyboard.press('Enter');
  await expect.poll(() => marks.allTextContents()).toEqual(['1', 'ring finger']);
  await expect.poll(() => page.url()).toContain('limbNames=,ring%2520finger');
  // A click on a plot pins the loop there.
  const plot = plots().nth(1);
  await plot.evaluate((element) => element.scrollIntoView({ block: 'center' }));
  const box = (await plot.locator('.u-over').boundingBox())!;
  await page.mouse.click(box.x + 0.5 * box.width, box.y + box.height / 2);
  const names = () =>
    viewer.evaluate((element: GirthViewer) => element.pinned.map(({ name }) => name));
  await expect.poll(names).toEqual(['ring finger']);
  await page.locator('#undo').click();
  await page.locator('#undo').click();
  await expect.poll(() => page.url()).not.toContain('limbNames=');
  await expect.poll(() => marks.allTextContents()).toEqual(['1', '2']);
  expect(await name.inputValue()).toBe('');
  await panel.locator('summary').click();
  await expect.poll(() => marks.count()).toBe(0);
});

test('the cursor of a plot moves the loop, and the pointer on the surface the cursor', async () => {
  await panel.locator('summary').click();
  await rows().nth(1).waitFor();
  const plot = plots().first();
  // Not under the footer.
  await plot.evaluate((element) => element.scrollIntoView({ block: 'center' }));
  const box = (await plot.locator('.u-over').boundingBox())!;
  const readout = viewer.locator('.readout');
  await page.mouse.move(box.x + 0.5 * box.width, box.y + box.height / 2);
  await expect.poll(() => readout.textContent()).toContain('8.00');
  expect(await plot.getAttribute('aria-valuetext')).toMatch(/from the tip: girth 8\.00/);
  await page.mouse.click(box.x + 0.5 * box.width, box.y + box.height / 2);
  await expect.poll(() => viewer.evaluate((element: GirthViewer) => element.pinned.length)).toBe(1);
  const pinned = await viewer.evaluate((element: GirthViewer) => element.pinned[0]!.loop.length);
  expect(pinned).toBeCloseTo(8, 9);
  await page.mouse.move(1, 1);
  await expect.poll(() => plot.getAttribute('aria-valuetext')).toBe('nowhere');

  // By the keyboard, from the tip to the base.
  await plot.focus();
  await page.keyboard.press('End');
  expect(await plot.getAttribute('aria-valuenow')).toBe('63');
  await expect.poll(() => readout.isVisible()).toBe(true);
  await page.keyboard.press('ArrowLeft');
  expect(await plot.getAttribute('aria-valuenow')).toBe('62');
  await page.keyboard.press('Escape');
  await expect.poll(() => readout.isVisible()).toBe(false);

  // On the surface, half-way along the second finger.
  const { x, y, distance } = await viewer.evaluate(async (element: GirthViewer) => {
    const { vertices, distances, length } = (await element.limbs()).limbs[1]!;
    const { left, top } = element.getBoundingClientRect();
    const seen = [...vertices]
      .map((vertex, i) => ({ ...element.screenPosition(vertex), distance: distances[i]! }))
      .filter(({ visible }) => visible)
      .sort((a, b) => Math.abs(a.distance - length / 2) - Math.abs(b.distance - length / 2))[0]!;
    return { x: left + seen.x, y: top + seen.y, distance: seen.distance };
  });
  await page.mouse.move(x, y);
  const other = plots().nth(1);
  await expect.poll(() => other.getAttribute('aria-valuetext')).not.toBe('nowhere');
  const words = (await other.getAttribute('aria-valuetext'))!;
  expect(Math.abs(parseFloat(words) - distance)).toBeLessThan(1.2);
  expect(await panel.locator('tr.pointed').count()).toBe(2);

  // A row shows its limb alone.
  const camera = () => viewer.evaluate((element: GirthViewer) => JSON.stringify(element.camera));
  const before = await camera();
  const button = rows().nth(1).getByRole('button');
  await button.click();
  expect(await button.getAttribute('aria-pressed')).toBe('true');
  await expect.poll(camera).not.toBe(before);
});
