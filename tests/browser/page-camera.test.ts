// The camera and what it sees: still when at rest, and alike for surfaces of any size and place.

import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { moved, scaled, torus } from './meshes.js';
import { builtPage, drop, modelIs } from './page-support.js';
import { fieldComplete, framesPass, hover, placeOnSurface } from './viewer-page.js';

const openBuilt = builtPage();

/** Many frames are drawn here, by the processor: each takes time in proportion to its pixels. */
const viewport = { width: 800, height: 640 };

interface Place {
  x: number;
  y: number;
}

/** Where some vertices are on the screen, to the last bit. */
const placesOf = (viewer: Locator): Promise<Place[]> =>
  viewer.evaluate((element: GirthViewer) =>
    [0, 77, 200].map((vertex) => {
      const { x, y } = element.screenPosition(vertex);
      return { x, y };
    }),
  );

/** Their places once they stay. */
async function placesAtRest(viewer: Locator): Promise<Place[]> {
  let places = await placesOf(viewer);
  for (let attempt = 0; attempt < 300; ++attempt) {
    await framesPass(viewer.page());
    const later = await placesOf(viewer);
    if (later.every(({ x, y }, i) => x === places[i]!.x && y === places[i]!.y)) return later;
    places = later;
  }
  throw new Error('the surface never rests');
}

/** Drags from a place of the element, in shares of its size, in steps of a few pixels: each is a frame. */
async function drag(
  page: Page,
  viewer: Locator,
  right: number,
  button: 'left' | 'right',
  [across, down] = [0.5, 0.5],
) {
  const box = (await viewer.boundingBox())!;
  const [x, y] = [box.x + across * box.width, box.y + down * box.height];
  await page.mouse.move(x, y);
  await page.mouse.down({ button });
  await page.mouse.move(x + right, y, { steps: 8 });
  await page.mouse.up({ button });
}

for (const reducedMotion of ['no-preference', 'reduce'] as const) {
  test(`a camera at rest keeps its place to the last bit; motion: ${reducedMotion}`, async () => {
    const { page, viewer } = await openBuilt(undefined, { reducedMotion, viewport });
    await modelIs(page, 'chair.glb');
    await fieldComplete(viewer);
    // Turns by itself until then.
    await drag(page, viewer, 30, 'left');
    const places = await placesAtRest(viewer);
    const box = (await viewer.boundingBox())!;
    const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    for (let i = 0; i < 8; ++i) {
      // Loops come and go, a click pins one: each asks for frames.
      await page.mouse.move(middle.x + 9 * i, middle.y + 5 * i);
      if (i % 3 === 0) await page.mouse.click(middle.x + 9 * i, middle.y + 5 * i);
      await framesPass(page);
    }
    expect(await placesOf(viewer)).toEqual(places);
    // Beside the surface no loop is drawn that leaving it would clear: the frame that ended the motion is
    // the last one when the pointer comes back, and what it meets then it must meet later.
    for (let i = 0; i < 6; ++i) {
      await drag(page, viewer, i % 2 === 0 ? 7 : -7, 'left', [0.02, 0.02]);
      await page.mouse.move(1, 1);
      const place = await placeOnSurface(viewer, 0.5, 0.45);
      const { base } = await hover(page, viewer, place.x, place.y);
      await framesPass(page);
      expect((await hover(page, viewer, place.x, place.y)).base).toEqual(base);
    }
  });
}

const ring = torus(40, 20);
const surfaces: Record<string, string> = {
  'micrometres in metres': scaled(ring, 1e-5),
  'a scan far from the origin': moved(ring, [5e6, 4e5, -7e5]),
  'far too small': scaled(ring, 1e-20),
  'far too large': scaled(ring, 1e25),
};

test(
  'surfaces of any size and place are drawn, and follow the hand, alike',
  { timeout: 300_000 },
  async () => {
    const { page, viewer } = await openBuilt(undefined, {
      reducedMotion: 'no-preference',
      viewport,
    });
    await modelIs(page, 'chair.glb');
    // On the first one a loop shows itself, until the page is touched: it is no picture to compare with.
    await follows(page, viewer, 'untouched.obj', ring);
    await page.evaluate(() => delete (globalThis as unknown as { pixels?: unknown }).pixels);
    const usual = await follows(page, viewer, 'usual.obj', ring);
    expect(Math.min(...usual.by)).toBeGreaterThan(25);
    for (const [what, obj] of Object.entries(surfaces)) {
      const { before, by, off } = await follows(page, viewer, `${what}.obj`, obj);
      usual.before.forEach(({ x, y }, i) => {
        expect(Math.hypot(before[i]!.x - x, before[i]!.y - y), what).toBeLessThan(0.01);
      });
      usual.by.forEach((usually, i) => {
        expect(Math.abs(by[i]! - usually), what).toBeLessThan(0.5);
      });
      // Edges of lines may fall on other pixels; what is drawn may not.
      expect(off, what).toBeLessThan(0.002);
    }
  },
);

/**
 * Drops a surface and drags it aside: where its vertices are, how far that brings them, and the share of
 * pixels that are not as they were of the surface before.
 */
async function follows(page: Page, viewer: Locator, name: string, obj: string) {
  await drop(page, { name, bytes: Buffer.from(obj) });
  await modelIs(page, name);
  await fieldComplete(viewer);
  // Ends the turning, and all are seen from the same side.
  await viewer.evaluate((element: GirthViewer) => {
    element.camera = { polar: 1.1, azimuth: 0.6, distance: 4.5, target: [0, 0, 0] };
  });
  const before = await placesAtRest(viewer);
  const off = await changedPixels(viewer);
  await drag(page, viewer, 40, 'right');
  const after = await placesAtRest(viewer);
  return { off, before, by: after.map(({ x }, i) => x - before[i]!.x) };
}

/** The share of pixels, with the loop at a vertex, that are not as they were when it was asked before. */
const changedPixels = (viewer: Locator): Promise<number> =>
  viewer.evaluate(async (element: GirthViewer) => {
    const { id } = await element.pin(77);
    const bitmap = await createImageBitmap(await element.snapshot({ legend: false }));
    element.unpin(id);
    const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
    pen.drawImage(bitmap, 0, 0);
    const { data } = pen.getImageData(0, 0, bitmap.width, bitmap.height);
    const kept = globalThis as unknown as { pixels?: Uint8ClampedArray };
    const { pixels = data } = kept;
    kept.pixels = data;
    if (pixels.length !== data.length) return 1;
    let changed = 0;
    for (let i = 0; i < data.length; ++i) {
      if (Math.abs(data[i]! - pixels[i]!) > 24) ++changed;
    }
    return changed / data.length;
  });

test('a surface that drawing cannot hold is refused in words; the one before stays', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  for (const by of [1e150, 1e-150]) {
    await drop(page, { name: 'far.obj', bytes: Buffer.from(scaled(ring, by)) });
    const message = viewer.getByRole('alert');
    await message.waitFor();
    expect(await message.getAttribute('data-code')).toBe('LIMIT_EXCEEDED');
    const words = await message.textContent();
    expect(words).toContain('far.obj');
    expect(words).toMatch(
      /too (large|small) to be drawn: its size (has|begins with) (more than )?30 /,
    );
    expect(words).toContain('another unit');
    await message.getByRole('button').click();
    await modelIs(page, 'chair.glb');
  }
  await fieldComplete(viewer);
});
