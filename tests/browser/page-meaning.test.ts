// Within seconds a visitor knows what the colours mean.

import { expect, test } from 'vitest';
import { complaintsOfAxe } from './axe.js';
import { builtPage, modelIs } from './page-support.js';
import { coveredShares, fieldComplete, framesPass } from './viewer-page.js';

const openBuilt = builtPage();

test.each([
  [1440, 900],
  [1024, 768],
  [390, 844],
])('one line says what the colours mean, at %d by %d', async (width, height) => {
  const { page, viewer } = await openBuilt(undefined, { viewport: { width, height } });
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
  const line = page.locator('#meaning');
  expect(await line.textContent()).toMatch(/^Colours: the length of the shortest loop/);
  const box = (await line.boundingBox())!;
  // A loop at rest, as these tests ask for less motion, shows what is meant.
  const readout = viewer.locator('.readout');
  await readout.waitFor();
  const shown = () => readout.evaluate((element) => element.dataset['base']);
  const base = await shown();
  await framesPass(page);
  expect(await shown()).toBe(base);
  expect(await readout.textContent()).toMatch(/^0\.\d+\sm/);
  // It stands clear of the model, however small the room is.
  await expect.poll(() => coveredShares(viewer, '.readout')).toEqual([0]);
  const bar = (await viewer.locator('.bar-tools').boundingBox())!;
  expect(box.x + box.width).toBeLessThanOrEqual(bar.x);
  await page.mouse.move(1, 1);
  await readout.waitFor({ state: 'hidden' });
  await page.locator('#field-name').selectOption('sdf');
  await expect.poll(() => line.textContent()).toContain('how thick the shape is');
});

test('a loop slides along the surface by itself until the pointer moves', async () => {
  const { page, viewer } = await openBuilt('model=dumbbell', { reducedMotion: 'no-preference' });
  await modelIs(page, 'dumbbell.glb');
  await fieldComplete(viewer);
  const base = () => viewer.locator('.readout').getAttribute('data-base');
  const seen = new Set<string | null>();
  await expect
    .poll(async () => {
      seen.add(await base());
      return seen.size;
    })
    .toBeGreaterThan(3);
  await page.mouse.move(1, 1);
  await viewer.locator('.readout').waitFor({ state: 'hidden' });
});

test('a tour: a band slides along the octopus, tips, limbs and necks are listed', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await page.locator('#help').click();
  await page.getByRole('button', { name: 'A tour of the page' }).click();
  await modelIs(page, 'octopus.glb');
  const card = page.getByRole('region', { name: 'Tour' });
  await card.waitFor();
  const said: string[] = [];
  const panels = { 3: 'tips', 4: 'limbs', 5: 'necks', 7: 'print' } as Record<number, string>;
  for (let step = 1; step <= 8; ++step) {
    await card.getByText(`${step} of 8`).waitFor();
    said.push((await card.locator('p').first().textContent())!);
    if (step === 1) expect(await complaintsOfAxe(page)).toEqual([]);
    if (step === 2) await viewer.locator('.readout').waitFor({ state: 'visible' });
    if (step === 3) await page.locator('#tips-panel .places button').first().waitFor();
    if (step === 4) await viewer.locator('.number-mark').first().waitFor();
    const panel = panels[step];
    if (panel) await page.locator(`#${panel}-panel[open]`).waitFor();
    await card.getByRole('button', { name: step < 8 ? 'Next' : 'Done' }).click();
  }
  expect(new Set(said).size).toBe(8);
  expect(await card.isVisible()).toBe(false);
  await viewer.locator('.readout').waitFor({ state: 'hidden' });
});
