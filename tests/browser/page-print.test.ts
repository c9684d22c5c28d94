// Will a chair print that is one unit tall? Its size and unit, a printer, the verdict and what would help.

import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { clicksOn } from './clicks.js';
import { beside, box, moved, placed, scaled, turnedOver } from './meshes.js';
import { builtPage, drop, fragment, modelIs, openPanel, picture } from './page-support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();
/** 2 × 1 × 2, without a unit: what is up in OBJ is y. */
const stool = { name: 'stool.obj', bytes: Buffer.from(box(2, 1, 2)) };

test('a model of one unit: its size is questioned, and it prints once it is large enough', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await drop(page, stool);
  await modelIs(page, 'stool.obj');
  const pinned = () =>
    viewer.evaluate((element: GirthViewer) =>
      element.pinned.map(({ name, loop }) => ({ name, length: loop.length })),
    );
  const clicks = await clicksOn(page);
  const panel = await openPanel(page, 'print');
  // Only now: where the list of loops is open, it grows by this, and moves what is about to be clicked.
  await viewer.evaluate(async (element: GirthViewer) => {
    const { id } = await element.pin(0);
    element.nameLoop(id, 'corner');
  });
  const [before] = await pinned();
  await page.locator('#print-unit').selectOption('mm');
  const words = panel.locator('.size-words');
  await expect.poll(() => words.textContent()).toBe('1.00\u202fmm tall: really?');
  await page.locator('#print-height').fill('0.5 mm');
  await page.keyboard.press('Enter');
  await expect
    .poll(() => words.textContent())
    .toMatch(/^0\.500\u202fmm tall, 50% of the file’s size/);
  // The pinned loop is there in the other size, half as long.
  await expect.poll(pinned).toEqual([{ name: 'corner', length: before!.length / 2 }]);
  await page.locator('#print-preset').selectOption('Filament (FDM), plastic');
  expect(await page.locator('#print-source a').getAttribute('href')).toMatch(/^https:/);
  expect(await page.locator('#min-tube').inputValue()).toBe('3');
  await page.locator('#check').click();
  const answer = panel.locator('.answer');
  await expect
    .poll(() => answer.textContent())
    .toMatch(/^Fails: .* too thin, 100% of the surface\. Passes from \d+% of this size\.$/);
  // Open the panel, the unit, the printer, Check: the height is typed.
  expect(await clicks()).toBe(4);
  // All places at once, with a legend of their own.
  await expect
    .poll(() => viewer.locator('.legend').textContent())
    .toMatch(/Print check.*thick enough.*thin tube.*thin wall/s);
  const meaning = page.locator('#meaning');
  expect(await meaning.textContent()).toMatch(/^Colours: what is too thin to print/);
  await picture(page, 'page-print-fails.png');
  expect(await complaintsOfAxe(page)).toEqual([]);

  await panel.getByRole('button', { name: /^Make it \d+%$/ }).click();
  await expect
    .poll(() => answer.textContent())
    .toMatch(/^Passes: .* down to (99|100)% of this size/);
  expect(await page.locator('#min-wall').inputValue()).toBe('1');
  expect(await words.textContent()).toMatch(/^[1-9]\.\d\d\u202fmm tall, \d+% of the file’s size/);
  await expect.poll(() => fragment(page)).toMatch(/unit=mm&scale=[\d.]+/);
  // In centimetres it is the same, and so are the limits.
  await page.locator('#print-shown-unit').selectOption('cm');
  expect(await page.locator('#min-tube').inputValue()).toBe('0.3');
  expect(await answer.textContent()).toMatch(/^Passes/);
  await expect.poll(() => fragment(page)).toContain('shown=cm');
  // A word that is no length leaves no older answer.
  await page.locator('#min-wall').fill('thin');
  await page.keyboard.press('Enter');
  await expect.poll(() => answer.textContent()).toContain('“thin” is not a length');
  expect(await viewer.locator('.legend').textContent()).not.toContain('Print check');
  expect(await meaning.textContent()).toMatch(/^Colours: the length of the shortest loop/);
  await page.locator('#min-wall').fill('1.1in');
  await page.locator('#check').click();
  await expect.poll(() => answer.textContent()).toMatch(/^Fails/);
  expect(await page.locator('#min-wall').inputValue()).toBe('2.794');
});

/** A box of 10 with a cavity, in which a plate of 4 × 4 × 0.1 floats: from outside nobody sees it. */
function hiddenPlate(): string {
  const cavity = turnedOver(moved(scaled(box(4, 4, 4), 2), [1, 1, 1]));
  const plate = placed(box(4, 4, 1), (x, axis) => (axis === 2 ? 5 + 0.1 * x : 3 + x));
  return beside(beside(scaled(box(5, 5, 5), 2), cavity, 0), plate, 0);
}

test('a weak place that the surface hides is uncovered by a section', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'hidden.obj', bytes: Buffer.from(hiddenPlate()) });
  await modelIs(page, 'hidden.obj');
  const panel = await openPanel(page, 'print');
  await page.locator('#min-wall').fill('0.5');
  await page.locator('#check').click();
  await expect.poll(() => panel.locator('.answer').textContent()).toMatch(/^Fails: one place/);
  const middle = () =>
    viewer.evaluate((element: GirthViewer) => {
      const { positions } = element.geometry;
      for (let v = 0; v < positions.length / 3; v++) {
        const distance = Math.hypot(...[0, 1, 2].map((axis) => positions[3 * v + axis]! - 5));
        if (distance < 0.2 && element.screenPosition(v).visible) return true;
      }
      return false;
    });
  expect(await middle()).toBe(false);
  await panel.locator('.places button').first().click();
  await expect.poll(() => fragment(page)).toContain('section=');
  await expect.poll(middle).toBe(true);
  await picture(page, 'page-print-uncovered.png');
  await page.keyboard.press('Control+z');
  await expect.poll(() => fragment(page)).not.toContain('section=');
});

test('a height with a unit states that of the file; a glTF is in metres and shown in inches', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const line = page.locator('#details');
  await page.locator('#details-open').click();
  expect(await line.textContent()).toContain('m, as it states');
  await page.locator('#shown-unit').selectOption('in');
  await expect.poll(() => line.textContent()).toMatch(/× [\d.]+\u202fin/);
  await expect.poll(() => viewer.locator('.legend-title').textContent()).toBe('Girth, in');
  await page.keyboard.press('Escape');
  await page.locator('#details').waitFor({ state: 'hidden' });
  // Lengths that are small in the unit that is shown have their digits all the same.
  await openPanel(page, 'print');
  await page.locator('#min-wall').fill('1 um');
  await page.locator('#min-tube').click();
  expect(await page.locator('#min-wall').inputValue()).toBe('0.0000394');
  // Limits and printer are in the link, and come back with it.
  await expect.poll(() => fragment(page)).toContain('wall=0.000001');
  await page.locator('#print-preset').selectOption('Resin (SLA, DLP)');
  await expect.poll(() => fragment(page)).toContain('tube=0.0015&wall=0.0008&printer=sla');
  const link = page.url();
  await page.goto('about:blank');
  await page.goto(link);
  await modelIs(page, 'chair.glb');
  await expect
    .poll(() => page.locator('#print-preset option:checked').textContent())
    .toBe('Resin (SLA, DLP)');
  expect(await page.locator('#min-tube').inputValue()).toMatch(/^0\.059/);
  await drop(page, stool);
  await modelIs(page, 'stool.obj');
  if (!(await line.isVisible())) await page.locator('#details-open').click();
  await page.locator('#height').fill('0,9 m');
  await page.keyboard.press('Enter');
  await expect.poll(() => page.locator('#unit').inputValue()).toBe('m');
  await expect.poll(() => line.textContent()).toContain('1.8');
  await expect.poll(() => fragment(page)).toContain('unit=m&scale=0.9');
});

test('in another size a model keeps what was computed of it, and undo brings it back', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
  await page.locator('#field-name').selectOption('thickness');
  const thickness = () => viewer.evaluate((element: GirthViewer) => element.shareOf('thickness'));
  await expect.poll(thickness, { timeout: 60_000 }).toBe(1);
  const values = () =>
    viewer.evaluate(async (element: GirthViewer) => [
      [...(await element.fieldOf('igf')).values],
      [...(await element.fieldOf('thickness')).values],
    ]);
  const before = await values();
  const progress = await viewer.evaluateHandle((element: GirthViewer) => {
    const all: string[] = [];
    element.addEventListener('progress', ({ detail }) => all.push(detail.name));
    return all;
  });
  await page.locator('#details-open').click();
  const height = await viewer.evaluate((element: GirthViewer) => element.height);
  await page.locator('#height').fill(String(10 * height));
  await page.keyboard.press('Enter');
  await expect.poll(() => fragment(page)).toContain('scale=');
  const isGrown = async (factor: number): Promise<boolean> => {
    const now = await values();
    return before.every((all, i) =>
      all.every((value, v) => Math.abs(now[i]![v]! - factor * value) <= 1e-5 * factor),
    );
  };
  await expect.poll(() => isGrown(10)).toBe(true);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+z');
  await expect.poll(() => isGrown(1)).toBe(true);
  expect(await page.locator('#said').textContent()).toBe('Undone: size.');
  expect(await progress.jsonValue()).toEqual([]);
});
