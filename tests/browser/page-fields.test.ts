// The page's field panel: what colours the surface, its distribution, and the brush.

import type { Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { builtPage, modelIs } from './page-support.js';
import { fieldComplete, hover, placeOnSurface } from './viewer-page.js';

const openBuilt = builtPage();
let page: Page;
let viewer: Locator;

beforeEach(async () => {
  ({ page, viewer } = await openBuilt());
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
});

/** The share of the area with values in a range, counted here. */
const shareWithin = (low: number, high: number): Promise<number> =>
  viewer.evaluate(
    async (element: GirthViewer, [low, high]) => {
      const [{ values }, areas] = await Promise.all([element.fieldOf('igf'), element.areas()]);
      let [within, whole] = [0, 0];
      values.forEach((value, vertex) => {
        whole += areas[vertex]!;
        if (value >= low! && value <= high!) within += areas[vertex]!;
      });
      return (100 * within) / whole;
    },
    [low, high],
  );

test('thickness can be chosen: legend, median and colours follow', async () => {
  const girth = await page.locator('.caption').textContent();
  await page.locator('#field-name').selectOption('sdf');
  await expect.poll(() => viewer.locator('.legend-title').textContent()).toMatch(/diameter, m/);
  await expect.poll(() => page.locator('.caption').textContent()).not.toBe(girth);
  expect(await page.locator('.caption').textContent()).toMatch(/^median 0\.\d+/);
  // The loop's kind has no numbers: shares of the area take the plot's place.
  await page.locator('#field-name').selectOption('kind');
  await expect
    .poll(() => page.locator('.shares li').allTextContents())
    .toContainEqual(expect.stringMatching(/^loop\d+\.\d\u202f%$/));
  expect(await page.locator('#distribution').isVisible()).toBe(false);
});

test('a brush marks what it covers, by pointer and by keyboard', async () => {
  const plot = page.locator('#distribution');
  const box = (await plot.boundingBox())!;
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + 0.25 * box.width, y);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, y, { steps: 4 });
  await page.mouse.up();
  const caption = page.locator('.caption');
  await expect.poll(() => caption.textContent()).toMatch(/ to .*: [\d.]+\u202f%/);
  const range = /^([\d.]+) to ([\d.]+)\u202fm: ([\d.]+)/.exec((await caption.textContent())!)!;
  const [low, high, share] = range.slice(1).map(Number);
  // The ends are rounded where they are written.
  expect(Math.abs(share! - (await shareWithin(low!, high!)))).toBeLessThan(0.5);
  const [least, most] = await viewer.evaluate(
    async (element: GirthViewer) => (await element.fieldOf('igf')).range,
  );
  expect(low).toBeCloseTo(least + 0.25 * (most - least), 2);
  expect(high).toBeCloseTo(least + 0.6 * (most - least), 2);
  expect(await page.locator('.plot-band').isVisible()).toBe(true);

  await plot.focus();
  await page.keyboard.press('Escape');
  await expect.poll(() => caption.textContent()).toMatch(/^median/);
  expect(await page.locator('.plot-band').isVisible()).toBe(false);
  await page.keyboard.press('ArrowRight');
  await expect.poll(() => plot.getAttribute('aria-valuetext')).toMatch(/ to .* marked/);
  await page.getByRole('button', { name: 'Mark nothing' }).click();
  expect(await plot.getAttribute('aria-valuetext')).toBe('no range marked');
});

test('pointing at the surface marks the value in the plot', async () => {
  const place = await placeOnSurface(viewer, 0.5, 0.45);
  await hover(page, viewer, place.x, place.y);
  const mark = page.locator('#distribution .plot-mark');
  await mark.waitFor();
  const [box, line] = [
    (await page.locator('#distribution').boundingBox())!,
    (await mark.boundingBox())!,
  ];
  const right = (line.x - box.x) / box.width;
  const [value, [low, high]] = await viewer.evaluate(async (element: GirthViewer) => {
    const base = JSON.parse(
      element.shadowRoot!.querySelector<HTMLElement>('.readout')!.dataset['base']!,
    ) as { face: number; weights: number[] } | number;
    const field = await element.fieldOf('igf');
    const near = typeof base === 'number' ? [field.values[base]!] : [...field.values];
    return [near.length === 1 ? near[0]! : NaN, field.range] as const;
  });
  // At a point within a face the mark is that of the nearest corner: between the field's ends.
  if (Number.isNaN(value)) expect(right).toBeGreaterThanOrEqual(-0.01);
  else expect(right).toBeCloseTo((value - low) / (high - low), 1);
  expect(right).toBeLessThanOrEqual(1.01);
  await page.mouse.move(1, 1);
  await mark.waitFor({ state: 'hidden' });
});

test('the cumulative curve takes the histogram’s place; lines of equal value are drawn', async () => {
  await page.getByRole('button', { name: 'Cumulative distribution' }).click();
  expect(await page.getByRole('button', { name: 'Histogram' }).getAttribute('aria-pressed')).toBe(
    'false',
  );
  await page.locator('#isolines').selectOption('10 lines');
  expect(await viewer.getAttribute('isolines')).toBe('10');
  await expect.poll(() => viewer.locator('.legend-line').count()).toBe(10);
});
