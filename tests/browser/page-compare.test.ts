// Several models on the page: distributions over each other, distances, and a ranking.

import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { complaintsOfAxe } from './axe.js';
import { clicksOn } from './clicks.js';
import { dumbbell, scaled, torus, tube } from './meshes.js';
import {
  builtPage,
  cutWords,
  drop,
  fragment,
  modelIs,
  openPanel,
  screens,
  showOn,
} from './page-support.js';

const openBuilt = builtPage();

/** The ranking, once all distances are there. */
async function ranking(page: Page, count: number): Promise<{ name: string; words: string }[]> {
  const rows = page.getByRole('list', { name: 'Ranking' }).getByRole('button');
  const read = async () => ({
    names: await rows.locator('b').allTextContents(),
    words: await rows.locator('.words span').allTextContents(),
  });
  await expect
    .poll(async () => (await read()).words.filter((one) => /^distance \d/.test(one)).length, {
      timeout: 90_000,
    })
    .toBe(count - 1);
  const { names, words } = await read();
  return names.map((name, i) => ({ name, words: words[i]!.replace('distance ', '') }));
}

test('models dropped together are compared: the same shape is nearest, whatever its size', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const bell = dumbbell(16, 12);
  await drop(
    page,
    { name: 'bell.obj', bytes: Buffer.from(bell) },
    { name: 'ring.obj', bytes: Buffer.from(torus(24, 12)) },
    { name: 'large-bell.obj', bytes: Buffer.from(scaled(bell, 5)) },
  );
  await modelIs(page, 'bell.obj');
  const panel = await openPanel(page, 'compare');
  const rows = await ranking(page, 3);
  expect(rows.map(({ name }) => name)).toEqual(['bell.obj', 'large-bell.obj', 'ring.obj']);
  expect(Number(rows[1]!.words)).toBeLessThan(1e-3);
  expect(Number(rows[2]!.words)).toBeGreaterThan(0.1);
  expect(await panel.locator('.matrix td button').count()).toBe(9);
  // Pictures are drawn by a module that is fetched with the first of them.
  await expect.poll(() => panel.locator('.places canvas').count()).toBe(3);
  // Another is asked about, by another field.
  await page.getByRole('list', { name: 'Ranking' }).getByRole('button').nth(2).click();
  await page.locator('#compare-field').selectOption('geofarthest');
  const others = await ranking(page, 3);
  expect(others[0]!.name).toBe('ring.obj');
  await panel.getByRole('button', { name: 'Remove it' }).click();
  expect(await panel.locator('.count').textContent()).toBe('2');
});

test('which of four are most alike is said without a click; the distances are a table to take away', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const clicks = await clicksOn(page);
  const girths = await countGirths(page);
  await dropFour(page);
  const panel = page.locator('#compare-panel');
  await panel.getByText(/^Most alike: bell and large-bell \(0\.00\d\d\)$/).waitFor();
  expect(await clicks()).toBe(0);
  // The girth of the model that is shown is computed once, for the surface and for the comparison.
  expect(await girths()).toBe(4);
  expect(await panel.textContent()).toMatch(
    /0 is the same curve.* goes from 0\.00\d\d to 0\.\d{4}/,
  );
  // Curves differ by their strokes, too.
  const strokes = await panel
    .locator('.swatch')
    .evaluateAll((swatches) => swatches.map((one) => getComputedStyle(one).backgroundImage));
  expect(new Set(strokes.map((stroke) => stroke.replace(/rgb\([^)]*\)/g, ''))).size).toBe(4);

  expect(await complaintsOfAxe(page)).toEqual([]);
  // One grid: one stop of the tab key, and arrows.
  const cells = panel.getByRole('grid').getByRole('button');
  expect(await cells.evaluateAll((all) => all.filter((cell) => cell.tabIndex === 0).length)).toBe(
    1,
  );
  expect(await cells.nth(1).textContent()).toMatch(/^0\.00\d\d$/);
  await cells.first().focus();
  for (const key of ['ArrowRight', 'ArrowDown', 'ArrowDown', 'End', 'ArrowRight']) {
    await page.keyboard.press(key);
  }
  const focused = () => page.evaluate(() => document.activeElement?.getAttribute('aria-label'));
  expect(await focused()).toMatch(/^ring\.obj and tube\.obj: distance 0\.\d{4}$/);
  await page.keyboard.press('Enter');
  await panel.getByText('Most similar to ring.obj').waitFor();
  expect(await focused()).toMatch(/^ring\.obj and tube\.obj/);

  // Where there is no room, the matrix says by its edge that it goes on.
  const box = panel.locator('.matrix-box');
  const goesOn = () => box.evaluate((element) => element.classList.contains('more'));
  expect(await goesOn()).toBe(false);
  await box.evaluate((element: HTMLElement) => (element.style.inlineSize = '100px'));
  await expect.poll(goesOn).toBe(true);
  await box.evaluate((element) => element.scrollTo(element.scrollWidth, 0));
  await expect.poll(goesOn).toBe(false);
  await box.evaluate((element: HTMLElement) => (element.style.inlineSize = ''));

  const coming = page.waitForEvent('download');
  await panel.getByRole('button', { name: 'CSV' }).click();
  const csv = await coming;
  expect(csv.suggestedFilename()).toBe('distances-igf.csv');
  const rows = readFileSync(await csv.path(), 'utf8')
    .trim()
    .split('\n');
  expect(rows[0]).toBe('distance by igf,bell.obj,large-bell.obj,ring.obj,tube.obj');
  expect(rows[3]).toMatch(/^ring\.obj,0\.\d+,0\.\d+,0,0\.\d+$/);
});

test('a model is kept once; what cannot be read says so, the rest goes on', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'bell.obj', bytes: Buffer.from(dumbbell(8, 6)) });
  await modelIs(page, 'bell.obj');
  const panel = await openPanel(page, 'compare');
  await panel.getByRole('button', { name: 'Add this model' }).click();
  await panel.getByRole('button', { name: 'Add this model' }).click();
  expect(await panel.locator('.count').textContent()).toBe('1');
  await drop(
    page,
    { name: 'a-ring.obj', bytes: Buffer.from(torus(12, 8)) },
    { name: 'broken.obj', bytes: Buffer.from('v 0 0 0\nf 1 2 3\n') },
  );
  await modelIs(page, 'a-ring.obj');
  const rows = page.getByRole('list', { name: 'Ranking' }).getByRole('button');
  await expect
    .poll(() => rows.allTextContents(), { timeout: 60_000 })
    .toEqual([
      expect.stringContaining('bell.obj'),
      expect.stringMatching(/a-ring\.obj ?distance \d\.\d{4}$/),
      expect.stringMatching(/broken\.obj.*(vertex|face)/),
    ]);
  await panel.getByRole('button', { name: 'Remove all' }).click();
  expect(await rows.count()).toBe(0);
});

test('of several files the first cannot be read: it is named, and the others open', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await drop(
    page,
    { name: 'a-broken.obj', bytes: Buffer.from('v 0 0 0\nf 1 2 3\n') },
    { name: 'b-empty.ply', bytes: Buffer.alloc(0) },
    { name: 'c-ring.obj', bytes: Buffer.from(torus(12, 8)) },
    { name: 'd-bell.obj', bytes: Buffer.from(dumbbell(8, 6)) },
  );
  await modelIs(page, 'c-ring.obj');
  const words = () => viewer.getByRole('alert').textContent();
  await expect.poll(words).toMatch(/a-broken\.obj could not be used\. .*(vertex|face)/);
  expect(await words()).toContain('b-empty.ply could not be used.');
  expect(await words()).toContain('c-ring.obj is shown instead.');
  const details = page.locator('#details');
  await expect.poll(() => details.textContent()).toContain('A-broken.obj was passed over');
  await expect.poll(() => fragment(page)).toContain('file=c-ring.obj');
  // All four are in the comparison, and those that cannot be read say why; none is there twice.
  const panel = await openPanel(page, 'compare');
  const rows = page.getByRole('list', { name: 'Ranking' }).getByRole('button');
  await rows.filter({ hasText: 'd-bell.obj' }).waitFor();
  await panel.getByRole('button', { name: 'Add this model' }).click();
  await expect.poll(() => panel.locator('.count').textContent()).toBe('4');
  await rows.filter({ hasText: 'c-ring.obj' }).click();
  await expect
    .poll(() => rows.allTextContents(), { timeout: 60_000 })
    .toEqual([
      expect.stringMatching(/c-ring\.obj ?compared with the others/),
      expect.stringMatching(/d-bell\.obj ?distance \d\.\d{4}$/),
      expect.stringMatching(/a-broken\.obj.*(vertex|face)/),
      expect.stringMatching(/b-empty\.ply.*[a-z]{3}/),
    ]);
});

test('of several files none can be read: the model before stays, and words say so', async () => {
  const { page, viewer } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await drop(
    page,
    { name: 'one.obj', bytes: Buffer.from('v 0 0 0\nf 1 2 3\n') },
    { name: 'two.obj', bytes: Buffer.from('v 0 0 nan\n') },
  );
  const words = viewer.getByText('None of the 2 models can be used; one.obj:');
  await words.waitFor();
  expect(await viewer.getByRole('alert').textContent()).toContain('former model is still here');
  await modelIs(page, 'chair.glb');
});

/** Counts from now on how many girth functions the kernel's threads are asked for. */
async function countGirths(page: Page): Promise<() => Promise<number>> {
  await page.evaluate(() => {
    const asked = { girths: 0 };
    Object.assign(globalThis, { asked });
    // oxlint-disable-next-line typescript/unbound-method
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (
      this: Worker,
      message: { operation?: string; arguments?: { field?: { name?: string } } },
      transfer: Transferable[],
    ) {
      const { operation, arguments: given } = message;
      if (operation === 'field' && given?.field?.name === 'igf') ++asked.girths;
      post.call(this, message, { transfer });
    } as typeof post;
  });
  return () =>
    page.evaluate(() => (globalThis as unknown as { asked: { girths: number } }).asked.girths);
}

/** A dumbbell, a larger one of the same shape, a ring and an open tube, dropped together. */
async function dropFour(page: Page): Promise<void> {
  const bell = dumbbell(16, 12);
  await drop(
    page,
    { name: 'bell.obj', bytes: Buffer.from(bell) },
    { name: 'large-bell.obj', bytes: Buffer.from(scaled(bell, 5)) },
    { name: 'ring.obj', bytes: Buffer.from(torus(24, 12)) },
    { name: 'tube.obj', bytes: Buffer.from(tube(9, 16, 5)) },
  );
  await modelIs(page, 'bell.obj');
}

test('by every descriptor the same shape is nearest, and is at no distance', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await dropFour(page);
  const panel = await openPanel(page, 'compare');
  const choice = page.locator('#compare-field');
  const names = await choice
    .locator('option')
    .evaluateAll((options: HTMLOptionElement[]) => options.map(({ value }) => value));
  expect(names.sort()).toEqual(
    ['geoaverage', 'geofarthest', 'hks', 'igf', 'igf-ms', 'igf-sdf', 'sdf', 'sihks', 'wks'].sort(),
  );
  for (const name of names) {
    await choice.selectOption(name);
    // The numbers of the descriptor before have gone at once: none is taken for this one's.
    const rows = await ranking(page, 4);
    expect(rows[0]!.name, name).toBe('bell.obj');
    expect(rows[1]!.name, name).toBe('large-bell.obj');
    const [same, ...others] = rows.slice(1).map(({ words }) => Number(words));
    expect(same, name).toBeLessThan(0.02 * Math.min(...others));
    // The table has distances beyond those of the ranking.
    const distances = (): Promise<number[]> =>
      panel
        .locator('.matrix td button')
        .evaluateAll((buttons) =>
          buttons
            .map((button) => /: distance ([\d.]+)$/.exec(button.getAttribute('aria-label')!))
            .flatMap((found) => (found ? [Number(found[1])] : [])),
        );
    await expect.poll(async () => (await distances()).length).toBe(16);
    const cells = await distances();
    // Symmetric, and nothing on the diagonal.
    cells.forEach((distance, at) => {
      const [row, column] = [Math.floor(at / 4), at % 4];
      expect(distance).toBe(cells[4 * column + row]);
      if (row === column) expect(distance).toBe(0);
    });
    await expect.poll(() => panel.getByRole('button', { name: 'Cancel' }).isVisible()).toBe(false);
  }
});

test('however often the choice changes while distances come, none is lost', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await dropFour(page);
  await openPanel(page, 'compare');
  const names = ['igf', 'sdf', 'geoaverage', 'geofarthest'];
  // Changes that come between two results, wherever in the work that is.
  await page.locator('#compare-field').evaluate(async (select: HTMLSelectElement, values) => {
    for (let change = 0; change < 60; ++change) {
      select.value = values[change % values.length]!;
      select.dispatchEvent(new Event('change'));
      await new Promise((done) => setTimeout(done, 5 + ((change * 37) % 101)));
    }
  }, names);
  for (const name of names) {
    await page.locator('#compare-field').selectOption(name);
    const rows = await ranking(page, 4);
    expect(rows[1]!.name, name).toBe('large-bell.obj');
  }
});

test('four files: no list cuts its words at any size, and pictures', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  await dropFour(page);
  const panel = await openPanel(page, 'compare');
  await ranking(page, 4);
  const aside = page.locator('aside');
  for (const screen of screens) {
    const keep = await showOn(page, screen);
    await panel.locator('summary').scrollIntoViewIfNeeded();
    await keep('four');
    await aside.evaluate((element) => element.scrollTo(0, element.scrollHeight));
    await keep('four-below');
    expect(await cutWords(page), `${screen.width}`).toEqual([]);
  }
});

test('cancelled in mid-run: what is computed stays, and it can be gone on with', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  // The third takes minutes: it is in mid-run whenever the click comes.
  await drop(
    page,
    { name: 'a-bell.obj', bytes: Buffer.from(dumbbell(16, 12)) },
    { name: 'b-ring.obj', bytes: Buffer.from(torus(24, 12)) },
    { name: 'c-endless.obj', bytes: Buffer.from(torus(160, 110)) },
    { name: 'd-tube.obj', bytes: Buffer.from(tube(9, 16, 5)) },
  );
  await modelIs(page, 'a-bell.obj');
  const panel = await openPanel(page, 'compare');
  const rows = page.getByRole('list', { name: 'Ranking' }).getByRole('button');
  await rows.filter({ hasText: /c-endless\.obj ?computing, \d+/ }).waitFor({ timeout: 60_000 });
  const cancel = panel.getByRole('button', { name: 'Cancel' });
  await cancel.click();
  await cancel.waitFor({ state: 'hidden' });
  const words = await rows.allTextContents();
  expect(words).toEqual([
    expect.stringMatching(/a-bell\.obj ?compared with the others/),
    expect.stringMatching(/b-ring\.obj ?distance 0\.\d{4}/),
    expect.stringMatching(/c-endless\.obj ?not computed/),
    expect.stringMatching(/d-tube\.obj ?not computed/),
  ]);
  // Without the endless one it goes on with the rest, and what was computed is still known.
  await rows.filter({ hasText: 'c-endless' }).click();
  await panel.getByRole('button', { name: 'Remove it' }).click();
  await panel.getByRole('button', { name: 'Go on' }).click();
  const rest = await ranking(page, 3);
  expect(rest.map(({ name }) => name).sort()).toEqual(['a-bell.obj', 'b-ring.obj', 'd-tube.obj']);
});
