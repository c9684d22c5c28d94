// Real files and broken ones, read by the command and by the page: the same surfaces, the same
// account of what was done, the same errors. Skipped where GIRTH_DATA names no corpus.

import { execFileSync } from 'node:child_process';
import { readdirSync, statSync } from 'node:fs';
import { join, relative } from 'node:path';
import { isDeepStrictEqual } from 'node:util';
import { afterAll, expect, test } from 'vitest';
import type { MeshInfo } from '../../web/src/kernel/index.js';
import type { KernelPage } from './kernel-page.js';
import { kernelSite } from './build-kernel-site.js';
import { kernelHtml } from './kernel-site.js';
import { chromiumForTests, command, serve, strictPolicy, type StaticServer } from './support.js';

/** Inside `page.evaluate` only. */
declare const girth: KernelPage;

const data = process.env['GIRTH_DATA'];
const openPage = chromiumForTests();
let server: StaticServer | undefined;
afterAll(() => server?.close());

/** Every so manieth of many files is read: the whole corpus is read by the command's own tests. */
const share = 4;
const largest = 3 * 2 ** 20;

function modelsBelow(folder: string): string[] {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => /\.(glb|gltf|obj|off|ply|stl)$/i.test(name))
    .sort()
    .map((name) => join(folder, name))
    .filter((file) => statSync(file).size <= largest);
}

interface Outcome {
  /** The code and words of the error, or nothing. */
  error?: string;
  info?: object;
}

/** The answer of `girth info --json` for each file: a line on one of its two outputs. */
function byCommand(files: string[]): Map<string, Outcome> {
  const outcomes = new Map<string, Outcome>();
  for (const file of files) {
    let printed: string;
    try {
      const stdio = ['ignore', 'pipe', 'pipe'] as const;
      printed = execFileSync(command, ['info', '--json', file], {
        encoding: 'utf8',
        stdio: [...stdio],
      });
    } catch (thrown) {
      const { stderr } = thrown as { stderr: string };
      const [, code = '', words = ''] = /^girth: .*?: ([A-Z_]+): (.*)/s.exec(stderr) ?? [];
      outcomes.set(file, { error: code ? `${code}: ${words.trim()}` : stderr });
      continue;
    }
    outcomes.set(file, { info: JSON.parse(printed) as object });
  }
  return outcomes;
}

/** The page's answer as the command would give it: all else is left out. */
function asCommandSays(info: MeshInfo, command: object): object {
  const { vertexCount: vertices, faceCount: faces, edgeCount: edges, report } = info;
  const { components, genus, boundaries, area, format, notes, unit } = info;
  const counted = { vertices, faces, edges, components, genus, boundaries, area };
  const said: object = { ...report, ...counted, format, unit, notes, report };
  return Object.fromEntries(Object.entries(said).filter(([key]) => key in command));
}

test.runIf(data)('command and page read the same', async () => {
  server = await serve(kernelSite, {
    policy: strictPolicy,
    pages: { '/': kernelHtml },
    folders: { '/data/': data! },
  });
  const files = [
    ...modelsBelow(join(data!, 'gltf')),
    ...modelsBelow(join(data!, 'bad')),
    ...modelsBelow(join(data!, 'models')).filter((_, i) => i % 2 === 0),
  ].filter((_, i) => i % share === 0);
  const truth = byCommand(files);

  const { page } = await openPage(server.url);
  await page.waitForFunction('globalThis.girth');
  const paths = files.map(
    (file) => `/data/${relative(data!, file).split('/').map(encodeURIComponent).join('/')}`,
  );
  const read = await page.evaluate(async (paths) => {
    const kernel = await girth.createKernel({ threads: 1, mode: 'pool' });
    const outcomes: { info?: MeshInfo; error?: string }[] = [];
    for (const path of paths) {
      try {
        const mesh = await kernel.load(new URL(path, location.href));
        outcomes.push({ info: mesh.info });
        mesh.dispose();
      } catch (error) {
        const { code, message, hint } = error as { code: string; message: string; hint: string };
        outcomes.push({ error: `${code}: ${message}; ${hint}` });
      }
    }
    kernel.dispose();
    return outcomes;
  }, paths);
  await page.context().close();

  const different: object[] = [];
  files.forEach((file, i) => {
    const { info, error } = read[i]!;
    const { info: wanted = {}, error: wantedError } = truth.get(file)!;
    const said = info ? asCommandSays(info, wanted) : {};
    const same = Object.entries(said).every(([key, value]) =>
      isDeepStrictEqual(value, wanted[key as keyof object]),
    );
    if (!same || error !== wantedError) {
      different.push({ file: relative(data!, file), said, wanted, error, wantedError });
    }
  });
  const surfaces = read.filter(({ info }) => info).length;
  console.log(`${files.length} files: ${surfaces} surfaces, ${files.length - surfaces} errors`);
  expect(different).toEqual([]);
  expect(surfaces).toBeGreaterThan(60);
  for (const packed of [/draco/i, /meshopt/i]) {
    expect(files.some((file, i) => packed.test(file) && read[i]!.info)).toBe(true);
  }
});
