// The page's tips, parts and print check: lists, thresholds, reports and files.

import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Download, Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { box } from './meshes.js';
import { builtPage, cutWords, drop, modelIs, openPanel, picture } from './page-support.js';
import { smallExamples } from './small-examples.js';
import { command } from './support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();
let page: Page;
let viewer: Locator;

beforeEach(async () => {
  ({ page, viewer } = await openBuilt());
});

async function openExample(name: string): Promise<void> {
  await modelIs(page, 'chair.glb');
  await page.getByRole('button', { name }).click();
  await modelIs(page, `${name.toLowerCase()}.glb`);
  await fieldComplete(viewer);
}

const textOf = async (download: Download): Promise<string> =>
  readFileSync(await download.path(), 'utf8');

async function downloadBy(act: () => Promise<void>): Promise<Download> {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return download;
}

test('the octopus has eight tips; one is chosen and flown to; noise can be ranked away', async () => {
  await openExample('Octopus');
  const panel = await openPanel(page, 'tips');
  const rows = panel.getByRole('list', { name: 'Tips', exact: true }).getByRole('button');
  await expect.poll(() => rows.count()).toBe(8);
  expect(await panel.locator('.count').textContent()).toBe('8');
  // Area, reach and rise with their units, as the element has them.
  const { jump, apexDistance } = await viewer.evaluate(
    async (element: GirthViewer) => (await element.tips()).tips[1]!,
  );
  const words = await rows.nth(1).textContent();
  expect(words).toContain(`rises by ${jump.toFixed(4)}\u202fm`);
  expect(words).toContain(`length ${apexDistance.toFixed(4)}\u202fm`);
  expect(words).toMatch(/area [\d.]+\u202f(cm²|mm²)/);
  const camera = () => viewer.evaluate((element: GirthViewer) => JSON.stringify(element.camera));
  const before = await camera();
  await rows.nth(1).click();
  expect(await rows.nth(1).getAttribute('aria-pressed')).toBe('true');
  await expect.poll(camera).not.toBe(before);
  // Arcs that cut nothing off are listed as open.
  const arcs = await viewer.evaluate(
    async (element: GirthViewer) => (await element.tips()).arcs.length,
  );
  const listed = panel.getByRole('list', { name: 'Other lines' }).getByRole('button');
  expect(await listed.count()).toBe(Math.min(100, arcs));

  await panel.getByLabel('Tips that rise by at least').focus();
  await page.keyboard.press('End');
  await expect.poll(() => rows.count()).toBe(1);
  expect(await panel.locator('#tips-words').textContent()).toBe(
    '7 tips rise by less and are hidden.',
  );
});

test('a box has no tips, and says so', async () => {
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'box.obj', bytes: Buffer.from(box(3, 3, 3)) });
  await modelIs(page, 'box.obj');
  await fieldComplete(viewer);
  const panel = await openPanel(page, 'tips');
  await expect.poll(() => panel.locator('#tips-words').textContent()).toContain('no tips');
  expect(await panel.locator('.count').textContent()).toBe('0');
});

test('thresholds by number, by dragging in the plot, by slider; automatic again', async () => {
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
  const panel = await openPanel(page, 'parts');
  await panel.locator('.controls').waitFor();
  const girth = page.locator('#parts-girth');
  const suggested = await girth.inputValue();
  expect(suggested).not.toBe('');
  expect(await page.locator('#field-name').inputValue()).toBe('parts');

  await girth.fill('0.2');
  await girth.press('Enter');
  await page.locator('#parts-shapeDiameter').fill('0.05');
  await page.locator('#parts-shapeDiameter').press('Enter');
  const thresholds = () =>
    viewer.evaluate((element: GirthViewer) => [
      element.thresholds!.girth,
      element.thresholds!.shapeDiameter,
    ]);
  expect(await thresholds()).toEqual([0.2, 0.05]);
  const counts = () =>
    viewer.evaluate(async (element: GirthViewer) => {
      const { parts } = await element.parts(element.thresholds!);
      const of = (kind: string) => parts.filter((part) => part.kind === kind).length;
      return [of('tube'), of('plate')];
    });
  const [tubes, plates] = await counts();
  expect(tubes).toBeGreaterThan(0);
  expect(plates).toBeGreaterThan(0);
  await expect.poll(() => panel.locator('h3').first().textContent()).toBe(`Tubes: ${tubes}`);
  expect(await panel.locator('h3').nth(1).textContent()).toBe(`Plates: ${plates}`);

  const cross = (await panel.locator('.plot-cross').boundingBox())!;
  await page.mouse.move(cross.x + cross.width / 2, cross.y + cross.height / 2);
  await page.mouse.down();
  await page.mouse.move(cross.x - 20, cross.y + 25, { steps: 3 });
  await page.mouse.up();
  const dragged = await thresholds();
  expect(dragged[0]).toBeLessThan(0.2);
  expect(dragged[1]).toBeLessThan(0.05);
  await panel.getByRole('slider', { name: 'Girth below which' }).first().focus();
  await page.keyboard.press('ArrowRight');
  expect((await thresholds())[0]).toBeGreaterThan(dragged[0]!);

  await girth.fill('-1');
  await girth.press('Enter');
  expect(await girth.getAttribute('aria-invalid')).toBe('true');
  await page.locator('#automatic').click();
  await expect.poll(() => girth.inputValue()).toBe(suggested);
  // Closed, the surface is coloured as before.
  await panel.locator('summary').click();
  await expect.poll(() => page.locator('#field-name').inputValue()).toBe('igf');
});

test('the print check finds the command’s places, pictured and reported', async () => {
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
  const panel = await openPanel(page, 'print');
  await page.locator('#check').click();
  await expect
    .poll(() => panel.locator('.answer').textContent())
    .toContain('Type a least tube diameter');
  await page.locator('#min-tube').fill('0.04');
  await page.locator('#min-wall').fill('0.02');
  await page.locator('#check').click();
  await panel.locator('.places img').first().waitFor({ timeout: 60_000 });

  const chair = join(smallExamples, 'chair.glb');
  const run = (): string => {
    try {
      const limits = ['--min-tube', '0.04m', '--min-wall', '0.02m'];
      return execFileSync(command, ['parts', chair, ...limits, '--json'], { encoding: 'utf8' });
    } catch (error) {
      const { status, stdout } = error as { status: number; stdout: string };
      expect(status).toBe(4);
      return stdout;
    }
  };
  const json = await downloadBy(() => panel.getByRole('button', { name: 'JSON' }).click());
  expect(json.suggestedFilename()).toBe('chair-print-check.json');
  const [mine, theirs] = [await textOf(json), run()].map(
    (text) => JSON.parse(text) as { file: string; places: unknown[] },
  );
  expect(mine).toEqual({ ...theirs, file: 'chair.glb' });
  const count = theirs!.places.length;
  expect(count).toBeGreaterThan(0);
  expect(await panel.locator('.answer').textContent()).toMatch(
    count === 1 ? 'one place is' : `${count} places are`,
  );

  const html = await downloadBy(() => panel.getByRole('button', { name: 'Report (HTML)' }).click());
  const report = await page.context().newPage();
  const asked: string[] = [];
  report.on('request', (request) => asked.push(request.url()));
  await report.setContent(await textOf(html));
  expect(await report.locator('table').first().locator('tbody tr').count()).toBe(
    Math.min(60, count),
  );
  const drawn = await report
    .locator('img')
    .evaluateAll((images: HTMLImageElement[]) =>
      Promise.all(images.map((image) => image.decode().then(() => image.naturalWidth))),
    );
  expect(drawn.length).toBe(Math.min(60, count) + 1);
  expect(Math.min(...drawn)).toBeGreaterThan(100);
  expect(asked.filter((address) => !address.startsWith('data:'))).toEqual([]);
  await report.close();

  // No tube fails any more; and a number that is none is said to be none.
  await page.locator('#min-tube').fill('0.001');
  await page.locator('#min-wall').fill('');
  await page.locator('#check').click();
  await expect.poll(() => panel.locator('.answer').textContent()).toContain('Passes');
  await page.locator('#min-tube').fill('three');
  await page.locator('#check').click();
  await expect.poll(() => panel.locator('.answer').textContent()).toContain('is not a length');
  expect(await panel.locator('.places').isVisible()).toBe(false);
});

test('a file without a unit that is open: the print check says both', async () => {
  await modelIs(page, 'chair.glb');
  const open = readFileSync(join(import.meta.dirname, '../data/bad/open.obj'));
  await drop(page, { name: 'open.obj', bytes: open });
  await modelIs(page, 'open.obj');
  const panel = await openPanel(page, 'print');
  const cautions = panel.locator('.cautions li');
  expect(await cautions.allTextContents()).toEqual([
    expect.stringContaining('does not state its unit'),
    expect.stringContaining('The surface is open'),
  ]);
  await page.locator('#print-unit').selectOption('mm');
  await expect.poll(() => cautions.count()).toBe(1);
  expect(await panel.locator('.unit').first().textContent()).toBe('mm');
});

test('every computed field by name, tips and parts as files', async () => {
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
  await page.locator('#field-name').selectOption('sdf');
  await expect
    .poll(() => viewer.locator('.legend-title').textContent(), { timeout: 30_000 })
    .toMatch(/diameter/);
  const exporting = async (name: string, group: string, format: string): Promise<Download> => {
    await page.getByRole('button', { name: 'Export' }).click();
    await page.locator('#export').waitFor();
    if (name) await page.locator('#export-name').selectOption(name);
    return downloadBy(() => page.locator(`#${group} [data-format=${format}]`).click());
  };
  const model = await exporting('', 'export-model', 'ply');
  expect(model.suggestedFilename()).toBe('chair.ply');
  expect((await textOf(model)).slice(0, 3)).toBe('ply');
  const sdf = await exporting('sdf', 'export-field', 'csv');
  expect(sdf.suggestedFilename()).toBe('chair-sdf.csv');
  expect((await textOf(sdf)).split('\n')[0]).toMatch(/^vertex,sdf/);
  const all = await textOf(await exporting('all', 'export-field', 'csv'));
  expect(all.split('\n')[0]).toMatch(/^vertex,igf,.*sdf/);
  const tips = JSON.parse(await textOf(await exporting('', 'export-tips', 'json'))) as {
    tips: unknown[];
  };
  expect(tips.tips.length).toBe(4);
  const parts = await exporting('', 'export-parts', 'json');
  expect(parts.suggestedFilename()).toBe('chair-parts.json');
  const picture = await exporting('', 'export-picture', 'png');
  expect(
    readFileSync(await picture.path())
      .subarray(1, 4)
      .toString(),
  ).toBe('PNG');
});

// Spectra and distances of a whole surface take their time.
test('beside the tips: heat maxima, extrema of the mean distance, shape diameter', async () => {
  await openExample('Octopus');
  const panel = await openPanel(page, 'tips');
  const tips = panel.getByRole('list', { name: 'Tips', exact: true }).getByRole('button');
  await expect.poll(() => tips.count()).toBe(8);
  const choice = page.locator('#rival');
  const rows = panel.locator('.rivals .places').getByRole('button');

  await choice.selectOption('heat maxima');
  await rows.first().waitFor({ timeout: 90_000 });
  // As many as there are tips, to begin with: at an arm's end each, or nearly.
  expect(await rows.count()).toBe(8);
  const heat = await viewer.evaluate((element: GirthViewer) => element.heatMaxima());
  expect(await panel.locator('.rivals .hint').textContent()).toBe(
    `${heat.length} maxima in all, as diamonds on the surface.`,
  );
  expect(await rows.nth(1).textContent()).toContain(`maximum at vertex ${heat[1]!.vertex}`);
  // The girth's tips stay beside them.
  expect(await tips.count()).toBe(8);

  expect(await cutWords(page)).toEqual([]);
  await choice.selectOption('GeoAverage');
  const hint = panel.locator('.rivals .hint');
  await expect.poll(() => hint.textContent(), { timeout: 90_000 }).toMatch(/minim/);
  const extrema = await viewer.evaluate(async (element: GirthViewer) => {
    const of = async (minima: boolean) =>
      (await element.maxima('geoaverage', { minima })).map((one) => ({ ...one, minima }));
    const { values, range } = await element.fieldOf('geoaverage');
    const both = [...(await of(false)), ...(await of(true))];
    both.sort((a, b) => b.persistence - a.persistence);
    return { both, highest: values.indexOf(range[1]), least: values.indexOf(range[0]) };
  });
  const minima = extrema.both.filter(({ minima }) => minima).length;
  expect(minima).toBeGreaterThan(0);
  expect(await hint.textContent()).toContain(`${extrema.both.length - minima} maxima`);
  const count = page.locator('#rival-count');
  await count.fill('50');
  expect(await rows.count()).toBe(Math.min(50, extrema.both.length));
  const words = (await rows.allTextContents()).join('\n');
  expect(words).toContain(`minimum at vertex ${extrema.least}`);
  expect(words).toContain(`maximum at vertex ${extrema.highest}`);
  await count.fill('3');
  expect(await rows.count()).toBe(3);
  const camera = () => viewer.evaluate((element: GirthViewer) => JSON.stringify(element.camera));
  const before = await camera();
  await rows.nth(2).click();
  await expect.poll(camera).not.toBe(before);
  await picture(page, 'rivals-geoaverage.png');

  await choice.selectOption('shape diameter');
  await expect.poll(() => page.locator('#field-name').inputValue()).toBe('sdf');
  expect(await rows.count()).toBe(0);
  await choice.selectOption('nothing');
  expect(await page.locator('#field-name').inputValue()).toBe('igf');
}, 300_000);
