// The panel of tubes: the degree of a narrowing, what it is compared with, the diameter along the centreline, and surfaces that
// are no tubes.

import type { Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { clicksOn } from './clicks.js';
import { box, tube } from './meshes.js';
import { builtPage, drop, modelIs, screens, showOn } from './page-support.js';

const openBuilt = builtPage({ isolated: false });
let page: Page;
let viewer: Locator;
let panel: Locator;

/** Half as wide at a third of its length, and a quarter wider at two thirds. */
const vessel = tube(
  121,
  24,
  60,
  (height) =>
    2 - Math.exp(-(((height - 20) / 3) ** 2)) + 0.5 * Math.exp(-(((height - 40) / 3) ** 2)),
);

beforeEach(async () => {
  ({ page, viewer } = await openBuilt());
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'vessel.obj', bytes: Buffer.from(vessel) });
  await modelIs(page, 'vessel.obj');
  await viewer.evaluate((element: GirthViewer) => element.setAttribute('unit', 'mm'));
  panel = page.locator('#tube-panel');
});

const places = (): Locator =>
  panel.getByRole('list', { name: 'Narrowings and widenings' }).locator('li');

/** The numbers in front of the percent signs. */
async function degrees(place: Locator): Promise<number[]> {
  const text = await place.locator('.words').textContent();
  return [...(text ?? '').matchAll(/([\d.]+)\u202f%/g)].map(([, number]) => Number(number));
}

test('the degree of a narrowing and of a bulge, in one action', async () => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const clicks = await clicksOn(page);
  await panel.locator('summary').click();
  await panel.getByText('One branch.').waitFor();
  expect(await clicks()).toBe(1);
  const [narrow, wide] = await places().all();
  expect(await narrow!.textContent()).toContain('narrower');
  expect(await wide!.textContent()).toContain('wider');
  for (const [place, byDiameter, byArea] of [
    [narrow!, 50, 75],
    [wide!, 25, 56.25],
  ] as const) {
    const [diameter, area] = await degrees(place);
    expect(Math.abs(diameter! - byDiameter)).toBeLessThan(1);
    expect(Math.abs(area! - byArea)).toBeLessThan(1.5);
  }
  expect(await panel.locator('summary').textContent()).toContain('2');
  for (const screen of screens) {
    const keep = await showOn(page, screen);
    await panel.evaluate((element) => element.scrollIntoView({ block: 'start' }));
    await keep('page-tube');
    expect(await complaintsOfAxe(page, undefined, '#tube-panel')).toEqual([]);
  }
  await panel.getByRole('button', { name: 'Copy table' }).click();
  await panel.getByText(/^Copied: /).waitFor();
  const [head, ...rows] = (await page.evaluate(() => navigator.clipboard.readText()))
    .trim()
    .split('\n')
    .map((row) => row.split('\t'));
  expect(head!.slice(0, 3)).toEqual(['branch', 'distance (mm)', 'equivalent diameter (mm)']);
  const diameters = rows.map((row) => Number(row[2]));
  expect(Math.min(...diameters)).toBeLessThan(2.02);
  expect(Math.max(...diameters)).toBeGreaterThan(4.9);
});

test('the section at the cursor is said, and its loop pinned; another reference is in the link, and undone', async () => {
  await panel.locator('summary').click();
  await panel.getByText('One branch.').waitFor();
  const plot = panel.getByRole('slider', { name: 'Diameter along the centreline' });
  await plot.focus();
  await page.keyboard.press('ArrowRight');
  await panel.getByText(/from the beginning: diameter 3\.98\smm, largest circle inside/).waitFor();
  await page.keyboard.press('Enter');
  await expect.poll(() => viewer.evaluate((element: GirthViewer) => element.pinned.length)).toBe(1);
  await panel.getByLabel('Compared with').selectOption('mean');
  await expect.poll(() => page.url()).toContain('reference=mean');
  await page.keyboard.press('Control+z');
  await expect.poll(() => panel.getByLabel('Compared with').inputValue()).toBe('taper');
  await panel.getByText('One branch.').waitFor();
});

test('a surface that is no tube says why; another model is measured anew', async () => {
  await panel.locator('summary').click();
  await panel.getByText('One branch.').waitFor();
  await drop(page, { name: 'cube.obj', bytes: Buffer.from(box(4, 4, 4)) });
  await modelIs(page, 'cube.obj');
  await panel
    .getByText('The surface is no tube: it is less than 2.5 times as long as wide.')
    .waitFor();
  expect(await places().count()).toBe(0);
});
