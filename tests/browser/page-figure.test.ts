// A figure for a paper, from the page alone: an octopus upright with three loops, scale bar and legend, at
// 300 dpi, transparent; and the same view again of a second model.

import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { builtPage, modelIs } from './page-support.js';
import { coveredShares, fieldComplete, pairIsOver, placeOnSurface } from './viewer-page.js';

const openBuilt = builtPage();

/** Counts every press of the mouse on the page. */
async function countClicks(page: Page): Promise<() => Promise<number>> {
  await page.evaluate(() => {
    const counted = { clicks: 0 };
    Object.assign(globalThis, { counted });
    addEventListener('pointerdown', () => ++counted.clicks, { capture: true });
  });
  return () =>
    page.evaluate(() => (globalThis as unknown as { counted: { clicks: number } }).counted.clicks);
}

/** The picture that a click brings: its size, its density, and the pixels of its corner and in all. */
async function pictureOf(page: Page) {
  const coming = page.waitForEvent('download');
  await page.locator('#export-picture [data-format=png]').click();
  const download = await coming;
  const bytes = readFileSync(await download.path());
  const chunk = bytes.indexOf('pHYs');
  const density = chunk < 0 ? [] : [bytes.readUInt32BE(chunk + 4), bytes.readUInt32BE(chunk + 8)];
  const seen = await page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes]));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const alphaAt = (x: number, y: number) => context.getImageData(x, y, 1, 1).data[3]!;
    const { width, height } = bitmap;
    // The scale bar is a line of ink near the lower right corner.
    const bottom = context.getImageData(width / 2, height * 0.9, width / 2, height * 0.1).data;
    let ink = 0;
    for (let i = 0; i < bottom.length; i += 4) {
      if (bottom[i] === 28 && bottom[i + 1] === 29 && bottom[i + 3] === 255) ++ink;
    }
    return { width, corner: alphaAt(2, 2), ink };
  }, bytes.toString('base64'));
  return { name: download.suggestedFilename(), density, ...seen };
}

test('an octopus with three loops at 300 dpi, and the same view of another model: 15 clicks', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const clicks = await countClicks(page);
  await page.getByRole('button', { name: 'Octopus' }).click();
  await modelIs(page, 'octopus.glb');
  await fieldComplete(viewer);
  expect(await viewer.evaluate((element: GirthViewer) => element.upAxis!.name)).toBe('y');
  const pinned = () => viewer.evaluate((element: GirthViewer) => element.pinned.length);
  for (const [i, right] of [0.35, 0.5, 0.65].entries()) {
    const place = await placeOnSurface(viewer, right, 0.6);
    await page.mouse.click(place.x, place.y);
    await expect.poll(pinned).toBe(i + 1);
    await pairIsOver(page);
  }
  await page.mouse.move(1, 1);
  // All labels stand clear of the octopus, however small the room is.
  await expect.poll(() => coveredShares(viewer, '.tag')).toEqual([0, 0, 0]);
  const size = page.viewportSize()!;
  await page.setViewportSize({ width: 390, height: 844 });
  await expect.poll(() => coveredShares(viewer, '.tag')).toEqual([0, 0, 0]);
  await page.setViewportSize(size);
  // Labels stand clear of the legend's numbers too, though a loop lies beside them.
  const onNumbers = () =>
    viewer.evaluate(async (element: GirthViewer) => {
      let leftmost = { vertex: 0, x: Infinity };
      for (let vertex = 0; vertex < element.info!.vertexCount; ++vertex) {
        const { x, visible } = element.screenPosition(vertex);
        if (visible && x < leftmost.x) leftmost = { vertex, x };
      }
      const { id } = await element.pin(leftmost.vertex);
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      const boxes = (of: string) =>
        [...element.shadowRoot!.querySelectorAll(of)].map((one) => one.getBoundingClientRect());
      const numbers = boxes('.legend-tick');
      const crossed = boxes('.tag').filter((tag) =>
        numbers.some(
          (number) =>
            tag.left < number.right &&
            number.left < tag.right &&
            tag.top < number.bottom &&
            number.top < tag.bottom,
        ),
      );
      element.unpin(id);
      return crossed.length;
    });
  expect(await onNumbers()).toBe(0);
  await viewer.getByRole('button', { name: /^Axes/ }).click();
  await viewer.getByRole('button', { name: 'Front' }).click();
  await viewer.getByRole('checkbox', { name: 'Same view for the next model' }).click();
  const view = await viewer.evaluate((element: GirthViewer) => element.camera!);

  await page.getByRole('button', { name: 'Export' }).click();
  await page.locator('#picture-width').selectOption('two columns: 175 mm at 300 dpi');
  await page.getByRole('checkbox', { name: 'Transparent' }).click();
  const first = await pictureOf(page);
  expect(first).toMatchObject({
    name: 'octopus.png',
    width: 2067,
    density: [11811, 11811],
    corner: 0,
  });
  expect(first.ink).toBeGreaterThan(100);

  await page.getByRole('button', { name: 'Cup' }).click();
  await modelIs(page, 'cup.glb');
  await fieldComplete(viewer);
  const again = await viewer.evaluate((element: GirthViewer) => element.camera!);
  for (const name of ['polar', 'azimuth', 'distance'] as const) {
    expect(again[name]).toBeCloseTo(view[name], 6);
  }
  await page.getByRole('button', { name: 'Export' }).click();
  const second = await pictureOf(page);
  expect(second).toMatchObject({
    name: 'cup.png',
    width: 2067,
    density: [11811, 11811],
    corner: 0,
  });
  // Two more clicks were in the list of sizes, which opens outside of the page.
  expect(await clicks()).toBe(13);

  // The figure in lines: the outline, as wide as the surface is seen, with a loop; and the plot that is seen.
  const drawn = async (entry: number) => {
    await page.getByRole('button', { name: 'Export' }).click();
    const coming = page.waitForEvent('download');
    await page.locator('#export-picture [data-format=svg]').nth(entry).click();
    const download = await coming;
    const text = readFileSync(await download.path(), 'utf8');
    const read = await page.evaluate((text) => {
      const file = new DOMParser().parseFromString(text, 'image/svg+xml');
      const of = (name: string) => [...file.querySelectorAll(name)];
      const numbersOf = (path: string) =>
        of(path).flatMap((one) =>
          one
            .getAttribute('d')!
            .match(/-?[\d.]+/g)!
            .map(Number),
        );
      return {
        isRead: of('parsererror').length === 0,
        width: file.documentElement.getAttribute('width'),
        texts: of('text').map((one) => one.textContent),
        contour: numbersOf('.contour'),
        loops: of('.loop').length + of('.hidden').length,
        bars: of('rect').length,
      };
    }, text);
    return { name: download.suggestedFilename(), ...read };
  };
  const { base, length } = await viewer.evaluate(async (element: GirthViewer) => {
    const { loop } = await element.pin(0);
    return loop as { base: number; length: number };
  });
  expect(base).toBe(0);
  const outline = await drawn(0);
  expect(outline).toMatchObject({ name: 'cup-outline.svg', isRead: true, width: '175mm' });
  expect(outline.loops).toBeGreaterThan(0);
  expect(outline.texts.length).toBe(2);
  const said = outline.texts.map((words) => Number.parseFloat(words.replace(/^1\s+/, '')));
  const unit = await viewer.evaluate((element: GirthViewer) => element.lengthFormat.scale);
  expect(said[0]).toBeCloseTo(length * unit, 1);
  const box = (numbers: readonly number[]) => [
    ...[0, 1].map((axis) => Math.min(...numbers.filter((_, i) => i % 2 === axis))),
    ...[0, 1].map((axis) => Math.max(...numbers.filter((_, i) => i % 2 === axis))),
  ];
  const places = await viewer.evaluate((element: GirthViewer) =>
    Array.from({ length: element.info!.vertexCount }, (_, vertex) => {
      const { x, y } = element.screenPosition(vertex);
      return [x, y];
    }).flat(),
  );
  const ends = box(places);
  box(outline.contour).forEach((end, i) => expect(Math.abs(end - ends[i]!)).toBeLessThan(2.5));
  const plot = await drawn(1);
  expect(plot).toMatchObject({ name: 'cup-plot.svg', isRead: true, width: '175mm' });
  expect(plot.texts).toContain('Girth, m');
  expect(plot.bars).toBeGreaterThan(10);

  // A width that nobody lists.
  await page.getByRole('button', { name: 'Export' }).click();
  await page.locator('#picture-width').selectOption('another width');
  await page.locator('#picture-millimetres').fill('60');
  expect(await pictureOf(page)).toMatchObject({ width: 709, density: [11811, 11811] });

  // The print of the browser itself: words and a figure for paper, and nothing that is for hands.
  const asPrinted = () =>
    page.evaluate(() => {
      dispatchEvent(new Event('beforeprint'));
      const { shadowRoot } = document.querySelector('girth-viewer')!;
      const visible = (of: Iterable<Element>): Element[] =>
        [...of].filter((one) => one.checkVisibility({ visibilityProperty: true }));
      const figure = shadowRoot!.querySelector<HTMLCanvasElement>('.printed');
      const legend = figure
        ?.getContext('2d')!
        .getImageData(0, figure.height / 2, figure.width / 6, figure.height / 2).data;
      const seen = {
        words: document.body.innerText,
        controls: ['button', 'input', 'select', 'summary'].flatMap((name) => [
          ...visible(document.querySelectorAll(name)),
          ...visible(shadowRoot!.querySelectorAll(name)),
        ]).length,
        frame: visible(shadowRoot!.querySelectorAll('.frame > *')).map((one) => one.className),
        width: figure?.width,
        ink: legend?.filter((value, i) => i % 4 === 3 && value === 255).length ?? 0,
      };
      dispatchEvent(new Event('afterprint'));
      return { ...seen, isGone: !shadowRoot!.querySelector('.printed') };
    });
  await page.emulateMedia({ media: 'print' });
  await expect.poll(async () => (await asPrinted()).frame).toEqual(['printed']);
  const paper = await asPrinted();
  expect(paper).toMatchObject({ controls: 0, width: 2250, isGone: true });
  expect(paper.words).toMatch(/^Girth\s+cup\.glb/);
  expect(paper.words).toMatch(/Colours/);
  expect(paper.words.length).toBeLessThan(400);
  expect(paper.ink).toBeGreaterThan(1000);
  await page.emulateMedia({ media: null });
  const file = (await page.pdf({ format: 'A4' })).toString('latin1');
  expect(file.match(/\/Type \/Page\b/g)).toHaveLength(1);
  const widths = [...file.matchAll(/\/Width (\d+)/g)].map(([, width]) => Number(width));
  expect(Math.max(...widths)).toBeGreaterThanOrEqual(2000);
});
