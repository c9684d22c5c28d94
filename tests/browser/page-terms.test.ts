// The page's terms: pointed at, focused or tapped they are explained in two lines, with a picture.

import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import { builtPage, modelIs, openPanel, picture, screens, showOn } from './page-support.js';

const openBuilt = builtPage();

const explanation = (page: Page): Locator => page.locator('.explained');

/** The term that is explained now: the title, two lines, and a picture that was really drawn. */
async function explained(page: Page): Promise<{ title: string; lines: string[] }> {
  await explanation(page).waitFor({ state: 'visible' });
  const picture = explanation(page).locator('img');
  await expect
    .poll(() => picture.evaluate((image: HTMLImageElement) => image.complete && image.naturalWidth))
    .toBeGreaterThan(50);
  return {
    title: (await explanation(page).locator('b').textContent())!,
    lines: await explanation(page).locator('span').allTextContents(),
  };
}

test('every term can be pointed at: two lines and a picture, fetched only then', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const fetched: string[] = [];
  page.on('request', (request) => fetched.push(request.url()));
  const titles: Record<string, string> = {};
  const point = async (at: Locator) => {
    await at.hover();
    const { title, lines } = await explained(page);
    expect(lines.length).toBe(2);
    for (const line of lines) expect(line.length).toBeLessThan(60);
    // It covers nothing of the panels that the word is in.
    const [words, side] = [
      (await explanation(page).boundingBox())!,
      (await page.locator('aside').boundingBox())!,
    ];
    expect(words.x + words.width).toBeLessThan(side.x);
    expect(words.y).toBeGreaterThanOrEqual(0);
    await page.mouse.move(300, 20);
    await explanation(page).waitFor({ state: 'hidden' });
    titles[(await at.getAttribute('data-term'))!] = title;
  };
  await point(page.locator('#field-name'));
  await point(page.locator('#no-loops .term'));
  expect(fetched.filter((url) => /(girth|loop)-[\w-]+\.webp/.test(url)).length).toBe(2);
  expect(fetched.some((url) => /(tip|tube|plate)-[\w-]+\.webp/.test(url))).toBe(false);
  const tips = await openPanel(page, 'tips');
  await point(tips.locator('.term[data-term=tip]'));
  await point(tips.locator('h2'));
  const parts = await openPanel(page, 'parts');
  for (const name of ['tube', 'plate', 'sdf']) {
    await point(parts.locator(`.term[data-term=${name}]`));
  }
  const compare = await openPanel(page, 'compare');
  await point(compare.locator('.term[data-term=emd]'));
  expect(Object.keys(titles).sort()).toEqual([
    'emd',
    'girth',
    'loop',
    'plate',
    'sdf',
    'tip',
    'tube',
  ]);
  // The list's term follows what is chosen in it.
  await page.locator('#field-name').selectOption('sdf');
  await page.locator('#field-name').hover();
  expect((await explained(page)).title).toMatch(/^SDF/);
});

test('by keyboard: shown on focus, gone by Escape, and told to screen readers', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const summary = page.locator('#loops-panel summary');
  await summary.focus();
  await page.keyboard.press('Tab');
  const term = page.locator('#no-loops .term');
  expect(await term.evaluate((element) => element === document.activeElement)).toBe(true);
  const { title, lines } = await explained(page);
  expect(title).toBe('Loop');
  const described = await term.getAttribute('aria-describedby');
  expect(await page.locator(`#${described}`).textContent()).toBe(lines.join(' '));
  await page.keyboard.press('Escape');
  await explanation(page).waitFor({ state: 'hidden' });
  await page.keyboard.press('Enter');
  await explanation(page).waitFor({ state: 'visible' });
  await page.keyboard.press('Tab');
  await explanation(page).waitFor({ state: 'hidden' });
});

test('by touch on a phone', async () => {
  const { page } = await openBuilt('panel=tips', {
    hasTouch: true,
    viewport: { width: 390, height: 844 },
  });
  await modelIs(page, 'chair.glb');
  const panel = await openPanel(page, 'tips');
  const term = panel.locator('.term[data-term=girth]');
  await term.scrollIntoViewIfNeeded();
  await term.tap();
  expect((await explained(page)).title).toBe('Girth');
  const words = (await explanation(page).boundingBox())!;
  const word = (await term.boundingBox())!;
  expect(words.x).toBeGreaterThanOrEqual(0);
  expect(words.x + words.width).toBeLessThanOrEqual(390);
  // Above or below the word, not on it.
  expect(words.y + words.height <= word.y + 8 || words.y >= word.y + word.height - 8).toBe(true);
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    await picture(page, `term-390x844-${colorScheme}.png`);
  }
  await term.tap();
  await explanation(page).waitFor({ state: 'hidden' });
  await term.tap();
  await explanation(page).waitFor({ state: 'visible' });
  await page.locator('#model').tap();
  await explanation(page).waitFor({ state: 'hidden' });
});

test('the terms of a panel are explained at two sizes, and pictures', async () => {
  const { page } = await openBuilt();
  await modelIs(page, 'chair.glb');
  const panel = await openPanel(page, 'parts');
  for (const screen of screens.slice(0, 2)) {
    const keep = await showOn(page, screen);
    for (const name of ['tube', 'plate', 'sdf']) {
      await panel.locator(`.term[data-term=${name}]`).hover();
      await expect.poll(async () => (await explained(page)).title.toLowerCase()).toContain(name);
      await keep(`term-${name}`);
    }
  }
});
