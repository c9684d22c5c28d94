// The kernel with its real modules in Chromium, on a page that is cross-origin isolated and on one
// that is not, both under a strict content security policy; its bits against the command's.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, describe, expect, test } from 'vitest';
import { box, dumbbell, moved, torus } from './meshes.js';
import type { FacePoint } from '../../web/src/kernel/index.js';
import type { KernelPage } from './kernel-page.js';
import { onKernelPage } from './kernel-site.js';
import { chromiumForTests, command, differing, repository, type StaticServer } from './support.js';
import { loopByCommand } from './viewer-page.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const scratch = mkdtempSync(join(tmpdir(), 'girth-kernel-'));

/** Minutes of work: a field of it is in mid-run whenever something else happens. */
const endless = torus(160, 110);

const openPage = chromiumForTests();

afterAll(() => rmSync(scratch, { recursive: true }));

/** The values that the command computes of an OBJ file. */
function nativeValues(name: string, text: string): { values: number[]; kinds: number[] } {
  const [model, table] = [join(scratch, `${name}.obj`), join(scratch, `${name}.csv`)];
  writeFileSync(model, text);
  execFileSync(command, ['igf', model, '-o', table], { stdio: ['ignore', 'ignore', 'inherit'] });
  const rows = readFileSync(table, 'utf8').trim().split('\n').slice(1);
  const cells = rows.map((row) => row.split(','));
  return {
    values: cells.map(([, value]) => Number(value)),
    kinds: cells.map(([, , kind]) => (kind!.trim() === 'antipodal' ? 1 : 0)),
  };
}

for (const mode of ['threads', 'pool'] as const) {
  describe(`kernel, ${mode}`, () => {
    let page: Page;
    let server: StaticServer;
    onKernelPage(openPage, mode, (...opened) => ([page, server] = opened));

    test.each([1, 2])('starts with %i, in this mode, with nothing not needed', async (wanted) => {
      const started = await page.evaluate(async (wanted) => {
        const from = performance.now();
        const kernel = await girth.createKernel({ threads: wanted });
        const milliseconds = performance.now() - from;
        const { mode, threads } = kernel;
        kernel.dispose();
        return { mode, threads, milliseconds, isolated: crossOriginIsolated };
      }, wanted);
      console.log(`${mode}: started ${wanted} in ${started.milliseconds.toFixed(0)} ms`);
      expect(started).toMatchObject({ mode, threads: wanted, isolated: mode === 'threads' });
      expect(server.requests.some((path) => path.includes('threads'))).toBe(mode === 'threads');
    });

    test.each([
      ['torus', torus(40, 20)],
      ['dumbbell', dumbbell(30, 18)],
      ['box', box(8, 5, 3)],
    ])('%s: the same bits as the command', async (name, text) => {
      const native = nativeValues(name, text);
      const field = await page.evaluate(async (text) => {
        const kernel = await girth.createKernel({ threads: 2 });
        const mesh = await kernel.load(girth.obj(text));
        const field = await girth.watchedField(mesh);
        const loop = await mesh.loop(5);
        kernel.dispose();
        return { ...field, loop: { ...loop, polyline: Array.from(loop.polyline) } };
      }, text);
      expect(differing(field.values, native.values)).toBe(0);
      expect(field.kinds).toEqual(native.kinds);
      expect(field.range).toEqual([Math.min(...native.values), Math.max(...native.values)]);
      expect(field.loop.length).toBe(native.values[5]);
      expect(field.loop.polyline.length % 3).toBe(0);
      expect(field.loop.polyline.slice(0, 3)).toEqual(field.loop.polyline.slice(-3));
      // Reports: every vertex once, with its final value; progress rises to 1.
      expect(field).toMatchObject({ reportedOnce: true, wrong: 0 });
      expect(field.progress).toEqual([...field.progress].sort((a, b) => a - b));
      expect(field.progress.at(-1)).toBe(1);
    });

    test('far from the origin, points are drawn from near by and keep their precision', async () => {
      const by = [5e6, 4e5, -7e5] as const;
      const { here, there } = await page.evaluate(
        async (texts) => {
          const kernel = await girth.createKernel({ threads: 1 });
          const seen = async (text: string) => {
            const mesh = await kernel.load(girth.obj(text));
            const { origin, positions } = mesh.geometry;
            const { polyline, midpoint } = await mesh.loop({ face: 11, weights: [0.2, 0.3, 0.5] });
            return {
              origin,
              // In the file's coordinates.
              points: [positions, polyline, midpoint].map((points) =>
                Array.from(points, (x, i) => x + origin[i % 3]!),
              ),
            };
          };
          const found = { here: await seen(texts.here), there: await seen(texts.there) };
          kernel.dispose();
          return found;
        },
        { here: torus(40, 20), there: moved(torus(40, 20), [...by]) },
      );
      expect(here.origin).toEqual([0, 0, 0]);
      by.forEach((away, k) => expect(Math.abs(there.origin[k]! - away)).toBeLessThan(1));
      here.points.forEach((points, which) => {
        expect(there.points[which]!.length).toBe(points.length);
        const off = points.map((x, i) => Math.abs(there.points[which]![i]! - by[i % 3]! - x));
        expect(Math.max(...off)).toBeLessThan(1e-6);
      });
    });

    test('loops at points of faces: the same bits as the command', async () => {
      const text = torus(24, 12);
      const model = join(scratch, 'points.obj');
      writeFileSync(model, text);
      const points: FacePoint[] = [
        { face: 3, weights: [0.2, 0.3, 0.5] },
        { face: 100, weights: [1 / 3, 1 / 3, 1 / 3] },
        { face: 411, weights: [1e-3, 0.998, 1e-3] },
        { face: 57, weights: [0.25, 0, 0.75] },
        { face: 58, weights: [0, 1, 0] },
      ];
      const found = await page.evaluate(
        async ([text, points]) => {
          const kernel = await girth.createKernel({ threads: 1 });
          const mesh = await kernel.load(girth.obj(text));
          const loops = await Promise.all(points.map((point) => mesh.loop(point)));
          const corner = await mesh.loop(mesh.geometry.indices[3 * 58 + 1]!);
          const places = points.map(({ face, weights }) =>
            [0, 1, 2].map((axis) =>
              weights.reduce((sum, weight, k) => {
                const vertex = mesh.geometry.indices[3 * face + k]!;
                return sum + weight * mesh.geometry.positions[3 * vertex + axis]!;
              }, 0),
            ),
          );
          const refusals = await Promise.all([
            girth.refusal(mesh.loop({ face: 576, weights: [1, 0, 0] })),
            girth.refusal(mesh.loop({ face: 0.5, weights: [1, 0, 0] })),
            girth.refusal(mesh.loop({ face: 0, weights: [0.5, 0.6, 0.7] })),
            girth.refusal(mesh.loop({ face: 0, weights: [-1, 1, 1] })),
            girth.refusal(mesh.loop({ face: 0, weights: [NaN, 0, 1] })),
          ]);
          kernel.dispose();
          const plain = loops.map((loop) => ({ ...loop, polyline: Array.from(loop.polyline) }));
          return {
            loops: plain,
            corner: corner.length,
            places,
            codes: refusals.map((r) => r.code),
          };
        },
        [text, points] as const,
      );
      found.loops.forEach((loop, i) => {
        const { length, kind, angle } = loopByCommand(model, points[i]!);
        expect(loop).toMatchObject({ length, kind, angle, base: points[i] });
        const { polyline } = loop;
        for (let axis = 0; axis < 3; ++axis) {
          expect(polyline[axis]).toBeCloseTo(found.places[i]![axis]!, 5);
          expect(polyline.at(axis - 3)).toBeCloseTo(found.places[i]![axis]!, 5);
        }
        let drawn = 0;
        for (let p = 3; p < polyline.length; p += 3) {
          drawn += Math.hypot(...[0, 1, 2].map((k) => polyline[p + k]! - polyline[p - 3 + k]!));
        }
        expect(drawn / length).toBeCloseTo(1, 5);
      });
      expect(found.loops[4]!.length).toBe(found.corner);
      expect(found.codes).toEqual(Array(5).fill('INVALID_POINT'));
    });

    test('while a field is computed: report after report, and loops in between', async () => {
      const result = await page.evaluate(async (text) => {
        const kernel = await girth.createKernel({ threads: 2 });
        const mesh = await kernel.load(girth.obj(text));
        const watch = girth.watchPage();
        const controller = new AbortController();
        let batches = 0;
        const { signal } = controller;
        const refused = girth.refusal(mesh.field('igf', { signal, onPartial: () => ++batches }));
        const times: number[] = [];
        for (let loops = 0; loops < 5 || batches < 4; ++loops) {
          const from = performance.now();
          await mesh.loop((97 * loops) % mesh.info.vertexCount);
          times.push(performance.now() - from);
          await new Promise((resolve) => setTimeout(resolve, 50));
        }
        const longest = watch.stop();
        controller.abort();
        const { code } = await refused;
        kernel.dispose();
        times.sort((a, b) => a - b);
        return { code, batches, longest, loops: times.length, median: times[times.length >> 1] };
      }, endless);
      console.log(`${mode}: 35,200 faces`, JSON.stringify(result));
      // It was still computing after the last loop had come.
      expect(result.code).toBe('CANCELLED');
    });

    test('cancelling stops the work, keeps what there is, and leaves the kernel usable', async () => {
      const result = await page.evaluate(
        async ([long, short]) => {
          const kernel = await girth.createKernel({ threads: 2 });
          const mesh = await kernel.load(girth.obj(long));
          const controller = new AbortController();
          let abortedAt = 0;
          let reported = 0;
          const refused = await girth.refusal(
            mesh.field('igf', {
              signal: controller.signal,
              onPartial: ({ vertices }) => {
                reported += vertices.length;
                if (abortedAt) return;
                abortedAt = performance.now();
                setTimeout(() => controller.abort());
              },
            }),
          );
          const rejectedAfter = performance.now() - abortedAt;
          // This would wait for the whole of the other field, were it not stopped.
          const next = await kernel.load(girth.obj(short));
          const from = performance.now();
          const field = await girth.watchedField(next);
          const nextAfter = performance.now() - from;
          kernel.dispose();
          const { vertexCount } = mesh.info;
          return { refused, rejectedAfter, nextAfter, reported, vertexCount, field };
        },
        [endless, box(4, 3, 2)] as const,
      );
      console.log(
        `${mode}: cancelled in ${result.rejectedAfter.toFixed(0)} ms, ` +
          `another field after ${result.nextAfter.toFixed(0)} ms`,
      );
      expect(result.refused.code).toBe('CANCELLED');
      expect(result.reported).toBeGreaterThan(0);
      expect(result.reported).toBeLessThan(result.vertexCount);
      expect(result.field.values.every((value) => value > 0)).toBe(true);
      expect(result.field.reportedOnce).toBe(true);
    });

    test('disposing in mid-run ends with CANCELLED; two kernels on one page do not mind', async () => {
      const result = await page.evaluate(
        async ([long, short]) => {
          const [one, two] = await Promise.all([
            girth.createKernel({ threads: 2 }),
            girth.createKernel({ threads: 1 }),
          ]);
          const [a, b, c] = await Promise.all([
            one.load(girth.obj(long)),
            one.load(girth.obj(long)),
            two.load(girth.obj(short)),
          ]);
          let begun!: () => void;
          const running = new Promise<void>((resolve) => (begun = resolve));
          const refusals = [
            girth.refusal(a.field('igf')),
            girth.refusal(b.field('igf', { onPartial: begun })),
          ];
          const field = c.field('igf');
          a.dispose();
          refusals.push(girth.refusal(a.loop(0)));
          await running;
          one.dispose();
          const codes = (await Promise.all(refusals)).map(({ code }) => code);
          const count = (await field).values.length;
          two.dispose();
          return { codes, count };
        },
        [endless, torus(30, 20)] as const,
      );
      expect(result).toEqual({ codes: ['CANCELLED', 'CANCELLED', 'CANCELLED'], count: 600 });
    });

    test('another triangulation, and smoothed: its size, its genus, and values carried back', async () => {
      const result = await page.evaluate(
        async (text) => {
          const kernel = await girth.createKernel({ threads: 1 });
          const mesh = await kernel.load(girth.obj(text));
          const progress: number[] = [];
          const remeshed = await mesh.remesh(900, { onProgress: (share) => progress.push(share) });
          // Heights are linear within faces: what is lost is the distance of the two surfaces.
          const heights = (one: typeof mesh) =>
            one.geometry.positions.filter((_, i) => i % 3 === 2);
          const carried = await remeshed.carryBack(new Float64Array(heights(remeshed)));
          const wrong = heights(mesh).map((height, vertex) => Math.abs(height - carried[vertex]!));
          const values = await mesh.field('igf');
          const same = await mesh.difference(values, mesh, values);
          const controller = new AbortController();
          const stopped = girth.refusal(mesh.remesh(90_000, { signal: controller.signal }));
          setTimeout(() => controller.abort(), 50);
          const codes = [await stopped, await girth.refusal(mesh.remesh(0))].map(
            ({ code }) => code,
          );
          const { faceCount, genus } = remeshed.info;
          const loop = await remeshed.loop(0);
          // Triangles that keep the shape best are longer where it is bent one way only.
          const longest = async (even: boolean) => {
            const { geometry } = await mesh.remesh(400, { even });
            const { positions, indices } = geometry;
            const at = (v: number) => positions.subarray(3 * v, 3 * v + 3);
            return Math.max(
              ...Array.from(indices, (v, i) => {
                const [p, q] = [at(v), at(indices[i % 3 === 2 ? i - 2 : i + 1]!)];
                return Math.hypot(p[0]! - q[0]!, p[1]! - q[1]!, p[2]! - q[2]!);
              }),
            );
          };
          const smooth = await mesh.smooth(1);
          const [before, after] = [mesh, smooth].map(({ geometry }) => geometry);
          const unmoved = await mesh.smooth(0);
          const smoothing = {
            same: String(before!.indices) === String(after!.indices),
            moved: before!.positions.some((x, i) => x !== after!.positions[i]),
            none: String(unmoved.geometry.positions) === String(before!.positions),
            refused: (await girth.refusal(mesh.smooth(101))).code,
          };
          const evener = (await longest(true)) < (await longest(false));
          kernel.dispose();
          return {
            faceCount,
            genus,
            wrong: Math.max(...wrong),
            same,
            codes,
            progress,
            evener,
            smoothing,
            length: loop.length,
          };
        },
        torus(24, 16),
      );
      expect(Math.abs(result.faceCount - 900)).toBeLessThan(45);
      expect(result).toMatchObject({
        genus: [1],
        codes: ['CANCELLED', 'INVALID_OPTION'],
        evener: true,
        smoothing: { same: true, moved: true, none: true, refused: 'INVALID_OPTION' },
      });
      expect(result.same).toBeLessThan(1e-15);
      expect(result.wrong).toBeLessThan(0.05);
      expect(result.length).toBeGreaterThan(3);
      expect(result.progress).toEqual([...result.progress].sort((a, b) => a - b));
    });

    test('failures have codes, elements, words and remedies', async () => {
      const codes = await page.evaluate(async () => {
        const kernel = await girth.createKernel({ threads: 1 });
        const { refusal } = girth;
        const result = {
          empty: await refusal(kernel.load(girth.obj(''))),
          unknown: await refusal(kernel.load(girth.obj('hello', 'text.glb'))),
          points: await refusal(kernel.load(girth.obj('v 0 0 0\nv 1 0 0\nv 0 1 0\n'))),
          missing: await refusal(kernel.load('/no-such-model.glb')),
          index: await refusal(
            kernel.load({ positions: new Float64Array(9), indices: Uint32Array.of(0, 1, 7) }),
          ),
          nan: await refusal(
            kernel.load({
              positions: Float64Array.of(0, 0, 0, 1, 0, NaN, 0, 1, 0),
              indices: Uint32Array.of(0, 1, 2),
            }),
          ),
        };
        kernel.dispose();
        return result;
      });
      expect(codes.empty.code).toBe('EMPTY_FILE');
      expect(codes.unknown.code).toMatch(/UNKNOWN_FORMAT|MALFORMED_FILE/);
      expect(codes.points.code).toBe('EMPTY_MESH');
      expect(codes.missing).toMatchObject({ code: 'FILE_NOT_FOUND' });
      expect(codes.missing.message).toContain('/no-such-model.glb');
      expect(codes.index).toMatchObject({ code: 'INDEX_OUT_OF_RANGE', element: 0 });
      expect(codes.nan).toMatchObject({ code: 'NON_FINITE_POSITION', element: 1 });
      for (const { message, hint } of Object.values(codes)) {
        expect(message).toBeTruthy();
        expect(hint).toBeTruthy();
      }
    });

    test('glue and module of different builds are an error with a code', async () => {
      const other = await page.context().newPage();
      // Each module gets the other one's bytes.
      const bytes = (name: string) =>
        readFileSync(join(repository, `web/src/kernel/wasm/${name}.wasm`));
      await other.route(/\.wasm$/, (route) =>
        route.fulfill({
          body: bytes(route.request().url().includes('threads') ? 'girth-files' : 'girth-threads'),
          contentType: 'application/wasm',
        }),
      );
      await other.goto(server.url);
      await other.waitForFunction('globalThis.girth');
      const { code } = await other.evaluate(() =>
        girth.refusal(girth.createKernel({ threads: 2 })),
      );
      await other.close();
      expect(code).toBe('PROGRAM_NOT_LOADED');
    });

    test('a module that cannot be loaded is an error with a code', async () => {
      const other = await page.context().newPage();
      await other.route(/\.wasm$/, (route) => route.abort());
      await other.goto(server.url);
      await other.waitForFunction('globalThis.girth');
      const { code } = await other.evaluate(() =>
        girth.refusal(girth.createKernel({ threads: 1 })),
      );
      await other.close();
      expect(code).toBe('PROGRAM_NOT_LOADED');
    });
  });
}
