// The cost of jobs on a surface where they find it in their worker, against what they cost where the worker
// is given the arrays and builds the surface first, which is what the first job of a mesh does. Both in one
// page, in turns; of the times the median counts. Fields are made up: jobs do not compute them.

import type { Page } from 'playwright-core';
import { afterAll, beforeAll, test } from 'vitest';
import type { Field } from '../../web/src/kernel/index.js';
import type { KernelPage } from '../browser/kernel-page.js';
import { kernelSite, setup as buildKernelSite } from '../browser/build-kernel-site.js';
import { kernelHtml } from '../browser/kernel-site.js';
import { thinRing } from '../browser/meshes.js';
import { chromiumForTests, serve, type StaticServer } from '../browser/support.js';
import { quantile } from './figures.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const turns = 5;

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;

beforeAll(async () => {
  await buildKernelSite();
  // The second surface is heavy for the pool: without it, its worker would be ended after each job.
  const pages = {
    '/': kernelHtml,
    '/100.obj': thinRing(5120, 20),
    '/200.obj': thinRing(10240, 20),
  };
  server = await serve(kernelSite, { isolated: false, pages });
  ({ page } = await openPage(server.url));
  await page.waitForFunction('globalThis.girth');
});
afterAll(async () => server?.close());

/** Milliseconds of each job: the first of a mesh, and the next one. */
type Turn = Record<string, { first: number; next: number }>;

async function measure(thousands: number): Promise<Turn[]> {
  return page.evaluate(
    async ({ thousands, turns }) => {
      const kernel = await girth.createKernel({ threads: 1, mode: 'pool' });
      const file = new File([await (await fetch(`/${thousands}.obj`)).blob()], 'ring.obj');
      const original = await kernel.load(file);
      const arrays = {
        positions: Float64Array.from(original.geometry.positions),
        indices: original.geometry.indices,
      };
      const { vertexCount } = original.info;
      original.dispose();
      const fieldOf = (name: 'igf' | 'sdf' | 'thickness', wave: number): Field => ({
        name,
        values: Float64Array.from({ length: vertexCount }, (_, v) => 2 + Math.sin(v * wave)),
        kinds: new Uint8Array(name === 'igf' ? vertexCount : 0),
        range: [1, 3],
        unit: '',
        method: 'made up',
        withoutValue: 0,
        note: '',
      });
      const [igf, sdf] = [fieldOf('igf', 1e-3), fieldOf('sdf', 3e-3)];
      const thickness = fieldOf('thickness', 3e-3);
      const jobs = {
        areas: (mesh) => mesh.vertexAreas(),
        tips: (mesh) => mesh.tips(igf),
        thresholds: (mesh) => mesh.suggestedThresholds(igf, sdf),
        parts: (mesh) => mesh.parts(igf, sdf, { girth: 2, shapeDiameter: 2 }),
        maxima: (mesh) => mesh.maxima(igf),
        'weak places': (mesh) =>
          mesh.printCheck({ igf, thickness }, { tubeDiameter: 0.5, wallThickness: 1.5 }),
        'a file (NPY)': (mesh) => mesh.exportField(igf, 'npy'),
      } satisfies Record<string, (mesh: typeof original) => Promise<unknown>>;
      const timed = async (job: () => Promise<unknown>) => {
        const from = performance.now();
        await job();
        return performance.now() - from;
      };
      const all: Turn[] = [];
      for (let turn = 0; turn < turns; ++turn) {
        const times: Turn = {};
        for (const [name, job] of Object.entries(jobs)) {
          const mesh = await kernel.load(arrays);
          // Answered by the worker for loops once it has the surface: it is not at work meanwhile.
          await mesh.loop(0);
          times[name] = { first: await timed(() => job(mesh)), next: await timed(() => job(mesh)) };
          mesh.dispose();
        }
        all.push(times);
      }
      kernel.dispose();
      return all;
    },
    { thousands, turns },
  );
}

test.each([100, 200])('%i thousand vertices', async (thousands) => {
  const all = await measure(thousands);
  const rows = Object.keys(all[0]!).map((job) => {
    const median = (of: 'first' | 'next') =>
      quantile(
        all.map((turn) => turn[job]![of]),
        0.5,
      );
    const [first, next] = [median('first'), median('next')];
    return {
      job,
      'given the arrays, ms': first.toFixed(1),
      'found, ms': next.toFixed(1),
      ratio: (first / next).toFixed(1),
    };
  });
  console.log(`\nJobs on a surface of ${thousands} thousand vertices, medians of ${turns}:`);
  console.table(rows);
});
