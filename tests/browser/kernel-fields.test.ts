// Fields besides the girth, tips and parts, with the real modules in Chromium: the same bits as the
// command gives, with threads and with a pool; and what is said of surfaces that have none.

import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, describe, expect, test } from 'vitest';
import type {
  FieldName,
  FieldOptions,
  SpectralFieldName,
  SpectralOptions,
} from '../../web/src/kernel/index.js';
import type { KernelPage } from './kernel-page.js';
import { onKernelPage } from './kernel-site.js';
import { box, dumbbell, torus, tube } from './meshes.js';
import { chromiumForTests, command, differing } from './support.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const scratch = mkdtempSync(join(tmpdir(), 'girth-fields-'));
const openPage = chromiumForTests();

afterAll(() => rmSync(scratch, { recursive: true }));

/** The file that the command writes about a model, given as OBJ. */
function written(text: string, ending: string, ...words: string[]): string {
  const [model, output] = [join(scratch, 'model.obj'), join(scratch, `output.${ending}`)];
  writeFileSync(model, text);
  const [name, ...options] = words;
  const { status } = spawnSync(command, [name!, model, ...options, '-o', output]);
  // 4: the command has found weak places.
  if (status !== 0 && status !== 4) throw new Error(`girth ${name} ends with ${status}`);
  return readFileSync(output, 'utf8');
}

/** The column of a CSV that has a name. */
function column(csv: string, name: string): number[] {
  const [header, ...rows] = csv.trim().split('\n');
  const place = header!.split(',').indexOf(name);
  const cells = rows.map((row) => row.split(',')[place]!);
  return cells.map((cell) => (cell === '' ? NaN : Number(cell)));
}

/** JSON that the command or the kernel has written. */
type Written = Record<string, unknown>;

/** Two bulbs on a thin neck: tips, a tube, and thick ends. */
const bulbs = dumbbell(30, 18);

/** Enough faces to be computed in bands round loops. */
const ring = torus(64, 24);

/** A model with its faces turned over. */
const turned = (text: string) => text.replace(/^f (\S+) (\S+) (\S+)$/gm, 'f $1 $3 $2');

for (const mode of ['threads', 'pool'] as const) {
  describe(`fields, ${mode}`, () => {
    let page: Page;
    onKernelPage(openPage, mode, (opened) => (page = opened));

    const fields: [FieldName, FieldOptions, string[], string][] = [
      ['sdf', {}, [], '30 rays'],
      [
        'sdf',
        { sdf: { rays: 7, coneRadians: Math.PI / 2 } },
        ['--rays', '7', '--cone', '90'],
        '7 rays',
      ],
      ['thickness', {}, [], 'sharp below 75 degrees'],
      [
        'thickness',
        { thickness: { sharpRadians: Math.PI / 3 } },
        ['--sharp', '60'],
        'sharp below 60 degrees',
      ],
      ['geoaverage', {}, [], 'fast marching'],
      ['geofarthest', {}, [], 'fast marching'],
      ['geoaverage', { distances: 'exact' }, ['--exact'], 'exact'],
    ];
    test.each(fields)(
      '%s %o: the same bits as the command',
      async (name, options, words, method) => {
        for (const text of [bulbs, torus(24, 16), tube(12, 9, 3)]) {
          const native = column(written(text, 'csv', 'field', '--field', name, ...words), name);
          const field = await page.evaluate(
            async ([text, name, options]) => {
              const kernel = await girth.createKernel({ threads: 2 });
              const mesh = await kernel.load(girth.obj(text));
              const field = await girth.watchedField(mesh, options, name);
              kernel.dispose();
              return field;
            },
            [text, name, options] as const,
          );
          expect(differing(field.values, native)).toBe(0);
          const known = native.filter((value) => !Number.isNaN(value));
          expect(field).toMatchObject({
            range: [Math.min(...known), Math.max(...known)],
            withoutValue: native.length - known.length,
            method,
            unit: '',
            kinds: [],
            reportedOnce: true,
            wrong: 0,
          });
          expect(field.progress.at(-1)).toBe(1);
        }
      },
    );

    test('an urgent field comes before the girth, which goes on after it: all with the same bits', async () => {
      const text = torus(60, 40);
      const native = {
        igf: column(written(text, 'csv', 'igf'), 'igf'),
        thickness: column(written(text, 'csv', 'field', '--field', 'thickness'), 'thickness'),
      };
      const found = await page.evaluate(async (text) => {
        const kernel = await girth.createKernel({ threads: 2 });
        const mesh = await kernel.load(girth.obj(text));
        const ended: string[] = [];
        const seen: number[] = [];
        let begun = (): void => undefined;
        const isBegun = new Promise<void>((resolve) => (begun = resolve));
        const igf = mesh.field('igf', {
          onPartial: ({ vertices }) => {
            seen.push(...vertices);
            begun();
          },
        });
        await isBegun;
        const before = seen.length;
        const thickness = mesh.field('thickness', { urgent: true });
        void igf.then(() => ended.push('igf'));
        void thickness.then(() => ended.push('thickness'));
        const values = { igf: (await igf).values, thickness: (await thickness).values };
        kernel.dispose();
        return {
          ...{ ended, before, reports: seen.length, distinct: new Set(seen).size },
          values: { igf: [...values.igf], thickness: [...values.thickness] },
        };
      }, text);
      expect(found.before).toBeLessThan(native.igf.length);
      expect(found.ended).toEqual(['thickness', 'igf']);
      expect([found.reports, found.distinct]).toEqual([native.igf.length, native.igf.length]);
      expect(differing(found.values.igf, native.igf)).toBe(0);
      expect(differing(found.values.thickness, native.thickness)).toBe(0);
    });

    test('igf with a persistence: the same bits as the command, also read off barcodes', async () => {
      for (const [text, percent] of [
        [bulbs, 5],
        [torus(24, 16), 3],
      ] as const) {
        const words = ['--persistence', `${percent}%`];
        const native = column(written(text, 'csv', 'igf', ...words), 'igf');
        const plain = column(written(text, 'csv', 'igf'), 'igf');
        const result = await page.evaluate(
          async ([text, percent]) => {
            const kernel = await girth.createKernel({ threads: 2 });
            const mesh = await kernel.load(girth.obj(text));
            const persistence = (percent / 100) * Math.sqrt(mesh.info.area);
            const field = await girth.watchedField(mesh, { persistence });
            const barcodes = await mesh.barcodes({ maxPersistence: 2 * persistence });
            const read = barcodes.girth(persistence);
            const at = 5;
            const { length } = await mesh.loop(at, { persistence });
            const barcode = await mesh.barcode(at, { maxPersistence: persistence, loops: true });
            const { bars, loops } = barcode;
            const answer = {
              field,
              read: { values: Array.from(read.values), kinds: Array.from(read.kinds) },
              method: read.method,
              atPoint: [length, field.values[at]],
              births: bars.map(({ birth }) => 2 * birth),
              lengths: loops.map((loop) => loop.length),
              ofAll: Array.from(barcodes.bars.slice(2 * barcodes.offsets[at]!)).slice(0, 2),
              first: bars[0] && [bars[0].birth, bars[0].death],
              refused: await girth.refusal(Promise.resolve().then(() => barcodes.girth(0))),
            };
            kernel.dispose();
            return answer;
          },
          [text, percent] as const,
        );
        const { field, read, atPoint, births, lengths } = result;
        expect(differing(field.values, native)).toBe(0);
        expect(native.some((value, v) => value > plain[v]!)).toBe(text === bulbs);
        expect(field).toMatchObject({ reportedOnce: true, wrong: 0, withoutValue: 0 });
        expect(field.method).toMatch(/^exact, persistence 0\.\d+$/);
        expect(result.method).toBe(field.method);
        expect(differing(read.values, native)).toBe(0);
        expect(read.kinds).toEqual(field.kinds);
        expect(atPoint[0]).toBe(atPoint[1]);
        expect(births).toEqual(lengths);
        if (result.first) expect(result.ofAll[0]).toBe(result.first[0]);
        expect(result.refused.code).toBe('USAGE');
      }
    });

    test('a persistence that is none is refused', async () => {
      const codes = await page.evaluate(
        async (text) => {
          const kernel = await girth.createKernel({ threads: 2 });
          const mesh = await kernel.load(girth.obj(text));
          const codes = [];
          for (const persistence of [-1, NaN, Infinity]) {
            codes.push((await girth.refusal(mesh.field('igf', { persistence }))).code);
            codes.push((await girth.refusal(mesh.loop(0, { persistence }))).code);
            const maxPersistence = persistence;
            codes.push((await girth.refusal(mesh.barcodes({ maxPersistence }))).code);
          }
          for (const maxPersistence of [-1, NaN]) {
            codes.push((await girth.refusal(mesh.barcode(0, { maxPersistence }))).code);
          }
          codes.push((await girth.refusal(mesh.barcode(1e9))).code);
          const whole = await mesh.barcode(0);
          const none = await mesh.barcode(0, { maxSaddles: 0 });
          kernel.dispose();
          return { codes, whole: whole.rest.kind, none: none.bars.length };
        },
        torus(8, 6),
      );
      expect(codes.codes).toEqual([
        ...new Array<string>(11).fill('INVALID_OPTION'),
        'VERTEX_OUT_OF_RANGE',
      ]);
      expect(codes).toMatchObject({ whole: 'antipodal', none: 0 });
    });

    test('the refined girth: the same bits as the command, with states and audit', async () => {
      const csv = written(ring, 'csv', 'igf', '--method', 'refined', '--audit', '30');
      const words = ['proved', 'consistent', 'suspect'];
      const states = csv
        .trim()
        .split('\n')
        .slice(1)
        .map((row) => words.indexOf(row.split(',')[3]!));
      const result = await page.evaluate(async (text) => {
        const kernel = await girth.createKernel({ threads: 2 });
        const mesh = await kernel.load(girth.obj(text));
        const progress: number[] = [];
        const onProgress = (share: number) => progress.push(share);
        const refined = await mesh.refinedGirth({ audit: 30, onProgress });
        const file = new TextDecoder().decode(await mesh.exportField(refined, 'csv'));
        const npy = await mesh.exportField(refined, 'npy');
        const tips = await mesh.tips(refined);
        const remeshed = await mesh.remesh(800);
        const coarse = await remeshed.field('igf');
        const carried = await remeshed.carryField(coarse);
        const wrong = [];
        for (const one of [{ coarseFaces: 3 }, { audit: -1 }, { seed: 0.5 }, { audit: NaN }]) {
          wrong.push((await girth.refusal(mesh.refinedGirth(one))).code);
        }
        const answer = {
          ...girth.plain(refined),
          ...{ file, progress, wrong, tips: tips.tips.length, npyBytes: npy.length },
          same: Array.from(carried.values).every((value, v) => {
            return Math.abs(value / refined.values[v]! - 1) < 0.1;
          }),
          carriedKinds: girth.plain(carried.kinds),
          carriedMethod: carried.method,
          size: mesh.info.vertexCount,
        };
        kernel.dispose();
        return answer;
      }, ring);
      expect(result.file).toBe(csv);
      expect(differing(result.values, column(csv, 'igf'))).toBe(0);
      expect(result.states).toEqual(states);
      expect(new Set(states)).toEqual(new Set([0, 1]));
      expect(result).toMatchObject({ name: 'igf', method: 'refined', unit: '', withoutValue: 0 });
      expect(result).toMatchObject({ note: '', coarseFaces: 768, tips: 0, same: true });
      expect(result.audit).toMatchObject({ vertices: 30, equal: 30, greatest: 0, atMost: 1 });
      expect(result.audit.atLeast).toBeGreaterThan(0.88);
      expect(result.progress).toEqual([...result.progress].sort((a, b) => a - b));
      expect(result.progress.at(-1)).toBe(1);
      // Doubles behind a header: no states among them.
      expect(result.npyBytes).toBe(128 + 8 * result.size);
      expect(result.carriedKinds).toEqual(result.kinds);
      expect(result.carriedMethod).toBe('exact on 800 faces');
      expect(result.wrong).toEqual(new Array(4).fill('INVALID_OPTION'));
    });

    test('the refined girth ends at once when it is cancelled, and the next field is computed', async () => {
      const result = await page.evaluate(async (text) => {
        const kernel = await girth.createKernel({ threads: 2 });
        const mesh = await kernel.load(girth.obj(text));
        const controller = new AbortController();
        let told = 0;
        const { signal } = controller;
        const refined = mesh.refinedGirth({
          signal,
          onProgress: () => {
            ++told;
            controller.abort();
          },
        });
        const { code } = await girth.refusal(refined);
        const toldUntilThen = told;
        const field = await mesh.field('sdf');
        const mended = await mesh.refinedGirth({ audit: 0 });
        kernel.dispose();
        const { vertices, atLeast, atMost } = mended.audit;
        return {
          ...{ code, more: told - toldUntilThen, audit: [vertices, atLeast, atMost] },
          complete: field.withoutValue === 0 && mended.withoutValue === 0,
        };
      }, ring);
      expect(result).toMatchObject({ code: 'CANCELLED', more: 0, complete: true });
      expect(result.audit).toEqual([0, 0, 1]);
    });

    test('angle: that of the loops', async () => {
      const result = await page.evaluate(async (text) => {
        const kernel = await girth.createKernel({ threads: 2 });
        const mesh = await kernel.load(girth.obj(text));
        const field = await girth.watchedField(mesh, {}, 'angle');
        const angles = [];
        for (let v = 0; v < mesh.info.vertexCount; v += 7) angles.push((await mesh.loop(v)).angle);
        kernel.dispose();
        return { field, angles };
      }, bulbs);
      const { field, angles } = result;
      expect(field.values.filter((_, v) => v % 7 === 0)).toEqual(angles);
      expect(field).toMatchObject({ unit: 'radian', method: 'exact', withoutValue: 0, note: '' });
      expect(Math.max(...angles)).toBeGreaterThan(1);
    });

    // Rounding differs between compilers: no bits here. On a surface whose values differ: of equal
    // eigenvalues some may be cut off, and which eigenfunctions those are is arbitrary.
    const uneven = torus(24, 16);
    const spectral: [SpectralFieldName, SpectralOptions, string[], string][] = [
      ['hks', { pairs: 40, time: 0.01 }, ['--pairs', '40', '--time', '0.01'], 'hks'],
      ['wks', { pairs: 60, component: 20 }, ['--pairs', '60'], 'wks_20'],
      ['sihks', { pairs: 60 }, ['--pairs', '60'], 'sihks_1'],
    ];
    test.each(spectral)('%s %o: what the command gives', async (name, spectral, words, named) => {
      const native = column(written(uneven, 'csv', 'field', '--field', name, ...words), named);
      const { field, other, refused } = await page.evaluate(
        async ([text, symmetric, name, spectral]) => {
          const kernel = await girth.createKernel({ threads: 2 });
          const mesh = await kernel.load(girth.obj(text));
          const progress: number[] = [];
          const onProgress = (share: number) => progress.push(share);
          const field = girth.plain(await mesh.field(name, { spectral, onProgress }));
          const two = await kernel.load(girth.obj(symmetric));
          const other = girth.plain(await two.heatMaxima(spectral));
          const wrong = [{ pairs: 0 }, { pairs: NaN }, { component: 0 }, { component: 101 }];
          const refused = [];
          for (const one of wrong) {
            const asked = name === 'hks' ? { ...spectral, time: -1 } : { ...spectral, ...one };
            refused.push(await girth.refusal(mesh.field(name, { spectral: asked })));
          }
          kernel.dispose();
          return { field: { ...field, progress }, other, refused };
        },
        [uneven, bulbs, name, spectral] as const,
      );
      const largest = Math.max(...native.map(Math.abs));
      const off = field.values.map((value, v) => Math.abs(value - native[v]!) / largest);
      expect(Math.max(...off)).toBeLessThan(1e-6);
      expect(field).toMatchObject({ unit: '', withoutValue: 0, kinds: [] });
      expect(field.method).toMatch(/^\d+ eigenpairs/);
      expect(field.progress).toEqual([...field.progress].sort((a, b) => a - b));
      expect(field.progress.at(-1)).toBe(1);
      // Heat stays longest at the two ends.
      expect(other.length).toBeGreaterThanOrEqual(2);
      expect(refused.map(({ code }) => code)).toEqual(Array(4).fill('INVALID_OPTION'));
    });

    test('maxima of a field', async () => {
      const { maxima, minima, values } = await page.evaluate(async (text) => {
        const kernel = await girth.createKernel({ threads: 2 });
        const mesh = await kernel.load(girth.obj(text));
        const field = await mesh.field('geoaverage');
        const maxima = await mesh.maxima(field);
        const minima = await mesh.maxima(field, { minima: true });
        kernel.dispose();
        return { maxima, minima, values: Array.from(field.values) };
      }, bulbs);
      const [low, high] = [Math.min(...values), Math.max(...values)];
      // Far ends of the bulbs; the middle of the neck.
      expect(maxima.length).toBeGreaterThanOrEqual(2);
      expect(maxima[0]).toMatchObject({ value: high, persistence: high - low, saddle: -1 });
      expect(values[maxima[0]!.vertex]).toBe(high);
      expect(minima[0]).toMatchObject({ value: low, saddle: -1 });
      expect(values[minima[0]!.vertex]).toBe(low);
      for (const { value, persistence, saddle } of maxima.slice(1)) {
        expect(value - values[saddle]!).toBe(persistence);
      }
    });

    test('shapes compared: by themselves, each with itself, by their own difference', async () => {
      const result = await page.evaluate(
        async ([a, b, c]) => {
          const kernel = await girth.createKernel({ threads: 2 });
          const meshes = [];
          for (const text of [a, b, c]) meshes.push(await kernel.load(girth.obj(text)));
          const progress: number[] = [];
          const { matrices, failed } = await kernel.compare(meshes, {
            descriptors: ['igf', 'sdf', 'geofarthest', 'igf-ms', 'sihks', 'igf-sdf', '2*igf+sdf'],
            onProgress: (share) => progress.push(share),
          });
          const differences = [];
          for (const name of ['igf', 'sdf', 'geofarthest'] as const) {
            const fields = [await meshes[0]!.field(name), await meshes[1]!.field(name)];
            differences.push(await meshes[0]!.difference(fields[0]!, meshes[1]!, fields[1]!));
          }
          const refused = [
            await girth.refusal(kernel.compare(meshes, { descriptors: ['igf', 'none'] })),
            await girth.refusal(kernel.compare(meshes, { descriptors: ['igf'], faces: -1 })),
            await girth.refusal(kernel.compare(meshes, { descriptors: ['igf'], smooth: 1.5 })),
          ];
          const smooth = await Promise.all(meshes.map((mesh) => mesh.smooth(3)));
          const smoothed = [
            await kernel.compare(meshes, { descriptors: ['igf'], smooth: 3 }),
            await kernel.compare(smooth, { descriptors: ['igf'] }),
          ].map((compared) => Array.from(compared.matrices[0]!.distances));
          const few = await kernel.compare(meshes, { descriptors: ['igf'], faces: 300 });
          kernel.dispose();
          const plain = matrices.map(({ distances }) => Array.from(distances));
          const fewer = Array.from(few.matrices[0]!.distances);
          return { matrices: plain, failed, progress, differences, refused, fewer, smoothed };
        },
        [bulbs, torus(24, 16), torus(30, 18)] as const,
      );
      expect(result.failed).toEqual([]);
      const [smoothed, ofSmooth] = result.smoothed;
      expect(smoothed).not.toEqual(result.matrices[0]);
      smoothed!.forEach((distance, i) => expect(distance).toBeCloseTo(ofSmooth![i]!, 9));
      result.matrices.forEach((matrix) => {
        for (let i = 0; i < 3; ++i) {
          expect(matrix[4 * i]).toBe(0);
          for (let k = 0; k < i; ++k) {
            expect(matrix[3 * i + k]).toBeGreaterThan(0);
            expect(matrix[3 * i + k]).toBe(matrix[3 * k + i]);
          }
        }
        // Two tori are more alike than a torus and the bulbs.
        expect(matrix[5]!).toBeLessThan(Math.min(matrix[1]!, matrix[2]!));
      });
      result.differences.forEach((difference, d) => {
        expect(result.matrices[d]![1]! / difference).toBeCloseTo(1, 9);
      });
      // Scaled to its mean, each part counts by its weight.
      const mean = (matrix: number[]) => (matrix[1]! + matrix[2]! + matrix[5]!) / 3;
      const [igf, sdf] = [result.matrices[0]!, result.matrices[1]!];
      const sum = (2 * igf[1]!) / mean(igf) + sdf[1]! / mean(sdf);
      expect(result.matrices[6]![1]! / sum).toBeCloseTo(1, 9);
      expect(result.fewer[1]! / igf[1]!).toBeGreaterThan(0.5);
      expect(result.fewer[1]! / igf[1]!).toBeLessThan(2);
      expect(result.progress).toEqual([...result.progress].sort((a, b) => a - b));
      expect(result.progress.at(-1)).toBe(1);
      expect(result.refused.map(({ code }) => code)).toEqual([
        'USAGE',
        'INVALID_OPTION',
        'INVALID_OPTION',
      ]);
    });

    test('a field in mid-run is cancelled, and the next one starts', async () => {
      const result = await page.evaluate(
        async ([long, short]) => {
          const kernel = await girth.createKernel({ threads: 2 });
          const mesh = await kernel.load(girth.obj(long));
          const controller = new AbortController();
          let reported = 0;
          const { code } = await girth.refusal(
            mesh.field('geoaverage', {
              distances: 'exact',
              signal: controller.signal,
              onPartial: ({ vertices }) => {
                reported += vertices.length;
                setTimeout(() => controller.abort());
              },
            }),
          );
          const next = await kernel.load(girth.obj(short));
          const field = await girth.watchedField(next, {}, 'sdf');
          kernel.dispose();
          return { code, reported, vertexCount: mesh.info.vertexCount, field };
        },
        [torus(160, 110), box(4, 3, 2)] as const,
      );
      expect(result.code).toBe('CANCELLED');
      expect(result.reported).toBeGreaterThan(0);
      expect(result.reported).toBeLessThan(result.vertexCount);
      expect(result.field.values.every((value) => value > 0)).toBe(true);
    });

    test('shape diameter of an open surface and of one inside out: said in words', async () => {
      const notes = await page.evaluate(
        async ([open, out]) => {
          const kernel = await girth.createKernel({ threads: 1 });
          const told = [];
          for (const text of [open, out]) {
            const mesh = await kernel.load(girth.obj(text));
            const field = await girth.watchedField(mesh, {}, 'sdf');
            told.push(field);
          }
          kernel.dispose();
          return told.map(({ note, withoutValue, values }) => ({
            note,
            withoutValue,
            count: values.length,
          }));
        },
        // A single triangle has no inside at all.
        ['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n', turned(torus(24, 16))] as const,
      );
      expect(notes[0]).toMatchObject({ withoutValue: 3, count: 3 });
      expect(notes[0]!.note).toContain('3 of 3 vertices have no shape diameter');
      expect(notes[1]!.note).toContain('inside out');
    });

    test('options out of range are refused, with words', async () => {
      const refusals = await page.evaluate(
        async (text) => {
          const kernel = await girth.createKernel({ threads: 1 });
          const mesh = await kernel.load(girth.obj(text));
          const wrong = [
            { rays: 0 },
            { rays: NaN },
            { rays: 1e9 },
            { coneRadians: 0 },
            { coneRadians: 4 },
            { coneRadians: NaN },
          ];
          const result = [];
          for (const sdf of wrong) result.push(await girth.refusal(mesh.field('sdf', { sdf })));
          const { values } = await mesh.field('sdf');
          kernel.dispose();
          return { result, count: values.length };
        },
        box(2, 2, 2),
      );
      expect(refusals.result.map(({ code }) => code)).toEqual(Array(6).fill('USAGE'));
      for (const { message } of refusals.result) expect(message).toMatch(/cone|rays/);
      expect(refusals.count).toBeGreaterThan(0);
    });

    test('tips, thresholds, parts and weak places: as the command writes them', async () => {
      const tips = JSON.parse(written(bulbs, 'json', 'tips')) as Written;
      const parts = JSON.parse(written(bulbs, 'json', 'parts')) as Written;
      const places = JSON.parse(
        written(bulbs, 'json', 'parts', '--girth', '2', '--shape-diameter', '1'),
      ) as Written;
      const weakest = ['--min-tube', '0.5', '--min-wall', '0.1'];
      const weakPlaces = JSON.parse(written(bulbs, 'json', 'parts', ...weakest)) as Written;
      const found = await page.evaluate(async (text) => {
        const kernel = await girth.createKernel({ threads: 2 });
        const mesh = await kernel.load(girth.obj(text, 'model.obj'));
        const [igf, sdf] = [await mesh.field('igf'), await mesh.field('sdf')];
        const suggested = await mesh.suggestedThresholds(igf, sdf);
        const json = (bytes: Uint8Array) => JSON.parse(new TextDecoder().decode(bytes)) as Written;
        const chosen = { girth: 2, shapeDiameter: 1 };
        const areas = await mesh.vertexAreas();
        const limits = { tubeDiameter: 0.5, wallThickness: 0.1 };
        const thickness = await mesh.field('thickness');
        const result = {
          area: mesh.info.area,
          areas: areas.reduce((sum, area) => sum + area, 0),
          suggested,
          tips: girth.plain(await mesh.tips(igf)),
          parts: girth.plain(await mesh.parts(igf, sdf, suggested)),
          check: girth.plain(await mesh.printCheck({ igf, thickness }, limits)),
          writtenTips: json(await mesh.exportTips(igf, 'json')),
          writtenParts: json(await mesh.exportParts(igf, sdf, suggested, 'json')),
          writtenChosen: json(await mesh.exportParts(igf, sdf, chosen, 'json')),
          writtenWeak: json(await mesh.exportWeakPlaces({ igf, thickness }, limits, 'json')),
          contours: new TextDecoder().decode(await mesh.exportTips(igf, 'obj')),
          csv: new TextDecoder().decode(await mesh.exportFields([igf, sdf], 'csv')).split('\n')[0],
          refusals: [
            await girth.refusal(mesh.parts(igf, sdf, { girth: NaN, shapeDiameter: 1 })),
            await girth.refusal(mesh.parts(igf, sdf, { girth: 1, shapeDiameter: -1 })),
            await girth.refusal(
              mesh.parts(igf, sdf, { girth: 1, shapeDiameter: 1, smoothing: -1 }),
            ),
            await girth.refusal(mesh.printCheck({}, { tubeDiameter: -1, wallThickness: 0 })),
            await girth.refusal(mesh.exportFields([igf, sdf], 'npy')),
            await girth.refusal(mesh.exportFields([igf, igf], 'csv')),
            await girth.refusal(mesh.exportFields([], 'csv')),
            await girth.refusal(mesh.exportFields([{ ...sdf, name: 'a,b' }], 'csv')),
            await girth.refusal(mesh.exportTips(igf, 'csv' as 'obj')),
          ],
        };
        kernel.dispose();
        return result;
      }, bulbs);
      expect(found.areas / found.area).toBeCloseTo(1, 12);
      const file = 'model.obj';
      expect(found.writtenTips).toEqual({ ...tips, file });
      expect(found.writtenParts).toEqual({ ...parts, file });
      expect(found.suggested).toEqual(parts['thresholds']);
      expect(found.writtenChosen).toEqual({ ...places, file });

      // The objects say the same as the files.
      expect(found.tips.tips.length).toBeGreaterThan(0);
      expect(found.tips.tips.map(({ jump, area, vertices }) => ({ jump, area, vertices }))).toEqual(
        (tips['tips'] as Written[]).map(({ jump, area, vertices }) => ({ jump, area, vertices })),
      );
      for (const { contour, apex, vertices } of found.tips.tips) {
        expect(vertices).toContain(apex);
        expect(contour.every(({ closed, polyline }) => closed && polyline.length >= 9)).toBe(true);
      }
      expect(found.contours).toMatch(/^o tip_0\n/);
      const named = found.parts.parts.map(({ kind, vertices }) => ({ kind, vertices }));
      expect(named).toEqual(
        (parts['parts'] as Written[]).map(({ kind, vertices }) => ({ kind, vertices })),
      );
      found.parts.parts.forEach(({ kind, vertices, thinnest }, number) => {
        for (const v of vertices) {
          expect(found.parts.partOf[v]).toBe(number);
          expect(['body', 'tube', 'plate', 'unknown'][found.parts.kinds[v]!]).toBe(kind);
        }
        if (kind !== 'unknown') expect(vertices).toContain(thinnest);
      });
      const { places: weak, failingShare, passingScale } = found.check;
      expect(found.writtenWeak).toEqual({ ...weakPlaces, file });
      expect(found.writtenWeak).toMatchObject({ failingShare, passingScale });
      expect(found.writtenWeak['passes']).toBe(weak.length === 0);
      expect(passingScale > 1).toBe(weak.length > 0);
      expect(found.csv).toBe('vertex,igf,kind,sdf');
      expect(found.refusals.map(({ code }) => code)).toEqual(Array(9).fill('USAGE'));
      expect(found.refusals[0]!.message).toContain("girth's threshold");
    });
  });
}
