// Nothing on the page that axe objects to, in light and dark, at three sizes; and pictures of it.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import type { SurfacePoint } from '../../web/src/kernel/index.js';
import { complaintsOfAxe } from './axe.js';
import { builtPage, openPanel, pictures } from './page-support.js';
import { fieldComplete, framesPass, pairIsOver, placeOnSurface } from './viewer-page.js';

mkdirSync(pictures, { recursive: true });

const openBuilt = builtPage();

/** Does something in dark, then in light, once the plots and the surface are drawn so. */
async function inBoth(page: Page, act: (scheme: 'light' | 'dark') => Promise<void>): Promise<void> {
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme });
    await framesPass(page);
    await act(colorScheme);
  }
}

/** Expects no complaint of axe in light, and none on colours in dark, where nothing else differs. */
const expectAccessible = (page: Page): Promise<void> =>
  inBoth(page, async (scheme) => {
    const rules = scheme === 'dark' ? ['color-contrast'] : undefined;
    expect(await complaintsOfAxe(page, rules), scheme).toEqual([]);
  });

const keepPictures = (page: Page, name: string): Promise<void> =>
  inBoth(page, async (scheme) => {
    await page.screenshot({ path: join(pictures, `${name}-${scheme}.png`) });
  });

test.each([
  [1440, 900],
  [1024, 768],
  [390, 844],
])('no complaint of axe at %d by %d, and a picture', async (width, height) => {
  const size = `${width}x${height}`;
  const { page, viewer } = await openBuilt(undefined, {
    colorScheme: 'light',
    viewport: { width, height },
    hasTouch: width < 500,
  });
  await page.locator('#model b').waitFor();
  await fieldComplete(viewer);
  const place = await placeOnSurface(viewer, 0.5, 0.45);
  if (width < 500) {
    await page.touchscreen.tap(place.x, place.y);
    await viewer.locator('.readout').waitFor({ state: 'visible' });
    const base = (await viewer.locator('.readout').getAttribute('data-base'))!;
    const { x, y } = await viewer.evaluate(
      (element: GirthViewer, base) => element.screenPosition(JSON.parse(base) as SurfacePoint),
      base,
    );
    const box = (await viewer.boundingBox())!;
    // At once it would be a double tap, which pins nothing.
    await pairIsOver(page);
    await page.touchscreen.tap(box.x + x, box.y + y);
  } else await page.mouse.click(place.x, place.y);
  await page.locator('#loops tbody tr').waitFor();
  await expectAccessible(page);
  await keepPictures(page, `page-${size}`);
  // The bar's menus, and a legend that is clipped.
  await viewer.evaluate((element: GirthViewer) => {
    const [low, high] = element.shown!.extent!;
    element.setAttribute('range', `${low} ${(low + high) / 2}`);
  });
  for (const name of [/^Axes/, /^How the surface/]) {
    await viewer.getByRole('button', { name }).click();
    await expectAccessible(page);
    await page.keyboard.press('Escape');
  }
  await viewer.evaluate((element) => element.removeAttribute('range'));
  for (const [sheet, button] of [
    ['export', page.getByRole('button', { name: 'Export' })],
    ['share', page.getByRole('button', { name: 'Share' })],
    ['details', page.locator('#details-open')],
  ] as const) {
    await button.click();
    await page.locator(`#${sheet}`).waitFor();
    await expectAccessible(page);
    await keepPictures(page, `${sheet}-${size}`);
    await page.keyboard.press('Escape');
  }
  for (const name of ['tips', 'limbs', 'parts', 'print', 'compare']) {
    const panel = await openPanel(page, name);
    if (name === 'parts') await panel.locator('.controls').waitFor();
    if (name === 'compare') {
      await panel.getByRole('button', { name: 'Add this model' }).click();
      await panel.locator('.places canvas').waitFor();
    }
    // What has been scrolled under the field's row counts as small to axe, for as long as it is there.
    await page.locator('aside').evaluate((aside) => aside.scrollTo(0, 0));
    await expectAccessible(page);
    await panel.locator('summary').scrollIntoViewIfNeeded();
    await keepPictures(page, `${name}-${size}`);
  }
  const overflow = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  expect(overflow).toBe(0);
});
