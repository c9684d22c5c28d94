// How thick here, in a plane: tape, perimeter and area of the curves of a section, and beside them the loops.

import type { Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { clicksOn } from './clicks.js';
import { hand } from './meshes.js';
import { builtPage, drop, modelIs, screens, showOn } from './page-support.js';

const openBuilt = builtPage({ isolated: false });
let page: Page;
let viewer: Locator;
let panel: Locator;

beforeEach(async () => {
  ({ page, viewer } = await openBuilt());
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'hand.obj', bytes: Buffer.from(hand([9, 6])) });
  await modelIs(page, 'hand.obj');
  await viewer.evaluate((element: GirthViewer) => element.setAttribute('unit', 'mm'));
  panel = page.locator('#sections-panel');
});

/** Opens the panel with a plane across the fingers. */
async function cutFingers(height: string): Promise<void> {
  await panel.locator('summary').click();
  await panel.getByLabel('Across').selectOption('z');
  await panel.locator('#section-height').fill(height);
  await page.keyboard.press('Enter');
}

const curves = (): Locator => panel.locator('table').first().locator('tbody tr');

async function copied(actions: Locator): Promise<string[][]> {
  await actions.getByRole('button', { name: 'Copy table' }).click();
  await actions.getByText(/^Copied: /).waitFor();
  const text = await page.evaluate(() => navigator.clipboard.readText());
  return text
    .trim()
    .split('\n')
    .map((row) => row.split('\t'));
}

test('the curves of a plane at a typed height, in three actions, and to a spreadsheet', async () => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const clicks = await clicksOn(page);
  await cutFingers('8 mm');
  const words = panel.getByText(
    '2 curves: together 16.00 mm, one tape round all of them 16.00 mm.',
  );
  await words.waitFor();
  expect(await clicks()).toBe(2);
  for (const row of await curves().all()) {
    const cells = await row.locator('td').allTextContents();
    expect(cells).toEqual(['8.00', '8.00', '4.00', '2.00 ×2.83']);
  }
  await expect.poll(() => page.url()).toContain('section=z');
  const [head, ...rows] = await copied(panel.locator('.table-actions').first());
  expect(head).toEqual([
    ...['curve', 'tape (mm)', 'perimeter (mm)', 'area (mm²)'],
    ...['least width (mm)', 'greatest width (mm)', 'kind'],
  ]);
  expect(rows.map((row) => row.slice(1, 4).map(Number))).toEqual([
    [8, 8, 4],
    [8, 8, 4],
  ]);
  // Below the fingers there is one curve; the plane is the one of the bar, and of the link.
  await panel.getByLabel('Height of the plane').fill('150');
  await panel.getByText('One curve: tape 28.00 mm.').waitFor();
  await viewer.evaluate((element: GirthViewer) => element.setAttribute('section', 'z 90%'));
  await panel.getByText('One curve: tape 8.00 mm.').waitFor();
  await panel.locator('#section-height').fill('20 mm');
  await page.keyboard.press('Enter');
  await panel.getByText('The surface reaches from 0.00 mm to 13.00 mm.').waitFor();
  for (const screen of screens) {
    const keep = await showOn(page, screen);
    await panel.scrollIntoViewIfNeeded();
    await keep('page-sections');
    expect(await complaintsOfAxe(page, undefined, '#sections-panel')).toEqual([]);
  }
});

test('ten named points: loop, perimeter and tape of each, to a spreadsheet', async () => {
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await panel.locator('summary').click();
  await viewer.evaluate(async (element: GirthViewer) => {
    const { positions } = element.geometry;
    const heights = Array.from({ length: positions.length / 3 }, (_, v) => positions[3 * v + 2]!);
    const between = heights.flatMap((z, v) => (z > 6 && z < 9 ? [v] : []));
    for (const vertex of between.slice(0, 10)) {
      const { id } = await element.pin(vertex);
      element.nameLoop(id, `finger ${id}`);
    }
  });
  const pinned = panel.getByRole('region', { name: 'At pinned loops' });
  const rows = pinned.locator('tbody tr');
  await expect.poll(() => rows.count()).toBe(10);
  await expect.poll(() => rows.filter({ hasText: '…' }).count()).toBe(0);
  for (const row of await rows.all()) {
    expect(await row.locator('td').allTextContents()).toEqual(['8.00', '8.00', '8.00']);
  }
  const [head, ...cells] = await copied(pinned.locator('.table-actions'));
  expect(head).toEqual(['name', 'loop (mm)', 'perimeter (mm)', 'tape (mm)']);
  expect(cells).toHaveLength(10);
  for (const [name, ...lengths] of cells) {
    expect(name).toMatch(/^finger \d+$/);
    for (const length of lengths) expect(Number(length)).toBeCloseTo(8, 9);
  }
});
