// Upright, and always a way back: the way up, the bar on the canvas, the keys, the turning.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { builtPage, drop, fragment, modelIs, openPanel } from './page-support.js';
import { repository } from './support.js';
import { fieldComplete, framesPass, placeOnSurface } from './viewer-page.js';

const openBuilt = builtPage();

/** A slab on a thin leg with a broad foot, along z: vertices 0 to 3 are below the foot, 16 to 19 on the slab. */
const stool = (() => {
  const rings = [
    [3, 0],
    [0.5, 1],
    [0.5, 9],
    [3.5, 9],
    [3.5, 10],
  ] as const;
  const lines = rings.flatMap(([half, z]) =>
    [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ].map(([x, y]) => `${x! * half} ${y! * half} ${z}`),
  );
  const faces = ['3 2 1 0', '16 17 18 19'];
  for (let ring = 0; ring < 4; ++ring) {
    for (let k = 0; k < 4; ++k) {
      const [a, b] = [4 * ring + k, 4 * ring + ((k + 1) % 4)];
      faces.push(`${a} ${b} ${b + 4} ${a + 4}`);
    }
  }
  return ['OFF', `20 ${faces.length} 0`, ...lines, ...faces.map((face) => `4 ${face}`)].join('\n');
})();

async function dropStool(page: Page): Promise<void> {
  await drop(page, { name: 'stool.off', bytes: Buffer.from(stool) });
  await modelIs(page, 'stool.off');
}
/** How far its foot is below its top on the screen, in CSS pixels. */
const footBelowTop = (viewer: Locator): Promise<number> =>
  viewer.evaluate(
    (element: GirthViewer) => element.screenPosition(0).y - element.screenPosition(18).y,
  );
const upOf = (viewer: Locator) =>
  viewer.evaluate((element: GirthViewer) => [element.upAxis!.name, element.upAxis!.by]);

test('a model stands on its feet by a guess that is shown and can be changed', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  expect(await upOf(viewer)).toEqual(['y', 'format']);
  await dropStool(page);
  expect(await upOf(viewer)).toEqual(['z', 'guess']);
  expect(await footBelowTop(viewer)).toBeGreaterThan(100);
  const axes = viewer.getByRole('button', { name: /^Axes/ });
  expect(await axes.textContent()).toContain('z up?');
  await axes.click();
  const up = viewer.getByLabel('Which way is up');
  expect(await up.locator('option').first().textContent()).toBe('z is up, a guess');
  await up.selectOption('−z is up');
  expect(await upOf(viewer)).toEqual(['-z', 'choice']);
  expect(await footBelowTop(viewer)).toBeLessThan(-100);
  await expect.poll(() => fragment(page)).toContain('up=-z');
  // Another model stands as fits it.
  await page.locator('#examples button', { hasText: 'Cup' }).click();
  await modelIs(page, 'cup.glb');
  expect(await upOf(viewer)).toEqual(['y', 'format']);
});

test('a link keeps the way up and how the surface is drawn', async () => {
  const { page, viewer } = await openBuilt('model=dumbbell&up=z&shading=flat');
  await modelIs(page, 'dumbbell.glb');
  await expect.poll(() => upOf(viewer)).toEqual(['z', 'choice']);
  expect(await viewer.getAttribute('shading')).toBe('flat');
});

test('what is seen fills the picture, upright or wide, also of another size', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await dropStool(page);
  const filled = () =>
    viewer.evaluate((element: GirthViewer) => {
      const places = [...Array(element.info!.vertexCount).keys()].map((v) =>
        element.screenPosition(v),
      );
      const across = places.map(({ x }) => x / element.clientWidth);
      const down = places.map(({ y }) => y / element.clientHeight);
      const spans = [across, down].map((along) => [Math.min(...along), Math.max(...along)]);
      return {
        least: Math.min(...spans.map(([low]) => low!)),
        most: Math.max(...spans.map(([, high]) => high!)),
        largest: Math.max(...spans.map(([low, high]) => high! - low!)),
      };
    });
  for (const size of [
    { width: 1024, height: 768 },
    { width: 1440, height: 600 },
  ]) {
    await page.setViewportSize(size);
    // All at once: until the camera has heard of the new size, each alone may hold for the old one.
    await expect
      .poll(async () => {
        const { least, most, largest } = await filled();
        return least > 0 && most < 1 && largest > 0.75;
      })
      .toBe(true);
  }
});

test('a plane cuts the surface: what is cut away is neither drawn nor picked', async () => {
  const { page, viewer } = await openBuilt('model=cup');
  await modelIs(page, 'cup.glb');
  await dropStool(page);
  await viewer.getByRole('button', { name: 'Section plane' }).click();
  const across = viewer.getByRole('button', { name: 'Section across z' });
  await across.click();
  expect(await viewer.getAttribute('section')).toBe('z 50%');
  expect(await across.getAttribute('aria-pressed')).toBe('true');
  const place = viewer.getByLabel('Place of the section');
  expect(await place.getAttribute('aria-valuetext')).toMatch(/^z = 5\.0/);
  await expect.poll(() => fragment(page)).toContain('section=z 50%');

  /** The middle between two vertices: whether it is in the picture, and whether a pointer finds a loop there. */
  const seen = async (a: number, b: number): Promise<[drawn: boolean, picked: boolean]> => {
    const at = await viewer.evaluate(
      async (element: GirthViewer, vertices) => {
        const [one, other] = vertices.map((vertex) => element.screenPosition(vertex));
        const [x, y] = [(one!.x + other!.x) / 2, (one!.y + other!.y) / 2];
        const picture = await createImageBitmap(await element.snapshot());
        const canvas = new OffscreenCanvas(picture.width, picture.height);
        const context = canvas.getContext('2d')!;
        context.drawImage(picture, 0, 0);
        const ratio = picture.width / element.clientWidth;
        const { left, top } = element.getBoundingClientRect();
        const alpha = context.getImageData(ratio * x, ratio * y, 1, 1).data[3]!;
        return { alpha, x: left + x, y: top + y };
      },
      [a, b],
    );
    await page.mouse.move(1, 1);
    // Listens before the pointer comes.
    const heard = await viewer.evaluateHandle((element: GirthViewer) => ({
      found: new Promise<boolean>((resolve) => {
        element.addEventListener('hover', ({ detail }) => {
          if (detail.vertex !== undefined) resolve(true);
        });
        setTimeout(() => resolve(false), 2000);
      }),
    }));
    await page.mouse.move(at.x, at.y, { steps: 3 });
    return [at.alpha > 200, await heard.evaluate(({ found }) => found)];
  };
  const [slab, foot] = [
    [16, 18],
    [1, 5],
  ] as const;
  // Nothing is picked before that has been prepared.
  await expect.poll(() => seen(...foot)).toEqual([true, true]);
  expect(await seen(...slab)).toEqual([false, false]);
  expect(await viewer.evaluate((element: GirthViewer) => element.screenPosition(18).visible)).toBe(
    false,
  );
  await viewer.getByRole('button', { name: 'Other side' }).click();
  expect(await viewer.getAttribute('section')).toBe('-z 50%');
  await expect.poll(() => seen(...slab)).toEqual([true, true]);
  expect(await seen(...foot)).toEqual([false, false]);
  // By keyboard; and undone in one step.
  await place.focus();
  await page.keyboard.press('Home');
  expect(await viewer.getAttribute('section')).toBe('-z 0%');
  await expect.poll(() => fragment(page)).toContain('section=-z 0%');
  await page.keyboard.press('Control+z');
  await expect.poll(() => viewer.getAttribute('section')).toBe('-z 50%');
  await viewer.getByRole('button', { name: 'Section across the view' }).click();
  expect(await viewer.getAttribute('section')).toMatch(/^-?[\d.]+,-?[\d.]+,-?[\d.]+ 50%$/);
  // Another model is whole.
  await page.locator('#examples button', { hasText: 'Cup' }).click();
  await modelIs(page, 'cup.glb');
  expect(await viewer.getAttribute('section')).toBe(null);
});

test('front, side, top and home; smooth, flat, transparent and edges', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await dropStool(page);
  const camera = () => viewer.evaluate((element: GirthViewer) => element.camera!);
  const home = await camera();
  await viewer.getByRole('button', { name: /^Axes/ }).click();
  for (const [name, polar, azimuth] of [
    ['Front', Math.PI / 2, 0],
    ['Side', Math.PI / 2, Math.PI / 2],
    ['Top', 0, 0],
  ] as const) {
    await viewer.getByRole('button', { name }).click();
    const view = await camera();
    expect(view.polar).toBeCloseTo(polar, 1);
    expect(view.azimuth).toBeCloseTo(azimuth, 4);
  }
  await viewer.getByRole('button', { name: 'First view (0)' }).click();
  expect(await camera()).toEqual(home);
  expect(await viewer.evaluate((element: GirthViewer) => element.isAtHome)).toBe(true);
  const picture = async () => (await viewer.locator('canvas').screenshot()).toString('base64');
  const seen = new Set<string>();
  await viewer.getByLabel('How the surface is drawn').click();
  for (const name of ['Smooth', 'Flat', 'Transparent']) {
    await viewer.getByRole('radio', { name }).check();
    await framesPass(page);
    seen.add(await picture());
  }
  await viewer.getByRole('checkbox', { name: 'Edges' }).check();
  await framesPass(page);
  seen.add(await picture());
  expect(seen.size).toBe(4);
  // Escape closes the menu and gives the focus back.
  await page.keyboard.press('Escape');
  expect(await viewer.getByRole('radio', { name: 'Flat' }).isVisible()).toBe(false);
});

test('keys move the surface wherever the focus is, but not while somebody types', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const camera = () => viewer.evaluate((element: GirthViewer) => JSON.stringify(element.camera));
  await page.locator('#tips-panel summary').focus();
  const before = await camera();
  await page.keyboard.press('ArrowLeft');
  const turned = await camera();
  expect(turned).not.toBe(before);
  await page.keyboard.press('0');
  expect(await camera()).toBe(before);
  await page.keyboard.press('2');
  expect(await camera()).not.toBe(before);
  await page.keyboard.press('0');
  const print = await openPanel(page, 'print');
  // Not the height, which is committed when it is left: the model of another size is looked at anew.
  const field = print.locator('#min-tube');
  await field.fill('10');
  await field.press('ArrowLeft');
  await field.press('2');
  expect(await field.inputValue()).toBe('120');
  await page.locator('#field-name').focus();
  await page.keyboard.press('1');
  await framesPass(page);
  expect(await camera()).toBe(before);
});

test('a double click turns about a point and pins nothing; a click alone pins', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await drop(page, {
    name: 'prism.obj',
    bytes: readFileSync(join(repository, 'tests/data/prism.obj')),
  });
  await modelIs(page, 'prism.obj');
  await fieldComplete(viewer);
  const target = () => viewer.evaluate((element: GirthViewer) => element.camera!.target);
  const before = await target();
  const place = await placeOnSurface(viewer, 0.5, 0.3);
  await page.mouse.dblclick(place.x, place.y);
  const box = (await viewer.boundingBox())!;
  expect(await target()).not.toEqual(before);
  const pinned = () => viewer.evaluate((element: GirthViewer) => element.pinned.length);
  expect(await pinned()).toBe(0);
  // The corner that was clicked is in the middle between left and right, where a click of its own pins.
  const corner = await placeOnSurface(viewer, 0.5, 0.5);
  expect(Math.abs(corner.x - (box.x + box.width / 2))).toBeLessThan(10);
  await page.mouse.click(corner.x, corner.y);
  await expect.poll(pinned).toBe(1);
});

test('the turning stops at the first action anywhere, and has a pause', async () => {
  const { page, viewer } = await openBuilt('model=dumbbell', { reducedMotion: 'no-preference' });
  await modelIs(page, 'dumbbell.glb');
  await fieldComplete(viewer);
  const azimuth = () => viewer.evaluate((element: GirthViewer) => element.camera!.azimuth);
  const turns = async () => {
    const before = await azimuth();
    await framesPass(page);
    await framesPass(page);
    return (await azimuth()) !== before;
  };
  await expect.poll(turns).toBe(true);
  await page.locator('#parts-panel summary').click();
  await expect.poll(turns).toBe(false);
  await viewer.getByRole('button', { name: 'Turn slowly' }).click();
  await expect.poll(turns).toBe(true);
  await viewer.getByRole('button', { name: 'Pause the turning' }).click();
  await expect.poll(turns).toBe(false);
  expect(await viewer.getByRole('button', { name: 'Turn slowly' }).isVisible()).toBe(true);
});
