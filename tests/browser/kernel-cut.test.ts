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

/** The files that the command writes of a model that is cut at its first neck. */
function byCommand(
  model: string | Buffer,
  ending: string,
  name = 'model.obj',
  where = ['--neck', '0', '--cap'],
): Buffer[] {
  const input = join(scratch, name);
  writeFileSync(input, model);
  const isForEach = ending === 'stl' || ending === 'ply';
  const output = join(scratch, isForEach ? `cut-*.${ending}` : `cut.${ending}`);
  const words = ['cut', input, ...where, '--force', '-o', output];
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

test('loops of points, and level curves of the girth, are cut along as by the command, to the bit', async () => {
  const model = dumbbell(16, 12);
  const mine = await page.evaluate(async (text) => {
    const kernel = await girth.createKernel({ threads: 1 });
    const mesh = await kernel.load(girth.obj(text));
    const igf = await mesh.field('igf');
    const texts = async (curves: Parameters<typeof mesh.exportCut>[0]) =>
      (await mesh.exportCut(curves, 'obj', { cap: true })).map((bytes) =>
        [...bytes].map((b) => String.fromCharCode(b)).join(''),
      );
    // One whose loop goes through the middle of the dumbbell.
    const vertex = igf.values.findIndex(
      (value, v) => igf.kinds[v] === 0 && value < 1.01 * igf.range[0],
    );
    const loop = await mesh.loop(vertex);
    const inside = await mesh.loop({ face: 100, weights: [0.2, 0.3, 0.5] });
    const level = (igf.range[0] + igf.range[1]) / 2;
    const curves = await mesh.levelCurves(igf, level);
    const { positions, origin } = mesh.geometry;
    const { indices } = mesh.geometry;
    const mix = (of: ArrayLike<number>, wide: number) => (point: (typeof loop.points)[0]) => {
      const corners =
        typeof point === 'number' ? [point] : [0, 1, 2].map((k) => indices[3 * point.face + k]!);
      const weights = typeof point === 'number' ? [1] : point.weights;
      return Array.from({ length: wide }, (_, k) =>
        corners.reduce((sum, v, i) => sum + weights[i]! * of[wide * v + k]!, 0),
      );
    };
    const refused = [
      await girth.refusal(mesh.levelCurves(igf, NaN)),
      await girth.refusal(mesh.levelCurves({ ...igf, values: igf.values.slice(1) }, level)),
    ];
    const barcode = await mesh.barcode(vertex, { loops: true });
    const result = {
      files: {
        loop: await texts([loop.points]),
        level: await texts(curves.map(({ points }) => points)),
      },
      ...{ vertex, level, origin, codes: refused.map(({ code }) => code) },
      none: (await mesh.levelCurves(igf, 2 * igf.range[1])).length,
      closed: curves.map(({ closed }) => closed),
      ends: [inside.points[0], inside.points.at(-1), inside.base],
      drawn: [loop, inside, ...curves, ...barcode.loops].map(({ points, polyline }) => ({
        polyline: [...polyline],
        points: points.flatMap(mix(positions, 3)),
      })),
      levels: curves.flatMap(({ points }) => points.flatMap(mix(igf.values, 1))),
    };
    kernel.dispose();
    return result;
  }, model);
  for (const [kind, where] of [
    ['loop', String(mine.vertex)],
    ['level', `--at=${mine.level}`],
  ] as const) {
    const theirs = byCommand(model, 'obj', 'model.obj', [where, '--cap']);
    expect(theirs.length).toBe(1);
    // As booleans: the files are no words to be compared in a message.
    expect([kind, theirs[0]!.toString('latin1') === mine.files[kind][0]]).toEqual([kind, true]);
    expect(theirs[0]!.toString('latin1').match(/^o /gm)!.length).toBeGreaterThan(1);
  }
  expect(mine.codes).toEqual(['INVALID_OPTION', 'USAGE']);
  expect(mine.none).toBe(0);
  expect(mine.closed).toEqual(mine.closed.map(() => true));
  // From p to p; the points are those of the line, and the field has the level there.
  expect(mine.ends).toEqual([mine.ends[2], mine.ends[2], mine.ends[2]]);
  expect(mine.drawn.length).toBeGreaterThan(3);
  for (const { polyline, points } of mine.drawn) {
    expect(points.length).toBe(polyline.length);
    points.forEach((x, i) => expect(x).toBeCloseTo(polyline[i]!, 5));
  }
  for (const value of mine.levels) expect(value).toBeCloseTo(mine.level, 9);
});

/** The numbers of an OBJ's lines of one kind. */
const linesOf = (text: string, kind: string): number[][] =>
  text
    .split('\n')
    .filter((line) => line.startsWith(`${kind} `))
    .map((line) => line.split(' ').slice(1).map(Number));

/** A dumbbell with colours; as PLY with a field and texture coordinates too, which have a seam along half of its faces. */
function coloured(isPly: boolean): string {
  const plain = dumbbell(16, 12);
  const points = linesOf(plain, 'v').map(([x, y, z]) => [x!, y!, z!] as const);
  const faces = linesOf(plain, 'f');
  const colour = (i: number): number[] => [i % 256, (7 * i) % 256, (31 * i) % 256];
  if (!isPly) {
    const vertices = points.map(
      (point, i) =>
        `v ${point.join(' ')} ${colour(i)
          .map((c) => c / 255)
          .join(' ')}`,
    );
    return [...vertices, ...faces.map((face) => `f ${face.join(' ')}`), ''].join('\n');
  }
  const both = [...points, ...points];
  const line = ([x, y, z]: readonly [number, number, number], i: number): string =>
    [x, y, z, ...colour(i % points.length), i / both.length, (x + 3) / 6, x * y].join(' ');
  const list = faces.map((face, f) => {
    const shift = f % 2 === 0 ? -1 : points.length - 1;
    return `3 ${face.map((vertex) => vertex + shift).join(' ')}`;
  });
  return [
    'ply\nformat ascii 1.0',
    `element vertex ${both.length}`,
    ...['x', 'y', 'z'].map((name) => `property double ${name}`),
    ...['red', 'green', 'blue'].map((name) => `property uchar ${name}`),
    ...['s', 't', 'heat'].map((name) => `property double ${name}`),
    `element face ${faces.length}`,
    'property list uchar int vertex_indices\nend_header',
    ...both.map(line),
    ...list,
    '',
  ].join('\n');
}

test('parts keep the colours, texture coordinates and fields of their file, and faces know their part, as by the command', async () => {
  // The model as glTF, by the command: no neck of the PLY stands out so much, and nothing is cut.
  const uncut = ['--necks', '--min-prominence', '1000'];
  const glb = byCommand(coloured(true), 'glb', 'whole.ply', uncut)[0]!;
  for (const name of ['coloured.ply', 'coloured.obj', 'coloured.glb']) {
    const model = name.endsWith('glb') ? glb : Buffer.from(coloured(name.endsWith('ply')));
    const mine = await page.evaluate(
      async ({ bytes, name }) => {
        const kernel = await girth.createKernel({ threads: 1 });
        const content = Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0));
        const mesh = await kernel.load(new File([content], name));
        const { necks } = await mesh.necks(await mesh.field('igf'));
        const files: Record<string, string[]> = {};
        for (const format of ['ply', 'obj', 'glb', 'csv'] as const) {
          const all = await mesh.exportCut([necks[0]!.points], format, { cap: true });
          files[format] = all.map((bytes) =>
            [...bytes].map((b) => String.fromCharCode(b)).join(''),
          );
        }
        // Content of the file goes with its surface only.
        const [plain] = await (await mesh.remesh(300)).exportCut([], 'ply');
        kernel.dispose();
        return { files, plain: String.fromCharCode(...plain!.slice(0, 300)) };
      },
      { bytes: model.toString('base64'), name },
    );
    for (const format of ['ply', 'obj', 'glb', 'csv'] as const) {
      const theirs = byCommand(model, format, name).map((bytes) => bytes.toString('latin1'));
      expect(theirs.length).toBeGreaterThan(0);
      expect(mine.files[format]!.length).toBe(theirs.length);
      // As booleans: the files are no words to be compared in a message.
      theirs.forEach((file, i) =>
        expect([format, i, file === mine.files[format]![i]]).toEqual([format, i, true]),
      );
    }
    const [first] = mine.files['ply']!;
    expect(first).toContain('property uchar red');
    expect(first!.includes('heat')).toBe(!name.endsWith('obj'));
    expect(mine.plain).toContain('ply');
    expect(mine.plain).not.toContain('red');
  }
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

interface WrittenSegments {
  thresholds: { girth: number; shapeDiameter: number };
  crossing: number[];
  segments: {
    area: number;
    faces: number;
    kind: string;
    shares: Record<string, number>;
    tips: { tip: number }[];
  }[];
  faces: number[];
}

test('segments, their labels, kinds and tips, and their files are those of the command', async () => {
  const model = dumbbell(16, 12);
  const mine = await page.evaluate(async (text) => {
    const kernel = await girth.createKernel({ threads: 1 });
    const mesh = await kernel.load(girth.obj(text, 'divided.obj'));
    const [igf, sdf] = [await mesh.field('igf'), await mesh.field('sdf')];
    const progress: number[] = [];
    const options = { minProminence: 0.1, onProgress: (share: number) => progress.push(share) };
    const found = await mesh.segments(igf, sdf, options);
    const files: Record<string, string> = {};
    for (const format of ['csv', 'json', 'glb'] as const) {
      const bytes = await mesh.exportSegments(igf, sdf, format, { minProminence: 0.1 });
      files[format] = [...bytes].map((b) => String.fromCharCode(b)).join('');
    }
    const limits = { girth: Infinity, shapeDiameter: Infinity };
    const tubes = await mesh.segments(igf, sdf, { minProminence: 0.1, ...limits });
    // The narrowest neck has infinite prominence.
    const bodies = await mesh.segments(igf, sdf, {
      minProminence: 1e9,
      girth: 0,
      shapeDiameter: 0,
    });
    const stop = new AbortController();
    const stopped = girth.refusal(mesh.segments(igf, sdf, { signal: stop.signal }));
    stop.abort();
    const refused = [
      await stopped,
      await girth.refusal(mesh.segments(sdf, igf)),
      await girth.refusal(mesh.segments(igf, sdf, { minProminence: -1 })),
      await girth.refusal(mesh.segments(igf, sdf, { girth: NaN })),
      await girth.refusal(mesh.segments(igf, sdf, { shapeDiameter: -1 })),
      await girth.refusal(mesh.segments(igf, sdf, { smoothing: NaN })),
    ];
    const { area, faceCount } = mesh.info;
    const tipCount = (await mesh.tips(igf)).tips.length;
    kernel.dispose();
    return {
      found: girth.plain(found),
      files,
      tubes: tubes.segments.map(({ kind, shares }) => [kind, shares.tube]),
      bodies: bodies.segments.map(({ kind, shares }) => [kind, shares.body]),
      progress,
      codes: refused.map(({ code }) => code),
      ...{ area, faceCount, tipCount },
    };
  }, model);
  const theirs: Record<string, string> = {};
  writeFileSync(join(scratch, 'divided.obj'), model);
  for (const format of ['csv', 'json', 'glb']) {
    const output = `divided.${format}`;
    const words = ['segments', 'divided.obj', '--min-prominence', '0.1', '-o', output];
    execFileSync(command, words, { stdio: 'ignore', cwd: scratch });
    theirs[format] = readFileSync(join(scratch, output), 'latin1');
    // As booleans: the files are no words to be compared in a message.
    expect([format, mine.files[format] === theirs[format]]).toEqual([format, true]);
  }
  const written = JSON.parse(theirs['json']!) as WrittenSegments;
  const { segments, labels, thresholds, crossing } = mine.found;
  expect([...labels]).toEqual(written.faces);
  expect([thresholds, crossing]).toEqual([written.thresholds, written.crossing]);
  expect(
    segments.map(({ area, faces, kind, shares, tips }) => {
      return { area, faces: faces.length, kind, shares, tips };
    }),
  ).toEqual(
    written.segments.map(({ area, faces, kind, shares, tips }) => {
      return { area, faces, kind, shares, tips: tips.map(({ tip }) => tip) };
    }),
  );
  // Nothing is lost, and a face has the label of a segment that has a piece of it.
  expect(segments.length).toBeGreaterThan(1);
  expect(segments.reduce((sum, { area }) => sum + area, 0)).toBeCloseTo(mine.area, 9);
  expect(labels.length).toBe(mine.faceCount);
  labels.forEach((label, face) => expect(segments[label]!.faces).toContain(face));
  const tips = segments.flatMap(({ tips }) => tips).sort((a, b) => a - b);
  expect(tips).toEqual(Array.from({ length: mine.tipCount }, (_, i) => i));
  for (const { shares } of segments) {
    expect(Object.values(shares).reduce((sum, share) => sum + share, 0)).toBeCloseTo(1, 9);
  }
  for (const [kind, found] of [
    ['tube', mine.tubes],
    ['body', mine.bodies],
  ] as const) {
    expect(found.map(([of]) => of)).toEqual([kind, kind]);
    for (const [, share] of found) expect(share).toBeCloseTo(1, 9);
  }
  expect(mine.progress.at(-1)).toBe(1);
  expect(mine.codes).toEqual(['CANCELLED', 'USAGE', 'INVALID_OPTION', 'USAGE', 'USAGE', 'USAGE']);
});
