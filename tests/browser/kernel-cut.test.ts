// Cutting by the kernel: what the command makes of the same loop.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, expect, test } from 'vitest';
import type { KernelPage } from './kernel-page.js';
import { onKernelPage } from './kernel-site.js';
import { dumbbell, torus } from './meshes.js';
import { chromiumForTests, command } from './support.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const scratch = mkdtempSync(join(tmpdir(), 'girth-cut-'));
const openPage = chromiumForTests();
let page: Page;
onKernelPage(openPage, 'pool', (opened) => (page = opened));
afterAll(() => rmSync(scratch, { recursive: true }));

/** What the command writes of a model that is cut at its first neck. */
function byCommand(model: string, ending: string): Buffer[] {
  const input = join(scratch, 'model.obj');
  writeFileSync(input, model);
  const output = join(scratch, ending === 'stl' ? 'cut-*.stl' : `cut.${ending}`);
  const words = ['cut', input, '--neck', '1', '--cap', '--force', '-o', output];
  execFileSync(command, words, { stdio: 'ignore' });
  const names = readdirSync(scratch).filter((name) => name.startsWith('cut'));
  const files = names.filter((name) => name.endsWith(ending)).sort();
  return files.map((name) => readFileSync(join(scratch, name)));
}

test('a neck is cut as by the command, to the bit', async () => {
  const model = dumbbell(16, 12);
  const mine = await page.evaluate(async (text) => {
    const kernel = await girth.createKernel({ threads: 1 });
    const mesh = await kernel.load(girth.obj(text));
    const { necks } = await mesh.necks(await mesh.field('igf'));
    const curves = [necks[0]!.points];
    const files: Record<string, string[]> = {};
    for (const format of ['obj', 'stl', 'json'] as const) {
      const all = await mesh.exportCut(curves, format, { cap: true });
      files[format] = all.map((bytes) => [...bytes].map((b) => String.fromCharCode(b)).join(''));
    }
    const [open, closed] = [await mesh.cut(curves), await mesh.cut(curves, { cap: true })];
    const { info } = mesh;
    const again = await kernel.load({
      positions: closed.parts[0]!.positions,
      indices: closed.parts[0]!.indices,
    });
    const { area } = again.info;
    kernel.dispose();
    return {
      files,
      open: girth.plain(open),
      closed: girth.plain(closed),
      length: necks[0]!.length,
      area: info.area,
      faceCount: info.faceCount,
      vertexCount: info.vertexCount,
      again: { area },
    };
  }, model);
  for (const format of ['obj', 'stl'] as const) {
    const theirs = byCommand(model, format).map((bytes) => bytes.toString('latin1'));
    expect(mine.files[format]).toEqual(theirs);
  }
  const { parts: theirs } = JSON.parse(byCommand(model, 'json')[0]!.toString()) as {
    parts: { area: number; volume: number; faces: number }[];
  };
  const [open, closed] = [mine.open.parts, mine.closed.parts];
  expect(closed.map(({ area, volume, faces }) => [area, volume, faces.length])).toEqual(
    theirs.map(({ area, volume, faces }) => [area, volume, faces]),
  );
  // Nothing is lost: the parts have the surface's area, and each piece knows its face.
  expect(open.length).toBe(2);
  expect(open[0]!.area + open[1]!.area).toBeCloseTo(mine.area, 9);
  expect(open.map(({ boundaryCount }) => boundaryCount)).toEqual([1, 1]);
  // NaN, which JSON does not have.
  expect(open.map(({ volume }) => volume)).toEqual([null, null]);
  const faces = new Set(open.flatMap(({ faces }) => [...faces]));
  expect(faces.size).toBe(mine.faceCount);
  const vertices = new Set(open.flatMap(({ vertices }) => [...vertices]));
  expect([...vertices].filter((v) => v < mine.vertexCount).length).toBe(mine.vertexCount);
  expect(closed.map(({ boundaryCount }) => boundaryCount)).toEqual([0, 0]);
  expect(mine.again.area).toBeCloseTo(closed[0]!.area, 9);
});

test('a handle is opened and nothing falls off; what cannot be cut is refused', async () => {
  const found = await page.evaluate(
    async (text) => {
      const kernel = await girth.createKernel({ threads: 1 });
      const mesh = await kernel.load(girth.obj(text));
      const { handles } = await mesh.handles();
      const cut = await mesh.cut([handles[0]!.points], { cap: true });
      const both = handles.map(({ points }) => points);
      const stop = new AbortController();
      const stopped = girth.refusal(mesh.cut([both[0]!], { signal: stop.signal }));
      stop.abort();
      const refused = [
        await stopped,
        await girth.refusal(mesh.cut(both)),
        await girth.refusal(mesh.cut([[0, 10 ** 6, 0]])),
        await girth.refusal(mesh.cut([[0, mesh.info.vertexCount >> 1, 0]])),
      ];
      const none = await mesh.cut([]);
      kernel.dispose();
      return {
        parts: cut.parts.map(({ genus, boundaryCount }) => [genus, boundaryCount]),
        none: none.parts.length,
        codes: refused.map(({ code }) => code),
      };
    },
    torus(16, 10),
  );
  expect(found.parts).toEqual([[0, 0]]);
  expect(found.none).toBe(1);
  // The two loops of a torus cross.
  expect(found.codes).toEqual([
    'CANCELLED',
    'INVALID_OPTION',
    'VERTEX_OUT_OF_RANGE',
    'INVALID_POINT',
  ]);
});
