// Models and numbers that cannot be used as they are, on the page and through the element: words, and
// nothing is lost.

import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { beside, box, moved, sheet, turnedOver } from './meshes.js';
import { builtPage, drop, modelIs, openPanel } from './page-support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();

async function openModel(name: string, obj: string): Promise<{ page: Page; viewer: Locator }> {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await drop(page, { name, bytes: Buffer.from(obj) });
  await modelIs(page, name);
  await fieldComplete(viewer);
  return { page, viewer };
}

/** Asks the print check for tubes and walls of these limits; its answer. */
async function check(page: Page, tube: string, wall: string): Promise<string> {
  const panel = await openPanel(page, 'print');
  await page.locator('#min-tube').fill(tube);
  await page.locator('#min-wall').fill(wall);
  await page.locator('#check').click();
  const answer = panel.locator('.answer');
  await expect.poll(() => answer.textContent()).not.toMatch(/^(Checking …)?$/);
  return (await answer.textContent())!;
}

const cautions = (page: Page): Promise<string[]> =>
  page.locator('#print-panel .cautions li').allTextContents();
const partsWords = (page: Page): Locator => page.locator('#parts-panel [role=status]').first();

test('thresholds that are no lengths: words, and those before stay', async () => {
  const { page, viewer } = await openModel('box.obj', box(6, 6, 1));
  const panel = await openPanel(page, 'parts');
  await panel.locator('.controls').waitFor();
  const girth = page.locator('#parts-girth');
  await girth.fill('3');
  await girth.press('Enter');
  const thresholds = () => viewer.evaluate((element: GirthViewer) => element.thresholds);
  const before = await thresholds();
  expect(before?.girth).toBe(3);
  for (const wrong of ['-1', 'three', '1e999', '1..2', '--']) {
    await girth.fill(wrong);
    await girth.press('Enter');
    expect(await partsWords(page).textContent()).toBe(
      `“${wrong}” is not a length: type a number from 0 on, such as 1.5 or 3 mm.`,
    );
    expect(await girth.getAttribute('aria-invalid')).toBe('true');
    expect(await thresholds()).toEqual(before);
  }
  await girth.fill('4,5');
  await girth.press('Enter');
  expect(await partsWords(page).textContent()).toBe('');
  expect((await thresholds())?.girth).toBe(4.5);
  expect(await check(page, '', '-3')).toBe(
    '“-3” is not a length: type a number from 0 on, such as 1.5 or 3 mm.',
  );
});

test('through the element: wrong numbers and fields that are not computed', async () => {
  const { viewer } = await openModel('box.obj', box(4, 2, 1));
  const outcomes = await viewer.evaluate(async (element: GirthViewer) => {
    const words = async (act: () => unknown): Promise<string> => {
      try {
        await act();
        return 'done';
      } catch (error) {
        const { name, message, code } = error as Error & { code?: string };
        return `${name} ${code ?? ''}: ${message}`;
      }
    };
    // Nobody has asked for it yet: no values, but no failure either; and asking computes it.
    const diameters = element.values('sdf');
    return {
      negative: await words(() => element.setThresholds({ girth: -1, shapeDiameter: 1 })),
      nan: await words(() => element.setThresholds({ girth: NaN, shapeDiameter: 1 })),
      smoothing: await words(() =>
        element.setThresholds({ girth: 1, shapeDiameter: 1, smoothing: -0.5 }),
      ),
      infinite: await words(() =>
        element.setThresholds({ girth: Infinity, shapeDiameter: Infinity }),
      ),
      parts: await words(() => element.parts({ girth: NaN, shapeDiameter: 1 })),
      weak: await words(() => element.printCheck({ tubeDiameter: -1, wallThickness: 1 })),
      name: await words(() => element.values('depth' as 'sdf')),
      compute: await words(() => element.fieldOf('depth' as 'sdf')),
      maxima: await words(() => element.maxima('depth' as 'sdf')),
      vertex: await words(() => element.loop(1e6)),
      unasked: [diameters.length, diameters.every(Number.isNaN)],
      tips: await words(async () => element.exportTips('json')),
      computed: (await element.fieldOf('sdf')).withoutValue,
    };
  });
  const { unasked, computed, ...said } = outcomes;
  const expected: Record<keyof typeof said, RegExp> = {
    negative: /^RangeError.*numbers from 0 on/,
    nan: /^RangeError/,
    smoothing: /^RangeError/,
    infinite: /^done$/,
    parts: /^GirthError USAGE: .*threshold/,
    weak: /^GirthError USAGE: ./,
    name: /^RangeError.*no field is called depth/,
    compute: /^RangeError/,
    maxima: /no field .*depth/,
    vertex: /^GirthError VERTEX_OUT_OF_RANGE/,
    tips: /^done$/,
  };
  for (const [key, words] of Object.entries(said)) {
    expect(words, key).toMatch(expected[key as keyof typeof said]);
  }
  expect(unasked).toEqual([30, true]);
  expect(computed).toBe(0);
});

test('a surface that is inside out: no thickness, and what to do', async () => {
  const { page, viewer } = await openModel('inside-out.obj', turnedOver(box(3, 3, 3)));
  await page.locator('#field-name').selectOption('sdf');
  await viewer.getByText(/the surface is inside out/).waitFor();
  await openPanel(page, 'parts');
  await expect
    .poll(() => partsWords(page).textContent())
    .toMatch(/^The surface is inside out: .* No vertex has both a girth and a shape diameter\.$/);
  expect(await page.locator('#parts-panel .controls').isVisible()).toBe(false);
  expect(await check(page, '1', '1')).toMatch(
    /^Not checked: no vertex has a thickness.*turn its faces outwards\.$/,
  );
  expect(await cautions(page)).toContainEqual(expect.stringMatching(/^The surface is inside out/));
  // The girth does not mind, and is still there; tubes alone can be checked.
  expect(await check(page, '5', '')).toMatch(/too thin/);
  await page.locator('#field-name').selectOption('igf');
  await expect.poll(() => page.locator('.caption').textContent()).toMatch(/^median \d/);
});

test('walls of a surface that is inside out do not pass, though rays cross a gap outside', async () => {
  const gap = beside(box(2, 2, 2), moved(box(2, 8, 8), [2.5, -3, -3]), 0);
  const { page, viewer } = await openModel('gap.obj', turnedOver(gap));
  const { withoutValue, values } = await viewer.evaluate(async (element: GirthViewer) => {
    const { withoutValue, values } = await element.fieldOf('sdf');
    return { withoutValue, values: values.length };
  });
  expect(withoutValue).toBeLessThan(values);
  expect(await check(page, '', '0.1')).toMatch(/^Not checked: the surface is inside out/);
  expect(await page.locator('#print-panel .count').textContent()).toBe('');
});

test.each([
  ['one side', 1],
  ['two sides and no volume', 2],
] as const)(
  'a flat sheet of %s has no thickness, and does not pass the check',
  async (_, sides) => {
    const { page } = await openModel('sheet.obj', sheet(4, sides));
    if (sides === 2) {
      expect(await page.locator('#details').textContent()).toContain(
        '32 faces dropped that were there twice',
      );
    }
    await openPanel(page, 'parts');
    await expect.poll(() => partsWords(page).textContent()).toMatch(/25 of 25 vertices/);
    expect(await check(page, '', '1')).toMatch(/^Not checked: no vertex has a thickness/);
    expect(await cautions(page)).toContainEqual(expect.stringMatching(/^The surface is open/));
    expect(await page.locator('#print-panel .count').textContent()).toBe('');
  },
);

test('a cavity inside: two components, and the wall between them is measured', async () => {
  const cavity = moved(turnedOver(box(2, 2, 2)), [1, 1, 1]);
  const { page, viewer } = await openModel('hollow.obj', beside(box(4, 4, 4), cavity, 0));
  expect(await page.locator('#model').textContent()).toContain('2 components');
  expect(await check(page, '', '0.5')).toMatch(/^Passes/);
  // The wall is 1 thick, and rays that miss the cavity are longer.
  expect(await check(page, '', '1.5')).toMatch(/too thin/);
  const { range, withoutValue } = await viewer.evaluate((element: GirthViewer) =>
    element.fieldOf('sdf'),
  );
  expect(withoutValue).toBe(0);
  expect(range[0]).toBeGreaterThan(0.99);
  expect(range[0]).toBeLessThan(1.2);
});

test('one body inside another, and two that cross: each is measured by what its rays meet', async () => {
  const { page, viewer } = await openModel(
    'nested.obj',
    beside(box(4, 4, 4), moved(box(2, 2, 2), [1, 1, 1]), 0),
  );
  const values = () =>
    viewer.evaluate(async (element: GirthViewer) => {
      const [igf, sdf] = [await element.fieldOf('igf'), await element.fieldOf('sdf')];
      return { without: igf.withoutValue + sdf.withoutValue, girth: igf.range };
    });
  // The girth knows only the component: the inner cube's is 8, as if it were alone.
  const nested = await values();
  expect(nested.without).toBe(0);
  expect(nested.girth[0]).toBeCloseTo(8, 9);
  expect(nested.girth[1]).toBeCloseTo(17.89, 1);
  await drop(page, {
    name: 'crossing.obj',
    bytes: Buffer.from(beside(box(3, 3, 3), moved(box(3, 3, 3), [1.5, 0.7, 0.9]), 0)),
  });
  await modelIs(page, 'crossing.obj');
  await fieldComplete(viewer);
  const crossing = await values();
  expect(crossing.without).toBe(0);
  expect(crossing.girth[0]).toBeCloseTo(12.17, 1);
  await openPanel(page, 'parts');
  await expect
    .poll(() => page.locator('#parts-panel .count').textContent())
    .toMatch(/\d+ tubes?, \d+ plates?/);
});
