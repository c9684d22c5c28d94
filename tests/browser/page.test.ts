// The page as a user meets it, with cross-origin isolation (threads) and without (a pool of
// workers), both under a strict content security policy.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { beforeEach, describe, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { torus } from './meshes.js';
import { builtPage, drop, modelIs as modelIsOn } from './page-support.js';
import { smallExamples } from './small-examples.js';
import { repository } from './support.js';
import { fieldBegun, fieldComplete, hover, loopByCommand, placeOnSurface } from './viewer-page.js';

const data = join(repository, 'tests/data');

/** How often the next few frames draw something in WebGL. */
const drawsInFrames = (page: Page): Promise<number> =>
  page.evaluate(async () => {
    const { prototype } = WebGL2RenderingContext;
    const original = Object.getOwnPropertyDescriptor(prototype, 'drawElements')!;
    const draw = original.value as (...args: unknown[]) => void;
    let draws = 0;
    prototype.drawElements = function (...args) {
      ++draws;
      draw.apply(this, args);
    };
    for (let i = 0; i < 4; ++i) await new Promise((done) => requestAnimationFrame(done));
    Object.defineProperty(prototype, 'drawElements', original);
    return draws;
  });

for (const isolated of [true, false]) {
  describe(isolated ? 'page, isolated' : 'page, not isolated', () => {
    const openBuilt = builtPage({ isolated });
    let page: Page;
    let viewer: Locator;
    let address: string;

    beforeEach(async () => {
      ({ page, viewer, address } = await openBuilt());
    });

    const modelIs = (name: string) => modelIsOn(page, name);

    test('a dropped OBJ: the length under the pointer is the command’s', async () => {
      await modelIs('chair.glb');
      const file = join(data, 'prism.obj');
      await drop(page, { name: 'prism.obj', bytes: readFileSync(file) });
      await modelIs('prism.obj');
      await fieldComplete(viewer);
      expect(await page.locator('#invitation').isVisible()).toBe(false);
      const place = await placeOnSurface(viewer, 0.5, 0.5);
      const shown = await hover(page, viewer, place.x, place.y);
      const truth = loopByCommand(file, shown.base);
      expect(shown.length).toBe(truth.length);
      expect(shown.kind).toBe(truth.kind);
      expect(Number.parseFloat(shown.text)).toBeCloseTo(truth.length, 3);
      // The loop passes where the pointer is, not at the nearest vertex.
      const box = (await viewer.boundingBox())!;
      const { x, y } = await viewer.evaluate(
        (element: GirthViewer, base) => element.screenPosition(base),
        shown.base,
      );
      expect(Math.hypot(box.x + x - place.x, box.y + y - place.y)).toBeLessThan(0.1);
    });

    test('a chosen GLB with seams: welded, and the command’s lengths all over', async () => {
      await modelIs('chair.glb');
      const file = join(data, 'prism_seams.glb');
      await page.locator('#file').setInputFiles(file);
      await modelIs('prism_seams.glb');
      expect(await page.locator('#details').textContent()).toContain('vertices welded');
      await fieldComplete(viewer);
      for (const [right, down] of [
        [0.5, 0.4],
        [0.5, 0.7],
      ] as const) {
        const place = await placeOnSurface(viewer, right, down);
        const shown = await hover(page, viewer, place.x, place.y);
        expect(shown.length).toBe(loopByCommand(file, shown.base).length);
      }
    });

    test('hover, pin, list, remove; the keyboard does the same', async () => {
      await modelIs('chair.glb');
      await fieldComplete(viewer);
      const file = join(smallExamples, 'chair.glb');
      const place = await placeOnSurface(viewer, 0.5, 0.45);
      const shown = await hover(page, viewer, place.x, place.y);
      expect(shown.length).toBe(loopByCommand(file, shown.base).length);
      await page.mouse.click(place.x, place.y);
      await page.locator('#loops tbody tr').waitFor();
      await page.mouse.move(1, 1);
      const pinned = await viewer.evaluate((element: GirthViewer) => element.pinned[0]!.loop);
      expect(pinned.base).toEqual(shown.base);
      expect(pinned.length).toBe(shown.length);
      const written = shown.text.match(/^[\d.]+/)![0];
      expect(await page.locator('#loops tbody .number').textContent()).toContain(written);
      expect(await viewer.locator('.tag').count()).toBe(1);

      await viewer.locator('canvas').focus();
      await page.keyboard.press('Shift+ArrowRight');
      await viewer.locator('.readout').waitFor({ state: 'visible' });
      await page.keyboard.press('Shift+ArrowUp');
      await page.keyboard.press('Enter');
      await page.locator('#loops tbody tr').nth(1).waitFor();
      await page.keyboard.press('Delete');
      await expect.poll(() => page.locator('#loops tbody tr').count()).toBe(1);
      await page.locator('#loops tbody button').click();
      expect(await page.locator('#no-loops').isVisible()).toBe(true);
      expect(await viewer.locator('.tag').count()).toBe(0);
    });

    test('cancelled in mid-run it keeps what there is and says how much', async () => {
      await modelIs('chair.glb');
      // Minutes of work: it is in mid-run whenever the click comes.
      await drop(page, { name: 'endless.obj', bytes: Buffer.from(torus(160, 110)) });
      await modelIs('endless.obj');
      const progress = viewer.locator('[role=progressbar]');
      const words = viewer.getByText(/^Girth, partial: \d+% of vertices$/);
      const cancel = async () => {
        await fieldBegun(viewer);
        await viewer.getByRole('button', { name: 'Cancel computing' }).click();
        await words.waitFor();
        expect(await progress.isVisible()).toBe(false);
        const values = await viewer.evaluate((element: GirthViewer) =>
          Array.from(element.values('igf')),
        );
        const computed = values.filter((value) => !Number.isNaN(value));
        expect(computed.length).toBeGreaterThan(0);
        expect(computed.length).toBeLessThan(values.length);
        expect(computed.every((value) => value > 0)).toBe(true);
        const percent = Number(/\d+/.exec((await words.textContent())!)![0]);
        expect(Math.abs(percent - (100 * computed.length) / values.length)).toBeLessThan(1.01);
        // Once the colours are spread, nothing is drawn until something changes.
        await expect.poll(() => drawsInFrames(page)).toBe(0);
        return values;
      };
      const first = await cancel();

      await viewer.getByRole('button', { name: 'Compute all' }).click();
      await progress.waitFor();
      expect(await words.isVisible()).toBe(false);
      const second = await cancel();
      // Both have the same bits, as far as they have come.
      first.forEach((value, vertex) => {
        if (!Number.isNaN(value)) expect(second[vertex]).toBe(value);
      });

      // The workers are free again: another model is computed from end to end.
      await drop(page, { name: 'prism.obj', bytes: readFileSync(join(data, 'prism.obj')) });
      await modelIs('prism.obj');
      await fieldComplete(viewer);
      expect(await words.isVisible()).toBe(false);
    });

    test('broken files: words, and the former model still there', async () => {
      await modelIs('chair.glb');
      const message = viewer.getByRole('alert');
      for (const name of ['truncated.glb', 'text.glb', 'nan.obj', 'index.obj', 'empty.obj']) {
        await drop(page, { name, bytes: readFileSync(join(data, 'bad', name)) });
        const words = viewer.getByText(`${name} could not be used.`);
        await words.waitFor({ timeout: 20_000 });
        expect(await message.textContent()).toContain('What helps:');
        expect(await message.textContent()).toContain('The former model is still here.');
      }
      await modelIs('chair.glb');
      await message.getByRole('button').click();
      expect(await message.isVisible()).toBe(false);
      // The former model's computation was not touched either.
      await fieldComplete(viewer);
      const place = await placeOnSurface(viewer, 0.5, 0.45);
      expect((await hover(page, viewer, place.x, place.y)).length).toBeGreaterThan(0);
    });

    test('the colour map, its range and the edges can be changed', async () => {
      await modelIs('chair.glb');
      await fieldComplete(viewer);
      await page.locator('#colormap').selectOption('magma');
      expect(await viewer.getAttribute('colormap')).toBe('magma');
      const top = viewer.locator('.legend-tick').first();
      const before = await top.textContent();
      await page.getByLabel('Upper end of the colours').focus();
      for (let i = 0; i < 3; ++i) await page.keyboard.press('PageDown');
      expect(await top.textContent()).toMatch(/^≥/);
      expect(await page.locator('#range').inputValue()).toBe('own');
      await page.locator('#range').selectOption('auto');
      expect(await top.textContent()).toBe(before);
      await page.locator('#range').selectOption('5 to 95 %');
      await expect.poll(() => top.textContent()).toMatch(/^≥/);
      await page.getByLabel('How the surface is drawn').click();
      await page.getByLabel('Edges').check();
      expect(await viewer.getAttribute('edges')).toBe('');
    });

    // Whatever computes is WebAssembly, so none of it may be started by the page itself. (How long the
    // page's own tasks are depends on what else the machine does: `npm run bench:page` measures it.)
    test('nothing computes on the page’s own thread', async () => {
      const watched = await page.context().newPage();
      await watched.addInitScript(() => {
        const started: string[] = [];
        Object.assign(globalThis, { started });
        for (const name of ['instantiate', 'instantiateStreaming'] as const) {
          const original = WebAssembly[name] as (...args: unknown[]) => unknown;
          Object.assign(WebAssembly, {
            [name]: (...args: unknown[]) => {
              started.push(name);
              return original(...args);
            },
          });
        }
        WebAssembly.Instance = new Proxy(WebAssembly.Instance, {
          construct: (target, args) => {
            started.push('Instance');
            return new target(...(args as ConstructorParameters<typeof WebAssembly.Instance>));
          },
        });
      });
      await watched.goto(address);
      await watched.locator('#model b', { hasText: 'chair.glb' }).waitFor({ timeout: 30_000 });
      await watched.getByRole('button', { name: 'Octopus' }).click();
      await watched.locator('#model b', { hasText: 'octopus.glb' }).waitFor({ timeout: 30_000 });
      await watched.locator('html[data-field=complete]').waitFor({ timeout: 90_000 });
      expect(await watched.evaluate(() => (globalThis as { started?: string[] }).started)).toEqual(
        [],
      );
    });
  });
}
