// Necks, handles and tunnels on the page: found, listed, shown, and the surface cut along them.

import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { dumbbell, torus } from './meshes.js';
import { builtPage, drop, fragment, modelIs, openPanel, pictures } from './page-support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();

/** The page with a drawn model. */
async function openWith(name: string, text: string, options = {}) {
  const built = await openBuilt(undefined, options);
  await modelIs(built.page, 'chair.glb');
  await drop(built.page, { name, bytes: Buffer.from(text) });
  await modelIs(built.page, name);
  await fieldComplete(built.viewer);
  return built;
}

async function downloaded(page: Page, format: string) {
  const coming = page.waitForEvent('download');
  await page.locator(`#necks-panel [data-format=${format}]`).click();
  const download = await coming;
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

test('a neck is listed, shown, and the surface cut along it', async () => {
  mkdirSync(pictures, { recursive: true });
  const { page, viewer } = await openWith('dumbbell.obj', dumbbell(16, 12));
  const panel = await openPanel(page, 'necks');
  const rows = panel.getByRole('list', { name: 'Necks' }).getByRole('button');
  await rows.first().waitFor({ timeout: 60_000 });
  const known = await viewer.evaluate(async (element: GirthViewer) => {
    const { necks } = await element.necks();
    const { area } = element.info!;
    const [{ length, sides }] = necks as [(typeof necks)[0]];
    return { count: necks.length, length, sides: sides.map((side) => side.area), area };
  });
  expect(await rows.count()).toBe(known.count);
  expect(await panel.locator('h3').allTextContents()).toContain('No handle and no tunnel');
  expect(Number.parseFloat((await rows.first().textContent())!.replace(/^1/, ''))).toBeCloseTo(
    known.length,
    1,
  );
  expect(known.sides.reduce((sum, area) => sum + area, 0)).toBeCloseTo(known.area, 9);
  const cut = panel.getByRole('button', { name: 'Cut here' });
  expect(await cut.isDisabled()).toBe(true);
  await rows.first().focus();
  await page.keyboard.press('Enter');
  expect(await rows.first().getAttribute('aria-pressed')).toBe('true');
  await panel.getByText(/^Chosen: .* long; it separates an area of .* from an area of /).waitFor();
  await cut.click();
  await panel.getByText('Cut into 2 parts.').waitFor();
  const parts = panel.getByRole('list', { name: 'Parts of the cut' }).getByRole('listitem');
  expect(await parts.count()).toBe(2);
  expect(await parts.first().textContent()).toMatch(/area .*² · volume .*³|area [\d.,]+ · volume/);
  await expect.poll(() => fragment(page)).toContain('panel=necks');
  await page.screenshot({ path: join(pictures, 'page-cut.png') });
  // A line that is scrolled away in part is no touch target.
  await page.locator('aside').evaluate((aside) => aside.scrollTo(0, 0));
  expect(await complaintsOfAxe(page)).toEqual([]);

  const glb = await downloaded(page, 'glb');
  expect(glb.name).toBe('dumbbell-parts.glb');
  expect(glb.bytes.toString('latin1', 0, 4)).toBe('glTF');
  const stl = await downloaded(page, 'stl');
  expect(stl.name).toBe('dumbbell-parts-stl.zip');
  const json = await downloaded(page, 'json');
  expect((JSON.parse(json.bytes.toString()) as { parts: unknown[] }).parts.length).toBe(2);
  await panel.getByRole('button', { name: 'Show it whole' }).click();
  expect(await parts.count()).toBe(0);

  // Which necks are listed is a matter of how far they stand out; the narrowest always does.
  await panel.locator('#neck-prominence').fill('1000000');
  await page.keyboard.press('Enter');
  expect(await rows.count()).toBe(1);
  await panel.locator('#neck-prominence').fill('-1');
  await page.keyboard.press('Enter');
  expect(await panel.locator('#neck-prominence').getAttribute('aria-invalid')).toBe('true');
});

test('handles and tunnels are listed by their lengths, on a phone too', async () => {
  const { page, viewer } = await openWith('torus.obj', torus(16, 10), {
    viewport: { width: 390, height: 844 },
  });
  const panel = await openPanel(page, 'necks');
  const list = panel.getByRole('list', { name: 'Handles and tunnels' });
  const rows = list.getByRole('button');
  await rows.first().waitFor({ timeout: 60_000 });
  expect(await rows.count()).toBe(2);
  expect(await panel.locator('h3').allTextContents()).toContain('1 handle, 1 tunnel');
  const lengths = await viewer.evaluate(async (element: GirthViewer) =>
    (await element.handles()).handles.map(({ kind, length }) => ({ kind, length })),
  );
  expect(lengths[0]!.length).toBeLessThanOrEqual(lengths[1]!.length);
  const words = await rows.allTextContents();
  lengths.forEach(({ kind }, i) => expect(words[i]).toContain(kind));
  await rows.first().click();
  await panel.getByRole('button', { name: 'Cut here' }).click();
  await panel.getByText('Cut, and still one part: the loop separates nothing.').waitFor();
  await page.screenshot({ path: join(pictures, 'page-cut-phone.png') });
});
