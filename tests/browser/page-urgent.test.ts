// Wishes of a person go before the girth, which is computed unasked; and partial colours are not saved without a word.

import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import type { Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { builtPage, drop, modelIs, openPanel, picture } from './page-support.js';
import { torus } from './meshes.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();
let page: Page;
let viewer: Locator;

/** A sphere, whose girth takes long: no loop holds anywhere. */
function sphere(rings: number, sides: number): string {
  const lines = ['v 0 0 1'];
  for (let ring = 1; ring < rings; ++ring) {
    for (let side = 0; side < sides; ++side) {
      const [down, round] = [(Math.PI * ring) / rings, (2 * Math.PI * side) / sides];
      // Bumps, so that it is nowhere symmetric; none at the poles.
      const flat = Math.sin(down) ** 4;
      const r = 1 + flat * (0.02 * Math.sin(7 * down + 3 * round) + 0.03 * Math.cos(5 * round));
      const [x, y] = [r * Math.sin(down) * Math.cos(round), r * Math.sin(down) * Math.sin(round)];
      lines.push(`v ${x} ${y} ${r * Math.cos(down)}`);
    }
  }
  lines.push('v 0 0 -1');
  const at = (ring: number, side: number) => 2 + (ring - 1) * sides + (side % sides);
  const last = 2 + (rings - 1) * sides;
  for (let side = 0; side < sides; ++side) {
    lines.push(`f 1 ${at(1, side)} ${at(1, side + 1)}`);
    for (let ring = 1; ring + 1 < rings; ++ring) {
      lines.push(`f ${at(ring, side)} ${at(ring + 1, side)} ${at(ring + 1, side + 1)}`);
      lines.push(`f ${at(ring, side)} ${at(ring + 1, side + 1)} ${at(ring, side + 1)}`);
    }
    lines.push(`f ${at(rings - 1, side)} ${last} ${at(rings - 1, side + 1)}`);
  }
  return lines.join('\n');
}

const shareOf = (name: 'igf' | 'thickness') =>
  viewer.evaluate((element: GirthViewer, name) => element.shareOf(name), name);

async function show(name: string, text: string): Promise<void> {
  await drop(page, { name, bytes: Buffer.from(text) });
  await modelIs(page, name);
}

beforeEach(async () => {
  ({ page, viewer } = await openBuilt());
  await modelIs(page, 'chair.glb');
});

test('the print check shows walls before the girth is there, and each computation is cancelled by itself', async () => {
  await show('sphere.obj', sphere(90, 120));
  const girth = viewer.getByRole('button', { name: 'Cancel computing: Girth' });
  await girth.waitFor();
  const panel = await openPanel(page, 'print');
  await page.locator('#min-tube').fill('0.5');
  await page.locator('#min-wall').fill('0.1');
  await page.locator('#check').click();
  await panel.getByText(/^Passes: nothing is too thin/).waitFor();
  expect(await shareOf('thickness')).toBe(1);
  expect(await shareOf('igf')).toBeLessThan(1);
  await panel.getByText('Girth, for tubes').waitFor();
  expect(await panel.locator('progress').isVisible()).toBe(true);
  await picture(page, 'print-before-girth.png');
  await girth.click();
  await panel.getByText('Tubes are not checked: cancelled').waitFor();
  await panel.getByText('Not checked: tubes and gaps.').waitFor();
  expect(await panel.locator('progress').isVisible()).toBe(false);
});

test('a picture whose colours are not all there is saved after a question', async () => {
  await show('sphere.obj', sphere(90, 120));
  await viewer.getByRole('button', { name: 'Cancel computing: Girth' }).waitFor();
  await expect.poll(() => shareOf('igf')).toBeGreaterThan(0);
  await page.locator('[popovertarget=export]').click();
  await page.locator('#export-picture [data-format=png]').click();
  const question = page.locator('.partial-colours');
  await question.getByText(/^Girth.*: \d+% of the vertices are computed\.$/).waitFor();
  await picture(page, 'partial-colours.png');
  const coming = page.waitForEvent('download');
  await question.getByRole('button', { name: 'Save as it is' }).click();
  expect((await coming).suggestedFilename()).toBe('sphere.png');
  expect(await question.isVisible()).toBe(false);
});

test('the model is saved as a web page, which shows values and loops from a disk', async () => {
  await show('ring.obj', torus(24, 16));
  await fieldComplete(viewer);
  const pinned = await viewer.evaluate(async (element: GirthViewer) => {
    const { id, loop } = await element.pin({ face: 5, weights: [0.25, 0.25, 0.5] });
    element.nameLoop(id, 'the <tube>');
    element.setAttribute('colormap', 'magma');
    return loop.length;
  });
  await page.locator('[popovertarget=export]').click();
  const coming = page.waitForEvent('download');
  await page.locator('#export-page [data-format=html]').click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe('ring.html');
  const values = await viewer.evaluate((element: GirthViewer) => [...element.values('igf')]);
  const saved = await page.context().browser()!.newContext({ offline: true });
  try {
    const other = await saved.newPage();
    const path = `${await download.path()}.html`;
    await download.saveAs(path);
    expect(readFileSync(path, 'utf8')).toContain('<title>ring.obj</title>');
    await other.goto(pathToFileURL(path).href);
    await fieldComplete(other.locator('girth-viewer'));
    const shown = other.locator('girth-viewer');
    await expect
      .poll(() => shown.evaluate((element) => (element as GirthViewer).pinned.length))
      .toBe(1);
    const found = await shown.evaluate((element) => {
      const viewer = element as GirthViewer;
      const [{ name, loop }] = viewer.pinned as [GirthViewer['pinned'][number]];
      return { name, length: loop.length, values: [...viewer.values('igf')] };
    });
    expect(found).toEqual({ name: 'the <tube>', length: pinned, values });
    expect(await shown.getAttribute('colormap')).toBe('magma');
    expect(await other.locator('#girth-caption').textContent()).toBe('');
  } finally {
    await saved.close();
  }
});
