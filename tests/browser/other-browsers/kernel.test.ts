// Firefox and WebKit: the kernel on a page that is cross-origin isolated and on one that is not gives the bits of
// the command.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { kernelSite } from '../build-kernel-site.js';
import type { KernelPage } from '../kernel-page.js';
import { kernelHtml } from '../kernel-site.js';
import { beside, box, hand, torus, tube } from '../meshes.js';
import { smallExamples } from '../small-examples.js';
import { command, differing, repository, serve, type StaticServer } from '../support.js';
import { type OtherPage, otherBrowsers } from './browsers.js';

/** Inside `evaluate` only. */
declare const girth: KernelPage;

const models: Record<string, string | Buffer> = {
  'prism.obj': readFileSync(join(repository, 'tests/data/prism.obj')),
  'tube.obj': tube(20, 12, 3),
  'hand.obj': hand([2, 3, 2.5]),
  'two.obj': beside(torus(24, 12), box(3, 2, 2), 9),
  'chair.glb': readFileSync(join(smallExamples, 'chair.glb')),
};

describe.each(otherBrowsers)('$name', ({ name: browserName, isThere, open }) => {
  const folder = mkdtempSync(join(tmpdir(), 'girth-other-browsers-'));
  let browser: OtherPage;
  let server: StaticServer | undefined;
  beforeAll(async () => {
    if (isThere) browser = await open();
  });
  afterAll(async () => {
    await browser?.close();
    rmSync(folder, { recursive: true });
  });

  test.runIf(isThere).each([true, false])(
    'isolated %s: the values of five models are those of the command, to the bit',
    async (isolated) => {
      server = await serve(kernelSite, { isolated, pages: { '/': kernelHtml } });
      await browser.open(server.url);
      for (const [name, model] of Object.entries(models)) {
        const bytes = Buffer.from(model);
        const { mode, isShared, values, error } = await browser.evaluate(
          async ({ name, base64 }) => {
            try {
              while (!('girth' in globalThis)) await new Promise((done) => setTimeout(done, 20));
              const kernel = await girth.createKernel({ threads: 2 });
              const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
              const mesh = await kernel.load({ name, bytes });
              const { values } = await mesh.field('igf');
              const { mode } = kernel;
              kernel.dispose();
              // As text: every digit arrives.
              const isShared = crossOriginIsolated && 'SharedArrayBuffer' in globalThis;
              return { mode, isShared, values: Array.from(values, String), error: '' };
            } catch (thrown) {
              return { mode: '', isShared: false, values: [], error: String(thrown) };
            }
          },
          { name, base64: bytes.toString('base64') },
        );
        expect(error, name).toBe('');
        // WebKitGTK has no shared memory even on an isolated page.
        expect(isShared).toBe(isolated && browserName === 'Firefox');
        expect(mode).toBe(isShared ? 'threads' : 'pool');
        const file = join(folder, name);
        const csv = `${file}.csv`;
        writeFileSync(file, bytes);
        execFileSync(command, ['igf', file, '-o', csv]);
        const rows = readFileSync(csv, 'utf8').trim().split('\n').slice(1);
        const truth = rows.map((row) => Number(row.split(',')[1] || 'NaN'));
        expect(truth.length, name).toBeGreaterThan(0);
        expect(differing(values.map(Number), truth), name).toBe(0);
      }
      await server.close();
    },
  );
});
