// The page with a surface of a hundred thousand vertices: it opens, and can be used while it computes. How
// fast it is, `npm run bench:page` measures.

import { expect, test } from 'vitest';
import type { GirthViewer } from '../../../web/src/element/index.js';
import { withoutDrawing } from '../long-tasks.js';
import { thinRing } from '../meshes.js';
import { builtPage, modelIs } from '../page-support.js';
import { fieldBegun, fieldComplete, hover } from '../viewer-page.js';

const openBuilt = builtPage();

test('102,400 vertices: sliders, loops and other fields while the girth is computed', async () => {
  const { page, viewer } = await openBuilt('file=ring.obj&method=exact');
  await withoutDrawing(page);
  await page.reload();
  const buffer = Buffer.from(thinRing(5120, 20));
  await page.locator('#file').setInputFiles({ name: 'ring.obj', mimeType: 'text/plain', buffer });
  await page.locator('#model', { hasText: '204,800 faces · genus 1' }).waitFor();
  await fieldBegun(viewer);
  const share = () => viewer.evaluate((element: GirthViewer) => element.shareOf('igf'));
  const begun = await share();
  expect(begun).toBeLessThan(1);

  // The range follows its slider.
  const upper = page.getByLabel('Upper end of the colours');
  await expect.poll(() => upper.isEnabled()).toBe(true);
  await upper.focus();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('PageDown');
  expect(await page.locator('#range').inputValue()).toBe('own');
  await expect.poll(() => viewer.locator('.legend-tick').first().textContent()).toMatch(/^≥/);
  await page.locator('#range').selectOption('full range');
  // A loop answers at once, before its vertex has had its turn.
  const box = (await viewer.boundingBox())!;
  const seen = await viewer.evaluate((element: GirthViewer) => {
    for (let vertex = 0; vertex < 102_400; vertex += 511) {
      const { x, y, visible } = element.screenPosition(vertex);
      if (visible) return { x, y };
    }
    throw new Error('nothing of the surface can be seen');
  });
  const place = { x: box.x + seen.x, y: box.y + seen.y };
  const shown = await hover(page, viewer, place.x, place.y);
  expect(shown.kind).toBe('loop');
  // Round the tube: a polygon of 20 edges of length 1, or nearly.
  expect(Math.abs(shown.length - 20)).toBeLessThan(0.5);
  expect(await share()).toBeGreaterThanOrEqual(begun);

  // Thickness is computed beside it, its distribution drawn and marked.
  await viewer.getByRole('button', { name: 'Cancel computing' }).click();
  await viewer.getByText(/^Girth, partial: \d+% of vertices$/).waitFor();
  await page.locator('#field-name').selectOption('sdf');
  await expect
    .poll(() => viewer.evaluate((element: GirthViewer) => element.shareOf('sdf')), {
      timeout: 90_000,
    })
    .toBe(1);
  await page.locator('#distribution').focus();
  await page.keyboard.press('End');
  await expect.poll(() => page.locator('.caption').textContent()).toMatch(/ to .*: [<\d.]+/);
  await page.keyboard.press('Escape');
  await expect.poll(() => page.locator('.caption').textContent()).toMatch(/^median/);
});

test('102,400 faces: the girth of fewer triangles is there first, and what is made of it', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const buffer = Buffer.from(thinRing(2560, 20));
  await page.locator('#file').setInputFiles({ name: 'ring.obj', mimeType: 'text/plain', buffer });
  await modelIs(page, 'ring.obj');
  expect(await viewer.getAttribute('method')).toBe('coarse');
  await fieldComplete(viewer);
  const { unit, carried } = await viewer.evaluate(async (element: GirthViewer) => {
    const { values, unit } = await element.fieldOf('igf');
    return { unit, carried: [values.length, Math.min(...values), Math.max(...values)] };
  });
  // Round the tube: a polygon of 20 edges of length 1, or nearly.
  expect(unit).toBe('');
  expect(carried[0]).toBe(51_200);
  expect(carried[1]).toBeGreaterThan(18);
  expect(carried[2]).toBeLessThan(22);
  await page.locator('#tips-panel .count', { hasText: '0' }).waitFor();
  // The link does not say what is usual.
  expect(new URL(page.url()).hash).not.toContain('method');
  // Another model is computed as is usual for that one.
  await page.getByRole('button', { name: 'Dumbbell' }).click();
  await modelIs(page, 'dumbbell.glb');
  expect(await viewer.getAttribute('method')).toBe(null);
});
