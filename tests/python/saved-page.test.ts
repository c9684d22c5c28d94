// Pages that `pygirth.show` saves, opened from the disk in a browser that has no network.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterAll, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { installedPython } from '../../web/scripts/python.mjs';
import { placeOnSurface } from '../browser/viewer-page.js';
import { chromiumForTests, repository } from '../browser/support.js';

const folder = mkdtempSync(join(tmpdir(), 'girth-saved-'));
afterAll(() => rmSync(folder, { recursive: true }));
const open = chromiumForTests();

/** Runs lines of Python, which save page.html, and opens it; `python` gives what they print. */
async function openPage(lines: string[]) {
  const program = ['import pygirth, json, numpy as np', 'from shapes import *', ...lines].join(
    '\n',
  );
  const python = execFileSync(join(repository, installedPython), ['-c', program], {
    cwd: folder,
    encoding: 'utf8',
    env: { ...process.env, PYTHONPATH: join(repository, 'tests/python') },
  });
  const requests: string[] = [];
  const opened = await open(pathToFileURL(join(folder, 'page.html')).href, {}, async (page) => {
    page.on('request', (request) => requests.push(request.url()));
    await page.context().setOffline(true);
  });
  const frame = opened.page.frames().at(-1)!;
  await frame.waitForFunction(() => {
    const viewer = document.querySelector('girth-viewer');
    return viewer?.info && (viewer.shown || viewer.getAttribute('field') === 'none');
  });
  const viewer = frame.locator('girth-viewer');
  const fetched = requests.filter((url) => !/^(file|data|blob|about):/.test(url));
  return { ...opened, python, frame, viewer, fetched };
}

const legendOf = (element: GirthViewer) =>
  element.shadowRoot!.querySelector('.legend, [class*=legend]')?.textContent ?? '';

test('a saved page shows the values of the girth, bit for bit, and fetches nothing', async () => {
  const { python, viewer, page, fetched, complaints } = await openPage([
    'm = pygirth.Mesh(*torus(), unit="metre")',
    'f = m.igf()',
    'pygirth.show(f, name="Ring", loops=[100], points=[3, 5]).save("page.html")',
    'print(json.dumps({"values": f.values.tolist(), "length": m.loop(100).length}))',
  ]);
  const { values, length } = JSON.parse(python) as { values: number[]; length: number };
  expect(await viewer.evaluate((element) => [...(element as GirthViewer).values('igf')])).toEqual(
    values,
  );
  expect(await page.title()).toBe('Ring');
  expect(await viewer.evaluate(legendOf)).toContain('Girth');
  await expect
    .poll(() => viewer.evaluate((element) => (element as GirthViewer).pinned.length))
    .toBe(1);
  const pinned = await viewer.evaluate((element) => (element as GirthViewer).pinned[0]!.loop);
  expect([pinned.base, pinned.length, pinned.unit]).toEqual([100, length, 'metre']);
  expect(fetched).toEqual([]);
  expect(complaints).toEqual([]);
});

test('the value under the pointer is written out, by the row of the arrays', async () => {
  const { page, viewer, frame, complaints } = await openPage([
    'v, f = torus()',
    // Every vertex twice, the first one unused: rows and vertices have other numbers.
    'm = pygirth.Mesh(np.repeat(v, 2, axis=0), 2 * f + 1)',
    'pygirth.show(m, np.arange(len(m.vertices)) * 10.0, title="Rows").save("page.html")',
  ]);
  expect(await viewer.evaluate(legendOf)).toContain('Rows');
  const place = await placeOnSurface(viewer, 0.5, 0.15);
  await page.mouse.move(place.x, place.y);
  const caption = frame.locator('#girth-caption');
  await expect.poll(() => caption.textContent()).toMatch(/^Vertex \d+: /);
  const [, row, value] = /^Vertex (\d+): ([\d,.]+)$/.exec((await caption.textContent())!)!;
  expect(Number(row) % 2).toBe(1);
  expect(Number(value!.replaceAll(',', ''))).toBeCloseTo(10 * Number(row), 0);
  await page.mouse.click(place.x, place.y);
  expect(complaints).toEqual([]);
});

test('a notebook shows the same page in a frame of its own', async () => {
  const { frame, page, viewer, complaints } = await openPage([
    'm = pygirth.Mesh(*prism())',
    'shown = pygirth.show(m, m.geodesics(0), name="A & <b> \\"c\\"", colormap="magma", range=(0, 5))',
    'open("page.html", "w").write("<!doctype html><meta charset=utf-8>" + shown._repr_html_())',
  ]);
  expect(frame).not.toBe(page.mainFrame());
  expect(await viewer.evaluate((element) => (element as GirthViewer).info!.name)).toBe(
    'A & <b> "c"',
  );
  expect(await viewer.evaluate(legendOf)).toContain('Distance');
  const shown = await viewer.evaluate((element) => (element as GirthViewer).shown!);
  expect([shown.colormap, shown.range]).toEqual(['magma', [0, 5]]);
  expect(complaints).toEqual([]);
});

test('without a field, and far from the origin, the surface alone is drawn', async () => {
  const { viewer, complaints } = await openPage([
    'v, f = torus()',
    'pygirth.show((v + [1e6, 0, 0], f)).save("page.html")',
  ]);
  const info = await viewer.evaluate((element) => (element as GirthViewer).info!);
  expect([info.vertexCount, info.faceCount, info.edgeCount]).toEqual([640, 1280, 1920]);
  expect(info.size[0]).toBeCloseTo(8, 9);
  expect(complaints).toEqual([]);
});
