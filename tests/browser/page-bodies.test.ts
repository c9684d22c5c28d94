// For every body: what is seen by hand and by ear where no checker looks.

import type { Locator, Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { builtPage, modelIs, openPanel } from './page-support.js';
import { fieldComplete, framesPass } from './viewer-page.js';

const openBuilt = builtPage();

async function open(options: Parameters<typeof openBuilt>[1] = {}) {
  const built = await openBuilt('model=dumbbell', options);
  await modelIs(built.page, 'dumbbell.glb');
  await fieldComplete(built.viewer);
  return built;
}

const boxOf = async (locator: Locator) => (await locator.boundingBox())!;

test('at 200% nothing covers anything: the page scrolls', async () => {
  const { page, viewer } = await open({ viewport: { width: 720, height: 450 } });
  const [surface, strip, field] = [
    await boxOf(viewer),
    await boxOf(page.locator('#examples')),
    await boxOf(page.locator('#field-name')),
  ];
  expect(surface.height).toBeGreaterThan(200);
  expect(surface.y + surface.height).toBeLessThanOrEqual(strip.y + 1);
  expect(strip.y + strip.height).toBeLessThanOrEqual(field.y + 1);
  await page.getByRole('button', { name: 'Export' }).scrollIntoViewIfNeeded();
  expect(await page.getByRole('button', { name: 'Export' }).isVisible()).toBe(true);
});

test('the line about the example has room at any width', async () => {
  const { page } = await open();
  const line = page.locator('#examples p');
  for (const width of [1110, 1200, 1440]) {
    await page.setViewportSize({ width, height: 800 });
    const rows = await line.evaluate((element) => {
      const { lineHeight } = getComputedStyle(element);
      return Math.round(element.getBoundingClientRect().height / Number.parseFloat(lineHeight));
    });
    expect(rows, `${width}`).toBeGreaterThan(0);
    expect(rows, `${width}`).toBeLessThanOrEqual(2);
    const [strip, last] = [
      await boxOf(page.locator('#examples')),
      await boxOf(page.locator('#examples button').last()),
    ];
    expect(last.x + last.width, `${width}`).toBeLessThanOrEqual(strip.x + strip.width);
    expect(last.y, `${width}`).toBeLessThan(strip.y + 20);
  }
});

test('in forced colours legend, range, swatches and pressed states are there', async () => {
  const { page, viewer } = await open();
  await page.emulateMedia({ forcedColors: 'active' });
  const style = (locator: Locator, name: string, pseudo?: string) =>
    locator.evaluate(
      (element, [name, pseudo]) => getComputedStyle(element, pseudo).getPropertyValue(name),
      [name, pseudo] as const,
    );
  expect(await style(viewer.locator('.legend-bar'), 'background-image')).toContain('rgb(253');
  expect(await style(page.locator('.sliders'), 'forced-color-adjust', '::before')).toBe('none');
  const pressed = page.locator('#examples [aria-pressed=true]');
  const other = page.locator('#examples [aria-pressed=false]').first();
  expect(await style(pressed, 'background-color')).not.toBe(await style(other, 'background-color'));
  await page.locator('#field-name').selectOption('kind');
  const swatch = page.locator('.shares .swatch').first();
  await swatch.waitFor();
  expect(await style(swatch, 'background-color')).toBe('rgb(86, 180, 233)');
});

/** Everything that live regions say from now on. */
async function listen(page: Page): Promise<() => Promise<string[]>> {
  await page.evaluate(() => {
    const heard: string[] = [];
    Object.assign(globalThis, { heard });
    const roots = [document, document.querySelector('girth-viewer')!.shadowRoot!];
    for (const root of roots) {
      new MutationObserver((changes) => {
        for (const { target } of changes) {
          const element = target instanceof Element ? target : target.parentElement;
          const region = element?.closest('[aria-live], [role=status], [role=alert]');
          if (region?.textContent) heard.push(region.textContent);
        }
      }).observe(root, { subtree: true, childList: true, characterData: true });
    }
  });
  return () => page.evaluate(() => (globalThis as unknown as { heard: string[] }).heard);
}

test('a field is said once, at its end; pinning, removing and choosing are said', async () => {
  const { page, viewer } = await open();
  const heard = await listen(page);
  await page.locator('#field-name').selectOption('sdf');
  await expect.poll(heard).toContainEqual(expect.stringMatching(/^Shape diameter: computed, from/));
  expect((await heard()).filter((words) => words.includes('median'))).toEqual([]);
  await viewer.evaluate((element: GirthViewer) => element.pin(0));
  await expect.poll(heard).toContainEqual(expect.stringMatching(/^Loop 1 pinned: \d/));
  await page.getByRole('button', { name: 'Remove' }).first().click();
  await expect.poll(heard).toContainEqual('Loop 1 removed');
  const tips = await openPanel(page, 'tips');
  await tips.locator('.places button').first().click();
  await expect.poll(heard).toContainEqual(expect.stringMatching(/^Shown: rises by/));
});

test('borders of fields have 3:1 in light and dark', async () => {
  const { page } = await open();
  await openPanel(page, 'print');
  const ratiosOf = () =>
    page.evaluate(() => {
      const channels = (colour: string) => (colour.match(/[\d.]+/g) ?? []).slice(0, 3).map(Number);
      const luminance = (colour: string) => {
        const [r = 0, g = 0, b = 0] = channels(colour).map((byte) => {
          const share = byte / 255;
          return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
        });
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
      };
      const paper = luminance(getComputedStyle(document.documentElement).backgroundColor);
      const controls =
        '#colormap, #isolines, .switch, #open, #help, #print-panel input:not([type=checkbox])';
      return [...document.querySelectorAll(controls)].map((element) => {
        const line = luminance(getComputedStyle(element).borderTopColor);
        return (Math.max(line, paper) + 0.05) / (Math.min(line, paper) + 0.05);
      });
    });
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    await framesPass(page);
    const ratios = await ratiosOf();
    expect(ratios.length).toBeGreaterThan(4);
    expect(Math.min(...ratios), colorScheme).toBeGreaterThanOrEqual(3);
  }
});

test('with wide letters and lines nothing is cut', async () => {
  const { page } = await open();
  const cut = (id: string) =>
    page.locator(id).evaluate((input) => input.scrollWidth - input.clientWidth);
  for (const id of ['#range-low', '#range-high']) expect(await cut(id)).toBeLessThanOrEqual(0);
  await page.addStyleTag({
    content:
      '* { letter-spacing: 0.12em !important; word-spacing: 0.16em !important; line-height: 1.5 !important }',
  });
  await page.locator('#details-open').click();
  const sheet = await boxOf(page.locator('#details'));
  const remesh = await boxOf(page.getByRole('button', { name: 'Remesh' }));
  expect(remesh.x + remesh.width).toBeLessThanOrEqual(sheet.x + sheet.width);
  await page.keyboard.press('Escape');
  const aside = await boxOf(page.locator('aside'));
  for (const id of ['#range-low', '#range-high']) {
    const end = page.locator(id);
    expect(
      await end.evaluate((input) => input.scrollWidth - input.clientWidth),
    ).toBeLessThanOrEqual(0);
    const box = await boxOf(end);
    expect(box.x).toBeGreaterThanOrEqual(aside.x);
    expect(box.x + box.width).toBeLessThanOrEqual(aside.x + aside.width);
  }
});

test('canvas and document are called by the model and its field', async () => {
  const { page, viewer } = await open();
  expect(await page.title()).toBe('dumbbell.glb – Girth');
  const canvas = viewer.locator('canvas');
  expect(await canvas.getAttribute('aria-label')).toBe('dumbbell.glb, coloured by: Girth');
  await page.locator('#field-name').selectOption('sdf');
  await expect
    .poll(() => canvas.getAttribute('aria-label'))
    .toBe('dumbbell.glb, coloured by: Shape diameter');
  const keys = await canvas.evaluate((element) => {
    const id = element.getAttribute('aria-describedby')!;
    return (element.getRootNode() as ShadowRoot).getElementById(id)!.textContent;
  });
  expect(keys).toContain('Enter pins its loop');
});

test('handles of plots have a unit', async () => {
  const { page } = await open();
  const parts = await openPanel(page, 'parts');
  await parts.locator('.controls').waitFor();
  const handles = parts.locator('.scatter [role=slider]');
  for (const words of await handles.evaluateAll((all) =>
    all.map((handle) => handle.getAttribute('aria-valuetext')),
  )) {
    expect(words).toMatch(/^[\d.]+ m$/);
  }
});

test('a sheet closes when the focus leaves it, and with the first Escape', async () => {
  const { page } = await open();
  const sheet = page.locator('#details');
  await page.locator('#details-open').click();
  await sheet.waitFor();
  await page.locator('#field-name').focus();
  await sheet.waitFor({ state: 'hidden' });
  await page.locator('#help').focus();
  await page.locator('#details-open').click();
  await page.keyboard.press('Tab');
  await page.keyboard.press('Escape');
  await sheet.waitFor({ state: 'hidden' });
});
