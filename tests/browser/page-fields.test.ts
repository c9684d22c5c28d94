// The page's field panel: what colours the surface, its distribution, and the brush.

import type { Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { glbWith } from './glb.js';
import { box, dumbbell } from './meshes.js';
import { builtPage, drop, fragment, modelIs, picture } from './page-support.js';
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
  const girth = (await page.locator('.caption').textContent())!;
  await page.locator('#field-name').selectOption('sdf');
  await expect.poll(() => viewer.locator('.legend-title').textContent()).toMatch(/diameter, m/);
  // Until the field is there, there are no words, or still those of the girth.
  const caption = async () => (await page.locator('.caption').textContent())!.replace(girth, '');
  await expect.poll(caption).toMatch(/^median 0\.\d+/);
  // The loop's kind has no numbers: shares of the area take the plot's place.
  await page.locator('#field-name').selectOption('kind');
  await expect
    .poll(() => page.locator('.shares li').allTextContents())
    .toContainEqual(expect.stringMatching(/^loop\d+\.\d\u202f%$/));
  expect(await page.locator('#distribution').isVisible()).toBe(false);
  // Sliders without values have words, not the numbers of their steps.
  const slider = page.locator('.sliders input').first();
  expect(await slider.getAttribute('aria-valuetext')).toBe('no values yet');
  expect(await slider.isDisabled()).toBe(true);
});

test('which number of a signature is shown can be chosen, and is in the link', async () => {
  await drop(page, { name: 'bell.obj', bytes: Buffer.from(dumbbell(24, 16)) });
  await modelIs(page, 'bell.obj');
  const slider = page.locator('#signature');
  expect(await slider.isVisible()).toBe(false);
  const values = () =>
    viewer.evaluate(async (element: GirthViewer) => [
      ...(await element.fieldOf(element.getAttribute('field') as 'hks')).values,
    ]);
  const ratio = (numbers: number[]) => Math.max(...numbers) / Math.min(...numbers);
  await page.locator('#field-name').selectOption({ label: 'Heat kernel (HKS)' });
  await slider.waitFor();
  expect(await page.locator('.signature output').textContent()).toBe('0.002');
  const early = await values();
  await slider.focus();
  await page.keyboard.press('End');
  expect(await viewer.getAttribute('time')).toBe('1');
  await viewer.getByText('heat after the time 1 of the area').waitFor();
  const late = await values();
  // Heat has spread over the whole shape: it differs less from place to place.
  expect(ratio(late)).toBeLessThan(1.2);
  expect(ratio(early)).toBeGreaterThan(1.2);
  await expect.poll(() => fragment(page)).toContain('time=1');

  await page.locator('#field-name').selectOption({ label: 'SIHKS (scale-free)' });
  expect(await page.locator('.signature output').textContent()).toBe('1 of 19');
  const first = await values();
  await slider.focus();
  await page.keyboard.press('ArrowRight');
  expect(await viewer.getAttribute('component')).toBe('2');
  expect(await values()).not.toEqual(first);
  await page.locator('#field-name').selectOption({ label: 'Wave kernel (WKS)' });
  await expect.poll(() => page.locator('.signature output').textContent()).toBe('20 of 100');
  await picture(page, 'signature.png');

  // There is no such energy: that is said, and the usual one is shown.
  const usual = await values();
  await viewer.evaluate((element) => element.setAttribute('energy', '30'));
  expect(await values()).not.toEqual(usual);
  const hint = viewer.evaluate(
    (element: GirthViewer) =>
      new Promise<string>((resolve) => {
        element.addEventListener('error', ({ detail }) => resolve(detail.hint), { once: true });
        element.setAttribute('energy', '1000');
      }),
  );
  expect(await hint).toBe('energy can be a whole number from 1 to 100');
  expect(await values()).toEqual(usual);
  await page.locator('#field-name').selectOption({ label: 'Girth (IGF)' });
  expect(await slider.isVisible()).toBe(false);
});

test('two fields in one: difference and ratio, with legend, plot, link, undo and file', async () => {
  await page.locator('#second-field').selectOption('less Shape diameter (SDF)');
  const title = () => viewer.locator('.legend-title').textContent();
  await expect.poll(title).toBe('Girth \u2212 shape diameter, m');
  await expect.poll(() => page.locator('.caption').textContent()).toMatch(/^median 0\.\d+/);
  const shown = await viewer.evaluate(async (element: GirthViewer) => {
    const [igf, sdf] = await Promise.all([element.fieldOf('igf'), element.fieldOf('sdf')]);
    const values = element.values('igf-sdf');
    const { range, colormap } = element.shown!;
    const csv = new TextDecoder().decode(await element.exportField('csv', 'igf-sdf'));
    const isExact = values.every((value, v) => value === igf.values[v]! - sdf.values[v]!);
    return {
      range,
      colormap,
      isExact,
      second: Number(csv.split('\n')[2]!.split(',')[1]) - values[1]!,
      csv,
    };
  });
  expect(shown.isExact).toBe(true);
  expect(shown.colormap).toBe('rdbu');
  expect(shown.range![0]).toBe(-shown.range![1]);
  expect(shown.csv).toMatch(/^vertex,igf_minus_sdf\n/);
  expect(Math.abs(shown.second)).toBeLessThan(1e-12);
  expect(await page.locator('#meaning').textContent()).toContain('red where it is more');
  await expect.poll(() => fragment(page)).toContain('field=igf-sdf');
  // The list on the page that files are made of has it.
  await page.locator('[popovertarget=export]').click();
  expect(await page.locator('#export-name').inputValue()).toBe('igf-sdf');
  await page.keyboard.press('Escape');
  // The compared field stays, the first field is another.
  await page.locator('#field-name').selectOption('thickness');
  await expect.poll(title).toMatch(/^Thickness \u2212 shape diameter, m/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(title).toBe('Girth \u2212 shape diameter, m');
  expect(await page.locator('#field-name').inputValue()).toBe('igf');
  await page.locator('#second-field').selectOption('divided by Shape diameter (SDF)');
  await expect.poll(title).toBe('Girth ÷ shape diameter');
  expect(await page.locator('#colormap').inputValue()).toBe('viridis');

  // Values of a file, in the list and beside the girth; they go with their file.
  const heat = { _HEAT: (vertex: number) => 20 + vertex };
  await drop(page, { name: 'heat.glb', bytes: Buffer.from(glbWith(box(3, 2, 2), heat)) });
  await modelIs(page, 'heat.glb');
  await fieldComplete(viewer);
  expect(await page.locator('#field-name').inputValue()).toBe('igf');
  await page.locator('#second-field').selectOption('less Heat');
  await expect.poll(title).toBe('Girth \u2212 heat');
  const isDifference = () =>
    viewer.evaluate(async (element: GirthViewer) => {
      const { values } = await element.fieldOf('igf');
      const heat = element.values('_heat');
      return (
        new Set(heat).size === heat.length &&
        element.values('igf-_heat').every((value, v) => value === values[v]! - heat[v]!)
      );
    });
  expect(await isDifference()).toBe(true);
  await page.locator('#examples button', { hasText: 'Cup' }).click();
  await modelIs(page, 'cup.glb');
  await expect.poll(title).toBe('Girth, m');
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
  const mark = page.locator('#distribution .plot-mark');
  const axis = page.locator('#distribution .plot-over');
  const places: number[] = [];
  for (const [right, down] of [
    [0.5, 0.45],
    [0.45, 0.75],
    [0.55, 0.6],
  ] as const) {
    const hovered = viewer.evaluate(
      (element: GirthViewer) =>
        new Promise<number>((resolve) => {
          element.addEventListener('hover', function listen(event) {
            const { values } = event.detail;
            if (values.igf === undefined) return;
            element.removeEventListener('hover', listen);
            resolve(values.igf);
          });
        }),
    );
    const place = await placeOnSurface(viewer, right, down);
    await hover(page, viewer, place.x, place.y);
    await mark.waitFor();
    const value = await hovered;
    const [low, high] = await viewer.evaluate(
      async (element: GirthViewer) => (await element.fieldOf('igf')).range,
    );
    const [box, line] = [(await axis.boundingBox())!, (await mark.boundingBox())!];
    // The line, 1.5 pixels wide, stands where the value is: in its bin, and within it.
    const expected = box.x + (box.width * (value - low)) / (high - low);
    expect(Math.abs(line.x - expected)).toBeLessThan(1.5);
    const bin = (x: number) => Math.floor((48 * (x - box.x)) / box.width + 1e-9);
    expect(Math.abs(bin(line.x + 0.75) - bin(expected))).toBeLessThanOrEqual(1);
    places.push(line.x);
    await page.mouse.move(1, 1);
    await mark.waitFor({ state: 'hidden' });
  }
  // At other places other values: a mark that stays where it is would not do.
  expect(Math.max(...places) - Math.min(...places)).toBeGreaterThan(10);
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

test.each([
  [1024, 768],
  [390, 844],
])('at %d by %d no list cuts the words of a choice', async (width, height) => {
  await page.setViewportSize({ width, height });
  const cut = await page
    .locator('#field select:visible')
    .evaluateAll((selects: HTMLSelectElement[]) => {
      const words = document.createElement('span');
      document.body.append(words);
      const arrow = 20;
      const found = selects.flatMap((select) =>
        [...select.options].flatMap(({ text, hidden }) => {
          words.textContent = text;
          words.style.cssText = `position: absolute; white-space: nowrap; font: ${getComputedStyle(select).font}`;
          const fits = words.offsetWidth + arrow <= select.clientWidth;
          return hidden || fits ? [] : [`${text}: ${words.offsetWidth} in ${select.clientWidth}`];
        }),
      );
      words.remove();
      return found;
    });
  expect(cut).toEqual([]);
});
