// Files that have their values in them: shown at once, without anything that computes; and computed when asked for.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { packed } from '../web/package/packed.js';
import { glbWith } from './glb.js';
import { box, dumbbell } from './meshes.js';
import { chromiumForTests, command, serve, strictPolicy, type StaticServer } from './support.js';
import { hover, loopByCommand, placeOnSurface } from './viewer-page.js';

/** Bytes, packed by gzip, that are fetched for the first picture, without the model. */
const mostOfFirstPicture = 200_000;

const site = mkdtempSync(join(tmpdir(), 'girth-figure-'));
const figureFile = join(site, 'figure.glb');
const head =
  '<!doctype html><meta charset="utf-8"><title>figure</title><link rel="icon" href="data:,">';
const script = '<script type="module" src="girth/dist/girth-viewer.js"></script>';
const element = (attributes: string): string =>
  `${head}${script}<girth-viewer ${attributes} style="width: 480px"></girth-viewer>`;
const pages = {
  '/figure.html': element('src="figure.glb"'),
  '/heat.html': element('src="heat.glb"'),
  '/soup.html': element('src="soup.glb" field="_heat"'),
  '/none.html': element('src="heat.glb" field="_cold"'),
  '/sdf.html': element('src="figure.glb" field="sdf"'),
};

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;
let complaints: string[];

beforeAll(async () => {
  const model = join(site, 'dumbbell.obj');
  writeFileSync(model, dumbbell(16, 12));
  const arguments_ = ['igf', model, '--unit', 'mm', '-o', figureFile, '--loops', '5,100', '--tips'];
  execFileSync(command, arguments_);
  const heat = { _HEAT: (vertex: number) => 20 + vertex };
  writeFileSync(join(site, 'heat.glb'), glbWith(box(3, 2, 2), heat));
  // Every corner for itself, as with flat light.
  writeFileSync(join(site, 'soup.glb'), glbWith(cornersApart(box(2, 2, 2)), heat));
  server = await serve(site, {
    policy: strictPolicy,
    pages,
    folders: { '/girth/': packed().folder },
  });
});

afterAll(async () => {
  await server?.close();
  rmSync(site, { recursive: true });
});

afterEach(() => page.context().close());

/** A surface whose faces have three vertices of their own each. */
function cornersApart(obj: string): string {
  const lines = obj.trim().split('\n');
  const points = lines.filter((line) => line.startsWith('v '));
  const corners = lines
    .filter((line) => line.startsWith('f '))
    .flatMap((line) => line.slice(2).split(' ').map(Number));
  const faces = corners.flatMap((_, i) => (i % 3 === 0 ? [`f ${i + 1} ${i + 2} ${i + 3}`] : []));
  return [...corners.map((corner) => points[corner - 1]), ...faces].join('\n');
}

/** Opens a page, and gives what it asks for from then on. */
async function open(path: string): Promise<() => string[]> {
  const before = server.requests.length;
  ({ page, complaints } = await openPage(server.url + path));
  return () => server.requests.slice(before);
}

const viewerOf = () => page.locator('girth-viewer');
const legend = () => viewerOf().locator('.legend').innerText();
const computes = (path: string): boolean => /\.wasm$|girth-kernel|worker/.test(path);

test('values, legend, loops and tips of a file are shown, and nothing that computes is fetched', async () => {
  const asked = await open('/figure.html');
  await expect.poll(legend).toContain('Girth, mm');
  await expect.poll(() => viewerOf().locator('.tag').count()).toBe(2);
  const shown = await viewerOf().evaluate(async (viewer: GirthViewer) => {
    const { info, shown } = viewer;
    const areas = await viewer.areas();
    const { tips } = await viewer.tips();
    return {
      range: shown!.range,
      values: [...viewer.values('igf')],
      whole: await viewer.fieldOf('igf').then(({ method, kinds }) => [method, kinds.length]),
      area: [areas.reduce((sum, area) => sum + area), info!.area],
      counts: [info!.vertexCount, info!.faceCount, info!.edgeCount, info!.components],
      topology: [info!.genus, info!.boundaries],
      tips: tips.map(({ jump }) => jump),
      lengths: viewer.pinned.map(({ loop }) => loop.length),
    };
  });
  const truth = JSON.parse(
    execFileSync(command, ['info', figureFile, '--json'], { encoding: 'utf8' }),
  ) as { vertices: number; faces: number; genus: number[] };
  const [vertexCount, faceCount, edgeCount] = shown.counts as [number, number, number];
  expect(vertexCount).toBe(truth.vertices);
  expect(faceCount).toBe(truth.faces);
  expect(2 * edgeCount).toBe(3 * faceCount);
  expect(shown.topology).toEqual([[0], [0]]);
  expect(shown.area[0]).toBeCloseTo(shown.area[1]!, 9);
  expect(shown.whole).toEqual(['exact', vertexCount]);
  // In metres, as the command reads the same file, rounded to 32 bits.
  for (const [vertex, length] of [5, 100].map(
    (vertex, i) => [vertex, shown.lengths[i]!] as const,
  )) {
    const { length: exact } = loopByCommand(figureFile, vertex);
    expect(length / exact).toBeCloseTo(1, 5);
    expect(shown.values[vertex]! / exact).toBeCloseTo(1, 5);
  }
  const tips = JSON.parse(
    execFileSync(command, ['tips', figureFile, '--json'], { encoding: 'utf8' }),
  ) as { tips: { jump: number }[] };
  expect(shown.tips).toHaveLength(tips.tips.length);
  tips.tips.forEach(({ jump }, i) => expect(shown.tips[i]! / jump).toBeCloseTo(1, 4));
  expect(asked().filter(computes)).toEqual([]);

  const scripts = asked().filter((path) => path.startsWith('/girth/'));
  const bytes = scripts.reduce((sum, path) => {
    return sum + gzipSync(readFileSync(join(packed().folder, path.slice('/girth/'.length)))).length;
  }, 0);
  console.info(`first picture: ${bytes} bytes by gzip in ${scripts.length} files`);
  expect(bytes).toBeLessThanOrEqual(mostOfFirstPicture);
  expect(complaints).toEqual([]);
});

test('a pointer brings the loop under it; the view and what is pinned stay', async () => {
  await open('/figure.html');
  const viewer = viewerOf();
  await expect.poll(() => viewer.locator('.tag').count()).toBe(2);
  await viewer.evaluate((viewer: GirthViewer) => {
    viewer.camera = { ...viewer.camera!, azimuth: 0.8 };
    viewer.nameLoop(viewer.pinned[1]!.id, 'waist');
    Object.assign(globalThis, { loads: 0 });
    viewer.addEventListener('load', () => ++(globalThis as unknown as { loads: number }).loads);
  });
  await viewer.hover({ position: { x: 5, y: 5 } });
  // From now on, loops are those of the kernel.
  await expect
    .poll(() => viewer.evaluate((viewer: GirthViewer) => viewer.pinned[0]?.loop.length))
    .toBe(loopByCommand(figureFile, 5).length);
  await expect
    .poll(() => viewer.evaluate((viewer: GirthViewer) => viewer.pinned.map(({ name }) => name)))
    .toEqual(['', 'waist']);
  const place = await placeOnSurface(viewer, 0.5, 0.5);
  const shown = await hover(page, viewer, place.x, place.y);
  expect(shown.length).toBe(loopByCommand(figureFile, shown.base).length);
  const kept = await viewer.evaluate(async (viewer: GirthViewer) => {
    const rounded = viewer.values('igf')[5]!;
    const { tips } = await viewer.tips();
    const field = await viewer.fieldOf('igf');
    return {
      azimuth: viewer.camera!.azimuth,
      loads: (globalThis as unknown as { loads: number }).loads,
      change: field.values[5]! / rounded,
      exact: field.values[5]!,
      tips: tips.length,
    };
  });
  expect(kept.azimuth).toBeCloseTo(0.8, 6);
  expect(kept.loads).toBe(0);
  expect(kept.change).toBeCloseTo(1, 5);
  expect(kept.exact).toBe(loopByCommand(figureFile, 5).length);
  expect(complaints).toEqual([]);
});

test('a field that the file does not have is computed when it is asked for', async () => {
  await open('/sdf.html');
  await expect.poll(legend).toContain('Shape diameter');
  // The legend is there with the first values.
  const known = () =>
    viewerOf().evaluate((viewer: GirthViewer) => ({
      sdf: viewer.values('sdf').every((value) => value > 0),
      igf: viewer.values('igf').every((value) => value > 0),
    }));
  await expect.poll(known).toEqual({ sdf: true, igf: true });
  expect(complaints).toEqual([]);
});

test('values of any name are shown under it', async () => {
  const asked = await open('/heat.html');
  await expect.poll(legend).toContain('Heat');
  const shown = await viewerOf().evaluate(({ shown }: GirthViewer) => shown!);
  expect(shown.name).toBe('_heat');
  expect(shown.extent).toEqual([20, 20 + 33]);
  expect(asked().filter(computes)).toEqual([]);
  // Others are computed.
  await viewerOf().evaluate((viewer) => viewer.setAttribute('field', 'igf'));
  await expect.poll(legend).toContain('Girth');
  await viewerOf().evaluate((viewer) => viewer.setAttribute('field', '_HEAT'));
  await expect.poll(legend).toContain('Heat');
  expect(complaints).toEqual([]);
});

test('a surface that has to be mended first is read by the kernel, and has its values all the same', async () => {
  const asked = await open('/soup.html');
  await expect.poll(legend).toContain('Heat');
  const { count, range } = await viewerOf().evaluate(({ info, shown }: GirthViewer) => ({
    count: info!.vertexCount,
    range: shown!.extent!,
  }));
  expect(count).toBe(26);
  expect(range[0]).toBeGreaterThanOrEqual(20);
  expect(asked().some(computes)).toBe(true);
  expect(complaints).toEqual([]);
});

test('values that the file does not have are said to be missing, with those that there are', async () => {
  await open('/none.html');
  const message = viewerOf().getByRole('alert');
  await message.waitFor();
  expect(await message.textContent()).toContain('no values called _cold');
  expect(await message.textContent()).toContain('it has _heat');
});
