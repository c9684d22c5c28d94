// Limbs by the kernel: what the command finds, with progress, and stopped at once.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, expect, test } from 'vitest';
import type { KernelPage } from './kernel-page.js';
import { onKernelPage } from './kernel-site.js';
import { hand } from './meshes.js';
import { chromiumForTests, command } from './support.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const scratch = mkdtempSync(join(tmpdir(), 'girth-limbs-'));
const openPage = chromiumForTests();
let page: Page;
onKernelPage(openPage, 'pool', (opened) => (page = opened));
afterAll(() => rmSync(scratch, { recursive: true }));

const model = hand([6, 9]);

interface WrittenStation {
  distance: number;
  ring: number;
  median: number | null;
  least: number | null;
}
interface WrittenLimb {
  length: number;
  narrowest: number;
  median: number;
  base: number;
  end: string;
  tips: number[];
  vertices: number[];
  apex: { vertices: number[] };
  profile: WrittenStation[];
}

test('limbs are those of the command, bit for bit, and so are the files', async () => {
  const [input, output] = [join(scratch, 'test.obj'), join(scratch, 'limbs.json')];
  writeFileSync(input, model);
  execFileSync(command, ['limbs', input, '--stations', '24', '-o', output], { stdio: 'ignore' });
  const text = readFileSync(output, 'utf8').replace(input, 'test.obj');
  const theirs = (JSON.parse(text) as { limbs: WrittenLimb[] }).limbs;
  const mine = await page.evaluate(async (text) => {
    const kernel = await girth.createKernel({ threads: 1 });
    const mesh = await kernel.load(girth.obj(text));
    const igf = await mesh.field('igf');
    const progress: number[] = [];
    const options = { stations: 24, onProgress: (share: number) => progress.push(share) };
    const found = await mesh.limbs(igf, options);
    // The loops stand where the profile says, and are as long.
    const loops = [];
    for (const { place, least } of found.limbs[0]!.profile) {
      if (place !== undefined) loops.push([(await mesh.loop(place)).length, least]);
    }
    const decoder = new TextDecoder();
    const file = decoder.decode(await mesh.exportLimbs(igf, 'json', { stations: 24 }));
    const table = decoder.decode(await mesh.exportLimbs(igf, 'csv'));
    kernel.dispose();
    return { found: girth.plain(found), progress, loops, file, table };
  }, model);
  const { limbs, tipsWithoutLimb } = mine.found;
  expect(tipsWithoutLimb).toEqual([]);
  expect(limbs.length).toBe(2);
  limbs.forEach((limb, i) => {
    const their = theirs[i]!;
    for (const name of ['length', 'narrowest', 'median', 'base', 'end', 'vertices'] as const) {
      expect(limb[name]).toEqual(their[name]);
    }
    expect(limb.apex).toBe(their.apex.vertices[0]);
    expect(limb.tips).toEqual(their.tips);
    expect(limb.profile.length).toBe(24);
    limb.profile.forEach((station, k) => {
      const { distance, ring, median, least } = their.profile[k]!;
      expect([station.distance, station.ring]).toEqual([distance, ring]);
      // NaN is null in JSON, and leaves the page as null.
      expect([station.median, station.least]).toEqual([median, least]);
    });
    expect(limb.narrowest).toBeCloseTo(8, 9);
    expect(limb.median).toBeCloseTo(8, 6);
  });
  expect(limbs[0]!.length).toBeGreaterThan(9);
  expect(limbs[0]!.length).toBeLessThan(11.2);
  expect(mine.progress.at(-1)).toBe(1);
  expect(mine.loops.length).toBeGreaterThan(15);
  for (const [length, least] of mine.loops) expect(length).toBeCloseTo(least!, 9);
  expect(mine.file).toBe(text);
  expect(mine.table.split('\n')[0]).toMatch(/^limb,length,narrowest,/);
});

interface WrittenAxis {
  length: number;
  loops: { distance: number; along: number; girth: number; area: number; centre: number[] }[];
}

test('the axis of a limb is that of the command, and its files are, without measuring again', async () => {
  const input = join(scratch, 'axis.obj');
  writeFileSync(input, model);
  const along = ['profile', input, '--limb', '0', '--samples', '20'];
  const formats = ['csv', 'json', 'obj', 'glb'] as const;
  const theirs = formats.map((format) => {
    const output = join(scratch, `axis-of-limb.${format}`);
    execFileSync(command, [...along, '-o', output], { stdio: 'ignore' });
    return readFileSync(output, 'latin1').replace(input, 'axis.obj');
  });
  const path = execFileSync(command, ['profile', input, '3', '40', '7', '--json'], {
    encoding: 'utf8',
  }).replace(input, 'axis.obj');
  const mine = await page.evaluate(async (text) => {
    const kernel = await girth.createKernel({ threads: 1 });
    const mesh = await kernel.load(girth.obj(text, 'axis.obj'));
    const { limbs } = await mesh.limbs(await mesh.field('igf'), { stations: 20 });
    const progress: number[] = [];
    const axis = await mesh.axis(limbs[0]!, { onProgress: (share) => progress.push(share) });
    const latin = (bytes: Uint8Array) => Array.from(bytes, (b) => String.fromCharCode(b)).join('');
    const files = [];
    for (const format of ['csv', 'json', 'obj', 'glb'] as const) {
      files.push(latin(await mesh.exportProfile(axis, format)));
    }
    // The axis that is handed over is written as it is.
    const [first] = axis.loops;
    const changed = { ...axis, loops: [{ ...first!, girth: 1.5 }] };
    const one = latin(await mesh.exportProfile(changed, 'csv'));
    const drawn = await mesh.profile([3, 40, 7]);
    const paths = [];
    for (const given of [drawn, [3, 40, 7]] as const) {
      paths.push(latin(await mesh.exportProfile(given as typeof drawn, 'json')));
    }
    const stop = new AbortController();
    const stopped = girth.refusal(mesh.axis(limbs[0]!, { signal: stop.signal }));
    stop.abort();
    const elsewhere = { face: 10 ** 6, weights: [1, 0, 0] as const };
    const [station] = drawn.stations;
    const without = await mesh.axis({ profile: [] });
    const refused = [
      await stopped,
      await girth.refusal(
        mesh.axis({ profile: [{ ...limbs[0]!.profile[0]!, least: 1, place: elsewhere }] }),
      ),
      await girth.refusal(
        mesh.exportProfile({ ...drawn, stations: [{ ...station!, place: elsewhere }] }, 'csv'),
      ),
      await girth.refusal(mesh.exportProfile([3, 40], 'obj' as 'csv')),
      await girth.refusal(mesh.exportProfile(axis, 'ply' as 'csv')),
    ];
    kernel.dispose();
    const codes = refused.map(({ code }) => code);
    return { axis: girth.plain(axis), progress, files, one, paths, without: without.length, codes };
  }, model);
  expect(mine.files).toEqual(theirs);
  const their = JSON.parse(theirs[1]!) as WrittenAxis;
  expect(mine.axis.length).toBe(their.length);
  expect(mine.axis.unit).toBe('');
  expect(mine.axis.loops.length).toBeGreaterThan(10);
  expect(mine.axis.loops).toMatchObject(
    their.loops.map(({ distance, along, girth, area, centre }) => {
      return { distance, along, girth, area, centre };
    }),
  );
  // The line that is drawn is the axis, and of each loop as long as the loop.
  const linesLength = (line: number[]) => {
    let length = 0;
    for (let i = 3; i < line.length; i += 3) {
      length += Math.hypot(...[0, 1, 2].map((k) => line[i + k]! - line[i + k - 3]!));
    }
    return length;
  };
  expect(linesLength(mine.axis.polyline)).toBeCloseTo(mine.axis.length, 4);
  for (const { polyline, girth } of mine.axis.loops)
    expect(linesLength(polyline)).toBeCloseTo(girth, 4);
  expect(mine.progress.at(-1)).toBe(1);
  expect(mine.one.trimEnd().split('\n').length).toBe(2);
  expect(mine.one.split('\n')[1]!.split(',')[2]).toBe('1.5');
  expect(mine.paths).toEqual([path, path]);
  expect(mine.without).toBe(0);
  expect(mine.codes).toEqual(['CANCELLED', 'INVALID_POINT', 'INVALID_POINT', 'USAGE', 'USAGE']);
});

test('what cannot be measured is refused, and a signal stops it', async () => {
  const codes = await page.evaluate(async (text) => {
    const kernel = await girth.createKernel({ threads: 1 });
    const mesh = await kernel.load(girth.obj(text));
    const [igf, sdf] = [await mesh.field('igf'), await mesh.field('sdf')];
    const stop = new AbortController();
    const stopped = girth.refusal(mesh.limbs(igf, { signal: stop.signal }));
    stop.abort();
    const refused = [
      await stopped,
      await girth.refusal(mesh.limbs(sdf)),
      await girth.refusal(mesh.limbs(igf, { stations: 0 })),
      await girth.refusal(mesh.limbs(igf, { stations: 1e6 })),
      await girth.refusal(mesh.exportLimbs(igf, 'obj' as 'csv')),
    ];
    kernel.dispose();
    return refused.map(({ code }) => code);
  }, model);
  expect(codes).toEqual(['CANCELLED', 'USAGE', 'INVALID_OPTION', 'INVALID_OPTION', 'USAGE']);
});
