// Typing and dragging on the page while everything else changes: what is being edited stays.

import type { Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { box } from './meshes.js';
import { builtPage, drop, modelIs, openPanel } from './page-support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();
let page: Page;
let viewer: Locator;

const boxFile = (name: string) => ({ name, bytes: Buffer.from(box(6, 6, 1)) });

beforeEach(async () => {
  ({ page, viewer } = await openBuilt());
  await modelIs(page, 'chair.glb');
  await drop(page, boxFile('box.obj'));
  await modelIs(page, 'box.obj');
  await fieldComplete(viewer);
});

/** Events that may happen on the page at any time, each until its consequences are there. */
const happenings: Record<string, () => Promise<unknown>> = {
  'a late toggle of every panel': () =>
    page.evaluate(() => {
      for (const panel of document.querySelectorAll('details')) {
        panel.dispatchEvent(new Event('toggle'));
      }
    }),
  'a panel that closes and opens': () =>
    page.evaluate(async () => {
      const panel = document.querySelector<HTMLDetailsElement>('details[open]')!;
      panel.open = false;
      await new Promise((done) => setTimeout(done));
      panel.open = true;
      await new Promise((done) => setTimeout(done));
    }),
  'a unit': () => viewer.evaluate((element) => element.setAttribute('unit', 'cm')),
  'a field': () => viewer.evaluate((element: GirthViewer) => element.fieldOf('geoaverage')),
  'a field that is shown': () =>
    viewer.evaluate(async (element: GirthViewer) => {
      const arrived = new Promise((done) =>
        element.addEventListener('fieldchange', done, { once: true }),
      );
      element.setAttribute('field', element.getAttribute('field') === 'angle' ? 'igf' : 'angle');
      await arrived;
    }),
  'a surface that is touched': () =>
    viewer.evaluate((element) => element.dispatchEvent(new CustomEvent('touch'))),
};

/** Lets everything happen, and returns after what it is that a control no longer has its text. */
async function lost(control: Locator, text: string): Promise<string[]> {
  const culprits: string[] = [];
  for (const [name, happen] of Object.entries(happenings)) {
    await happen();
    if ((await control.inputValue()) !== text) culprits.push(name);
  }
  return culprits;
}

const answer = (): Locator => page.locator('#print-panel .answer');

test('a limit of the print check stays while it is typed, and counts without being left', async () => {
  await openPanel(page, 'print');
  const wall = page.locator('#min-wall');
  await wall.focus();
  await page.keyboard.type('1');
  expect(await lost(wall, '1')).toEqual([]);
  await wall.focus();
  await page.keyboard.press('End');
  await page.keyboard.type('.5');
  expect(await lost(wall, '1.5')).toEqual([]);
  // As assistive technology submits a form: the field is not left, and reports no change.
  await page.evaluate(() =>
    document.querySelector<HTMLFormElement>('#print-panel form')!.requestSubmit(),
  );
  await expect.poll(() => answer().textContent()).toMatch(/too thin/);
  expect(await wall.inputValue()).toBe('1.5');
});

test('a limit stays while a check runs and ends', async () => {
  await openPanel(page, 'print');
  await page.locator('#min-tube').fill('5');
  await page.locator('#check').click();
  await page.locator('#min-wall').focus();
  await page.keyboard.type('0.25');
  await expect.poll(() => answer().textContent()).toMatch(/too thin|Passes/);
  await page.locator('#print-panel .places img').first().waitFor();
  expect(await page.locator('#min-wall').inputValue()).toBe('0.25');
  expect(await page.locator('#min-tube').inputValue()).toBe('5');
});

test('limits keep their numbers in another unit; another model takes them away', async () => {
  await openPanel(page, 'print');
  await page.locator('#min-tube').fill('5');
  await page.locator('#min-wall').fill('0.5');
  await page.locator('#print-unit').selectOption('mm');
  const values = () =>
    Promise.all(['#min-tube', '#min-wall'].map((id) => page.locator(id).inputValue()));
  expect(await values()).toEqual(['5', '0.5']);
  expect(await page.locator('#print-panel .unit').first().textContent()).toBe('mm');
  await page.locator('#min-wall').focus();
  await page.keyboard.type('2');
  await drop(page, boxFile('other.obj'));
  await modelIs(page, 'other.obj');
  expect(await values()).toEqual(['', '']);
});

test('a threshold stays while it is typed; Escape brings back what holds', async () => {
  const panel = await openPanel(page, 'parts');
  await panel.locator('.controls').waitFor();
  const thresholds = () => viewer.evaluate((element: GirthViewer) => element.thresholds!);
  const girth = page.locator('#parts-girth');
  const before = await girth.inputValue();
  await girth.focus();
  await girth.press('ControlOrMeta+A');
  await page.keyboard.type('7');
  expect(await lost(girth, '7')).toEqual([]);
  await girth.focus();
  await girth.press('Enter');
  expect((await thresholds()).girth).toBe(7);
  expect(await girth.inputValue()).toBe('7');
  await girth.press('ControlOrMeta+A');
  await page.keyboard.type('8');
  await girth.press('Escape');
  expect(await girth.inputValue()).toBe('7');
  // Words stay to be mended, whatever comes, until a threshold is set in another way.
  await girth.fill('three');
  await girth.press('Enter');
  expect(await lost(girth, 'three')).toEqual([]);
  await page.locator('#automatic').click();
  await expect.poll(() => girth.inputValue()).toBe(before);
});

test('faces to remesh to stay while they are typed; Escape is for the number first', async () => {
  await page.locator('#details-open').click();
  const faces = page.locator('#faces');
  const before = await faces.inputValue();
  await faces.focus();
  await faces.press('ControlOrMeta+A');
  await page.keyboard.type('1234');
  expect(await lost(faces, '1234')).toEqual([]);
  await faces.press('Escape');
  expect(await faces.inputValue()).toBe(before);
  expect(await page.locator('#details').isVisible()).toBe(true);
  await faces.press('Escape');
  expect(await page.locator('#details').isVisible()).toBe(false);
});

test('a slider that is held stays under the hand', async () => {
  await page.locator('#field-name').selectOption('hks');
  const slider = page.locator('#signature');
  await slider.waitFor();
  await viewer.evaluate((element: GirthViewer) => element.fieldOf('hks'));
  const place = (await slider.boundingBox())!;
  const y = place.y + place.height / 2;
  await page.mouse.move(place.x + place.width / 2, y);
  await page.mouse.down();
  await page.mouse.move(place.x + 0.8 * place.width, y, { steps: 3 });
  const held = await slider.inputValue();
  await viewer.evaluate((element: GirthViewer) => element.fieldOf('geoaverage'));
  await viewer.evaluate((element) => element.setAttribute('unit', 'cm'));
  expect(await slider.inputValue()).toBe(held);
  expect(await viewer.getAttribute('time')).toBe(null);
  await page.mouse.up();
  expect(await slider.inputValue()).toBe(held);
  expect(Number(await viewer.getAttribute('time'))).toBeGreaterThan(0.002);
});

test('a row that is pressed while its list is filled is chosen, and stays so', async () => {
  const panel = await openPanel(page, 'print');
  await page.locator('#min-wall').fill('1.5');
  await page.locator('#check').click();
  const row = panel.locator('.places button').first();
  await row.waitFor();
  await row.scrollIntoViewIfNeeded();
  const box = (await row.boundingBox())!;
  await page.mouse.move(box.x + 10, box.y + 10);
  await page.mouse.down();
  await panel.locator('.places img').first().waitFor();
  await viewer.evaluate((element: GirthViewer) => element.fieldOf('geoaverage'));
  await page.mouse.up();
  expect(await row.getAttribute('aria-pressed')).toBe('true');
});
