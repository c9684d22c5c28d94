// The girth that noise cannot break on the page: the slider through it, and the saddles of a pinned point.

import type { Locator } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { builtPage, fragment, modelIs, picture } from './page-support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();

/** The girth as it is shown: how it was computed, and its bits. */
const girthOf = (viewer: Locator) =>
  viewer.evaluate(async (element: GirthViewer) => {
    const { method, values } = await element.fieldOf('igf');
    return { method, values: [...values] };
  });

/** Moves a slider to a place as a hand does, and lets it go. */
async function slideTo(slider: Locator, place: number): Promise<void> {
  await slider.evaluate((input: HTMLInputElement, place) => {
    input.value = String(place);
    for (const type of ['input', 'change']) input.dispatchEvent(new Event(type, { bubbles: true }));
  }, place);
}

test('a slider moves through the persistent girth, the same bits as when it is computed for one', async () => {
  const { page, viewer } = await openBuilt('model=dumbbell');
  await modelIs(page, 'dumbbell.glb');
  await fieldComplete(viewer);
  const plain = await girthOf(viewer);
  expect(plain.method).toBe('exact');
  const slider = page.getByRole('slider', { name: 'Wrinkles ignored' });
  const percent = (words: string | null) => Number(/([\d.]+)\u202f%/.exec(words ?? '')?.[1] ?? 0);
  const words = () => page.locator('output[for=persistence]').textContent();
  expect(await words()).toBe('none');

  await slideTo(slider, 60);
  await expect.poll(() => viewer.getAttribute('persistence'), { timeout: 60_000 }).toBe('3%');
  expect(percent(await words())).toBe(3);
  const slid = await girthOf(viewer);
  expect(slid.values).not.toEqual(plain.values);
  slid.values.forEach((value, v) => expect(value).toBeGreaterThanOrEqual(plain.values[v]!));
  await expect.poll(() => fragment(page)).toContain('persistence=3%');

  // While the hand moves, and not only when it lets go.
  await slider.evaluate((input: HTMLInputElement) => {
    input.value = '20';
    input.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await expect.poll(() => viewer.getAttribute('persistence')).toBe('1%');
  await slideTo(slider, 0);
  await expect.poll(() => viewer.getAttribute('persistence')).toBe(null);
  expect(await girthOf(viewer)).toEqual(plain);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => viewer.getAttribute('persistence')).toBe('3%');

  // From a link it is computed for that one persistence.
  const other = await openBuilt('model=dumbbell&persistence=3%25');
  await modelIs(other.page, 'dumbbell.glb');
  await fieldComplete(other.viewer);
  expect(await girthOf(other.viewer)).toEqual(slid);
  expect(percent(await other.page.locator('output[for=persistence]').textContent())).toBe(3);
});

test('what is stopped while saddles are looked for stays as it was', async () => {
  const { page, viewer } = await openBuilt('model=octopus');
  await modelIs(page, 'octopus.glb');
  await fieldComplete(viewer);
  const slider = page.getByRole('slider', { name: 'Wrinkles ignored' });
  // Stopped in the page itself: from here the word could come when all saddles have been found.
  for (const isAtOnce of [true, false]) {
    await slider.evaluate(async (input: HTMLInputElement, isAtOnce) => {
      const element = document.querySelector<GirthViewer>('girth-viewer')!;
      input.value = '40';
      for (const type of ['input', 'change']) {
        input.dispatchEvent(new Event(type, { bubbles: true }));
      }
      if (!isAtOnce) await new Promise((resolve) => setTimeout(resolve));
      element.cancel();
    }, isAtOnce);
    await page.getByText('As before:').waitFor();
    expect(await slider.inputValue()).toBe('0');
    expect(await viewer.getAttribute('persistence')).toBe(null);
    expect(await viewer.evaluate((element: GirthViewer) => element.shareOf('igf'))).toBe(1);
  }
  // Once more, to the end; of two wishes meanwhile, the later one counts.
  await slideTo(slider, 40);
  await slideTo(slider, 20);
  await expect.poll(() => viewer.getAttribute('persistence'), { timeout: 60_000 }).toBe('1%');
  // A colouring that saddles do not change has no slider.
  await page.locator('#field-name').selectOption('sdf');
  expect(await slider.isVisible()).toBe(false);
});

test('the saddles of a pinned point are bars, each shows its loop', async () => {
  const { page, viewer } = await openBuilt('model=dumbbell&loops=40');
  await modelIs(page, 'dumbbell.glb');
  await fieldComplete(viewer);
  const section = page.getByRole('region', { name: 'Saddles of a point' });
  const bars = section.getByRole('button');
  await bars.first().waitFor();
  const known = await viewer.evaluate(async (element: GirthViewer) => {
    const [pin] = element.pinned;
    const { bars } = await element.barcode(pin!.loop.base, { loops: true });
    return { length: pin!.loop.length, births: bars.map(({ birth }) => birth) };
  });
  expect(await bars.count()).toBe(Math.min(12, known.births.length));
  // The first of all saddles is that of the girth.
  expect(2 * known.births[0]!).toBeCloseTo(known.length, 12);
  expect(await section.locator('.girth').count()).toBe(1);
  const left = await bars.evaluateAll((all) =>
    all.map((bar) => bar.firstElementChild!.getBoundingClientRect().left),
  );
  expect(left).toEqual([...left].sort((a, b) => a - b));
  await bars.first().focus();
  const said = section.getByRole('status');
  await expect.poll(() => said.textContent()).toMatch(/^Loop of [\d.]+\u202fm: /);
  await picture(page, 'page-saddles.png');
  expect(await complaintsOfAxe(page)).toEqual([]);
  await page.keyboard.press('Tab');
  await page.locator('#field-name').focus();
  await expect.poll(() => said.textContent()).not.toMatch(/^Loop of/);
  // Without a loop there is nothing to show.
  await viewer.evaluate((element: GirthViewer) => element.unpin(element.pinned[0]!.id));
  await expect.poll(() => section.isVisible()).toBe(false);
});
