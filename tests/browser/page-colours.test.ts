// Colours and reading: the range that follows the body, its ends typed, the logarithm, what stays in sight.

import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { builtPage, drop, fragment, modelIs, openPanel } from './page-support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();

/** A long thin pipe of triangles, closed by points: at its ends the girth is as long as there and back. */
const rod = (() => {
  const [around, along] = [6, 300];
  const lines: string[] = [];
  for (let i = 0; i <= along; ++i) {
    // A little wider from ring to ring: values that are all the same have no body.
    const width = 1 + i / along;
    for (let k = 0; k < around; ++k) {
      const angle = (2 * Math.PI * k) / around;
      const [x, z] = [width * Math.cos(angle), width * Math.sin(angle)];
      lines.push(`v ${x.toFixed(5)} ${i} ${z.toFixed(5)}`);
    }
  }
  lines.push('v 0 -0.2 0', `v 0 ${along + 0.2} 0`);
  const [first, last] = [lines.length - 1, lines.length];
  for (let i = 0; i < along; ++i) {
    for (let k = 0; k < around; ++k) {
      const [a, b] = [i * around + k + 1, i * around + ((k + 1) % around) + 1];
      lines.push(`f ${a} ${a + around} ${b + around}`, `f ${a} ${b + around} ${b}`);
    }
  }
  for (let k = 0; k < around; ++k) {
    const next = (k + 1) % around;
    lines.push(`f ${k + 1} ${next + 1} ${first}`);
    lines.push(`f ${along * around + next + 1} ${along * around + k + 1} ${last}`);
  }
  return lines.join('\n');
})();

async function showRod(page: Page, viewer: Locator): Promise<void> {
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'rod.obj', bytes: Buffer.from(rod) });
  await modelIs(page, 'rod.obj');
  await fieldComplete(viewer);
}
const shown = (viewer: Locator) =>
  viewer.evaluate((element: GirthViewer) => {
    const { range, extent, log } = element.shown!;
    return { range: range!, extent: extent!, log };
  });

test('few places do not take all colours; the legend says what they are, and shows them', async () => {
  const { page, viewer } = await openBuilt();
  await showRod(page, viewer);
  const { range, extent } = await shown(viewer);
  expect(extent[1]).toBeGreaterThan(500);
  expect(range[1]).toBeLessThan(13);
  const beyond = viewer.locator('.legend-beyond');
  await expect.poll(() => beyond.textContent()).toMatch(/up to \d+\.\d+ in \d\.\d% of the surface/);
  expect(await viewer.locator('.legend-tick').first().textContent()).toMatch(/^≥/);
  expect(await complaintsOfAxe(page)).toEqual([]);
  await beyond.getByRole('button', { name: 'Full range' }).click();
  await expect.poll(async () => (await shown(viewer)).range).toEqual(extent);
  expect(await page.locator('#range').inputValue()).toBe('0% 100%');
  expect(await beyond.isVisible()).toBe(false);
});

test('ends are typed in any unit, and what is no end is said', async () => {
  const { page, viewer } = await openBuilt('model=dumbbell');
  await modelIs(page, 'dumbbell.glb');
  await fieldComplete(viewer);
  const high = page.locator('#range-high');
  await high.fill('200 mm');
  await high.press('Enter');
  expect((await shown(viewer)).range[1]).toBeCloseTo(0.2, 12);
  expect(await page.locator('#range').inputValue()).toBe('own');
  await high.fill('0.3 x');
  await high.press('Enter');
  expect(await page.locator('.caption').textContent()).toContain('has an unknown unit');
  expect(await high.getAttribute('aria-invalid')).toBe('true');
  expect((await shown(viewer)).range[1]).toBeCloseTo(0.2, 12);
  await high.press('Escape');
  expect(await page.locator('.caption').textContent()).toContain('median');
});

test('a logarithmic map is kept in the link', async () => {
  const { page, viewer } = await openBuilt('model=dumbbell&log=1');
  await modelIs(page, 'dumbbell.glb');
  await fieldComplete(viewer);
  // Palettes that fail for colour-blind eyes are named as such.
  const group = page.locator('#colormap optgroup');
  expect(await group.getAttribute('label')).toBe('Not for colour-blind eyes');
  expect(await group.locator('option').allTextContents()).toEqual(['turbo']);
  expect((await shown(viewer)).log).toBe(true);
  const log = page.getByRole('checkbox', { name: 'log' });
  expect(await log.isChecked()).toBe(true);
  await log.uncheck();
  expect((await shown(viewer)).log).toBe(false);
  await expect.poll(() => fragment(page)).not.toContain('log');
});

test('a panel opened while the girth is computed leaves the colours that are there', async () => {
  const { page, viewer } = await openBuilt();
  await showRod(page, viewer);
  // The fields that parts are made of are not there yet: they are asked for now.
  await viewer.evaluate((element: GirthViewer) => {
    const fieldOf = element.shown!.name;
    element.setAttribute('field', 'parts');
    Object.assign(globalThis, { seen: [fieldOf, element.shown!.name] });
  });
  expect(await page.evaluate(() => (globalThis as unknown as { seen: string[] }).seen)).toEqual([
    'igf',
    'igf',
  ]);
  await expect
    .poll(() => viewer.evaluate((element: GirthViewer) => element.shown?.name))
    .toBe('parts');
});

test('field and footer stay in sight while the panel scrolls', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
  const panel = await openPanel(page, 'parts');
  await panel.locator('.controls').waitFor();
  const staysInSight = async (ids: string[], height: number): Promise<void> => {
    await page.locator('aside').evaluate((aside) => aside.scrollTo(0, aside.scrollHeight / 2));
    for (const id of ids) {
      const box = (await page.locator(id).first().boundingBox())!;
      expect(box.y).toBeGreaterThan(50);
      expect(box.y + box.height).toBeLessThanOrEqual(height);
    }
  };
  await staysInSight(['#field-name', '#colormap', '.ways-out button'], 768);
  // Where there is less room, the field's name.
  await page.setViewportSize({ width: 1024, height: 560 });
  await staysInSight(['#field-name', '.ways-out button'], 560);
  expect((await page.locator('#colormap').boundingBox())!.y).toBeLessThan(50);
});
