// The page as it is met first: its first example, as large as it is.

import { expect, test } from 'vitest';
import { builtPage, modelIs, picture } from './page-support.js';
import { fieldComplete, pairIsOver } from './viewer-page.js';

for (const isolated of [true, false]) {
  const openBuilt = builtPage({ isolated, examples: 'real' });

  test(`opens on an example that is computed without a word, isolated: ${isolated}`, async () => {
    const { page, viewer } = await openBuilt();
    await modelIs(page, 'chair.glb');
    expect(await page.locator('#model').textContent()).toMatch(/chair\.glb · [\d,]+ faces · genus/);
    await fieldComplete(viewer);
    const seconds = (await page.evaluate(() => performance.now())) / 1000;
    console.log(
      `isolated ${isolated}: the first example is computed ${seconds.toFixed(1)} s after opening`,
    );
    expect(await page.evaluate(() => crossOriginIsolated)).toBe(isolated);
    expect(
      await page.getByText('Drop a mesh anywhere. It stays on your machine.').isVisible(),
    ).toBe(true);
    expect(await page.locator('#examples [aria-pressed=true]').textContent()).toBe('Chair');
    const ticks = await viewer.locator('.legend-tick').allTextContents();
    expect(ticks.length).toBeGreaterThanOrEqual(2);
    for (const tick of ticks) expect(tick).toMatch(/^\d+\.\d+$/);
    expect(await viewer.locator('.legend-title').textContent()).toMatch(/Girth, (m|mm)$/);
    // Progress has gone, its place is empty.
    expect(await viewer.locator('[role=progressbar]').isVisible()).toBe(false);
    await picture(page, `page-${isolated ? 'threads' : 'pool'}.png`);
  });
}

const openSmall = builtPage();

test('the loop that slides until somebody comes gives way to the one under the pointer, at once', async () => {
  const { page, viewer } = await openSmall('model=cup', { reducedMotion: 'no-preference' });
  await fieldComplete(viewer);
  const readout = viewer.locator('.readout');
  await readout.waitFor();
  // However far it has turned, the cup is in the middle.
  const { x, y, width, height } = (await viewer.boundingBox())!;
  await page.mouse.move(x + width / 2, y + height / 2);
  await viewer.locator('canvas.picking').waitFor();
  // Longer than the sliding one rests at a place.
  await pairIsOver(page);
  expect(await readout.isVisible()).toBe(true);
});
