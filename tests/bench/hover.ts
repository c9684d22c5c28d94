// How long it takes from a pointer on the surface to the frame that has its loop.

import type { Locator } from 'playwright-core';
import type { GirthViewer } from '../../web/src/element/index.js';
import { placeOnSurface } from '../browser/viewer-page.js';

/** Milliseconds between two moves: nobody waits for the last one any more. */
const pause = 150;

/** Moves the pointer over a surface so many times; milliseconds of each move until its loop has been drawn. */
export async function loopTimes(viewer: Locator, moves: number): Promise<number[]> {
  const page = viewer.page();
  await viewer.evaluate((element: GirthViewer) => {
    let moved = 0;
    const shown: number[] = [];
    Object.assign(globalThis, { shown });
    element.addEventListener('pointermove', (event) => (moved = event.timeStamp));
    element.addEventListener('pick', (event) => {
      if (event.detail.action !== 'hover') return;
      const asked = moved;
      // After the frame that has the loop.
      requestAnimationFrame(() => setTimeout(() => shown.push(performance.now() - asked)));
    });
  });
  for (let i = 0; i < moves; ++i) {
    const across = 0.3 + 0.4 * ((i * 0.618) % 1);
    const place = await placeOnSurface(viewer, across, 0.3 + (0.5 * i) / moves);
    await page.mouse.move(place.x, place.y);
    await page.waitForTimeout(pause);
  }
  return page.evaluate(() => (globalThis as unknown as { shown: number[] }).shown);
}
