// The element alone: on a plain static server without special headers, under a strict content
// security policy, from the npm tarball as users get it.

import { copyFileSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { ErrorDetail, GirthViewer } from '../../web/src/element/index.js';
import { packed } from '../web/package/packed.js';
import { box, gltf, stl, tube } from './meshes.js';
import { chromiumForTests, repository, serve, strictPolicy, type StaticServer } from './support.js';
import { fieldComplete, hover, loopByCommand, placeOnSurface } from './viewer-page.js';

const examples = join(repository, 'web/app/public/examples');
const site = mkdtempSync(join(tmpdir(), 'girth-element-'));

const head =
  '<!doctype html><meta charset="utf-8"><title>element</title><link rel="icon" href="data:,">';
const script = '<script type="module" src="girth/dist/girth-viewer.js"></script>';

/** A wrong value and a right one of each attribute that does not take any value. */
const attributes = {
  loading: ['later', 'lazy'],
  unit: ['furlong', 'mm'],
  'shown-unit': ['px', 'cm'],
  field: ['foo', 'sdf'],
  colormap: ['rainbow', 'magma'],
  range: ['zz', '5% 95%'],
  isolines: ['many', '10'],
  log: ['false', ''],
  method: ['quick', 'coarse'],
  persistence: ['-1%', '2%'],
  time: ['soon', '0.01'],
  energy: ['1000', '40'],
  component: ['0', '2'],
  loop: ['click', 'none'],
  pins: ['1 2', '1, 2'],
  tips: ['some', '#1'],
  parts: ['1', '1 2'],
  bottleneck: ['12', '1, 2'],
  profile: ['1', '1, 2, 3'],
  camera: ['back', 'top'],
  edges: ['no', ''],
  shading: ['gouraud', 'flat'],
  section: ['x', 'x 40%'],
  up: ['north', '-z'],
  'keep-view': ['off', ''],
  controls: ['zz', ''],
  turn: ['zz', ''],
} as const;
const attributesAs = (choose: (values: readonly [string, string]) => string): string =>
  Object.entries(attributes)
    .map(([name, values]) => `${name}="${choose(values)}"`)
    .join(' ');

const pages = {
  '/one.html': `${head}${script}<girth-viewer src="chair.glb"></girth-viewer>`,
  '/two.html': `${head}${script}<style>girth-viewer { width: 45%; display: inline-block }</style>
    <girth-viewer id="a" src="dumbbell.glb"></girth-viewer>
    <girth-viewer id="b" src="prism.obj" colormap="magma" loop="0 3"></girth-viewer>`,
  '/below.html': `${head}${script}<p style="height: 300vh"></p><girth-viewer src="dumbbell.glb"></girth-viewer>`,
  '/missing.html': `${head}${script}<girth-viewer src="nothing.glb"></girth-viewer>`,
  '/beside.html': `${head}${script}<girth-viewer src="parts/box.gltf"></girth-viewer>
    <girth-viewer id="open" src="tube.stl" unit="mm"></girth-viewer>`,
  // The last one is right.
  '/wrong.html': `${head}${script}<script type="module" src="/heard.js"></script>
    <girth-viewer id="a" src="prism.obj" ${attributesAs(([wrong]) => wrong)}></girth-viewer>
    <girth-viewer id="b" field="foo"></girth-viewer>
    <girth-viewer id="c" ${attributesAs(([, right]) => right)}></girth-viewer>`,
  '/heard.js': `globalThis.heard = [];
    for (const viewer of document.querySelectorAll('girth-viewer')) {
      viewer.addEventListener('error', ({ detail }) => heard.push([viewer.id, detail]));
    }`,
  '/noise.html': `${head}${script}<girth-viewer src="dumbbell.glb" persistence="3%"></girth-viewer>`,
  '/still.html': `${head}${script}<girth-viewer src="dumbbell.glb" field="none" loop="none"></girth-viewer>`,
};

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;
let complaints: string[];

beforeAll(async () => {
  for (const name of ['chair.glb', 'dumbbell.glb'])
    copyFileSync(join(examples, name), join(site, name));
  copyFileSync(join(repository, 'tests/data/prism.obj'), join(site, 'prism.obj'));
  const { json, bin } = gltf(box(3, 2, 2), 'data%20of%20it.bin');
  mkdirSync(join(site, 'parts'));
  writeFileSync(join(site, 'parts/box.gltf'), json);
  writeFileSync(join(site, 'parts/data of it.bin'), bin);
  writeFileSync(join(site, 'tube.stl'), stl(tube(12, 16, 4)));
  const folders = { '/girth/': packed().folder };
  server = await serve(site, { policy: strictPolicy, pages, folders });
});

afterAll(async () => {
  await server?.close();
  rmSync(site, { recursive: true });
});

afterEach(() => page.context().close());

async function open(path: string): Promise<void> {
  ({ page, complaints } = await openPage(server.url + path));
}

test('one script line and one tag: loads, computes in workers, shows the loop', async () => {
  await open('/one.html');
  const viewer = page.locator('girth-viewer');
  await fieldComplete(viewer);
  expect(await page.evaluate(() => crossOriginIsolated)).toBe(false);
  const place = await placeOnSurface(viewer, 0.5, 0.45);
  const shown = await hover(page, viewer, place.x, place.y);
  const truth = loopByCommand(join(examples, 'chair.glb'), shown.base);
  expect(shown.length).toBe(truth.length);
  // The threaded module is not even asked for.
  expect(server.requests.filter((path) => path.includes('threads'))).toEqual([]);
  expect(complaints).toEqual([]);

  const picture = await viewer.evaluate(async (element: GirthViewer) => {
    const blob = await element.snapshot();
    const bitmap = await createImageBitmap(blob);
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const pen = canvas.getContext('2d')!;
    pen.drawImage(bitmap, 0, 0);
    const { data } = pen.getImageData(0, 0, bitmap.width, bitmap.height);
    const colours = new Set<number>();
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 3]! > 250) colours.add((data[i]! << 16) | (data[i + 1]! << 8) | data[i + 2]!);
    }
    return { type: blob.type, colours: colours.size };
  });
  expect(picture.type).toBe('image/png');
  expect(picture.colours).toBeGreaterThan(500);
});

test('two on one page: each its own model, one kernel', async () => {
  await open('/two.html');
  const [a, b] = [page.locator('#a'), page.locator('#b')];
  await fieldComplete(a);
  await fieldComplete(b);
  expect(await a.evaluate((element: GirthViewer) => element.info!.name)).toBe('dumbbell.glb');
  const shown = await b.evaluate(async (element: GirthViewer) => {
    const values = element.values('igf');
    const loop = await element.loop(3);
    return { value: values[3], length: loop.length, closed: loop.polyline.length / 3 };
  });
  expect(shown.length).toBe(shown.value);
  expect(shown.length).toBe(loopByCommand(join(site, 'prism.obj'), 3).length);
  await expect.poll(() => b.locator('.tag').count()).toBe(2);
  const cores = await page.evaluate(() => navigator.hardwareConcurrency);
  // One for each core, one for the pointer, two for jobs (each model is read by one), and an idle one.
  const most = Math.min(8, cores) + 4;
  await expect.poll(() => page.workers().length).toBeLessThanOrEqual(most);
  await a.evaluate((element: GirthViewer) => element.remove());
  await b.evaluate((element: GirthViewer) => element.pinned.forEach(({ id }) => element.unpin(id)));
  expect((await hoverAnywhere(b)).length).toBeGreaterThan(0);
  expect(complaints).toEqual([]);
});

async function hoverAnywhere(viewer: ReturnType<Page['locator']>) {
  const place = await placeOnSurface(viewer, 0.5, 0.5);
  return hover(page, viewer, place.x, place.y);
}

test('fields, tips and parts of a real model, and a picture of its thinnest place', async () => {
  await open('/one.html');
  const viewer = page.locator('girth-viewer');
  await fieldComplete(viewer);
  const found = await viewer.evaluate(async (element: GirthViewer) => {
    const changed = new Promise<string[]>((done) =>
      element.addEventListener('fieldchange', () => {
        const key = element.shadowRoot!.querySelectorAll('.legend li');
        if (element.thresholds && key.length > 0) done(Array.from(key, (li) => li.textContent));
      }),
    );
    element.setAttribute('field', 'parts');
    const key = await changed;
    const { tips } = await element.tips();
    await element.showTips({ shown: true, selected: 0 });
    const sdf = await element.fieldOf('sdf');
    const { places: weak } = await element.printCheck({ tubeDiameter: 0.05, wallThickness: 0 });
    const { vertices, thinnest, least } = weak[0]!;
    const picture = await element.snapshotOf({ vertices, loop: await element.loop(thinnest) });
    const words = new TextDecoder();
    return {
      key,
      apexes: tips.map(({ apex }) => apex),
      thickest: sdf.range[1],
      least,
      girth: element.values('igf')[thinnest as number],
      picture: picture.size,
      rows: words.decode(await element.exportFields(['igf', 'sdf'], 'csv')).split('\n')[0],
    };
  });
  expect(found.key).toEqual(['body', 'tube', 'plate', 'unknown']);
  // One at the end of each leg.
  expect(found.apexes).toHaveLength(4);
  expect(found.thickest).toBeGreaterThan(0.1);
  // The least width of the section, where that is less than the girth by π.
  expect(found.least).toBeLessThanOrEqual(found.girth! / Math.PI);
  expect(found.least).toBeGreaterThan(found.girth! / 8);
  expect(found.picture).toBeGreaterThan(5000);
  expect(found.rows).toMatch(/^vertex,igf,kind,sdf/);
  expect(complaints).toEqual([]);
});

test('persistence: of the girth, of loops and of pinned ones', async () => {
  await open('/noise.html');
  await fieldComplete(page.locator('girth-viewer'));
  const result = await page.evaluate(async () => {
    const viewer = document.querySelector<GirthViewer>('girth-viewer')!;
    const persistent = await viewer.fieldOf('igf');
    const vertex = 7;
    const { id } = await viewer.pin(vertex);
    const lengthOf = () => viewer.pinned.find((one) => one.id === id)!.loop.length;
    const lengths = [lengthOf(), (await viewer.loop(vertex)).length];
    viewer.removeAttribute('persistence');
    const plain = await viewer.fieldOf('igf');
    const loop = await viewer.loop(vertex);
    while (lengthOf() !== loop.length) await new Promise((resolve) => setTimeout(resolve, 10));
    return {
      tau: [persistent.persistence, 0.03 * Math.sqrt(viewer.info!.area)],
      plainTau: plain.persistence ?? 0,
      ofPoint: [persistent.values[vertex], ...lengths],
      plainOfPoint: [plain.values[vertex], loop.length],
      isLess: persistent.values.some((value, v) => value < plain.values[v]!),
      isMore: persistent.values.some((value, v) => value > plain.values[v]!),
    };
  });
  expect(result.tau[0]).toBeCloseTo(result.tau[1]!, 12);
  expect(result.plainTau).toBe(0);
  expect(new Set(result.ofPoint).size).toBe(1);
  expect(new Set(result.plainOfPoint).size).toBe(1);
  expect(result).toMatchObject({ isLess: false, isMore: true });
});

test('nothing is fetched or computed before the element is in view', async () => {
  await open('/below.html');
  const before = server.requests.length;
  await page.waitForTimeout(500);
  expect(server.requests.slice(before).filter((path) => path.endsWith('.glb'))).toEqual([]);
  const viewer = page.locator('girth-viewer');
  expect(await viewer.evaluate((element: GirthViewer) => element.info)).toBeUndefined();
  await viewer.evaluate((element: GirthViewer) => element.scrollIntoView());
  await fieldComplete(viewer);
});

test('a glTF’s buffer is fetched from beside it; boundaries and units', async () => {
  await open('/beside.html');
  const [boxed, tubed] = [page.locator('girth-viewer').first(), page.locator('#open')];
  await fieldComplete(boxed);
  expect(await boxed.evaluate(({ info }: GirthViewer) => info!.faceCount)).toBe(64);
  expect(server.requests).toContain('/parts/data of it.bin');
  await tubed.evaluate((element) => element.scrollIntoView());
  await fieldComplete(tubed);
  expect(await tubed.evaluate(({ info }: GirthViewer) => info!.boundaries)).toEqual([2]);
  expect(await tubed.locator('.legend-title').textContent()).toBe('Girth, mm');
  const csv = await tubed.evaluate(async (element: GirthViewer) =>
    new TextDecoder().decode(await element.exportField('csv')),
  );
  // A row for every corner of the STL.
  expect(csv.trim().split('\n')).toHaveLength(1 + 3 * 352);
  expect(complaints).toEqual([]);
});

test('a missing file is said in words and sent as an event', async () => {
  await open('/missing.html');
  const message = page.locator('girth-viewer').getByRole('alert');
  await message.waitFor();
  expect(await message.textContent()).toContain('nothing.glb could not be used.');
  expect(await message.getAttribute('data-code')).toBe('FILE_NOT_FOUND');
});

test('events tell the story; a plain surface computes nothing', async () => {
  await open('/still.html');
  const viewer = page.locator('girth-viewer');
  await expect
    .poll(() => viewer.evaluate((element: GirthViewer) => element.info?.name))
    .toBe('dumbbell.glb');
  await page.waitForTimeout(300);
  expect(
    await viewer.evaluate((element: GirthViewer) => element.values('igf').every(Number.isNaN)),
  ).toBe(true);
  const events = await viewer.evaluate(async (element: GirthViewer) => {
    const seen: string[] = [];
    let last = 0;
    for (const name of ['load', 'progress', 'field', 'pick', 'error']) {
      element.addEventListener(name, (event) => {
        if (seen.at(-1) !== name) seen.push(name);
        if (name === 'progress') {
          const { fraction } = (event as CustomEvent<{ fraction: number }>).detail;
          if (fraction < last) seen.push('progress fell');
          last = fraction;
        }
      });
    }
    const done = new Promise((resolve) => element.addEventListener('field', resolve));
    element.removeAttribute('field');
    await done;
    await element.pin(0);
    await element.load('missing.glb').catch(() => undefined);
    return seen;
  });
  expect(events).toEqual(['progress', 'field', 'pick', 'error']);
});

test('a wrong attribute is one warning on the console and an error on each element, and counts as none', async () => {
  const warnings: string[] = [];
  ({ page, complaints } = await openPage(`${server.url}/wrong.html`, {}, async (page) => {
    page.on('console', (message) => {
      if (message.type() === 'warning') warnings.push(message.text());
    });
    await Promise.resolve();
  }));
  const viewer = page.locator('#a');
  await fieldComplete(viewer);
  const names = Object.keys(attributes);
  expect(names.concat('src', 'poster', 'field-title', 'linked', 'one-scale').sort()).toEqual(
    await viewer.evaluate((element) =>
      (element.constructor as typeof GirthViewer).observedAttributes.slice().sort(),
    ),
  );

  const said = warnings.filter((text) => text.startsWith('<girth-viewer>'));
  expect(said).toHaveLength(names.length);
  for (const [name, [wrong]] of Object.entries(attributes)) {
    expect(said.filter((text) => text.includes(` ${name}="${wrong}" `))).toHaveLength(1);
  }
  expect(said.join()).toContain('field can be igf, sdf, thickness, ');

  type Heard = [id: string, detail: ErrorDetail][];
  const heard = await page.evaluate(() => (globalThis as unknown as { heard: Heard }).heard);
  const of = (id: string) => heard.filter(([one]) => one === id).map(([, detail]) => detail);
  expect(of('a').map(({ attribute }) => attribute)).toEqual(names);
  expect(of('b').map(({ attribute }) => attribute)).toEqual(['field']);
  expect(of('c')).toEqual([]);
  expect(new Set(heard.map(([, { code }]) => code))).toEqual(new Set(['INVALID_OPTION']));

  // As if none of them were there.
  const shown = await viewer.evaluate((element: GirthViewer) => {
    const { shown, unit, shownUnit, upAxis } = element;
    const { name, colormap, log } = shown!;
    return { name, colormap, log, unit, shownUnit, up: upAxis?.by };
  });
  expect(shown).toEqual({
    ...{ name: 'igf', colormap: 'viridis', log: false, unit: '', shownUnit: '', up: 'format' },
  });
  expect(await viewer.locator('.bar-tools').isVisible()).toBe(false);
  expect(complaints).toEqual([]);
});
