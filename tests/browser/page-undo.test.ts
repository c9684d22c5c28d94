// Changes by hand can be undone and redone: fields, colours, loops, the camera, and the model itself; and saved as
// a project, which opens as it was.

import { execFileSync } from 'node:child_process';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { strToU8, unzipSync, zipSync } from 'fflate';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { box } from './meshes.js';
import { builtPage, drop, fragment, modelIs } from './page-support.js';
import { command } from './support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();

test('each change is a step back, and forth again, the model too', async () => {
  const { page, viewer } = await openBuilt('model=cup');
  await modelIs(page, 'cup.glb');
  await fieldComplete(viewer);
  const undo = page.getByRole('button', { name: 'Undo' });
  const redo = page.getByRole('button', { name: 'Redo' });
  const isDisabled = () =>
    Promise.all([undo, redo].map((button) => button.getAttribute('aria-disabled')));
  expect(await isDisabled()).toEqual(['true', 'true']);

  await page.locator('#colormap').selectOption('magma');
  await expect.poll(() => fragment(page)).toContain('colormap=magma');
  await page.locator('#isolines').selectOption('10');
  // At once, before the address has it.
  await undo.click();
  await expect.poll(() => viewer.getAttribute('isolines')).toBe(null);
  expect(await viewer.getAttribute('colormap')).toBe('magma');
  await page.keyboard.press('Control+z');
  await expect.poll(() => viewer.getAttribute('colormap')).toBe(null);
  expect(await isDisabled()).toEqual(['true', 'false']);
  expect(await page.locator('#said').textContent()).toContain('Undone: colour map.');
  expect(await redo.getAttribute('title')).toBe('Redo: colour map (Ctrl+Shift+Z)');
  expect(await page.locator('#said').isVisible()).toBe(true);
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(() => viewer.getAttribute('colormap')).toBe('magma');
  await page.keyboard.press('Control+y');
  await expect.poll(() => viewer.getAttribute('isolines')).toBe('10');
  expect(await isDisabled()).toEqual(['false', 'true']);

  // Two clicks are two steps, however soon the second comes.
  const log = page.getByRole('checkbox', { name: 'log' });
  await log.evaluate((box: HTMLInputElement) => {
    box.click();
    box.click();
  });
  await undo.click();
  expect(await log.isChecked()).toBe(true);
  await undo.click();
  expect(await log.isChecked()).toBe(false);
  await expect.poll(() => fragment(page)).toContain('isolines=10');

  // A file that was dropped comes back, though no link can have it.
  await drop(page, { name: 'cube.obj', bytes: Buffer.from(box(2, 2, 2)) });
  await modelIs(page, 'cube.obj');
  await expect.poll(() => fragment(page)).toContain('file=cube.obj');
  await undo.click();
  await modelIs(page, 'cup.glb');
  await expect.poll(() => fragment(page)).toContain('isolines=10');
  await redo.click();
  await modelIs(page, 'cube.obj');
  expect(await page.locator('#missing').isVisible()).toBe(false);
  await page.goBack();
  await modelIs(page, 'cup.glb');
});

test('a project opens as it was, and nothing of it is computed again', async () => {
  const { page, viewer } = await openBuilt('model=cup');
  await modelIs(page, 'cup.glb');
  await fieldComplete(viewer);
  await page.locator('#second-field').selectOption('less Shape diameter (SDF)');
  await page.locator('#colormap').selectOption('turbo');
  await viewer.evaluate(async (element: GirthViewer) => {
    element.nameLoop((await element.pin(7)).id, 'rim, left');
    element.setAttribute('section', 'y 60%');
    element.dispatchEvent(new CustomEvent('view'));
  });
  await expect.poll(() => fragment(page)).toMatch(/field=igf-sdf.*section=y 60%.*names=rim/);
  const isMissing = (element: GirthViewer) => element.values('igf-sdf').some(Number.isNaN);
  await expect.poll(() => viewer.evaluate(isMissing)).toBe(false);
  const shown = () =>
    viewer.evaluate((element: GirthViewer) => ({
      state: { ...element.state },
      girth: [...element.values('igf')],
      difference: [...element.values('igf-sdf')],
      loops: element.pinned.map(({ name, loop }) => [name, loop.length, ...loop.polyline]),
    }));
  const before = await shown();
  await page.locator('[popovertarget=export]').click();
  const coming = page.waitForEvent('download');
  await page.locator('#export-project button').click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe('cup.girth.zip');
  const bytes = readFileSync(await download.path());

  // The command reads the model from it.
  const file = join(tmpdir(), `girth-${process.pid}.girth.zip`);
  writeFileSync(file, bytes);
  try {
    const told = JSON.parse(
      execFileSync(command, ['info', file, '--json'], { encoding: 'utf8' }),
    ) as { vertices: number };
    expect(told.vertices).toBe(before.girth.length);
  } finally {
    rmSync(file);
  }

  await drop(page, { name: 'cube.obj', bytes: Buffer.from(box(2, 2, 2)) });
  await modelIs(page, 'cube.obj');
  await fieldComplete(viewer);
  await viewer.evaluate((element: GirthViewer) => {
    const computed: string[] = [];
    element.addEventListener('progress', ({ detail }) => computed.push(detail.name));
    Object.assign(window, { computed });
  });
  await drop(page, { name: 'cup.girth.zip', bytes });
  await modelIs(page, 'cup.glb');
  await viewer.locator('.legend-title', { hasText: 'Girth \u2212 shape diameter' }).waitFor();
  await expect.poll(async () => (await shown()).loops.length).toBe(1);
  expect(await shown()).toEqual({ ...before, state: { ...before.state, turn: undefined } });
  expect(await page.evaluate(() => (window as unknown as { computed: string[] }).computed)).toEqual(
    [],
  );
  await expect.poll(() => fragment(page)).toMatch(/^file=cup.glb.*field=igf-sdf.*section=y 60%/);
  expect(await page.locator('#loops input').inputValue()).toBe('rim, left');
  await page.getByRole('button', { name: 'Undo' }).click();
  await modelIs(page, 'cube.obj');
  await page.getByRole('button', { name: 'Redo' }).click();
  await modelIs(page, 'cup.glb');

  // A project of a newer version is said to be one, and its model is opened all the same.
  const entries = unzipSync(bytes);
  const newer = zipSync({
    ...entries,
    'girth-project.json': strToU8('{"format":"girth-project","version":2}'),
  });
  await drop(page, { name: 'newer.girth.zip', bytes: Buffer.from(newer) });
  const fault = page.locator('#project-fault');
  await fault.waitFor();
  expect(await fault.textContent()).toMatch(/newer version; what helps: reload the page\.$/);
  await expect.poll(() => fragment(page)).toMatch(/^file=newer.girth.zip/);
  await fieldComplete(viewer);
});
