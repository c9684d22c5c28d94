// Helpers of the tests of page and element: finding places on a surface, and asking the
// command for the truth.

import { execFileSync } from 'node:child_process';
import type { Locator, Page } from 'playwright-core';
import { expect } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import type { SurfacePoint } from '../../web/src/kernel/index.js';
import { command } from './support.js';

/** The length and kind that the command finds at a vertex of the file, or at a point of a face. */
export function loopByCommand(
  file: string,
  point: SurfacePoint,
): { length: number; kind: string; angle: number } {
  const place =
    typeof point === 'number'
      ? [String(point)]
      : ['--face', String(point.face), '--at', point.weights.join()];
  const text = execFileSync(command, ['loop', file, ...place, '--json'], { encoding: 'utf8' });
  return JSON.parse(text) as { length: number; kind: string; angle: number };
}

/** Waits until a whole field is there, and what is said of it: colours, legend, no progress. */
export async function fieldComplete(viewer: Locator, timeout = 90_000): Promise<void> {
  const complete = (element: GirthViewer) =>
    !!element.info &&
    element.values('igf').every((value) => !Number.isNaN(value)) &&
    !element.shadowRoot!.querySelector('[role=progressbar]')!.checkVisibility();
  const until = Date.now() + timeout;
  while (!(await viewer.evaluate(complete))) {
    if (Date.now() > until) throw new Error('the field was not completed in time');
    await viewer.page().waitForTimeout(50);
  }
}

/** Waits until the value of a vertex at least is there. */
export async function fieldBegun(viewer: Locator): Promise<void> {
  await expect
    .poll(
      () =>
        viewer.evaluate((element: GirthViewer) =>
          element.values('igf').some((value) => !Number.isNaN(value)),
        ),
      { interval: 20 },
    )
    .toBe(true);
}

/** Waits for a few frames: time enough for what moves to be seen to, however slow the machine is. */
export async function framesPass(page: Page): Promise<void> {
  await page.evaluate(async () => {
    for (let i = 0; i < 4; ++i) await new Promise((done) => requestAnimationFrame(done));
  });
}

/** Lets the time pass in which a second click or tap would make a pair with the last one: so do people. */
export async function pairIsOver(page: Page): Promise<void> {
  const last = await page.evaluate(() => performance.now());
  await page.waitForFunction((last) => performance.now() - last > 300, last);
}

/**
 * A point of the page where the surface is, beside the visible vertex nearest to a place given in
 * shares of the element's size. Waits until the surface rests and can be picked.
 */
export async function placeOnSurface(viewer: Locator, right: number, down: number) {
  // A surface that turns, or comes to rest slowly, would be elsewhere when the pointer gets there.
  await viewer.page().emulateMedia({ reducedMotion: 'reduce' });
  let before: { x: number; y: number } | undefined;
  for (let attempt = 0; attempt < 200; ++attempt) {
    const found = await viewer.evaluate(
      (element: GirthViewer, [right, down]) => {
        const box = element.getBoundingClientRect();
        const target = [right! * box.width, down! * box.height] as const;
        let nearest = { x: 0, y: 0, distance: Infinity };
        const middle = { x: 0, y: 0, count: 0 };
        for (let vertex = 0; vertex < element.info!.vertexCount; ++vertex) {
          const { x, y, visible } = element.screenPosition(vertex);
          const distance = Math.hypot(x - target[0], y - target[1]);
          if (!visible) continue;
          if (distance < nearest.distance) nearest = { x, y, distance };
          middle.x += x;
          middle.y += y;
          ++middle.count;
        }
        // A vertex on the outline is beside the surface as often as on it: go a little inwards.
        const [dx, dy] = [middle.x / middle.count - nearest.x, middle.y / middle.count - nearest.y];
        const step = Math.min(1, 2 / Math.hypot(dx, dy));
        return { x: box.left + nearest.x + step * dx, y: box.top + nearest.y + step * dy };
      },
      [right, down],
    );
    if (Number.isFinite(found.x) && found.x === before?.x && found.y === before.y) return found;
    before = found;
    await framesPass(viewer.page());
  }
  throw new Error('nothing of the surface can be seen');
}

export interface Shown {
  base: SurfacePoint;
  length: number;
  kind: string;
  /** As the user reads it. */
  text: string;
}

/** Moves the mouse from beside the surface to a place on it and reads what is written there. */
export async function hover(page: Page, viewer: Locator, x: number, y: number): Promise<Shown> {
  const readout = viewer.locator('.readout');
  await page.mouse.move(1, 1);
  await readout.waitFor({ state: 'hidden' });
  // One step: no other loop than this place's is asked for.
  await page.mouse.move(x, y);
  await readout.waitFor({ state: 'visible' });
  return readout.evaluate((element) => ({
    base: JSON.parse((element as HTMLElement).dataset['base']!) as SurfacePoint,
    length: Number((element as HTMLElement).dataset['length']),
    kind: (element as HTMLElement).dataset['kind']!,
    text: element.textContent,
  }));
}

/** The share of each label that a selector finds that lies over the drawn surface. */
export const coveredShares = (viewer: Locator, labels: string): Promise<number[]> =>
  viewer.evaluate(async (element: GirthViewer, labels) => {
    const box = element.getBoundingClientRect();
    const bitmap = await createImageBitmap(await element.snapshot());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    const ratio = bitmap.width / box.width;
    return [...element.shadowRoot!.querySelectorAll(labels)].map((tag) => {
      const { left, top, width, height } = tag.getBoundingClientRect();
      const place = [left - box.left, top - box.top, width, height].map((n) => n * ratio);
      const { data } = context.getImageData(place[0]!, place[1]!, place[2]!, place[3]!);
      // Its shadow is fainter.
      return data.filter((alpha, i) => i % 4 === 3 && alpha > 200).length / (data.length / 4);
    });
  }, labels);
