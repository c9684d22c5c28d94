// What was changed by hand can be undone and redone: fields, colours, loops, the camera, and the model itself.

import { expect, test } from 'vitest';
import { box } from './meshes.js';
import { builtPage, drop, fragment, modelIs } from './page-support.js';
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
  expect(await page.locator('#said').textContent()).toContain('Undone.');
  await page.keyboard.press('Control+Shift+z');
  await expect.poll(() => viewer.getAttribute('colormap')).toBe('magma');
  await page.keyboard.press('Control+y');
  await expect.poll(() => viewer.getAttribute('isolines')).toBe('10');
  expect(await isDisabled()).toEqual(['false', 'true']);

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
