// Necks and handles by the kernel: what the command finds, with progress, and stopped at once.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
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

const scratch = mkdtempSync(join(tmpdir(), 'girth-loops-'));
const openPage = chromiumForTests();
let page: Page;
onKernelPage(openPage, 'pool', (opened) => (page = opened));
afterAll(() => rmSync(scratch, { recursive: true }));

interface WrittenLoop {
  length: number;
  area: number;
  centre: number[];
  points: { position: number[] }[];
}
interface WrittenNeck extends WrittenLoop {
  prominence: number | null;
  sides: { area: number; volume: number }[];
  vertices: number[];
}
interface WrittenHandle extends WrittenLoop {
  kind: string;
}

/** What the command finds of a model. */
function byCommand<T>(name: 'necks' | 'handles', model: string): T[] {
  const [input, output] = [join(scratch, `${name}.obj`), join(scratch, `${name}.json`)];
  writeFileSync(input, model);
  execFileSync(command, [name, input, '-o', output], { stdio: 'ignore' });
  return (JSON.parse(readFileSync(output, 'utf8')) as Record<string, T[]>)[name]!;
}

/** The sum of the ways between the points of a line. */
function lengthOf(polyline: number[]): number {
  let sum = 0;
  for (let i = 3; i < polyline.length; i += 3) {
    sum += Math.hypot(...[0, 1, 2].map((k) => polyline[i + k]! - polyline[i + k - 3]!));
  }
  return sum;
}

test('necks are those of the command', async () => {
  const model = dumbbell(16, 12);
  const theirs = byCommand<WrittenNeck>('necks', model);
  const mine = await page.evaluate(async (text) => {
    const kernel = await girth.createKernel({ threads: 1 });
    const mesh = await kernel.load(girth.obj(text));
    const igf = await mesh.field('igf');
    const progress: number[] = [];
    const found = await mesh.necks(igf, { onProgress: (share) => progress.push(share) });
    const none = await mesh.necks(igf, { minProminence: 1e9 });
    // At a vertex which it passes, a neck that measures the girth is the loop.
    const first = found.necks[0]!;
    const girthThere = igf.values[first.vertices[0]!];
    kernel.dispose();
    return { found: girth.plain(found), progress, none: none.necks.length, girthThere };
  }, model);
  expect(mine.found.unresolved).toBe(0);
  expect(mine.found.necks.length).toBe(theirs.length);
  expect(theirs.length).toBeGreaterThan(0);
  mine.found.necks.forEach((neck, i) => {
    const their = theirs[i]!;
    expect([neck.length, neck.area, neck.centre]).toEqual([their.length, their.area, their.centre]);
    expect(neck.sides).toEqual(their.sides);
    expect(neck.vertices).toEqual(their.vertices);
    expect(neck.points.length).toBe(their.points.length);
    expect(lengthOf(neck.polyline)).toBeCloseTo(neck.length, 5);
  });
  expect(mine.girthThere).toBeCloseTo(mine.found.necks[0]!.length, 9);
  expect(mine.progress.at(-1)).toBe(1);
  expect(mine.none).toBe(theirs.filter(({ prominence }) => prominence === null).length);
});

test('handles and tunnels are those of the command', async () => {
  const model = torus(16, 10);
  const theirs = byCommand<WrittenHandle>('handles', model);
  const mine = await page.evaluate(async (text) => {
    const kernel = await girth.createKernel({ threads: 1 });
    const mesh = await kernel.load(girth.obj(text));
    const progress: number[] = [];
    const found = await mesh.handles({ onProgress: (share) => progress.push(share) });
    kernel.dispose();
    return { found: girth.plain(found), progress };
  }, model);
  expect(mine.found.unresolved).toBe(0);
  expect(mine.found.handles.map(({ kind }) => kind).sort()).toEqual(['handle', 'tunnel']);
  mine.found.handles.forEach((handle, i) => {
    const their = theirs[i]!;
    expect([handle.kind, handle.length, handle.area]).toEqual([
      their.kind,
      their.length,
      their.area,
    ]);
    expect(handle.points.length).toBe(their.points.length);
    expect(lengthOf(handle.polyline)).toBeCloseTo(handle.length, 5);
  });
  expect(mine.progress.at(-1)).toBe(1);
});

test('what cannot be searched is refused, and a signal stops it', async () => {
  const codes = await page.evaluate(
    async (text) => {
      const kernel = await girth.createKernel({ threads: 1 });
      const mesh = await kernel.load(girth.obj(text));
      const [igf, sdf] = [await mesh.field('igf'), await mesh.field('sdf')];
      const stop = new AbortController();
      const stopped = [
        girth.refusal(mesh.necks(igf, { signal: stop.signal })),
        girth.refusal(mesh.handles({ signal: stop.signal })),
      ];
      stop.abort();
      const refused = [
        ...(await Promise.all(stopped)),
        await girth.refusal(mesh.necks(sdf)),
        await girth.refusal(mesh.necks(igf, { minProminence: -1 })),
        await girth.refusal(mesh.necks(igf, { minProminence: NaN })),
        await girth.refusal(mesh.handles({ basePoints: 0 })),
        await girth.refusal(mesh.handles({ basePoints: NaN })),
      ];
      kernel.dispose();
      return refused.map(({ code }) => code);
    },
    torus(16, 10),
  );
  const invalid = 'INVALID_OPTION';
  expect(codes).toEqual(['CANCELLED', 'CANCELLED', 'USAGE', invalid, invalid, invalid, invalid]);
});
