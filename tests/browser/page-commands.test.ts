// The command palette and the list of keys: everything that the page can do, with the keyboard alone; and dark or light.

import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsIn } from './axe.js';
import { builtPage, fragment, modelIs, screensInBoth, showOn } from './page-support.js';
import { fieldComplete, framesPass } from './viewer-page.js';

const openBuilt = builtPage();

interface Rows {
  page: Page;
  viewer: Locator;
  palette: Locator;
  /** Their words, with those of their places. */
  rows: () => Promise<string[]>;
  /** Searches something from scratch. */
  search: (words: string) => Promise<void>;
}

async function openPalette(): Promise<Rows> {
  const viewport = { width: 1440, height: 900 };
  const { page, viewer } = await openBuilt('model=cup', { viewport });
  await modelIs(page, 'cup.glb');
  await fieldComplete(viewer);
  const palette = page.locator('#palette');
  return {
    page,
    viewer,
    palette,
    rows: () =>
      palette.locator('li').evaluateAll((rows) =>
        rows.map((row) =>
          [...row.querySelectorAll(':scope > small, :scope > span:not(.keys)')]
            .reverse()
            .map((part) => part.textContent.replace(/ on$/, ''))
            .join(': '),
        ),
      ),
    search: async (words) => {
      if (!(await palette.isVisible())) await page.keyboard.press('Control+k');
      await palette.waitFor();
      await page.keyboard.press('Control+a');
      await page.keyboard.type(words);
    },
  };
}

test('everything that the page offers is a command, once', async () => {
  const { page, palette, rows, search } = await openPalette();
  await search(' ');
  const all = await rows();
  for (const command of [
    'Undo',
    'Open',
    'Details',
    'Examples: Octopus',
    'Field: Shape diameter (SDF)',
    'Field › Colours: Magma',
    'Field › Distribution: Histogram',
    'Field › Lines of equal value: 10 lines',
    'Field › Range of the colours: 1 to 99 %',
    'Field: Log',
    'Field, parts and loops: Tips',
    'Field, parts and loops: Print check',
    'Field, parts and loops: Share',
    'Export › Picture: PNG as it is now',
    'Export › Values at every vertex: CSV a row for each vertex',
    'Field, parts and loops › Light or dark: Dark',
    'View: First view (0)',
    'View: Front',
    'View: Transparent',
    'View: Edges',
    'View › Which way is up: Z is up',
    'All keys',
    'A tour of the page',
    'Folder',
    'Documentation',
    'Surface: Pin the loop',
  ]) {
    expect(all.map((one) => one.toLowerCase())).toContain(command.toLowerCase());
  }
  expect(all.filter((one, i) => all.indexOf(one) !== i)).toEqual([]);
  expect(all.filter((one) => !/[a-z]/i.test(one))).toEqual([]);
  // None can be done that cannot be done now.
  const off = await palette.locator('[aria-disabled] > span:first-child').allTextContents();
  expect(off).toEqual(expect.arrayContaining(['Undo', 'Redo']));
  await page.keyboard.press('Control+a');
  await page.keyboard.type('undo');
  await page.keyboard.press('Enter');
  expect(await palette.locator('[role=status]').textContent()).toBe('Undo: not now.');
});

test('a few letters and Enter: fields, colours, panels, files, sheets, and what the surface does', async () => {
  const { page, viewer, palette, search } = await openPalette();
  const run = async (words: string): Promise<void> => {
    await search(words);
    await page.keyboard.press('Enter');
    await palette.waitFor({ state: 'hidden' });
  };
  await run('mgm');
  await expect.poll(() => viewer.getAttribute('colormap')).toBe('magma');
  await run('lines 10');
  await expect.poll(() => fragment(page)).toContain('isolines=10');
  await run('undo');
  await expect.poll(() => viewer.getAttribute('isolines')).toBe(null);
  await run('tips');
  await expect.poll(() => page.locator('#tips-panel').getAttribute('open')).toBe('');
  expect(await page.evaluate(() => document.activeElement?.matches('#tips-panel summary'))).toBe(
    true,
  );
  // Again: it is gone to, not closed.
  await run('tips');
  expect(await page.locator('#tips-panel').getAttribute('open')).toBe('');
  const [download] = await Promise.all([page.waitForEvent('download'), run('picture png')]);
  expect(download.suggestedFilename()).toBe('cup.png');
  await run('share');
  await page.locator('#share').waitFor();
  await run('edges');
  expect(await viewer.getAttribute('edges')).toBe('');
  const before = await viewer.evaluate((element: GirthViewer) => element.camera);
  await run('top view');
  expect(await viewer.evaluate((element: GirthViewer) => element.camera)).not.toEqual(before);
  await run('octo');
  await modelIs(page, 'octopus.glb');
  // Opened again before the browser has told that it was closed: what is typed is still for it.
  await page.keyboard.press('Control+k');
  await page.evaluate(() => {
    document.querySelector<HTMLDialogElement>('#palette')!.close();
    document.body.dispatchEvent(
      new KeyboardEvent('keydown', { key: 'k', ctrlKey: true, bubbles: true }),
    );
  });
  await framesPass(page);
  await run('dumb');
  await modelIs(page, 'dumbbell.glb');
});

test('a combobox with a list, driven by keys; the focus comes back', async () => {
  const { page, palette, rows, search } = await openPalette();
  await page.locator('#help').focus();
  await search('exp');
  const input = palette.locator('input');
  const active = (): Promise<string | null> => input.getAttribute('aria-activedescendant');
  const selected = (): Promise<string[]> =>
    palette.locator('[aria-selected=true]').evaluateAll((rows) => rows.map(({ id }) => id));
  const count = (await rows()).length;
  expect(count).toBeGreaterThan(9);
  expect([await active(), await selected()]).toEqual(['palette-0', ['palette-0']]);
  for (const [key, place] of [
    ['ArrowDown', 1],
    ['ArrowUp', 0],
    ['ArrowUp', count - 1],
    ['ArrowDown', 0],
    ['PageDown', 8],
    ['PageUp', 0],
  ] as const) {
    await page.keyboard.press(key);
    expect([await active(), await selected()], key).toEqual([
      `palette-${place}`,
      [`palette-${place}`],
    ]);
  }
  await search('qqqq');
  expect([await active(), await input.getAttribute('aria-expanded')]).toEqual([null, 'false']);
  expect(await palette.locator('[role=status]').textContent()).toBe('No command has this name.');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await palette.waitFor({ state: 'hidden' });
  expect(await page.evaluate(() => document.activeElement?.id)).toBe('help');
  // The button does the same, and so does a click on a row.
  await page.getByRole('button', { name: 'Commands' }).click();
  await palette.locator('li', { hasText: 'Octopus' }).filter({ hasText: 'Examples' }).click();
  await modelIs(page, 'octopus.glb');
});

test('the list of keys has those of controls and of the surface, and every one of them does something', async () => {
  const { page, viewer } = await openPalette();
  await page.keyboard.press('?');
  const list = page.locator('#key-list');
  await list.waitFor();
  const lines = await list
    .locator('dl > div')
    .evaluateAll((lines) =>
      lines.map((line) => [...line.children].map(({ textContent }) => textContent).join(': ')),
    );
  expect(lines).toEqual(
    expect.arrayContaining([
      'Undo: Ctrl Z',
      'Redo: Ctrl Shift Z or Ctrl Y',
      'Commands: Ctrl K',
      'Open: Ctrl O',
      'All keys: ?',
      'Front: 1',
      'Turn left: ←',
      'Move the loop up: Shift ↑',
      'Pin the loop: Enter',
    ]),
  );
  // The keys that the page leaves to the surface are keys that the surface knows.
  await page.keyboard.press('Escape');
  const box = (await viewer.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await viewer.locator('.readout').waitFor();
  for (const key of ['ArrowLeft', '+', '-', 'Shift+ArrowUp', 'c', 'Enter', 'Delete', '0', '1']) {
    const known = await viewer.evaluate((element: GirthViewer, key) => {
      const parts = key.split('+').filter(Boolean);
      const name = key === '+' ? '+' : parts.at(-1)!;
      return element.press(new KeyboardEvent('keydown', { key: name, shiftKey: parts.length > 1 }));
    }, key);
    expect(known, key).toBe(true);
  }
  // Where somebody types it is a letter.
  const panel = page.locator('#print-panel');
  await panel.locator('summary').click();
  await page.locator('#min-wall').focus();
  await page.keyboard.press('?');
  expect(await list.isVisible()).toBe(false);
  expect(await page.locator('#undo').getAttribute('title')).toMatch(/^Undo: .+ \(Ctrl\+Z\)$/);
});

test('dark or light by choice: the page, the surface and the plots; remembered, and auto again', async () => {
  const { page, viewer, palette, search } = await openPalette();
  await page.emulateMedia({ colorScheme: 'light' });
  const paper = (): Promise<string> =>
    page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  const behind = (): Promise<string> =>
    viewer.evaluate((element) => getComputedStyle(element).backgroundImage);
  const ofPlot = (): Promise<string> =>
    page
      .locator('#distribution canvas')
      .evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  await page.getByRole('button', { name: 'Cumulative distribution' }).click();
  const [light, plotInLight] = ['rgb(251, 251, 250)', await ofPlot()];
  expect([await paper(), await behind()]).toEqual([light, 'none']);
  await search('dark');
  await page.keyboard.press('Enter');
  await palette.waitFor({ state: 'hidden' });
  const dark = 'rgb(22, 23, 26)';
  expect([await paper(), await behind()]).toEqual([dark, expect.stringMatching(/^radial/)]);
  await expect.poll(ofPlot).not.toBe(plotInLight);
  expect(await page.locator('#theme').inputValue()).toBe('dark');
  await page.reload();
  await modelIs(page, 'cup.glb');
  expect([await paper(), await page.locator('#theme').inputValue()]).toEqual([dark, 'dark']);
  await page.locator('#theme').selectOption('light');
  await page.emulateMedia({ colorScheme: 'dark' });
  expect([await paper(), await behind()]).toEqual([light, 'none']);
  await page.locator('#theme').selectOption('');
  expect(await paper()).toBe(dark);
  await page.emulateMedia({ colorScheme: 'light' });
  await expect.poll(paper).toBe(light);
});

test('dark by choice where nothing can be kept: it holds for the visit', async () => {
  const { page } = await openPalette();
  await page.evaluate(() => {
    Storage.prototype.setItem = () => {
      throw new DOMException('denied', 'SecurityError');
    };
  });
  await page.locator('#theme').selectOption('dark');
  expect(await page.evaluate(() => document.documentElement.dataset['scheme'])).toBe('dark');
  expect(await page.locator('#said').textContent()).toMatch(/keeps nothing/);
});

test('no complaint of axe at two sizes, and pictures', async () => {
  const { page, search } = await openPalette();
  for (const screen of screensInBoth) {
    const keep = await showOn(page, screen);
    const shown = `${screen.scheme}, ${screen.width}`;
    await keep('front');
    await search(' ');
    expect(await complaintsIn(screen.scheme, page), shown).toEqual([]);
    await keep('palette-all');
    await search('exp');
    await page.keyboard.press('ArrowDown');
    expect(await complaintsIn(screen.scheme, page), shown).toEqual([]);
    await keep('palette');
    await page.keyboard.press('Escape');
    await page.keyboard.press('?');
    await page.locator('#key-list').waitFor();
    expect(await complaintsIn(screen.scheme, page), shown).toEqual([]);
    await keep('keys');
    await page.keyboard.press('Escape');
    await page.locator('#help').click();
    expect(await complaintsIn(screen.scheme, page), shown).toEqual([]);
    await keep('help');
    await page.keyboard.press('Escape');
  }
});
