// How the girth of large models is computed on the page: on few triangles first, and refined on demand. Here small models
// are treated as large ones are, because their links ask for it.

import type { Locator } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import type { RefinedGirth, SurfacePoint } from '../../web/src/kernel/index.js';
import { complaintsOfAxe } from './axe.js';
import { torus } from './meshes.js';
import { builtPage, cutWords, drop, fragment, modelIs, picture } from './page-support.js';
import { fieldComplete, placeOnSurface } from './viewer-page.js';

const openBuilt = builtPage();

/** Enough faces to be computed in bands round loops. */
const ring = { name: 'ring.obj', bytes: Buffer.from(torus(64, 24)) };

const girthOf = (viewer: Locator) =>
  viewer.evaluate(async (element: GirthViewer) => {
    const igf = (await element.fieldOf('igf')) as RefinedGirth;
    return { method: igf.method, values: [...igf.values], states: [...(igf.states ?? [])] };
  });

/** The word for the method that the list shows. */
const chosen = (list: Locator) => list.evaluate((select: HTMLSelectElement) => select.value);

test('few triangles first, then refined: an audit in words, states as colours and in files', async () => {
  const { page, viewer } = await openBuilt('file=ring.obj&method=coarse');
  await drop(page, ring);
  await modelIs(page, 'ring.obj');
  await fieldComplete(viewer);
  const list = page.getByLabel('Girth', { exact: true });
  const said = page.locator('.method [role=status]');
  expect(await chosen(list)).toBe('coarse');
  await said
    .getByText(
      'Computed on 768 triangles. Refined, at each of 1,536 vertices, it takes about 100 MB of memory.',
    )
    .waitFor();
  expect(await viewer.locator('.legend').textContent()).toContain('computed on 768 triangles');
  const coarse = await girthOf(viewer);
  expect(coarse.method).toBe('exact on 768 faces');
  expect(await page.locator('#field-name option[value=state]').isHidden()).toBe(true);
  const size = page.viewportSize()!;
  for (const one of [{ width: 390, height: 844 }, size]) {
    await page.setViewportSize(one);
    expect(await cutWords(page)).toEqual([]);
  }

  await list.selectOption('refined');
  await said
    .getByText('200 of 200 vertices that were drawn at random and computed exactly are equal')
    .waitFor({ timeout: 120_000 });
  await expect.poll(() => fragment(page)).toContain('method=refined');
  const refined = await girthOf(viewer);
  expect(refined.method).toBe('refined');
  const off = refined.values.map((value, v) => Math.abs(coarse.values[v]! / value - 1));
  expect(Math.max(...off)).toBeLessThan(0.05);
  expect(off.filter((share) => share > 1e-6).length).toBeGreaterThan(0.9 * off.length);
  expect(await viewer.evaluate((element: GirthViewer) => element.state.method)).toBe('refined');

  await page.locator('#field-name').selectOption('state');
  await page.locator('.shares').getByText('consistent').waitFor();
  const legend = viewer.locator('.legend');
  await expect.poll(() => legend.textContent()).toMatch(/How sure.*proved.*consistent/s);
  expect(await legend.textContent()).not.toContain('suspect');
  const csv = await viewer.evaluate(async (element: GirthViewer) =>
    new TextDecoder().decode(await element.exportField('csv')),
  );
  const [header, first] = csv.split('\n');
  expect(header).toBe('vertex,igf,kind,state');
  expect(first).toMatch(/,loop,(proved|consistent)$/);
  expect(await complaintsOfAxe(page)).toEqual([]);
  await picture(page, 'page-refined.png');

  // There and back, without computing again.
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(() => chosen(list)).toBe('coarse');
  expect(await girthOf(viewer)).toEqual(coarse);
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect.poll(() => chosen(list)).toBe('refined');
  expect(await girthOf(viewer)).toEqual(refined);
});

test('the length under the pointer is there before its loop', async () => {
  const { page, viewer } = await openBuilt('file=ring.obj&method=refined');
  await drop(page, ring);
  await modelIs(page, 'ring.obj');
  await fieldComplete(viewer);
  // Loops are asked for in vain until they are let go.
  await page.evaluate(() => {
    const held: (() => void)[] = [];
    // oxlint-disable-next-line typescript/unbound-method
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (
      this: Worker,
      message: { operation?: string },
      transfer: Transferable[],
    ) {
      const send = (): void => post.call(this, message, { transfer });
      if (message.operation === 'loop') held.push(send);
      else send();
    } as typeof post;
    Object.assign(globalThis, { letGo: () => held.splice(0).forEach((send) => send()) });
  });
  const place = await placeOnSurface(viewer, 0.3, 0.4);
  await page.mouse.move(place.x, place.y);
  const readout = viewer.locator('.readout');
  await readout.getByText('Read off the colours; the loop follows.').waitFor();
  const before = Number(await readout.getAttribute('data-length'));
  const base = JSON.parse((await readout.getAttribute('data-base'))!) as SurfacePoint;
  await page.evaluate(() => (globalThis as unknown as { letGo(): void }).letGo());
  await expect.poll(() => readout.getAttribute('data-kind')).toBe('loop');
  expect(JSON.parse((await readout.getAttribute('data-base'))!)).toEqual(base);
  const exact = Number(await readout.getAttribute('data-length'));
  expect(exact).not.toBe(before);
  expect(Math.abs(before / exact - 1)).toBeLessThan(0.02);
  await page.mouse.move(2, 2);
  await readout.waitFor({ state: 'hidden' });
});

test('refining is cancelled at once: the colours stay, and what there was is there', async () => {
  const { page, viewer } = await openBuilt('file=ring.obj&method=coarse');
  const bytes = Buffer.from(torus(160, 80));
  await drop(page, { name: 'ring.obj', bytes });
  await modelIs(page, 'ring.obj');
  await fieldComplete(viewer);
  const before = await girthOf(viewer);
  await page.getByLabel('Girth', { exact: true }).selectOption('refined');
  const said = page.locator('.method [role=status]');
  await said.getByText('The colours are those of fewer triangles until it is done.').waitFor();
  const progress = viewer.getByRole('progressbar', { name: 'Computing: Girth' });
  await expect.poll(() => progress.getAttribute('aria-valuenow')).not.toBe('0');
  const shown = await viewer.evaluate((element: GirthViewer) => element.shown?.extent);
  expect(shown).toEqual([Math.min(...before.values), Math.max(...before.values)]);
  await viewer.getByRole('button', { name: 'Cancel computing' }).click();
  await expect.poll(() => chosen(page.getByLabel('Girth', { exact: true }))).toBe('coarse');
  expect(await progress.isVisible()).toBe(false);
  expect(await girthOf(viewer)).toEqual(before);
});

test('wrinkles are ignored on few triangles at once', async () => {
  const { page, viewer } = await openBuilt('file=ring.obj&method=refined&persistence=3%25');
  await drop(page, ring);
  await modelIs(page, 'ring.obj');
  await fieldComplete(viewer);
  expect((await girthOf(viewer)).method).toBe(
    'exact on 768 faces, persistence 0.22282246449966475',
  );
  await page
    .locator('.method [role=status]')
    .getByText(/^Computed on 768 triangles(; \d+ of \d+ exact values (is|are) within 5%)?\.$/)
    .waitFor();
});
