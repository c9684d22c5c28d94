// The kernel in Node.js, from the packed package in an empty folder, as programs there use it: the same bits as the
// command, files by path, the same errors, and processes that end.

import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import {
  mkdirSync,
  mkdtempSync,
  readFileSync,
  renameSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { torus } from '../browser/meshes.js';
import { command, repository } from '../browser/support.js';
import { install } from '../web/package/packed.js';
import { dracoGlb, splitGltf, tetrahedron } from './models.js';

const folder = mkdtempSync(join(tmpdir(), 'girth-node-'));
const inFolder = (name: string) => join(folder, name);

beforeAll(async () => {
  install(folder);
  writeFileSync(inFolder('torus.obj'), torus(24, 12));
  // Enough faces to be computed in bands round loops.
  writeFileSync(inFolder('ring.obj'), torus(64, 24));
  writeFileSync(inFolder('packed.glb'), await dracoGlb(torus(24, 12)));
  mkdirSync(inFolder('scene'));
  const { gltf, bin } = splitGltf(tetrahedron, 'its data/the buffer.bin');
  writeFileSync(inFolder('scene/model.gltf'), gltf);
  mkdirSync(inFolder('scene/its data'));
  writeFileSync(inFolder('scene/its data/the buffer.bin'), bin);
});

afterAll(() => rmSync(folder, { recursive: true }));

/** Runs a program as a module in the folder, until it ends by itself. */
async function run(code: string, ...options: string[]) {
  const child = spawn(process.execPath, [...options, '--input-type=module', '--eval', code], {
    cwd: folder,
  });
  let [stdout, stderr] = ['', ''];
  child.stdout.on('data', (data) => (stdout += String(data)));
  child.stderr.on('data', (data) => (stderr += String(data)));
  const [exitCode, signal] = (await once(child, 'close')) as [number | null, string | null];
  return { status: exitCode ?? signal, stdout, stderr };
}

/** The JSON that a program prints which has gone well. */
async function printed(code: string): Promise<unknown> {
  const { status, stdout, stderr } = await run(
    `import { createKernel, GirthError } from 'girth';
     const fails = (promise) => promise.then(() => 'nothing', (error) =>
       error instanceof GirthError ? [error.code, error.message, error.hint] : String(error));
     ${code}`,
  );
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  return JSON.parse(stdout) as unknown;
}

/** The file that the command writes about a model. */
function written(...words: string[]): string {
  const output = inFolder('by-command.csv');
  execFileSync(command, [...words, '-o', output], { cwd: folder, stdio: 'ignore' });
  return readFileSync(output, 'utf8');
}

test('the readme’s lines write what the command writes', async () => {
  const readme = readFileSync(join(repository, 'README.md'), 'utf8');
  const [, lines] = /^```js\n([^]*?)^```/m.exec(readme) ?? [];
  const asTheirs = readFileSync(inFolder('packed.glb'));
  writeFileSync(inFolder('model.glb'), asTheirs);
  const { status, stdout, stderr } = await run(lines!);
  expect({ status, stderr }).toEqual({ status: 0, stderr: '' });
  expect(stdout).toMatch(/^288 \[ [\d.]+, [\d.]+ \]\n$/);
  expect(readFileSync(inFolder('values.csv'), 'utf8')).toBe(written('igf', 'model.glb'));
});

test.each(['threads', 'pool'])(
  'the same bits as the command, by a kernel of mode %s',
  async (mode) => {
    const answer = await printed(`
    import { writeFileSync } from 'node:fs';
    const kernel = await createKernel({ mode: '${mode}', threads: 3 });
    const mesh = await kernel.load('torus.obj');
    for (const name of ['igf', 'sdf', 'geofarthest']) {
      writeFileSync(name + '.csv', await mesh.exportField(await mesh.field(name), 'csv'));
    }
    const { length } = await mesh.loop(7);
    const persistence = 0.03 * Math.sqrt(mesh.info.area);
    const persistent = await mesh.field('igf', { persistence });
    writeFileSync('persistent.csv', await mesh.exportField(persistent, 'csv'));
    const ring = await kernel.load('ring.obj');
    writeFileSync('refined.csv', await ring.exportField(await ring.refinedGirth(), 'csv'));
    console.log(JSON.stringify([kernel.mode, kernel.threads, length]));
    kernel.dispose();
  `);
    const girth = written('igf', 'torus.obj');
    const atSeven = Number(girth.split('\n')[8]!.split(',')[1]);
    expect(answer).toEqual([mode, 3, atSeven]);
    expect(readFileSync(inFolder('igf.csv'), 'utf8')).toBe(girth);
    const persistent = written('igf', 'torus.obj', '--persistence', '3%');
    expect(readFileSync(inFolder('persistent.csv'), 'utf8')).toBe(persistent);
    const refined = written('igf', 'ring.obj', '--method', 'refined');
    expect(readFileSync(inFolder('refined.csv'), 'utf8')).toBe(refined);
    for (const name of ['sdf', 'geofarthest']) {
      const theirs = written('field', 'torus.obj', '--field', name);
      expect(readFileSync(inFolder(`${name}.csv`), 'utf8')).toBe(theirs);
    }
  },
);

test('models come from paths, addresses, bytes and files, with their buffers', async () => {
  const server = createServer((request, response) => {
    response.end(readFileSync(inFolder(decodeURIComponent(request.url!.slice(1)))));
  });
  await once(server.listen(0, '127.0.0.1'), 'listening');
  const { port } = server.address() as AddressInfo;
  const sources = [
    `'scene/model.gltf'`,
    `new URL('${pathToFileURL(inFolder('scene/model.gltf')).href}')`,
    `'http://127.0.0.1:${port}/scene/model.gltf'`,
    `{ bytes: readFileSync('packed.glb'), name: 'packed.glb' }`,
    `new Blob([readFileSync('torus.obj')])`,
    `new File([readFileSync('torus.obj')], 'torus.obj')`,
    `[{ path: 'model.gltf', content: new Blob([readFileSync('scene/model.gltf')]) },
      { path: 'its data/the buffer.bin', content: new Blob([readFileSync('scene/its data/the buffer.bin')]) }]`,
  ];
  const counts = await printed(`
    import { readFileSync } from 'node:fs';
    import { File } from 'node:buffer';
    const kernel = await createKernel();
    const counts = [];
    for (const source of [${sources.join(',\n')}]) {
      const { info } = await kernel.load(source);
      counts.push(info.vertexCount);
    }
    console.log(JSON.stringify(counts));
  `);
  server.close();
  expect(counts).toEqual([4, 4, 4, 288, 288, 288, 4]);
});

test('the unit is the one that a file states, there and back', async () => {
  for (const [name, head] of [
    ['plain', ''],
    ['mm', '# unit: millimetre\n'],
    ['km', '# unit: km\n'],
  ] as const) {
    writeFileSync(inFolder(`${name}.obj`), head + torus(8, 4));
  }
  const units = await printed(`
    const kernel = await createKernel({ threads: 1 });
    const units = [];
    for (const name of ['plain', 'mm', 'km']) {
      const mesh = await kernel.load(name + '.obj');
      const field = await mesh.field('igf');
      const again = [];
      for (const format of ['ply', 'glb']) {
        const bytes = await mesh.exportField(field, format);
        again.push((await kernel.load({ bytes, name: 'again.' + format })).info.unit);
      }
      units.push([mesh.info.unit, ...again]);
    }
    console.log(JSON.stringify(units));
  `);
  expect(units).toEqual([
    ['', '', ''],
    ['millimetre', 'millimetre', 'metre'],
    ['kilometre', 'kilometre', 'metre'],
  ]);
});

test('the prepared surface as a file of every format, and scaled as it was asked for', async () => {
  writeFileSync(inFolder('saved.obj'), `# unit: mm\n${torus(8, 4)}`);
  const found = await printed(`
    const kernel = await createKernel({ threads: 1 });
    const mesh = await kernel.load('saved.obj', { prepare: { scale: 3 } });
    const saved = [];
    for (const format of ['obj', 'off', 'ply', 'stl', 'glb']) {
      const again = await kernel.load({ bytes: await mesh.exportModel(format), name: 'a.' + format });
      const { faceCount, vertexCount, area, unit } = again.info;
      saved.push([format, faceCount, vertexCount, area / mesh.info.area, unit]);
    }
    const refused = await mesh.exportModel('3mf').catch(({ code }) => code);
    console.log(JSON.stringify([saved, refused]));
  `);
  const [saved, refused] = found as [[string, number, number, number, string][], string];
  expect(refused).toBe('USAGE');
  for (const [format, faces, vertices, ratio, unit] of saved) {
    expect([format, faces, vertices]).toEqual([format, 64, 32]);
    // STL and GLB have numbers of 32 bits; GLB is in metres.
    if (format !== 'glb') expect([format, unit]).toEqual([format, 'millimetre']);
    const metres = format === 'glb' ? 1e-6 : 1;
    const digits = ['obj', 'off', 'ply'].includes(format) ? 14 : 6;
    expect(ratio / metres).toBeCloseTo(1, digits);
  }
});

test('what cannot be read is an error with its code; no link leads out of a model’s folder', async () => {
  mkdirSync(inFolder('closed'));
  writeFileSync(inFolder('closed/model.gltf'), splitGltf(tetrahedron, 'link.bin').gltf);
  symlinkSync(inFolder('scene/its data/the buffer.bin'), inFolder('closed/link.bin'));
  writeFileSync(inFolder('closed/above.gltf'), splitGltf(tetrahedron, '../scene/x.bin').gltf);
  writeFileSync(inFolder('notes.txt'), 'no model at all');
  const paths = ['absent.glb', 'scene', 'closed/model.gltf', 'closed/above.gltf', 'notes.txt'];
  const answers = await printed(`
    const kernel = await createKernel({ threads: 1 });
    const answers = [];
    for (const path of ${JSON.stringify(paths)}) answers.push((await fails(kernel.load(path)))[0]);
    answers.push((await fails(kernel.load('http://127.0.0.1:9/model.glb')))[0]);
    console.log(JSON.stringify(answers));
  `);
  expect(answers).toEqual([
    'FILE_NOT_FOUND',
    'FILE_UNREADABLE',
    'MISSING_RESOURCE',
    'MISSING_RESOURCE',
    'UNKNOWN_FORMAT',
    'FILE_UNREADABLE',
  ]);
});

test.each(['threads', 'pool'])(
  'a field is cancelled, a kernel disposed of: mode %s',
  async (mode) => {
    writeFileSync(inFolder('large.obj'), torus(150, 80));
    const answers = await printed(`
    const kernel = await createKernel({ mode: '${mode}' });
    const mesh = await kernel.load('large.obj');
    const stopping = new AbortController();
    const onProgress = () => stopping.abort();
    const cancelled = await fails(mesh.field('igf', { signal: stopping.signal, onProgress }));
    const field = fails(mesh.field('igf', { onProgress: () => kernel.dispose() }));
    const disposed = await field;
    const late = await fails(mesh.field('sdf'));
    console.log(JSON.stringify([cancelled[0], disposed, late[0]]));
  `);
    const reason = 'the kernel has been disposed of';
    expect(answers).toEqual(['CANCELLED', ['CANCELLED', reason, expect.any(String)], 'CANCELLED']);
  },
);

test('a kernel may be disposed of while its workers start', async () => {
  const printedBy = await printed(`
    for (let i = 0; i < 20; ++i) {
      const kernel = await createKernel();
      await fails(kernel.load({ name: 'bad.obj', bytes: new TextEncoder().encode('f 1 2 3') }));
      await new Promise((resolve) => setTimeout(resolve, 3 * i));
      kernel.dispose();
    }
    console.log(true);
  `);
  expect(printedBy).toBe(true);
});

test('a process ends without dispose, and not before what was asked for is done', async () => {
  const { status, stdout, stderr } = await run(`
    import { createKernel } from 'girth';
    const kernel = await createKernel();
    const mesh = await kernel.load('torus.obj');
    void mesh.field('igf').then(({ range }) => console.log(range.length));
  `);
  expect({ status, stdout, stderr }).toEqual({ status: 0, stdout: '2\n', stderr: '' });
});

test('a package that is not whole is an error that says so', async () => {
  const dist = inFolder('node_modules/girth/dist/kernel');
  for (const file of ['workers/job-worker.js', 'wasm/girth-files.wasm']) {
    renameSync(join(dist, file), join(dist, 'hidden'));
    const error = await printed(`
      console.log(JSON.stringify(await fails(createKernel({ mode: 'pool' }))));
    `);
    renameSync(join(dist, 'hidden'), join(dist, file));
    expect(error).toEqual([
      'PROGRAM_NOT_LOADED',
      expect.stringContaining(file) as string,
      expect.stringContaining('install the package girth again') as string,
    ]);
  }
});

test('Node.js refuses no option that a program may be started with', async () => {
  const code = `
    import { createKernel } from 'girth';
    const kernel = await createKernel();
    console.log((await kernel.load('torus.obj')).info.vertexCount);
    kernel.dispose();
  `;
  const { status, stdout } = await run(code, '--conditions=development', '--no-warnings');
  expect({ status, stdout }).toEqual({ status: 0, stdout: '288\n' });
});
