// Things that the page gives to others: link, element and frame, each tried on another origin than the page's.

import type { BrowserContext, Frame, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { GirthViewer, ViewerState } from '../../web/src/element/index.js';
import { packed } from '../web/package/packed.js';
import { complaintsOfAxe } from './axe.js';
import { stl, tube } from './meshes.js';
import { drop, modelIs, picture, site } from './page-support.js';
import { smallExamples } from './small-examples.js';
import { chromiumForTests, serve, strictPolicy, type StaticServer } from './support.js';
import { fieldComplete } from './viewer-page.js';

const openPage = chromiumForTests();
const contexts: BrowserContext[] = [];
const servers: StaticServer[] = [];
let host: StaticServer;

beforeAll(async () => {
  host = await serve(site, {
    policy: strictPolicy,
    folders: { '/examples/': smallExamples },
    // Files that other origins may read.
    shared: /\.glb$/,
  });
});
afterEach(async () => {
  await Promise.all(contexts.splice(0).map((context) => context.close()));
});
afterAll(async () => {
  await Promise.all([host, ...servers].map((server) => server?.close()));
});

async function open(address: string) {
  const opened = await openPage(address, { reducedMotion: 'reduce' });
  contexts.push(opened.context);
  return opened;
}

/** A page of another origin, with the folder of the package beside it. */
async function onOtherOrigin(body: string) {
  const head = '<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,">';
  const server = await serve(packed().folder, {
    pages: { '/': head + body },
    folders: { '/girth/': packed().folder },
  });
  servers.push(server);
  return open(`${server.url}/`);
}

const state =
  'model=dumbbell&field=sdf&colormap=magma&range=5%25%2095%25&isolines=4&shading=flat&camera=1.2,0.4,5.5,0,0.1,0&loops=5,3:0.25:0.25&names=left%20bell,&bottleneck=3,500&panel=tips';

const stateOf = (where: Page | Frame): Promise<ViewerState> =>
  where.locator('girth-viewer').evaluate(({ state }: GirthViewer) => state);

/** The state on the screen, whatever names the model. */
async function seen(where: Page | Frame): Promise<ViewerState> {
  const { src, turn, 'keep-view': keeps, bottleneck, ...rest } = await stateOf(where);
  // The page itself draws it by its panel.
  void [src, turn, keeps, bottleneck];
  return rest;
}

test('link, element and frame show on another origin what the page shows', async () => {
  const { page, complaints } = await open(`${host.url}/#${state}`);
  await fieldComplete(page.locator('girth-viewer'));
  await expect.poll(async () => (await stateOf(page)).pins).toBe('5 left bell, 3:0.25:0.25');
  await expect.poll(async () => (await stateOf(page)).tips).toBe('all');
  const shown = await seen(page);
  expect(shown).toMatchObject({
    ...{ field: 'sdf', colormap: 'magma', range: '5% 95%', isolines: '4', shading: 'flat' },
    controls: true,
  });
  await page.getByRole('button', { name: 'Share' }).click();
  const sheet = page.getByRole('dialog', { name: 'Share this view' });
  const [link, element, frame] = await Promise.all(
    ['Link', 'Element', 'Frame'].map((name) =>
      sheet.getByRole('textbox', { name, exact: true }).inputValue(),
    ),
  );
  expect(await complaintsOfAxe(page)).toEqual([]);
  await picture(page, 'share.png');
  for (const colorScheme of ['light', 'dark'] as const) {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 390, height: 844 });
    await picture(page, `share-phone-${colorScheme}.png`);
  }
  expect(complaints).toEqual([]);

  const linked = await onOtherOrigin(`<a href="${link!.replaceAll('&', '&amp;')}">a view</a>`);
  await linked.page.getByRole('link').click();
  await expect.poll(() => seen(linked.page)).toEqual(shown);
  expect(linked.page.url()).toContain('&bottleneck=3,500&');
  expect(linked.complaints).toEqual([]);

  const withElement = await onOtherOrigin(element!);
  await expect.poll(() => seen(withElement.page)).toEqual(shown);
  await fieldComplete(withElement.page.locator('girth-viewer'));
  expect((await stateOf(withElement.page)).bottleneck).toBe('3, 500');
  expect(withElement.complaints).toEqual([]);

  const framed = await onOtherOrigin(frame!);
  const inside = framed.page.frames()[1]!;
  await expect.poll(() => inside.url()).toContain(`${host.url}/embed.html#src=`);
  await expect.poll(() => seen(inside)).toEqual(shown);
  expect((await stateOf(inside)).bottleneck).toBe('3, 500');
  expect(await framed.page.locator('iframe').getAttribute('title')).toBe(
    'dumbbell.glb: Shape diameter',
  );
  expect(framed.complaints).toEqual([]);
}, 120_000);

test('of a dropped file there is no frame; of one that was mended here, no element either, and words say why', async () => {
  const { page } = await open(`${host.url}/`);
  await modelIs(page, 'chair.glb');
  await drop(page, { name: 'a "tube".stl', bytes: Buffer.from(stl(tube(12, 16, 4))) });
  await modelIs(page, 'a "tube".stl');
  const sheet = page.locator('#share');
  const share = async () => {
    await page.getByRole('button', { name: 'Share' }).click();
    const lines = await sheet
      .getByRole('textbox')
      .evaluateAll((inputs: HTMLInputElement[]) =>
        inputs.map((input) => [input.ariaLabel, input.value]),
      );
    const words = await sheet.innerText();
    await page.keyboard.press('Escape');
    return { names: lines.map(([name]) => name), element: lines[1]?.[1], words };
  };
  const dropped = await share();
  expect(dropped.names).toEqual(['Link', 'Element']);
  expect(dropped.element).toContain('src="a &#34;tube&#34;.stl"');
  expect(dropped.words).toContain('and a "tube".stl too');

  await page.locator('#details-open').click();
  await page.getByRole('button', { name: /close .*holes|holes/i }).click();
  await expect.poll(async () => (await share()).names).toEqual(['Link']);
  expect((await share()).words).toContain('export it as GLB');
});

test('a frame says what its address lacks, and follows it when it changes', async () => {
  const { page, complaints } = await open(`${host.url}/embed.html`);
  const fault = page.getByRole('alert');
  await expect.poll(() => fault.first().textContent()).toContain('names no model');
  const go = (hash: string) =>
    page.evaluate((hash) => {
      location.hash = hash;
    }, hash);
  await go('src=examples/dumbbell.glb&colour=red');
  await expect.poll(() => fault.first().textContent()).toContain('a state has no “colour”');
  expect(await page.title()).toBe('Girth');
  await go('src=examples/dumbbell.glb&field=none&edges=');
  await expect.poll(() => page.title()).toBe('dumbbell.glb – Girth');
  expect(await stateOf(page)).toEqual({
    ...{ src: 'examples/dumbbell.glb', field: 'none', edges: true },
  });
  expect(await complaintsOfAxe(page)).toEqual([]);
  await go('src=http://[');
  await expect
    .poll(() => page.locator('girth-viewer [role=alert]').textContent())
    .toContain('is not an address');
  expect(complaints).toEqual([]);
});
