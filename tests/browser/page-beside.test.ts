// A second model beside the first: one view for both, one scale, and the page as it was when it is closed.

import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { dumbbell, torus } from './meshes.js';
import { builtPage, drop, fragment, modelIs, openPanel, screens, showOn } from './page-support.js';
import { fieldComplete, framesPass } from './viewer-page.js';

const openBuilt = builtPage();
type Options = Parameters<typeof openBuilt>[1];

interface Pair {
  page: Page;
  first: Locator;
  second: Locator;
  /** The second with its bar. */
  pane: Locator;
}

/** Opens the page with the cup, and says where the second would be. */
async function openCup(state = 'model=cup', options: Options = {}): Promise<Pair> {
  const { page } = await openBuilt(state, options);
  const [first, pane] = [page.locator('#viewer'), page.locator('.beside')];
  await modelIs(page, 'cup.glb');
  await fieldComplete(first);
  return { page, first, pane, second: pane.locator('girth-viewer') };
}

/** Opens the dumbbell beside it, by the menu. */
async function openBeside({ page, second }: Pair): Promise<void> {
  await page.getByRole('button', { name: 'Open a second model beside it' }).click();
  await page.locator('#beside-menu').getByRole('button', { name: 'Dumbbell' }).click();
  await fieldComplete(second);
}

const viewOf = (viewer: Locator): Promise<number[]> =>
  viewer.evaluate((element: GirthViewer) => {
    const { polar, azimuth, distance, target } = element.camera!;
    return [polar, azimuth, distance, ...target];
  });
const rangeOf = (viewer: Locator) =>
  viewer.evaluate((element: GirthViewer) => element.shown?.range);
const boxOf = async (locator: Locator) => (await locator.boundingBox())!;

async function expectSameView({ first, second }: Pair): Promise<void> {
  const [one, other] = await Promise.all([viewOf(first), viewOf(second)]);
  one.forEach((number, i) => expect(number).toBeCloseTo(other[i]!, 8));
}

/** How far the surface reaches beyond the edges of its element, in CSS pixels. */
const cutOff = (viewer: Locator): Promise<number> =>
  viewer.evaluate((element: GirthViewer) => {
    const { clientWidth, clientHeight } = element;
    const beyond = Array.from({ length: element.info!.vertexCount }, (_, vertex) => {
      const { x, y } = element.screenPosition(vertex);
      return Math.max(-x, -y, x - clientWidth, y - clientHeight);
    });
    return Math.max(...beyond);
  });

test('beside an example that has turned by itself, both are seen whole', async () => {
  const pair = await openCup('model=cup', { reducedMotion: 'no-preference' });
  const { page, first, second } = pair;
  const [, azimuth] = await viewOf(first);
  // Far enough to be wider, or higher, than at first.
  const hasTurned = async (): Promise<boolean> => (await viewOf(first))[1]! < azimuth! - 0.6;
  await expect.poll(hasTurned, { timeout: 60_000 }).toBe(true);
  // A turn by itself is nothing that was done.
  expect(await page.evaluate(() => location.hash)).toBe('#model=cup');
  await openBeside(pair);
  await framesPass(page);
  for (const viewer of [first, second]) expect(await cutOff(viewer)).toBeLessThan(0);
  await expectSameView(pair);
  expect((await viewOf(first))[1]).toBeLessThan(azimuth! - 0.6);
  await page.setViewportSize({ width: 700, height: 700 });
  // Each is told of its size in a frame of its own, and of the other's view in the next.
  for (const viewer of [first, second]) await expect.poll(() => cutOff(viewer)).toBeLessThan(0);
});

test('views are linked until they are not, fields are the same, and closing it leaves the page as it was', async () => {
  const pair = await openCup();
  const { page, first, second, pane } = pair;
  const before = {
    range: await rangeOf(first),
    box: await boxOf(first),
    view: await viewOf(first),
  };
  await openBeside(pair);
  expect(await pane.locator('.model').textContent()).toMatch(/^dumbbell\.glb · [\d,]+ faces/);
  await expect.poll(() => page.locator('#said').textContent()).toBe('dumbbell.glb is beside it.');
  const [left, right] = [await boxOf(first), await boxOf(second)];
  expect(right.x).toBeGreaterThanOrEqual(left.x + left.width);
  expect(Math.abs(right.width - left.width)).toBeLessThanOrEqual(1);
  expect(right.height).toBe(left.height);

  for (const [viewer, key] of [
    [first, 'ArrowLeft'],
    [second, 'ArrowUp'],
    [second, '+'],
  ] as const) {
    const earlier = await viewOf(first);
    await viewer.locator('canvas').press(key);
    await framesPass(page);
    expect(await viewOf(first)).not.toEqual(earlier);
    await expectSameView(pair);
  }
  await page.getByLabel('Linked views').uncheck();
  const alone = await viewOf(second);
  await first.locator('canvas').press('ArrowLeft');
  await framesPass(page);
  expect(await viewOf(second)).toEqual(alone);
  await page.getByLabel('Linked views').check();
  await framesPass(page);
  await expectSameView(pair);

  await page.locator('#field-name').selectOption('sdf');
  await page.locator('#colormap').selectOption('magma');
  await expect
    .poll(() => second.evaluate(({ shown }: GirthViewer) => [shown?.name, shown?.colormap]))
    .toEqual(['sdf', 'magma']);
  await page.locator('#field-name').selectOption('igf');
  await page.locator('#colormap').selectOption('viridis');

  await first.locator('canvas').press('0');
  await pane.getByRole('button', { name: 'Close the second model' }).click();
  expect(await pane.count()).toBe(0);
  await framesPass(page);
  expect(await boxOf(first)).toEqual(before.box);
  expect(await rangeOf(first)).toEqual(before.range);
  expect(await viewOf(first)).toEqual(before.view);
  expect(await first.getAttribute('linked')).toBe(null);
  // The focus is where it was opened from.
  expect(await page.evaluate(() => document.activeElement?.id)).toBe('beside-open');
  await expect.poll(() => fragment(page)).toBe('model=cup&colormap=viridis');
});

test('one scale for both, which two numbers of the first replace', async () => {
  const pair = await openCup();
  const { page, first, second } = pair;
  await openBeside(pair);
  const [own, others] = [(await rangeOf(first))!, (await rangeOf(second))!];
  expect(own).not.toEqual(others);
  const all = [Math.min(own[0], others[0]), Math.max(own[1], others[1])];
  const ranges = () => Promise.all([rangeOf(first), rangeOf(second)]);
  const legend = (viewer: Locator) => viewer.locator('.legend-tick:not(.inner)').allInnerTexts();
  await page.getByLabel('One scale for both').check();
  await expect.poll(ranges).toEqual([all, all]);
  await expect.poll(() => legend(second)).toEqual(await legend(first));
  await first.evaluate((element) => element.setAttribute('range', '0.1 0.2'));
  await expect.poll(ranges).toEqual([
    [0.1, 0.2],
    [0.1, 0.2],
  ]);
  await first.evaluate((element) => element.removeAttribute('range'));
  await expect.poll(ranges).toEqual([all, all]);
  await page.getByLabel('One scale for both').uncheck();
  await expect.poll(ranges).toEqual([own, others]);
});

test('links and undo have it', async () => {
  const pair = await openCup();
  const { page, pane } = pair;
  const undo = page.getByRole('button', { name: 'Undo' });
  await openBeside(pair);
  await expect.poll(() => fragment(page)).toBe('model=cup&beside=dumbbell');
  await page.getByLabel('Linked views').uncheck();
  await expect.poll(() => fragment(page)).toContain('apart=1');
  await undo.click();
  await expect.poll(() => page.getByLabel('Linked views').isChecked()).toBe(true);
  await undo.click();
  await expect.poll(() => pane.count()).toBe(0);
  await expect.poll(() => fragment(page)).toBe('model=cup');
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect.poll(() => pane.getByText('dumbbell.glb', { exact: true }).isVisible()).toBe(true);

  const linked = await openCup('model=cup&beside=dumbbell&apart=1&oneScale=1');
  await fieldComplete(linked.second);
  expect(await linked.page.getByLabel('Linked views').isChecked()).toBe(false);
  await expect
    .poll(async () => JSON.stringify(await rangeOf(linked.first)))
    .toBe(JSON.stringify(await rangeOf(linked.second)));
  // Undo has nothing to undo: the link made the view.
  const undoThere = linked.page.getByRole('button', { name: 'Undo' });
  expect(await undoThere.getAttribute('aria-disabled')).toBe('true');
});

test('a file can be beside it; a link says that it lacks the file, and takes it', async () => {
  const bell = { name: 'bell.obj', mimeType: 'text/plain', buffer: Buffer.from(dumbbell(8, 6)) };
  const { page, pane, second } = await openCup();
  await page.locator('#beside-open').click();
  await page.locator('#beside-menu').getByRole('button', { name: 'A file' }).waitFor();
  await page.locator('#beside-file').setInputFiles(bell);
  await expect.poll(() => pane.locator('.model b').allTextContents()).toEqual(['bell.obj']);
  await expect.poll(() => fragment(page)).toBe('model=cup&besideFile=bell.obj');
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => pane.count()).toBe(0);
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect.poll(() => second.evaluate(({ info }: GirthViewer) => info?.name)).toBe('bell.obj');

  const other = await openCup('model=cup&besideFile=bell.obj');
  const card = other.pane.locator('.missing');
  await card.getByText('A link cannot have a file in it').waitFor();
  expect(await complaintsOfAxe(other.page)).toEqual([]);
  expect(fragment(other.page)).toBe('model=cup&besideFile=bell.obj');
  const choosing = other.page.waitForEvent('filechooser');
  await card.getByRole('button', { name: 'Open' }).click();
  await (await choosing).setFiles(bell);
  await card.waitFor({ state: 'hidden' });
  await expect
    .poll(() => other.second.evaluate(({ info }: GirthViewer) => info?.name))
    .toBe('bell.obj');
});

test('what cannot be read is said in its place; another takes it', async () => {
  const pair = await openCup();
  const { page, pane } = pair;
  await page.locator('#beside-open').click();
  await page.locator('#beside-menu').getByRole('button', { name: 'A file' }).waitFor();
  await page
    .locator('#beside-file')
    .setInputFiles({ name: 'bad.obj', mimeType: 'text/plain', buffer: Buffer.from('f 1 2 3\n') });
  const alert = pane.getByRole('alert');
  await expect.poll(() => alert.textContent()).toContain('bad.obj');
  await page.keyboard.press('Escape');
  await openBeside(pair);
  expect(await alert.isVisible()).toBe(false);
  expect(await page.locator('#model b').textContent()).toBe('cup.glb');
});

test('two files that are dropped together are shown side by side from the panel that compares them', async () => {
  const { page, pane, first, second } = await openCup();
  await drop(
    page,
    { name: 'bell.obj', bytes: Buffer.from(dumbbell(8, 6)) },
    { name: 'ring.obj', bytes: Buffer.from(torus(12, 8)) },
  );
  await modelIs(page, 'bell.obj');
  const panel = await openPanel(page, 'compare');
  await panel.getByRole('button', { name: 'Side by side' }).click();
  await expect.poll(() => pane.locator('.model b').allTextContents()).toEqual(['ring.obj']);
  await fieldComplete(first);
  await fieldComplete(second);
});

test('the palette opens it', async () => {
  const { page } = await openCup();
  await page.keyboard.press('Control+k');
  await page.locator('#palette').waitFor();
  await page.keyboard.type('second model');
  await page.locator('#palette li', { hasText: 'Open a second model beside it' }).first().waitFor();
  await page.keyboard.press('Enter');
  await page.locator('#beside-menu').getByRole('button', { name: 'A file' }).waitFor();
});

test('nothing covers anything at any size, and axe has no complaint', async () => {
  const pair = await openCup('model=cup&beside=dumbbell&oneScale=1');
  const { page, first, second, pane } = pair;
  await fieldComplete(second);
  for (const screen of screens) {
    const keep = await showOn(page, screen);
    const [above, below] = [await boxOf(first), await boxOf(second)];
    expect(Math.abs(above.height - below.height)).toBeLessThanOrEqual(2);
    expect(Math.abs(above.width - below.width)).toBeLessThanOrEqual(2);
    if (screen.width < 720) expect(below.y).toBeGreaterThanOrEqual(above.y + above.height);
    else expect(below.x).toBeGreaterThanOrEqual(above.x + above.width);
    // The bar lies over nothing of the surface, and the legend below it.
    const [bar, legend] = [
      await boxOf(pane.locator('.beside-bar')),
      await boxOf(second.locator('.legend')),
    ];
    const top = await second.evaluate((element: GirthViewer) => {
      const { vertexCount } = element.info!;
      const heights = Array.from({ length: vertexCount }, (_, v) => element.screenPosition(v).y);
      return element.getBoundingClientRect().top + Math.min(...heights);
    });
    expect(bar.y + bar.height).toBeLessThanOrEqual(top);
    expect(bar.y + bar.height).toBeLessThanOrEqual(legend.y);
    const controls = await pane
      .locator('.beside-bar > *')
      .evaluateAll((parts) =>
        parts.map((part) => part.getBoundingClientRect().toJSON() as DOMRect),
      );
    for (const { left, right, bottom } of controls) {
      expect(left).toBeGreaterThanOrEqual(bar.x);
      expect(right).toBeLessThanOrEqual(bar.x + bar.width);
      expect(bottom).toBeLessThanOrEqual(bar.y + bar.height + 1);
    }
    expect(await complaintsOfAxe(page), `${screen.width}`).toEqual([]);
    await keep('beside');
  }
});
