// Real files on the page: several at once, folders and zips; what was done to them, and what can be
// done with them; and what is written.

import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { strToU8, unzipSync, zipSync } from 'fflate';
import type { Locator, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { beside, box, gltf, stl, tube } from './meshes.js';
import { openPanel, picture, site } from './page-support.js';
import {
  chromiumForTests,
  requireBuilt,
  serve,
  strictPolicy,
  type StaticServer,
} from './support.js';
import { fieldComplete, hover, placeOnSurface } from './viewer-page.js';

const scratch = mkdtempSync(join(tmpdir(), 'girth-files-'));

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;
let viewer: Locator;
let complaints: string[];

beforeAll(async () => {
  requireBuilt('build/page/index.html', 'build:page');
  server = await serve(site, { policy: strictPolicy });
  ({ page, complaints } = await openPage(server.url));
  viewer = page.locator('girth-viewer');
  await modelIs('chair.glb');
});
afterAll(async () => {
  await page?.context().close();
  await server?.close();
  rmSync(scratch, { recursive: true });
});
afterEach(() => expect(complaints.splice(0)).toEqual([]));

const modelIs = (name: string) =>
  page.locator('#model b').getByText(name, { exact: true }).waitFor({ timeout: 30_000 });
const modelLine = () => page.locator('#model').textContent();
const details = () => page.locator('#details');

/** Opens the sheet of the model. */
async function openDetails(): Promise<Locator> {
  if (!(await details().isVisible())) await page.locator('#details-open').click();
  await details().waitFor();
  return details();
}

interface Given {
  name: string;
  content: string | Uint8Array;
}

/** Chooses files as in the browser's dialog, with nothing lying over the surface. */
async function choose(...files: Given[]): Promise<void> {
  await page.evaluate(() => {
    for (const sheet of document.querySelectorAll<HTMLElement>(':popover-open'))
      sheet.hidePopover();
  });
  const payload = files.map(({ name, content }) => ({
    name,
    mimeType: '',
    buffer: Buffer.from(content),
  }));
  await page.locator('#file').setInputFiles(payload);
}

describe('what is opened', () => {
  const { json, bin } = gltf(box(3, 2, 2), 'box data.bin');

  test('several files: a glTF with its buffer', async () => {
    await choose({ name: 'box data.bin', content: bin }, { name: 'box.gltf', content: json });
    await modelIs('box.gltf');
    expect(await modelLine()).toContain('box.gltf · 64 faces · genus 0');
  });

  test('a zip with folders', async () => {
    const archive = zipSync({
      'model/zipped.gltf': strToU8(json),
      'model/box data.bin': bin,
      'model/colours.png': strToU8('no picture'),
      '__MACOSX/model/._box.gltf': strToU8('x'),
    });
    await choose({ name: 'download.zip', content: archive });
    await modelIs('zipped.gltf');
  });

  test('a folder', async () => {
    const folder = join(scratch, 'folder');
    mkdirSync(join(folder, 'buffers'), { recursive: true });
    const elsewhere = gltf(box(3, 2, 2), 'buffers/box.bin');
    writeFileSync(join(folder, 'in-folder.gltf'), elsewhere.json);
    writeFileSync(join(folder, 'buffers/box.bin'), elsewhere.bin);
    await page.locator('#folder').setInputFiles(folder);
    await modelIs('in-folder.gltf');
  });

  test('a file that is referred to and absent is named; the former model stays', async () => {
    await choose({ name: 'first.obj', content: box(2, 2, 2) });
    await modelIs('first.obj');
    for (const files of [
      [{ name: 'box.gltf', content: json }],
      [{ name: 'box.zip', content: zipSync({ 'box.gltf': strToU8(json) }) }],
    ]) {
      await choose(...files);
      const message = viewer.getByRole('alert');
      await message.waitFor();
      expect(await message.getAttribute('data-code')).toBe('MISSING_RESOURCE');
      const words = await message.textContent();
      expect(words).toContain('box data.bin');
      expect(words).toContain('What helps:');
      expect(words).toContain('The former model is still here.');
      await message.getByRole('button').click();
    }
    await modelIs('first.obj');
  });

  test('of several models the first is shown, and the others can be chosen', async () => {
    const archive = zipSync({
      'parts/b.obj': strToU8(box(2, 2, 2)),
      'parts/a.stl': stl(box(4, 3, 2)),
      'readme.txt': strToU8('two parts'),
    });
    await choose({ name: 'parts.zip', content: archive });
    await modelIs('a.stl');
    const sheet = await openDetails();
    const select = sheet.getByLabel('Model', { exact: true });
    expect(await select.locator('option').allTextContents()).toEqual([
      'parts/a.stl',
      'parts/b.obj',
    ]);
    await select.selectOption('parts/b.obj');
    await modelIs('b.obj');
    expect(await modelLine()).toContain('48 faces');
  });

  test('a zip that would fill the memory is refused in words', async () => {
    const bomb = Buffer.from(zipSync({ 'zeros.stl': new Uint8Array(2 ** 20) }));
    // As many zeros would take no more room in the zip: its directory says that there are.
    bomb.writeUInt32LE(2 ** 30, bomb.indexOf('PK\x01\x02') + 24);
    await choose({ name: 'bomb.zip', content: bomb });
    const message = viewer.getByRole('alert');
    await message.waitFor();
    expect(await message.getAttribute('data-code')).toBe('LIMIT_EXCEEDED');
    expect(await message.textContent()).toContain('bomb.zip could not be used.');
    await message.getByRole('button').click();
  });
});

describe('what was done', () => {
  test('a soup: its seams are welded, and the account says so', async () => {
    await choose({ name: 'soup.stl', content: stl(box(4, 3, 2)) });
    await modelIs('soup.stl');
    const sheet = await openDetails();
    expect(await sheet.textContent()).toContain('258 vertices welded');
    expect(await sheet.locator('dd').getByText('STL', { exact: true }).isVisible()).toBe(true);
    expect(await sheet.textContent()).toContain('4.000 × 3.000 × 2.000');
  });

  test('an open tube: its boundary, its loops, and the unit on every length', async () => {
    const sides = 24;
    await choose({ name: 'tube.obj', content: tube(30, sides, 8) });
    await modelIs('tube.obj');
    expect(await modelLine()).toContain('2 open boundaries');
    await fieldComplete(viewer);
    const place = await placeOnSurface(viewer, 0.5, 0.5);
    const perimeter = 2 * sides * Math.sin(Math.PI / sides);
    const shown = await hover(page, viewer, place.x, place.y);
    expect(shown.kind).toBe('loop');
    expect(shown.length).toBeCloseTo(perimeter, 9);
    await openPanel(page, 'loops');
    await page.mouse.click(place.x, place.y);
    await page.locator('#loops tbody tr').waitFor();
    await picture(page, 'page-open-tube.png');

    const sheet = await openDetails();
    await sheet.getByLabel('Unit of the file').selectOption('mm');
    expect(await sheet.textContent()).toMatch(/2\.000 × 2\.000 × 8\.000\smm/);
    await picture(page, 'page-details.png');
    await page.keyboard.press('Escape');
    expect(await viewer.locator('.legend-title').textContent()).toBe('Girth, mm');
    expect(await page.locator('#loops thead').textContent()).toContain('Girth, mm');
    expect(await viewer.locator('.tag').textContent()).toMatch(/\d\smm/);
    expect(await page.locator('#field .caption').textContent()).toMatch(/\d\smm$/);
    expect(await page.locator('#range-high').inputValue()).toMatch(/\d\smm$/);
    expect((await hover(page, viewer, place.x, place.y)).text).toMatch(/\d\smm/);

    // Another model has a unit of its own.
    await choose({ name: 'box.obj', content: box(3, 2, 2) });
    await modelIs('box.obj');
    await fieldComplete(viewer);
    expect(await viewer.locator('.legend-title').textContent()).toBe('Girth');
  });

  test('holes are closed on demand, and the unit stays', async () => {
    await choose({ name: 'open.obj', content: tube(12, 24, 4) });
    await modelIs('open.obj');
    const sheet = await openDetails();
    await sheet.getByLabel('Unit of the file').selectOption('in');
    await sheet.getByRole('button', { name: 'Close 2 holes' }).click();
    await expect.poll(modelLine).not.toContain('open boundaries');
    await fieldComplete(viewer);
    expect(await viewer.locator('.legend-title').textContent()).toBe('Girth, in');
    await openDetails();
    expect(await sheet.textContent()).toMatch(
      /A hole of 24 edges closed, length of its boundary 6\.\d+\sin/,
    );
    await sheet.getByRole('button', { name: 'Back to the file' }).click();
    await expect.poll(modelLine).toContain('2 open boundaries');
  });

  test('cracks of one rounding are named with the distance that closes them, and sewn', async () => {
    const corners = ['0 0 0', '0.3 0 0', '0 0.3 0', '0 0 0.3'];
    const facets = ['0 2 1', '0 1 3', '0 3 2', '1 2 3'].map((facet, i) => {
      const points = facet.split(' ').map((corner) => corners[Number(corner)]!);
      const apart = points.map((point) =>
        i === 3 ? point.replace('0.3', '0.30000000000000004') : point,
      );
      return `facet normal 0 0 0 outer loop vertex ${apart.join(' vertex ')} endloop endfacet`;
    });
    const content = ['solid crack', ...facets, 'endsolid crack'].join('\n');
    await choose({ name: 'crack.stl', content });
    await modelIs('crack.stl');
    const sheet = await openDetails();
    expect(await sheet.textContent()).toMatch(/A weld distance of 0\.0{16}\d\d closes the cracks/);
    await sheet.getByRole('button', { name: 'Sew the cracks' }).click();
    await expect.poll(modelLine).not.toContain('open boundaries');
    await fieldComplete(viewer);
    expect(await page.locator('#range-high').inputValue()).toBe('0.8196');
  });

  test('remeshed: another count of faces, as near as the paper measures it; and back', async () => {
    await choose({ name: 'part.obj', content: box(10, 4, 4) });
    await modelIs('part.obj');
    await fieldComplete(viewer);
    const sheet = await openDetails();
    await sheet.getByLabel('Remesh to').fill('800');
    await sheet.getByRole('button', { name: 'Remesh', exact: true }).click();
    await expect.poll(modelLine).not.toContain('384 faces');
    await fieldComplete(viewer);
    const { faceCount } = await viewer.evaluate(({ info }: GirthViewer) => info!);
    expect(Math.abs(faceCount - 800)).toBeLessThan(40);
    await openDetails();
    expect(await sheet.textContent()).toContain('Remeshed from 384 to about 800 faces');
    const difference = sheet.getByText(/The distribution of its girth differs from that before by/);
    await difference.waitFor();
    const written = /by ([\d.e−]+)/.exec((await difference.textContent())!)![1]!;
    expect(Number(written.replace('−', '-'))).toBeLessThan(0.05);
    await sheet.getByRole('button', { name: 'Back to the file' }).click();
    await expect.poll(modelLine).toContain('384 faces');
  });

  test('components: all are analysed, and some can be chosen', async () => {
    await choose({ name: 'two.obj', content: beside(box(3, 2, 2), box(4, 4, 2), 10) });
    await modelIs('two.obj');
    expect(await modelLine()).toContain('192 faces · 2 components');
    const sheet = await openDetails();
    const boxes = sheet.getByRole('checkbox');
    expect(await boxes.count()).toBe(2);
    const keep = sheet.getByRole('button', { name: 'Keep these' });
    expect(await keep.isDisabled()).toBe(true);
    // The largest comes first.
    await boxes.nth(0).uncheck();
    await keep.click();
    await expect.poll(modelLine).toContain('two.obj · 64 faces · genus 0');
    await fieldComplete(viewer);
    await openDetails();
    expect(await sheet.textContent()).toContain('1 of 2 components kept');
    await sheet.getByRole('checkbox').nth(0).check();
    await sheet.getByRole('button', { name: 'Keep these' }).click();
    await expect.poll(modelLine).toContain('2 components');
  });
});

describe('what is written', () => {
  /** Clicks an entry of the menu and takes the file. */
  async function exported(group: string, format: string): Promise<{ name: string; bytes: Buffer }> {
    if (!(await page.locator('#export').isVisible())) {
      await page.getByRole('button', { name: 'Export' }).click();
    }
    const coming = page.waitForEvent('download');
    await page.locator(`#export-${group} [data-format=${format}]`).click();
    const download = await coming;
    return {
      name: download.suggestedFilename(),
      bytes: readFileSync(await download.path()),
    };
  }

  test('the field and loops, and all of it can be read again', async () => {
    const content = stl(tube(12, 16, 4));
    await choose({ name: 'tube.stl', content });
    await modelIs('tube.stl');
    await fieldComplete(viewer);
    const truth = await viewer.evaluate((element: GirthViewer) => ({
      values: [...element.values('igf')],
      vertexOfInput: [...element.vertexOfInput],
    }));
    const ofInput = truth.vertexOfInput.map((vertex) => truth.values[vertex]!);
    expect(ofInput).toHaveLength(3 * (content.length - 84) * (1 / 50));

    const csv = await exported('field', 'csv');
    expect(csv.name).toBe('tube-igf.csv');
    const rows = csv.bytes.toString().trim().split('\n');
    expect(rows[0]).toBe('vertex,igf,kind');
    expect(rows.slice(1).map((row) => Number(row.split(',')[1]))).toEqual(ofInput);

    const npy = await exported('field', 'npy');
    expect(npy.bytes.subarray(0, 6).toString('latin1')).toBe('\x93NUMPY');
    const start = 10 + npy.bytes.readUInt16LE(8);
    const numbers = ofInput.map((_, i) => npy.bytes.readDoubleLE(start + 8 * i));
    expect(numbers).toEqual(ofInput);

    const json = JSON.parse((await exported('field', 'json')).bytes.toString()) as {
      igf: number[];
      file: string;
    };
    expect(json.igf).toEqual(ofInput);
    expect(json.file).toBe('tube.stl');

    const place = await placeOnSurface(viewer, 0.5, 0.5);
    await openPanel(page, 'loops');
    await page.mouse.click(place.x, place.y);
    await page.locator('#loops tbody tr').waitFor();
    const loop = await exported('loops', 'obj');
    expect(loop.name).toBe('tube-loops.obj');
    expect(loop.bytes.toString()).toMatch(/^v [\s\S]*\nl 1 2 .* 1\n$/);
    await page.keyboard.press('Escape');
    await viewer.evaluate((element: GirthViewer) => element.pin(0));
    const loops = await exported('loops', 'json');
    expect(loops.name).toBe('tube-loops.json');
    const { loops: both } = JSON.parse(loops.bytes.toString()) as { loops: { length: number }[] };
    expect(both[1]!.length).toBe(truth.values[0]);
    const lines = await exported('loops', 'obj');
    expect(lines.name).toBe('tube-loops-obj.zip');
    const entries = Object.keys(unzipSync(lines.bytes));
    expect(entries).toEqual(['tube-loops-1.obj', 'tube-loops-2.obj']);

    const picture = await exported('picture', 'png');
    expect(picture.bytes.subarray(1, 4).toString()).toBe('PNG');

    // Files that we write we read: the same surface, and from PLY the same bits.
    const ply = await exported('field', 'ply');
    const glb = await exported('field', 'glb');
    const before = await viewer.evaluate(({ info }: GirthViewer) => info!);
    for (const { name, bytes } of [ply, glb]) {
      await choose({ name, content: bytes });
      await modelIs(name);
      const after = await viewer.evaluate(({ info }: GirthViewer) => info!);
      expect(after.report.weldedVertices).toBe(0);
      expect([after.vertexCount, after.faceCount, after.boundaries]).toEqual([
        before.vertexCount,
        before.faceCount,
        before.boundaries,
      ]);
    }
    // It was unknown, and stays so.
    expect(await viewer.evaluate(({ info }: GirthViewer) => info!.unit)).toBe('');
  });
});
