// What the tests of the page and of the element share: finding places on a surface, and asking the
// command for the truth.

import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { repository } from './support.js';

/** `GIRTH_COMMAND` names another one than that of the build tree. */
const command = process.env['GIRTH_COMMAND'] ?? join(repository, 'build/native/cpp/cli/girth');

/** The length and kind that the command finds at a vertex of the file. */
export function loopByCommand(file: string, vertex: number): { length: number; kind: string } {
  const text = execFileSync(command, ['loop', file, String(vertex), '--json'], {
    encoding: 'utf8',
  });
  return JSON.parse(text) as { length: number; kind: string };
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

/**
 * A visible vertex nearest to a place given in shares of the element's size, and a point of the page
 * beside it, on the surface.
 * Waits until vertices can be picked.
 */
export async function visibleVertex(viewer: Locator, right: number, down: number) {
  // A surface that turns by itself would be elsewhere by the time the pointer gets there.
  await viewer.evaluate((element: GirthViewer) => element.removeAttribute('turn'));
  for (let attempt = 0; attempt < 200; ++attempt) {
    const found = await viewer.evaluate(
      (element: GirthViewer, [right, down]) => {
        const box = element.getBoundingClientRect();
        const target = [right! * box.width, down! * box.height] as const;
        let nearest = { vertex: -1, x: 0, y: 0, distance: Infinity };
        const middle = { x: 0, y: 0, count: 0 };
        for (let vertex = 0; vertex < element.info!.vertexCount; ++vertex) {
          const { x, y, visible } = element.screenPosition(vertex);
          const distance = Math.hypot(x - target[0], y - target[1]);
          if (!visible) continue;
          if (distance < nearest.distance) nearest = { vertex, x, y, distance };
          middle.x += x;
          middle.y += y;
          ++middle.count;
        }
        // A vertex on the outline is beside the surface as often as on it: go a little inwards.
        const [dx, dy] = [middle.x / middle.count - nearest.x, middle.y / middle.count - nearest.y];
        const step = Math.min(1, 2 / Math.hypot(dx, dy));
        return {
          vertex: nearest.vertex,
          x: box.left + nearest.x + step * dx,
          y: box.top + nearest.y + step * dy,
        };
      },
      [right, down],
    );
    if (found.vertex >= 0) return found;
    await viewer.page().waitForTimeout(50);
  }
  throw new Error('no vertex can be seen');
}

export interface Shown {
  /** Of the surface. */
  vertex: number;
  /** The first vertex of the file that it comes from. */
  inputVertex: number;
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
  const shown = await readout.evaluate((element) => ({
    vertex: Number((element as HTMLElement).dataset['vertex']),
    length: Number((element as HTMLElement).dataset['length']),
    kind: (element as HTMLElement).dataset['kind']!,
    text: element.textContent,
  }));
  const inputVertex = await viewer.evaluate(
    (element: GirthViewer, vertex) => element.vertexOfInput.indexOf(vertex),
    shown.vertex,
  );
  return { ...shown, inputVertex };
}
