// Nothing on the page that axe objects to, in light and dark, at three sizes; and pictures of it.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import type { SurfacePoint } from '../../web/src/kernel/index.js';
import { complaintsOfAxe } from './axe.js';
import { builtPage, openPanel, pictures } from './page-support.js';
import { pairIsOver, fieldComplete, placeOnSurface } from './viewer-page.js';

mkdirSync(pictures, { recursive: true });

const openBuilt = builtPage();

describe.each(['light', 'dark'] as const)('page, %s', (colorScheme) => {
  test.each([
    [1440, 900],
    [1024, 768],
    [390, 844],
  ])('no complaint of axe at %d by %d, and a picture', async (width, height) => {
    const { page, viewer } = await openBuilt(undefined, {
      colorScheme,
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
    await page.screenshot({ path: join(pictures, `page-${width}x${height}-${colorScheme}.png`) });
    expect(await complaintsOfAxe(page)).toEqual([]);
    // The bar's menus, and a legend that is clipped.
    await viewer.evaluate((element: GirthViewer) => {
      const [low, high] = element.shown!.extent!;
      element.setAttribute('range', `${low} ${(low + high) / 2}`);
    });
    for (const name of [/^Axes/, /^How the surface/]) {
      await viewer.getByRole('button', { name }).click();
      expect(await complaintsOfAxe(page)).toEqual([]);
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
      expect(await complaintsOfAxe(page)).toEqual([]);
      await page.screenshot({
        path: join(pictures, `${sheet}-${width}x${height}-${colorScheme}.png`),
      });
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
      expect(await complaintsOfAxe(page)).toEqual([]);
      await panel.locator('summary').scrollIntoViewIfNeeded();
      await page.screenshot({
        path: join(pictures, `${name}-${width}x${height}-${colorScheme}.png`),
      });
    }
    const overflow = await page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
    expect(overflow).toBe(0);
  });
});
