// The page's state in its address: a link reproduces the view, and 'back' goes back.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { builtPage, drop, fragment, modelIs, openPanel } from './page-support.js';
import { repository } from './support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();
let page: Page;
let viewer: Locator;
let address: string;

async function openAt(state: string): Promise<void> {
  ({ page, viewer, address } = await openBuilt(state));
}

test('the link of README shows its model and its loop', async () => {
  const readme = readFileSync(join(repository, 'README.md'), 'utf8');
  const [, state = ''] = /`http:\/\/localhost:4173\/#([^`]+)`/.exec(readme) ?? [];
  await openAt(state);
  await modelIs(page, 'octopus.glb');
  await page.locator('#loops tbody tr').first().waitFor({ state: 'attached', timeout: 60_000 });
  const bases = await viewer.evaluate((element: GirthViewer) =>
    element.pinned.map(({ loop }) => loop.base),
  );
  expect(bases).toEqual([120]);
});

test('a link reproduces model, field, colours, camera, loops and thresholds', async () => {
  await openAt(
    'model=octopus&field=sdf&colormap=turbo&range=5%25%2095%25&isolines=10&edges=1' +
      '&camera=1.2,0.9,3,0.2,0.1,0&loops=120,7:0.25:0.5&tip=2&panel=tips',
  );
  await modelIs(page, 'octopus.glb');
  await page.locator('#loops tbody tr').nth(1).waitFor({ state: 'attached', timeout: 60_000 });
  const attributes = await viewer.evaluate((element) =>
    ['field', 'colormap', 'range', 'isolines', 'edges'].map((name) => element.getAttribute(name)),
  );
  expect(attributes).toEqual(['sdf', 'turbo', '5% 95%', '10', '']);
  const { camera, bases } = await viewer.evaluate((element: GirthViewer) => ({
    camera: element.camera!,
    bases: element.pinned.map(({ loop }) => loop.base),
  }));
  expect(bases).toEqual([120, { face: 7, weights: [0.25, 0.5, 0.25] }]);
  expect(camera.polar).toBeCloseTo(1.2, 6);
  expect(camera.azimuth).toBeCloseTo(0.9, 6);
  expect(camera.distance).toBeCloseTo(3, 6);
  expect(camera.target[0]).toBeCloseTo(0.2, 6);
  const chosen = page.locator('#tips-panel [aria-pressed=true]');
  await chosen.waitFor({ timeout: 60_000 });
  expect(await chosen.locator('i').textContent()).toBe('2');
  // Nothing of it was changed by reproducing it.
  await page.waitForTimeout(800);
  expect(fragment(page).split('&').sort()).toEqual(
    [
      'camera=1.2,0.9,3,0.2,0.1,0',
      'colormap=turbo',
      'edges=1',
      'field=sdf',
      'isolines=10',
      'loops=120,7:0.25:0.5',
      'model=octopus',
      'panel=tips',
      'range=5% 95%',
      'tip=2',
    ].sort(),
  );
});

test('the address is left alone until something is changed; then it says it; back goes back', async () => {
  await openAt('');
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
  await page.waitForTimeout(800);
  expect(fragment(page)).toBe('');
  await page.getByRole('button', { name: 'Cup' }).click();
  await modelIs(page, 'cup.glb');
  await expect.poll(() => fragment(page)).toBe('model=cup');
  await page.locator('#field-name').selectOption('geofarthest');
  await expect.poll(() => fragment(page)).toBe('model=cup&field=geofarthest');
  await page.goBack();
  await expect.poll(() => page.locator('#field-name').inputValue()).toBe('igf');
  expect(await viewer.getAttribute('field')).toBeNull();
  await page.goBack();
  await modelIs(page, 'chair.glb');
  await page.goForward();
  await modelIs(page, 'cup.glb');
});

test('thresholds and their smoothing are in a link only where they were chosen', async () => {
  await openAt('model=chair&panel=parts&girth=0.2&diameter=0.05&smoothing=1');
  await modelIs(page, 'chair.glb');
  await expect
    .poll(() => page.locator('#parts-girth').inputValue(), { timeout: 60_000 })
    .toBe('0.2');
  expect(await page.locator('#parts-shapeDiameter').inputValue()).toBe('0.05');
  expect(await page.locator('#smoothing').inputValue()).toBe('1');
  await page.locator('#smoothing').selectOption('0');
  await page.locator('#automatic').click();
  await expect.poll(() => page.locator('#parts-girth').inputValue()).not.toBe('0.2');
  await expect.poll(() => fragment(page)).toBe('model=chair&panel=parts');
});

test('what is not understood is left out without a word', async () => {
  await openAt(
    'model=nothing&field=%3Cb%3E&range=9%201&camera=0,0&loops=99999999,x&tip=99&panel=parts2',
  );
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
  expect(await page.locator('#field-name').inputValue()).toBe('igf');
  expect(await viewer.evaluate((element: GirthViewer) => element.pinned.length)).toBe(0);
  expect(await viewer.getByRole('alert').isVisible()).toBe(false);
});

test('a link cannot have a file: it says so, and holds for whoever drops that file', async () => {
  await openAt('');
  await modelIs(page, 'chair.glb');
  const bytes = readFileSync(join(repository, 'tests/data/prism.obj'));
  await drop(page, { name: 'prism.obj', bytes });
  await modelIs(page, 'prism.obj');
  await page.locator('#colormap').selectOption('magma');
  await page.getByRole('button', { name: 'Share' }).click();
  const sheet = page.locator('#share');
  await sheet.waitFor();
  expect(await sheet.textContent()).toContain('prism.obj stays on your machine');
  const link = await sheet.getByRole('textbox', { name: 'Link' }).inputValue();
  expect(new URL(link).hash).toBe('#file=prism.obj&colormap=magma');

  const other = await page.context().newPage();
  await other.goto(link);
  const card = other.getByRole('region', { name: 'prism.obj' });
  await card.waitFor();
  expect(await other.locator('#model').textContent()).toBe('prism.obj · not opened yet');
  expect(await other.locator('girth-viewer').getAttribute('colormap')).toBeNull();
  await drop(other, { name: 'prism.obj', bytes });
  await other.getByText('prism.obj · 84 faces').waitFor();
  expect(await card.isVisible()).toBe(false);
  expect(await other.locator('girth-viewer').getAttribute('colormap')).toBe('magma');
});

test('a model by its address', async () => {
  await openAt('');
  await modelIs(page, 'chair.glb');
  await page.goto(`${address}/?again#model=${address}/examples/vessel.glb&field=none`);
  await modelIs(page, 'vessel.glb');
  expect(await viewer.getAttribute('field')).toBe('none');
  await openPanel(page, 'tips');
  await expect
    .poll(() => fragment(page))
    .toBe(`model=${address}/examples/vessel.glb&field=none&panel=tips`);
});
