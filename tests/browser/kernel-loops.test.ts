// Necks, bottlenecks, profiles and handles by the kernel: what the command finds, with progress, and stopped at once.

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

/** The loops that the command finds of a model. */
function byCommand<T>(name: 'necks' | 'handles', model: string): T[] {
  const [input, output] = [join(scratch, `${name}.obj`), join(scratch, `${name}.json`)];
  writeFileSync(input, model);
  execFileSync(command, [name, input, '-o', output], { stdio: 'ignore' });
  return (JSON.parse(readFileSync(output, 'utf8')) as Record<string, T[]>)[name]!;
}

/** The text that the command prints or writes of a model. */
function commandOn(model: string, name: string, ...words: string[]): string {
  const input = join(scratch, 'model.obj');
  writeFileSync(input, model);
  return execFileSync(command, [name, input, ...words], { encoding: 'utf8' });
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

interface WrittenBottleneck extends WrittenLoop {
  kind: string;
  girth: number;
  sides: { area: number; volume: number }[];
  way: unknown[];
}
interface WrittenProfile {
  length: number;
  stations: { distance: number; girth: number; kind: string }[];
}

test('a bottleneck and a profile are those of the command', async () => {
  const model = dumbbell(16, 12);
  // From one ball to the other one, from point to point of faces, and within one ball.
  const [from, to, near] = [5, 180, 30];
  const inFace = { face: 40, weights: [0.25, 0.25, 0.5] as const };
  const theirs = JSON.parse(
    commandOn(model, 'bottleneck', String(from), String(to), '--json'),
  ) as WrittenBottleneck;
  const within = JSON.parse(
    commandOn(model, 'bottleneck', String(from), '40:0.25,0.25,0.5', '--json'),
  ) as WrittenBottleneck;
  const words = [String(from), String(near), '40:0.25,0.25,0.5'];
  const even = ['--samples', '12', '--even'];
  const mine = await page.evaluate(
    async ({ text, from, to, near, inFace }) => {
      const kernel = await girth.createKernel({ threads: 1 });
      const mesh = await kernel.load(girth.obj(text, 'model.obj'));
      const igf = await mesh.field('igf');
      const progress: number[] = [];
      const onProgress = (share: number) => progress.push(share);
      const found = await mesh.bottleneck(igf, from, to, { onProgress });
      const back = await mesh.bottleneck(igf, to, from);
      const within = await mesh.bottleneck(igf, from, inFace);
      const { necks } = await mesh.necks(igf);
      const along: number[] = [];
      const profile = await mesh.profile([from, to], {
        onProgress: (share) => along.push(share),
      });
      const loops = await Promise.all(
        profile.stations.slice(0, 9).map(async ({ place }) => (await mesh.loop(place)).length),
      );
      const { length } = await mesh.path(from, to);
      const files = await Promise.all([
        mesh.exportProfile([from, near, inFace], 'csv'),
        mesh.exportProfile([from, to], 'csv', { samples: 12, crossings: false }),
      ]);
      kernel.dispose();
      return {
        ...girth.plain({ found, back, within, profile, progress, along, loops, length }),
        narrowest: Math.min(...necks.map((neck) => neck.length)),
        files: files.map((bytes) => new TextDecoder().decode(bytes)),
      };
    },
    { text: model, from, to, near, inFace },
  );
  expect(mine.found).toMatchObject({
    kind: theirs.kind,
    girth: theirs.girth,
    area: theirs.area,
    centre: theirs.centre,
    sides: theirs.sides,
  });
  expect(mine.found.points.length).toBe(theirs.points.length);
  expect(mine.found.way.length).toBe(theirs.way.length);
  // The waist of the dumbbell is the neck that every way crosses, whichever end it begins at.
  expect(mine.found.kind).toBe('neck');
  expect(mine.found.girth).toBeCloseTo(mine.narrowest, 9);
  expect(mine.back.girth).toBeCloseTo(mine.found.girth, 9);
  expect(lengthOf(mine.found.polyline)).toBeCloseTo(mine.found.girth, 5);
  expect([mine.within.kind, mine.within.girth]).toEqual([within.kind, within.girth]);
  for (const shares of [mine.progress, mine.along]) expect(shares.at(-1)).toBe(1);

  const profile = JSON.parse(
    commandOn(model, 'profile', String(from), String(to), '--json'),
  ) as WrittenProfile;
  expect(mine.profile.length).toBe(profile.length);
  expect(mine.profile.stations.map(({ distance, girth, kind }) => [distance, girth, kind])).toEqual(
    profile.stations.map(({ distance, girth, kind }) => [distance, girth, kind]),
  );
  expect(mine.loops).toEqual(mine.profile.stations.slice(0, 9).map((station) => station.girth));
  expect(mine.profile.length).toBeCloseTo(mine.length, 9);
  expect(lengthOf(mine.profile.polyline)).toBeCloseTo(mine.length, 5);
  // No way is narrower than the bottleneck at its narrowest place, as far as the samples show.
  expect(Math.min(...mine.profile.stations.map(({ girth }) => girth))).toBeLessThanOrEqual(
    1.01 * mine.found.girth,
  );
  expect(mine.files).toEqual([
    commandOn(model, 'profile', ...words, '-o', '-', '--format', 'csv'),
    commandOn(model, 'profile', String(from), String(to), ...even, '-o', '-', '--format', 'csv'),
  ]);
});

interface WrittenRemoval {
  faces: number;
  vertices: number;
  area: number;
  genusBefore: number;
  crossingFaces: number;
  provenLength: number;
  genus: number;
}

test('short handles are taken away as by the command', async () => {
  const model = torus(16, 10);
  const lengths = byCommand<WrittenHandle>('handles', model).map(({ length }) => length);
  const between = (lengths[0]! + lengths[1]!) / 2;
  const output = join(scratch, 'repaired.obj');
  const theirs = JSON.parse(
    commandOn(model, 'remesh', '--remove-handles', String(between), '-o', output, '--json'),
  ) as WrittenRemoval;
  const mine = await page.evaluate(
    async ({ text, between }) => {
      const kernel = await girth.createKernel({ threads: 1 });
      const mesh = await kernel.load(girth.obj(text));
      const progress: number[] = [];
      const onProgress = (share: number) => progress.push(share);
      const repaired = await mesh.removeHandles(between, { onProgress });
      const untouched = await mesh.removeHandles(0);
      const left = await repaired.handles();
      const stop = new AbortController();
      const stopped = girth.refusal(mesh.removeHandles(between, { signal: stop.signal }));
      stop.abort();
      const refused = [
        await stopped,
        await girth.refusal(mesh.removeHandles(-1)),
        await girth.refusal(mesh.removeHandles(NaN)),
      ];
      const { info, geometry, removal } = repaired;
      const { genus, area, faceCount, vertexCount } = info;
      const { positions } = geometry;
      const before = mesh.info;
      repaired.dispose();
      // The mesh that it was made of lives on.
      const { handles } = await mesh.handles();
      kernel.dispose();
      return {
        ...girth.plain({ removal, genus, area, faceCount, vertexCount, positions, progress }),
        codes: refused.map(({ code }) => code),
        left: left.handles.length,
        before: { genus: before.genus, faceCount: before.faceCount, handles: handles.length },
        untouched: {
          ...girth.plain(untouched.removal),
          faceCount: untouched.info.faceCount,
        },
      };
    },
    { text: model, between },
  );
  expect(mine.removal.removed.map(({ kind }) => kind)).toEqual(['handle']);
  // It is cut along a loop that need not be the shortest.
  const [cut] = mine.removal.removed;
  expect(cut!.length).toBeGreaterThanOrEqual(lengths[0]!);
  expect(cut!.length).toBeLessThan(between);
  expect([mine.removal.genusBefore, mine.removal.genusAfter]).toEqual([1, 0]);
  expect([mine.removal.genusBefore, mine.removal.genusAfter]).toEqual([
    theirs.genusBefore,
    theirs.genus,
  ]);
  expect(mine.removal.crossingFaces).toBe(theirs.crossingFaces);
  expect([mine.removal.provenLength, theirs.provenLength]).toEqual([between, between]);
  expect([mine.faceCount, mine.vertexCount, mine.area]).toEqual([
    theirs.faces,
    theirs.vertices,
    theirs.area,
  ]);
  const written = readFileSync(output, 'utf8')
    .split('\n')
    .filter((line) => line.startsWith('v '))
    .flatMap((line) => line.split(' ').slice(1).map(Number))
    .map(Math.fround);
  expect(mine.positions).toEqual(written);
  expect([mine.genus, mine.left]).toEqual([[0], 0]);
  expect(mine.before).toEqual({ genus: [1], faceCount: 320, handles: 2 });
  expect(mine.untouched).toEqual({
    removed: [],
    genusBefore: 1,
    genusAfter: 1,
    crossingFaces: 0,
    provenLength: 0,
    faceCount: 320,
  });
  expect(mine.progress.at(-1)).toBe(1);
  expect(mine.codes).toEqual(['CANCELLED', 'INVALID_OPTION', 'INVALID_OPTION']);
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
        girth.refusal(mesh.bottleneck(igf, 0, 80, { signal: stop.signal })),
        girth.refusal(mesh.profile([0, 80], { signal: stop.signal })),
      ];
      stop.abort();
      const refused = [
        ...(await Promise.all(stopped)),
        await girth.refusal(mesh.necks(sdf)),
        await girth.refusal(mesh.necks(igf, { minProminence: -1 })),
        await girth.refusal(mesh.necks(igf, { minProminence: NaN })),
        await girth.refusal(mesh.handles({ basePoints: 0 })),
        await girth.refusal(mesh.handles({ basePoints: NaN })),
        await girth.refusal(mesh.profile([0, 80], { samples: 1 })),
        await girth.refusal(mesh.profile([0, 80], { samples: 2.5 })),
        await girth.refusal(mesh.profile([0, 80], { samples: 0, crossings: false })),
        await girth.refusal(mesh.profile([0])),
        await girth.refusal(mesh.profile([0, 10 ** 6])),
        await girth.refusal(mesh.bottleneck(sdf, 0, 80)),
        await girth.refusal(mesh.bottleneck({ ...igf, persistence: 0.1 }, 0, 80)),
        await girth.refusal(mesh.bottleneck(igf, 0, { face: 10 ** 6, weights: [1, 0, 0] })),
      ];
      kernel.dispose();
      return refused.map(({ code }) => code);
    },
    torus(16, 10),
  );
  const [invalid, usage] = ['INVALID_OPTION', 'USAGE'];
  expect(codes).toEqual([
    ...Array.from({ length: 4 }, () => 'CANCELLED'),
    ...[usage, ...Array.from({ length: 7 }, () => invalid)],
    ...[usage, 'VERTEX_OUT_OF_RANGE', usage, usage, 'INVALID_POINT'],
  ]);
});

/** Bytes of a file of the command, as Latin text. */
function fileOfCommand(model: string, name: string, format: string, ...words: string[]): string {
  const output = join(scratch, `written.${format}`);
  writeFileSync(join(scratch, 'model.obj'), model);
  writeFileSync(join(scratch, 'pairs.csv'), '0,60\n');
  execFileSync(command, [name, 'model.obj', ...words, '-o', output, '--force'], {
    cwd: scratch,
    stdio: 'ignore',
  });
  return readFileSync(output, 'latin1');
}

test('what was found is written as the command writes it, byte by byte', async () => {
  const [body, ring] = [dumbbell(16, 12), torus(16, 9)];
  const mine = await page.evaluate(
    async ([body, ring]) => {
      const kernel = await girth.createKernel({ threads: 1 });
      const mesh = await kernel.load(girth.obj(body!, 'model.obj'));
      const holed = await kernel.load(girth.obj(ring!, 'model.obj'));
      const igf = await mesh.field('igf');
      const latin = (bytes: Uint8Array) =>
        Array.from(bytes, (b) => String.fromCharCode(b)).join('');
      const [necks, tips] = [await mesh.necks(igf), await mesh.tips(igf)];
      const [limbs, bottleneck] = [await mesh.limbs(igf), await mesh.bottleneck(igf, 0, 60)];
      const handles = await holed.handles();
      const sections = await mesh.sections({ normal: [1, 0, 0], offsets: [0, 1.5] });
      const pairs = [{ start: 0, end: 60 }];
      const distances = await mesh.distances({ pairs, paths: true });
      const files: Record<string, string> = {};
      for (const format of ['csv', 'json'] as const) {
        files[`distance ${format}`] = latin(await mesh.write(distances, format));
      }
      for (const format of ['csv', 'json', 'obj', 'glb'] as const) {
        files[`necks ${format}`] = latin(await mesh.write(necks, format));
        files[`handles ${format}`] = latin(await holed.write(handles, format));
        files[`section ${format}`] = latin(await mesh.write(sections, format));
        if (format !== 'csv') {
          files[`bottleneck ${format}`] = latin(await mesh.write(bottleneck, format));
        }
      }
      for (const format of ['json', 'obj'] as const) {
        files[`tips ${format}`] = latin(await mesh.write(tips, format));
      }
      for (const format of ['json', 'csv'] as const) {
        files[`limbs ${format}`] = latin(await mesh.write(limbs, format));
      }
      files['limbs csv --profiles'] = latin(await mesh.write(limbs, 'csv', { profiles: true }));
      // A shortened list of necks is written as a whole one is.
      const first = { ...necks, necks: necks.necks.slice(0, 1) };
      const rows =
        latin(await mesh.write(first, 'csv'))
          .trim()
          .split('\n').length - 1;
      const [neck] = necks.necks;
      const elsewhere = { ...neck!, points: [...neck!.points, 1_000_000] };
      const refused = [
        await girth.refusal(mesh.write({ ...tips }, 'json')),
        await girth.refusal(mesh.write({ necks: [elsewhere], unresolved: 0 }, 'json')),
        await girth.refusal(mesh.write(necks, 'ply' as 'obj')),
        await girth.refusal(holed.write(necks, 'obj')),
        await girth.refusal(mesh.write(mesh.info as never, 'json' as never)),
      ];
      kernel.dispose();
      return { files, rows, codes: refused.map(({ code }) => code) };
    },
    [body, ring],
  );
  for (const [asked, written] of Object.entries(mine.files)) {
    const [name = '', format = '', ...words] = asked.split(' ');
    const ends = name === 'bottleneck' ? ['0', '60'] : [];
    if (name === 'section') ends.push(...'--along x --at-height 0 --at-height 1.5'.split(' '));
    if (name === 'distance') ends.push('--between', 'pairs.csv', '--paths');
    const model = name === 'handles' ? ring : body;
    expect(written === fileOfCommand(model, name, format, ...ends, ...words), asked).toBe(true);
  }
  expect(Object.keys(mine.files)).toHaveLength(22);
  expect(mine.rows).toBe(1);
  expect(mine.codes).toEqual(['USAGE', 'INVALID_POINT', 'USAGE', 'INVALID_POINT', 'USAGE']);
});

test('curves on a prism are drawn tight: closed, open, and to a point', async () => {
  const found = await page.evaluate(async () => {
    const kernel = await girth.createKernel({ threads: 1 });
    const corners = 5;
    const side = 1 / (2 * Math.sin(Math.PI / corners));
    const lines: string[] = [];
    for (let ring = 0; ring <= 8; ring++) {
      for (let i = 0; i < corners; i++) {
        const angle = (2 * Math.PI * i) / corners;
        lines.push(`v ${side * Math.cos(angle)} ${side * Math.sin(angle)} ${ring}`);
      }
    }
    const at = (ring: number, i: number) => ring * corners + (i % corners) + 1;
    for (let ring = 0; ring < 8; ring++) {
      for (let i = 0; i < corners; i++) {
        lines.push(`f ${at(ring, i)} ${at(ring, i + 1)} ${at(ring + 1, i + 1)} ${at(ring + 1, i)}`);
      }
    }
    const mesh = await kernel.load(girth.obj(lines.join('\n'), 'prism.obj'));
    const round = [15, 21, 17, 23, 19];
    const closed = await mesh.tighten({ points: round, closed: true });
    const open = await mesh.tighten({ points: [10, 11, 12, 13, 14, 10, 15, 20, 25] });
    const point = await mesh.tighten({ points: [10, 11, 16], closed: true });
    const fixed = await mesh.tighten({ points: round, closed: true, fixed: true });
    const csv = new TextDecoder().decode(await mesh.write(fixed, 'csv'));
    const json = JSON.parse(new TextDecoder().decode(await mesh.write(closed, 'json'))) as object;
    const none = await girth.refusal(mesh.tighten({ points: [] }));
    const absent = await girth.refusal(mesh.tighten({ points: [0, 999] }));
    kernel.dispose();
    return { closed, open, point, fixed, csv, json, codes: [none.code, absent.code] };
  });
  expect(found.closed).toMatchObject({ kind: 'loop', promise: 'shortest', component: 0 });
  expect(found.closed.length).toBeCloseTo(5, 10);
  expect(found.closed.lengthBefore).toBeGreaterThan(5.5);
  expect(found.closed.polyline.length).toBe(3 * found.closed.points.length);
  expect(found.open.kind).toBe('path');
  expect(found.open.length).toBeCloseTo(Math.hypot(5, 3), 10);
  expect(found.point).toMatchObject({ kind: 'point', promise: 'shortest', length: 0, points: [] });
  expect(found.fixed.pieces.length).toBe(5);
  expect(found.csv.split('\n').length).toBe(7);
  expect(Object.keys(found.json)).toEqual([
    'file',
    'unit',
    'kind',
    'promise',
    'component',
    'lengthBefore',
    'length',
    'pieces',
    'points',
  ]);
  expect(found.codes).toEqual(['INVALID_OPTION', 'VERTEX_OUT_OF_RANGE']);
});

test('the tube of a narrowed prism: stations, the degree of the narrowing, files of both', async () => {
  const found = await page.evaluate(async () => {
    const kernel = await girth.createKernel({ threads: 1 });
    const corners = 12;
    const lines: string[] = [];
    for (let ring = 0; ring <= 24; ring++) {
      const away = Math.abs(ring - 12) / 4;
      const radius = away < 1 ? 1 - (1 + Math.cos(Math.PI * away)) / 4 : 1;
      for (let i = 0; i < corners; i++) {
        const angle = (2 * Math.PI * i) / corners;
        lines.push(`v ${radius * Math.cos(angle)} ${radius * Math.sin(angle)} ${ring / 2}`);
      }
    }
    const at = (ring: number, i: number) => ring * corners + (i % corners) + 1;
    for (let ring = 0; ring < 24; ring++) {
      for (let i = 0; i < corners; i++) {
        lines.push(`f ${at(ring, i)} ${at(ring, i + 1)} ${at(ring + 1, i + 1)} ${at(ring + 1, i)}`);
      }
    }
    const mesh = await kernel.load(girth.obj(lines.join('\n'), 'tube.obj'));
    const tubes = await mesh.tubes({ ends: [0, 24 * corners], reference: 'mean' });
    const csv = new TextDecoder().decode(await mesh.write(tubes, 'csv'));
    const json = JSON.parse(new TextDecoder().decode(await mesh.write(tubes, 'json'))) as object;
    const { code } = await girth.refusal(mesh.tubes({ leastDegree: 0 }));
    const rough = await girth.refusal(mesh.tubes({ reference: 'both' as never }));
    kernel.dispose();
    return { tubes, csv, json, codes: [code, rough.code] };
  });
  const [place] = found.tubes.places;
  expect(found.tubes.branches).toMatchObject([{ component: 0, ends: true, open: true }]);
  expect(found.tubes.branches[0]!.parent).toBeUndefined();
  expect(found.tubes.others).toEqual([]);
  expect(found.tubes.places.length).toBe(1);
  expect(place!.change).toBe('narrowing');
  expect(place!.degreeByDiameter).toBeCloseTo(0.5, 2);
  expect(place!.girth).toBeCloseTo(place!.perimeter, 3);
  expect(found.csv.split('\n').length).toBe(found.tubes.stations.length + 2);
  expect(found.csv.split('\n')[0]).toMatch(/^number,branch,distance,equivalentDiameter,/);
  expect(Object.keys(found.json)).toEqual([
    'file',
    'unit',
    'branches',
    'others',
    'places',
    'stations',
  ]);
  expect(found.codes).toEqual(['INVALID_OPTION', 'USAGE']);
});

test('sections of a prism: planes at heights, through points, the widest; and measures at landmarks', async () => {
  const found = await page.evaluate(async () => {
    const kernel = await girth.createKernel({ threads: 1 });
    // A box of 2 by 3 by 4.
    const corners = ['0 0 0', '2 0 0', '2 3 0', '0 3 0', '0 0 4', '2 0 4', '2 3 4', '0 3 4'];
    const faces = ['4 3 2 1', '5 6 7 8', '1 2 6 5', '2 3 7 6', '3 4 8 7', '4 1 5 8'];
    const lines = [...corners.map((one) => `v ${one}`), ...faces.map((one) => `f ${one}`)];
    const mesh = await kernel.load(girth.obj(lines.join('\n'), 'box.obj'));
    const normal = [0, 0, 1] as const;
    const { sections } = await mesh.sections({ normal, offsets: [1, 9], inscribed: true });
    const through = await mesh.sectionsThrough({ points: [1, 4], normal: [1, 0, 0] });
    const range = { low: 1, high: 2, measure: 'tape' } as const;
    const widest = await mesh.extremeSection({ normal, extreme: 'widest', ...range });
    const at = { point: { face: 4, weights: [0.25, 0.25, 0.5] } } as const;
    const { measures } = await mesh.measureLandmarks({
      landmarks: [
        { name: 'waist', how: 'tape', ...at },
        { name: 'all', how: 'section', all: true, ...at },
        { name: 'height', how: 'distance', point: 0, to: 4 },
      ],
    });
    const csv = new TextDecoder().decode(await mesh.write({ measures }, 'csv'));
    const refusals = [
      mesh.sections({ normal } as never),
      mesh.sections({ normal, offsets: [1], inscribe: true } as never),
      mesh.sections({ normal: [0, 0, 0], offsets: [1] }),
      mesh.sections({ normal: [0, 1] as never, offsets: [1] }),
      mesh.extremeSection({ normal, extreme: 'tallest' as never }),
      mesh.extremeSection({ normal, extreme: 'narrowest', low: 7, high: 9 }),
      mesh.sectionsThrough({ points: [1.5] }),
      mesh.sectionsThrough({ points: [{ face: 0 } as never] }),
      mesh.measureLandmarks({ landmarks: [{ name: 'neck', how: 'tape' } as never] }),
      mesh.measureLandmarks({
        landmarks: [{ name: 'neck', how: 'tape', point: 0, acros: true } as never],
      }),
      mesh.measureLandmarks({ landmarks: [{ name: 'neck', how: 'distance', point: 0 }] }),
    ].map(async (call) => (await girth.refusal(call)).code);
    const codes = await Promise.all(refusals);
    kernel.dispose();
    return { sections, through, widest, measures, csv, codes };
  });
  const [cut, missed] = found.sections;
  expect(cut!.perimeter).toBeCloseTo(10, 12);
  expect(cut!.curves[0]).toMatchObject({ closed: true, hole: false, inscribedDiameter: 2 });
  expect(cut!.curves[0]!.limb).toBeUndefined();
  expect(missed!.curves).toEqual([]);
  expect(found.through.sections.map(({ offset }) => offset)).toEqual([2, 0]);
  expect(found.widest.tape).toBeCloseTo(10, 12);
  expect(found.widest.curves[0]!.inscribedDiameter).toBeNaN();
  const [waist, all, height] = found.measures;
  expect([waist!.name, waist!.how]).toEqual(['waist', 'tape']);
  for (const { length } of [waist!, all!]) expect(length).toBeCloseTo(10, 12);
  expect(height!.length).toBeCloseTo(4, 12);
  expect(found.csv.split('\n')[0]).toBe('number,name,how,x,y,z,length,unit');
  const option = 'INVALID_OPTION';
  expect(found.codes).toEqual([
    ...[
      'USAGE',
      'USAGE',
      option,
      'USAGE',
      'USAGE',
      option,
      'VERTEX_OUT_OF_RANGE',
      'USAGE',
      'USAGE',
      'USAGE',
    ],
    'VERTEX_OUT_OF_RANGE',
  ]);
});
