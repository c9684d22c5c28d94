// Nothing on the page that axe objects to, in light and dark, at three sizes; and pictures of it.

import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import type { SurfacePoint } from '../../web/src/kernel/index.js';
import { complaintsIn } from './axe.js';
import { builtPage, openPanel, picture } from './page-support.js';
import { fieldComplete, framesPass, pairIsOver, placeOnSurface } from './viewer-page.js';

const openBuilt = builtPage();

interface Look {
  /** A selector of what is new on the page. Default: all of it. */
  within?: string;
  /** The name of the pictures. Default: none are taken. */
  name?: string;
  /** The place that is scrolled into view for them. */
  shown?: Locator;
}

/**
 * Expects no complaint of axe in light, and none on colours in dark, where nothing else differs; and takes a picture of each,
 * once the plots and the surface are drawn so.
 */
async function lookAt(page: Page, { within, name, shown }: Look = {}): Promise<void> {
  for (const colorScheme of ['dark', 'light'] as const) {
    await page.emulateMedia({ colorScheme });
    await framesPass(page);
    // Controls that have been scrolled under the field's row count as small to axe, for as long as they are there.
    await page.locator('aside').evaluate((aside) => aside.scrollTo(0, 0));
    expect(await complaintsIn(colorScheme, page, within), colorScheme).toEqual([]);
    if (!name) continue;
    await shown?.scrollIntoViewIfNeeded();
    await picture(page, `${name}-${colorScheme}.png`);
  }
}

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
  await lookAt(page, { name: `page-${size}` });
  // The bar's menus, and a legend that is clipped.
  await viewer.evaluate((element: GirthViewer) => {
    const [low, high] = element.shown!.extent!;
    element.setAttribute('range', `${low} ${(low + high) / 2}`);
  });
  for (const name of [/^Axes/, /^How the surface/, 'Section plane']) {
    await viewer.getByRole('button', { name }).click();
    if (name === 'Section plane') {
      await viewer.getByRole('button', { name: 'Section across x' }).click();
      await lookAt(page, { within: 'girth-viewer', name: `section-${size}` });
    } else await lookAt(page, { within: 'girth-viewer' });
    await page.keyboard.press('Escape');
  }
  await viewer.evaluate((element) => {
    element.removeAttribute('range');
    element.removeAttribute('section');
  });
  for (const [sheet, button] of [
    ['export', page.getByRole('button', { name: 'Export' })],
    ['share', page.getByRole('button', { name: 'Share' })],
    ['details', page.locator('#details-open')],
  ] as const) {
    await button.click();
    await page.locator(`#${sheet}`).waitFor();
    await lookAt(page, { within: `#${sheet}`, name: `${sheet}-${size}` });
    await page.keyboard.press('Escape');
  }
  for (const name of ['tips', 'limbs', 'parts', 'print', 'compare']) {
    const panel = await openPanel(page, name);
    if (name === 'parts') await panel.locator('.controls').waitFor();
    if (name === 'compare') {
      await panel.getByRole('button', { name: 'Add this model' }).click();
      await panel.locator('.places canvas').waitFor();
    }
    await lookAt(page, {
      within: `#${name}-panel`,
      name: `${name}-${size}`,
      shown: panel.locator('summary'),
    });
  }
  const overflow = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  expect(overflow).toBe(0);
});
