// Plots by finger, as by mouse: the brush on the histogram, the thresholds in the plot of girth and shape diameter.

import type { CDPSession, Locator, Page } from 'playwright-core';
import { beforeEach, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { builtPage, modelIs, openPanel } from './page-support.js';
import { fieldComplete, pairIsOver, placeOnSurface } from './viewer-page.js';

const openBuilt = builtPage();
let page: Page;
let viewer: Locator;
let session: CDPSession;

beforeEach(async () => {
  ({ page, viewer } = await openBuilt(undefined, {
    hasTouch: true,
    isMobile: true,
    viewport: { width: 390, height: 844 },
  }));
  session = await page.context().newCDPSession(page);
  await modelIs(page, 'chair.glb');
  await fieldComplete(viewer);
});

type Place = readonly [number, number];

/** A finger goes down at the first place, over the others, and is lifted. */
async function drag(first: Place, ...others: Place[]): Promise<void> {
  const send = (
    type: 'touchStart' | 'touchMove' | 'touchEnd',
    touchPoints: { x: number; y: number }[],
  ) => session.send('Input.dispatchTouchEvent', { type, touchPoints });
  await send('touchStart', [{ x: first[0], y: first[1] }]);
  let from = first;
  for (const to of others) {
    for (let step = 1; step <= 6; ++step) {
      const between = (k: 0 | 1) => from[k] + ((to[k] - from[k]) * step) / 6;
      await send('touchMove', [{ x: between(0), y: between(1) }]);
    }
    from = to;
  }
  await send('touchEnd', []);
}

test('a finger across the histogram marks a range; one along the page scrolls it', async () => {
  const plot = page.locator('#distribution');
  await plot.scrollIntoViewIfNeeded();
  const box = (await plot.boundingBox())!;
  const y = box.y + box.height / 2;
  await drag([box.x + 0.25 * box.width, y], [box.x + 0.6 * box.width, y + 4]);
  const caption = page.locator('.caption');
  await expect.poll(() => caption.textContent()).toMatch(/ to .*: [\d.]+\u202f%/);
  const [low, high] = /^([\d.]+) to ([\d.]+)/
    .exec((await caption.textContent())!)!
    .slice(1)
    .map(Number);
  const [least, most] = await viewer.evaluate(
    async (element: GirthViewer) => (await element.fieldOf('igf')).range,
  );
  expect(low).toBeCloseTo(least + 0.25 * (most - least), 2);
  expect(high).toBeCloseTo(least + 0.6 * (most - least), 2);

  // Down the page: the panel scrolls, and what is marked stays marked.
  const aside = page.locator('aside');
  expect(await aside.evaluate((element) => element.scrollTop)).toBe(0);
  const marked = await caption.textContent();
  await drag([box.x + 0.5 * box.width, y], [box.x + 0.5 * box.width, y - 150]);
  await expect.poll(() => aside.evaluate((element) => element.scrollTop)).toBeGreaterThan(30);
  expect(await caption.textContent()).toBe(marked);
  // The name of the field on the surface stays in sight.
  const [side, name] = [(await aside.boundingBox())!, page.locator('#field-name')];
  await aside.evaluate((element) => element.scrollTo(0, element.scrollHeight));
  expect((await page.locator('#print-panel').boundingBox())!.y).toBeGreaterThan(side.y);
  const row = (await name.boundingBox())!;
  expect(row.y).toBeGreaterThanOrEqual(side.y);
  expect(row.y + row.height).toBeLessThan(side.y + 60);
  // A tap takes the mark away, as a click does.
  await plot.scrollIntoViewIfNeeded();
  const now = (await plot.boundingBox())!;
  await page.touchscreen.tap(now.x + 0.5 * now.width, now.y + now.height / 2);
  await expect.poll(() => caption.textContent()).toMatch(/^median/);
});

/** Two taps of a finger, sent together, so that nothing comes between them. */
async function tapTwice({ x, y }: { x: number; y: number }): Promise<void> {
  const send = (type: 'touchStart' | 'touchEnd') => {
    const touchPoints = type === 'touchStart' ? [{ x, y }] : [];
    return session.send('Input.dispatchTouchEvent', { type, touchPoints });
  };
  await Promise.all([send('touchStart'), send('touchEnd'), send('touchStart'), send('touchEnd')]);
}

test('a double tap turns about a point and pins nothing; the readout leaves the axes free', async () => {
  const target = () => viewer.evaluate((element: GirthViewer) => element.camera!.target);
  const pinned = () => viewer.evaluate((element: GirthViewer) => element.pinned.length);
  const [before, point] = [await target(), await placeOnSurface(viewer, 0.5, 0.3)];
  await page.touchscreen.tap(point.x, point.y);
  await viewer.locator('.readout').waitFor();
  await pairIsOver(page);
  expect(await target()).toEqual(before);
  // The loop is shown: a single tap would pin it now.
  await tapTwice(point);
  await expect.poll(target).not.toEqual(before);
  await pairIsOver(page);
  expect(await pinned()).toBe(0);
  const bar = (await viewer.locator('.bar-tools').boundingBox())!;
  const readout = viewer.locator('.readout');
  for (const down of [0.15, 0.3, 0.45]) {
    await viewer.evaluate((element: GirthViewer, down) => {
      element.resetView();
      const far = (vertex: number): number => {
        const { x, y, visible } = element.screenPosition(vertex);
        const { clientWidth, clientHeight } = element;
        return visible ? Math.hypot(x - clientWidth, y - down * clientHeight) : Infinity;
      };
      const vertices = Array.from({ length: element.info!.vertexCount }, (_, vertex) => vertex);
      element.showLoop();
      element.showLoop(vertices.reduce((best, one) => (far(one) < far(best) ? one : best)));
    }, down);
    await readout.waitFor();
    const box = (await readout.boundingBox())!;
    const isBeside = box.x + box.width <= bar.x || box.y >= bar.y + bar.height;
    expect(isBeside, JSON.stringify([box, bar])).toBe(true);
  }
});

test('thresholds follow a finger, each by its line and both by their cross', async () => {
  const panel = await openPanel(page, 'parts');
  await panel.locator('.controls').waitFor({ timeout: 60_000 });
  await page.locator('#parts-girth').fill('0.2');
  await page.locator('#parts-girth').press('Enter');
  await page.locator('#parts-shapeDiameter').fill('0.05');
  await page.locator('#parts-shapeDiameter').press('Enter');
  const plot = panel.locator('.scatter');
  await plot.evaluate((element) => element.scrollIntoView({ block: 'center' }));
  const thresholds = () =>
    viewer.evaluate((element: GirthViewer): Place => [
      element.thresholds!.girth,
      element.thresholds!.shapeDiameter,
    ]);
  const middle = async (selector: string): Promise<Place> => {
    const box = (await panel.locator(selector).boundingBox())!;
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  const before = await thresholds();
  const [x, y] = await middle('.plot-cross');
  await drag([x, y], [x - 30, y + 30]);
  const both = await thresholds();
  expect(both[0]).toBeLessThan(before[0]);
  expect(both[1]).toBeLessThan(before[1]);
  // Where the finger let go, there the cross is.
  const [nowX, nowY] = await middle('.plot-cross');
  expect(Math.abs(nowX - (x - 30))).toBeLessThan(2);
  expect(Math.abs(nowY - (y + 30))).toBeLessThan(2);

  // A finger is broad: a dozen pixels beside the line are on it.
  const line = (await panel.locator('.plot-handle-girth').boundingBox())!;
  const low = line.y + line.height - 4;
  await drag([nowX + 14, low], [nowX + 54, low - 2]);
  const girthOnly = await thresholds();
  expect(line.width).toBeGreaterThanOrEqual(36);
  expect(girthOnly[0]).toBeGreaterThan(both[0]);
  expect(girthOnly[1]).toBe(both[1]);
  // The parts were found anew for it.
  await expect.poll(() => panel.locator('.count').textContent()).toMatch(/\d+ tubes?, \d+ plates?/);
});

test('a second tap pins the place that it touches; words are for fingers', async () => {
  const words = page.locator('#no-loops, #invitation');
  const seen = await words.evaluateAll((all) => all.map((one) => (one as HTMLElement).innerText));
  expect(seen.join(' ')).toMatch(/Open a mesh.*Tap the surface to see its loop, and tap again/);
  expect(seen.join(' ')).not.toMatch(/click|Drop|Point/);

  const point = await placeOnSurface(viewer, 0.5, 0.55);
  const surface = (await viewer.boundingBox())!;
  let second = point;
  for (const [right, down] of [
    [16, 0],
    [-16, 0],
    [0, 16],
    [0, -16],
  ] as const) {
    const [x, y] = [point.x + right - surface.x, point.y + down - surface.y];
    const near = await placeOnSurface(viewer, x / surface.width, y / surface.height);
    const pixels = Math.hypot(near.x - point.x, near.y - point.y);
    if (pixels > 10 && pixels < 22) second = near;
  }
  expect(second).not.toBe(point);
  await page.touchscreen.tap(point.x, point.y);
  await viewer.locator('.readout').waitFor();
  await pairIsOver(page);
  await page.touchscreen.tap(second.x, second.y);
  const pinned = () => viewer.evaluate((element: GirthViewer) => element.pinned.length);
  await expect.poll(pinned).toBe(1);
  const place = await viewer.evaluate((element: GirthViewer) => {
    const { left, top } = element.getBoundingClientRect();
    const { x, y } = element.screenPosition(element.pinned[0]!.loop.base);
    return { x: left + x, y: top + y };
  });
  expect(Math.hypot(place.x - second.x, place.y - second.y)).toBeLessThan(2);
});
