// Several models on the page: distributions over each other, distances, and a ranking.

import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { dumbbell, torus } from './meshes.js';
import { builtPage, drop, fragment, modelIs, openPanel } from './page-support.js';

const openBuilt = builtPage();

/** The ranking, once all distances are there. */
async function ranking(page: Page, count: number): Promise<{ name: string; words: string }[]> {
  const rows = page.getByRole('list', { name: 'Ranking' }).getByRole('button');
  const read = async () => ({
    names: await rows.locator('b').allTextContents(),
    words: await rows.locator('.words span').allTextContents(),
  });
  await expect
    .poll(async () => (await read()).words.filter((one) => /^\d/.test(one)).length, {
      timeout: 90_000,
    })
    .toBe(count - 1);
  const { names, words } = await read();
  return names.map((name, i) => ({ name, words: words[i]! }));
}

test('models dropped together are compared: the same shape is nearest, whatever its size', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const bell = dumbbell(16, 12);
  const larger = bell.replace(/^v (.*)$/gm, (_, numbers: string) =>
    ['v', ...numbers.split(' ').map((number) => 5 * Number(number))].join(' '),
  );
  await drop(
    page,
    { name: 'bell.obj', bytes: Buffer.from(bell) },
    { name: 'ring.obj', bytes: Buffer.from(torus(24, 12)) },
    { name: 'large-bell.obj', bytes: Buffer.from(larger) },
  );
  await modelIs(page, 'bell.obj');
  const panel = await openPanel(page, 'compare');
  const rows = await ranking(page, 3);
  expect(rows.map(({ name }) => name)).toEqual(['bell.obj', 'large-bell.obj', 'ring.obj']);
  expect(Number(rows[1]!.words)).toBeLessThan(1e-3);
  expect(Number(rows[2]!.words)).toBeGreaterThan(0.1);
  expect(await panel.locator('.matrix td button').count()).toBe(9);
  expect(await panel.locator('.places canvas').count()).toBe(3);
  // Another is asked about, by another field.
  await page.getByRole('list', { name: 'Ranking' }).getByRole('button').nth(2).click();
  await page.locator('#compare-field').selectOption('geofarthest');
  const others = await ranking(page, 3);
  expect(others[0]!.name).toBe('ring.obj');
  await panel.getByRole('button', { name: 'Remove it' }).click();
  expect(await panel.locator('.count').textContent()).toBe('2');
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
      expect.stringMatching(/a-ring\.obj ?\d\.\d{4}$/),
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
  const words = (await viewer.getByRole('alert').textContent())!;
  expect(words).toMatch(/a-broken\.obj could not be used\. .*(vertex|face)/);
  expect(words).toContain('b-empty.ply could not be used.');
  expect(words).toContain('c-ring.obj is shown instead.');
  expect(await page.locator('#details').textContent()).toContain('A-broken.obj was passed over');
  expect(fragment(page)).toContain('file=c-ring.obj');
  // All four are in the comparison, and those that cannot be read say why; none is there twice.
  const panel = await openPanel(page, 'compare');
  const rows = page.getByRole('list', { name: 'Ranking' }).getByRole('button');
  await rows.filter({ hasText: 'd-bell.obj' }).waitFor();
  await panel.getByRole('button', { name: 'Add this model' }).click();
  expect(await panel.locator('.count').textContent()).toBe('4');
  await rows.filter({ hasText: 'c-ring.obj' }).click();
  await expect
    .poll(() => rows.allTextContents(), { timeout: 60_000 })
    .toEqual([
      expect.stringMatching(/c-ring\.obj ?asked about/),
      expect.stringMatching(/d-bell\.obj ?\d\.\d{4}$/),
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
