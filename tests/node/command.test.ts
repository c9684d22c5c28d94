// `npx girth`: the command as a WebAssembly module does what the native command does, to the byte: files, standard output,
// errors, exit codes.

import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import {
  chmodSync,
  copyFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { deflateRawSync, gzipSync } from 'node:zlib';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { torus } from '../browser/meshes.js';
import { command } from '../browser/support.js';
import { install } from '../web/package/packed.js';
import { glb, off, ply, splitGltf, stl, tetrahedron } from './models.js';

const folder = mkdtempSync(join(tmpdir(), 'girth-command-'));
const program = join(folder, 'node_modules/girth/dist/command/girth.cjs');

/** Each runs in a folder of its own with the same models. */
const sides = { native: join(folder, 'native'), module: join(folder, 'module') };

beforeAll(() => {
  install(folder);
  const model = torus(24, 12);
  const { gltf, bin } = splitGltf(tetrahedron, 'the buffer.bin');
  for (const side of Object.values(sides)) {
    mkdirSync(join(side, 'folder'), { recursive: true });
    const files: Record<string, string | Uint8Array> = {
      'torus.obj': model,
      'torus.obj.gz': gzipSync(model),
      'broken.obj.gz': gzipSync(model).subarray(0, 200),
      'spoiled.obj.gz': gzipSync(model).fill(7, 40, 60),
      'torus.zip': zipped('torus.obj', model),
      'model.glb': glb(model),
      'model.off': off(model),
      'model.ply': ply(model),
      'model.stl': stl(model),
      'model.gltf': gltf,
      'the buffer.bin': bin,
      'empty.obj': '',
      'nan.obj': tetrahedron.replace('1 0 0', 'nan 0 0'),
      'no model.glb': 'no model',
      'locked.csv': 'locked',
    };
    for (const [name, content] of Object.entries(files)) writeFileSync(join(side, name), content);
    chmodSync(join(side, 'locked.csv'), 0o444);
  }
});

afterAll(() => rmSync(folder, { recursive: true }));

/** A zip archive of one deflated file. */
function zipped(name: string, text: string): Uint8Array {
  const content = Buffer.from(text);
  const packed = deflateRawSync(content);
  const common = Buffer.alloc(26);
  common.writeUInt16LE(20, 0);
  common.writeUInt16LE(8, 4);
  common.writeUInt32LE(crc32(content), 10);
  common.writeUInt32LE(packed.length, 14);
  common.writeUInt32LE(content.length, 18);
  common.writeUInt16LE(name.length, 22);
  const local = Buffer.concat([Buffer.from('PK\x03\x04'), common, Buffer.from(name), packed]);
  const rest = Buffer.alloc(14);
  const entry = Buffer.concat([
    ...[Buffer.from('PK\x01\x02\x14\x00'), common, rest, Buffer.from(name)],
  ]);
  const end = Buffer.alloc(22);
  end.write('PK\x05\x06', 'latin1');
  end.writeUInt16LE(1, 8);
  end.writeUInt16LE(1, 10);
  end.writeUInt32LE(entry.length, 12);
  end.writeUInt32LE(local.length, 16);
  return Buffer.concat([local, entry, end]);
}

function crc32(bytes: Uint8Array): number {
  let remainder = ~0;
  for (const byte of bytes) {
    remainder ^= byte;
    for (let bit = 0; bit < 8; ++bit) remainder = (remainder >>> 1) ^ (remainder & 1 && 0xedb88320);
  }
  return ~remainder >>> 0;
}

/** The outcome of a program in a folder: what it prints, its exit code, and the files that it writes. */
function done(cwd: string, file: string, args: string[], input?: string) {
  const before = new Set(readdirSync(cwd));
  const { status, signal, stdout, stderr } = spawnSync(file, args, { cwd, input });
  const written = readdirSync(cwd).filter((name) => !before.has(name));
  const files = Object.fromEntries(
    written.map((name) => {
      const path = join(cwd, name);
      const bytes = statSync(path).isFile() ? readFileSync(path).toString('latin1') : '';
      return [name, bytes];
    }),
  );
  for (const name of written) rmSync(join(cwd, name), { recursive: true });
  return {
    ...{ status, signal, files },
    ...{ stdout: stdout.toString('latin1'), stderr: stderr.toString('latin1') },
  };
}

/** Time and memory of runs differ; everything else does not. */
const timeless = (text: string) =>
  text
    .replace(/\b\d+(\.\d+)? (ms|s|min \d+ s)\b/g, '… s')
    .replace(/"(\w*[sS]econds\w*|peakBytes)":[^,}]*/g, '');

function compare(args: string[], input?: string) {
  const native = done(sides.native, command, args, input);
  const module = done(sides.module, process.execPath, [program, ...args], input);
  for (const run of [native, module]) {
    run.stdout = timeless(run.stdout);
    run.stderr = timeless(run.stderr);
  }
  expect(module).toEqual(native);
  return native;
}

/** Each option of these commands is in some line: a test below asks their help for them. */
const main = [
  'info torus.obj',
  'info --json torus.obj torus.obj.gz torus.zip model.glb model.off model.ply model.stl model.gltf',
  'info --jobs 2 model.off model.ply',
  'info torus.zip --entry torus.obj --weld 0.01 --close-holes --component largest --min-component 1e-3',
  'info model.stl --unit mm --in cm --scale 2',
  'info torus.obj --height 900mm --up x -q',
  'igf torus.obj -o values.csv --method ms --threads 3 --weld 0.01 --close-holes --positions --in cm --unit mm',
  'igf torus.obj -o values.csv --method refined --audit 20 --subdivide 2600 --json',
  'igf torus.obj -o values.npy --threads 3 --persistence 2% --barcode bars.json --component 0',
  'igf torus.obj -o values.ply --subdivide 900 --min-component 1e-3 --scale 3 -q',
  'igf model.glb -o values.glb --tips --loops 3,7 --force',
  'igf torus.obj -o values.json --faces 300 --height 900mm --up z --resume',
  'igf torus.zip -o - --format npy --entry torus.obj',
  'igf torus.obj model.off --json --stats --jobs 2',
  'loop torus.obj 7 -o loop.json --persistence 2% --unit mm --in cm',
  'loop torus.obj 7 --json --weld 0.01 --close-holes --component 0 --min-component 1e-3',
  'loop torus.obj --face 7 --at 0.2,0.3,0.5 -o loop.obj --scale 2 -q',
  'loop torus.zip 7 --entry torus.obj -o - --format csv --height 900mm --up z',
  'loop model.glb 7 -o loop.glb --force',
  'tips model.glb --json --threads 2 --persistence 1% --faces 300',
  'tips torus.obj --stability --noise 0.1 --subdivide 700 -o tips.obj --force --scale 2 --min-component 1e-3 -q',
  'tips model.off --unit mm --in cm --weld 0.01 --close-holes --component 0',
  'tips torus.zip --entry torus.obj -o - --format json --height 900mm --up z',
  'parts model.glb -o parts.csv --positions --smooth-labels 0.5 --threads 2 --scale 2 --faces 300',
  'parts torus.obj -o parts.ply --girth 3 --shape-diameter 2 --subdivide 700 --persistence 1% -q --force',
  'parts torus.zip --entry torus.obj --json --weld 0.01 --close-holes --component 0 --min-component 1e-3',
  'parts torus.obj -o - --format json --unit mm --in cm --height 900mm --up z',
  'field model.glb --field sdf -o values.npy --threads 2 --rays 7 --cone 90 --force',
  'field torus.obj --field thickness --sharp 30 -o values.json --positions --unit mm --in cm --scale 2',
  'field torus.obj --field geofarthest --exact --maxima 3 --json --close-holes --component 0 -q',
  'field torus.zip --entry torus.obj --field geoaverage -o - --format csv --height 900mm --up z',
  'field torus.obj --field distance --from 3,40 --radius 2 -o values.csv',
  'field torus.obj --field angle --persistence 2% --subdivide 700 -o values.ply --weld 0.01 --min-component 1e-3',
];

test.each([
  ...main,
  'remesh model.glb --faces 200 --smooth 2 -o small.glb',
  'compare torus.obj model.glb --json',
  'signature torus.obj -o signature.csv',
  'necks torus.obj --json',
  'limbs torus.obj --json',
  'cut torus.obj 7 -o cut.obj',
  '--version',
  'help',
])('girth %s', (line) => {
  expect(compare(line.split(' ')).status).toBe(0);
});

test.each(['info', 'igf', 'loop', 'tips', 'parts', 'field'])(
  'girth %s has the same options, and each is tried',
  (name) => {
    const { stdout } = compare([name, '--help']);
    const options = [...stdout.matchAll(/^ {2}(?:-\w, )?(--[\w-]+)/gm)].map(([, word]) => word!);
    expect(options.length).toBeGreaterThan(10);
    const tried = [...main, ...checks, ...spectra]
      .filter((line) => line.startsWith(`${name} `))
      .flatMap((line) =>
        line.replace(/ -q\b/g, ' --quiet').replace(/ -o\b/g, ' --output').split(' '),
      );
    expect(options.filter((word) => word !== '--help' && !tried.includes(word))).toEqual([]);
  },
);

/** Runs that find something too thin end with the code 4. */
const checks = [
  'parts torus.obj --unit mm --min-tube 300mm --min-wall 100mm --creases --json',
  'parts torus.obj --unit mm --min-gap 100mm',
];

test.each(checks)('girth %s finds what is too thin', (line) => {
  compare(line.split(' '));
});

const spectra = [
  'field model.glb --field hks -o - --format csv',
  'field model.off --field hks --pairs 40 --time 0.01,0.1 --only 2 -o - --format csv',
];

test.each(spectra)('girth %s: the same values, but not the same bits', (line) => {
  const args = line.split(' ');
  const values = [
    done(sides.native, command, args),
    done(sides.module, process.execPath, [program, ...args]),
  ].map(({ stdout }) =>
    stdout
      .trim()
      .split('\n')
      .slice(1)
      .map((row) => Number(row.split(',')[1])),
  );
  expect(values[0]!.length).toBeGreaterThan(200);
  values[1]!.forEach((value, i) => expect(value).toBeCloseTo(values[0]![i]!, 9));
});

test('standard input is a model', () => {
  const { stdout } = compare(['igf', '-', '-o', '-', '--format', 'csv'], torus(10, 6));
  expect(stdout.split('\n').length).toBeGreaterThan(60);
});

test.each([
  ['igf absent.obj -o values.csv', 2],
  ['igf folder -o values.csv', 2],
  ['igf empty.obj -o values.csv', 2],
  ['info nan.obj --json', 2],
  ['info torus.obj broken.obj.gz spoiled.obj.gz absent.obj model.off', 2],
  [['info', 'no model.glb'], 2],
  ['igf torus.obj -o nowhere/values.csv', 2],
  ['igf torus.obj -o folder', 1],
  ['igf torus.obj -o values.xyz', 1],
  ['igf torus.obj -o locked.csv', undefined],
  ['igf torus.obj -o /dev/full --format csv', 2],
  ['igf torus.obj --thread 2', 1],
  ['igf torus.obj --threads -1', 1],
  ['giirth', 1],
  ['igf', 1],
  ['loop torus.obj 99999', undefined],
  ['parts torus.obj --persistence -1', undefined],
] satisfies [string | string[], number | undefined][])('girth %s fails', (line, code) => {
  const { status } = compare(typeof line === 'string' ? line.split(' ') : line);
  if (code !== undefined) expect(status).toBe(code);
});

test.each([
  'info secret.obj',
  'info torus.obj secret.obj',
  'tips secret.obj --json',
  'igf shut/torus.obj -o values.csv',
  'igf torus.obj -o shut/values.csv',
  'igf torus.obj -o closed/values.csv',
  'igf torus.obj -o locked.csv',
])('without permission, girth %s fails', (line) => {
  // Root may read and write everything, so that the tests of root ask as nobody does.
  const user = process.getuid!() === 0 ? { uid: 65534, gid: 65534 } : {};
  const native = join(folder, 'native-command');
  copyFileSync(command, native);
  chmodSync(folder, 0o755);
  const runs = Object.values(sides).map((side, i) => {
    const cwd = join(side, 'permissions');
    mkdirSync(join(cwd, 'shut'), { recursive: true });
    mkdirSync(join(cwd, 'closed'));
    for (const name of ['torus.obj', 'secret.obj', 'shut/torus.obj'])
      writeFileSync(join(cwd, name), torus(10, 6));
    writeFileSync(join(cwd, 'locked.csv'), 'locked');
    chmodSync(join(cwd, 'secret.obj'), 0);
    chmodSync(join(cwd, 'locked.csv'), 0o444);
    chmodSync(join(cwd, 'shut'), 0);
    chmodSync(join(cwd, 'closed'), 0o555);
    chmodSync(cwd, 0o777);
    const args = line.split(' ');
    const { status, stdout, stderr } = spawnSync(
      i === 0 ? native : process.execPath,
      i === 0 ? args : [program, ...args],
      { cwd, encoding: 'utf8', ...user },
    );
    const locked = readFileSync(join(cwd, 'locked.csv'), 'utf8');
    const written = existsSync(join(cwd, 'values.csv'));
    chmodSync(join(cwd, 'shut'), 0o755);
    rmSync(cwd, { recursive: true });
    return { status, stdout: timeless(stdout), stderr: timeless(stderr), locked, written };
  });
  expect(runs[1]).toEqual(runs[0]);
  expect(runs[0]).toMatchObject({ status: 2, locked: 'locked', written: false });
  expect(runs[0]!.stdout + runs[0]!.stderr).toMatch(/FILE_UN(READ|WRIT)ABLE.*Permission denied/s);
});

test('standard output that is full is an error', () => {
  const run = (file: string, args: string[]) =>
    spawnSync('sh', ['-c', '"$@" > /dev/full', 'sh', file, ...args], {
      cwd: sides.native,
      encoding: 'utf8',
    });
  const args = ['igf', 'torus.obj', '-o', '-', '--format', 'csv', '--quiet'];
  const native = run(command, args);
  const module = run(process.execPath, [program, ...args]);
  expect(native.status).toBe(2);
  expect([module.status, module.stderr]).toEqual([native.status, native.stderr]);
});

test('Ctrl-C stops it, and nothing half is left', async () => {
  writeFileSync(join(sides.module, 'long.obj'), torus(400, 200));
  const child = spawn(process.execPath, [program, 'igf', 'long.obj', '-o', 'long.csv'], {
    cwd: sides.module,
  });
  let stderr = '';
  child.stderr.on('data', (data) => (stderr += String(data)));
  const ended = once(child, 'close');
  // The signal counts from when the command listens: until then it ends the process at once.
  const pressing = setInterval(() => child.kill('SIGINT'), 2000);
  const [status, signal] = (await ended) as [number | null, string | null];
  clearInterval(pressing);
  if (signal === null) {
    expect(status).toBe(3);
    expect(stderr).toContain('CANCELLED');
  } else {
    expect(signal).toBe('SIGINT');
  }
  expect(existsSync(join(sides.module, 'long.csv'))).toBe(false);
});

test('npx finds it in the package', () => {
  // As npm does when it has unpacked a package: it links the package's programs.
  execFileSync('npm', ['rebuild', '--ignore-scripts', '--offline', 'girth'], {
    cwd: folder,
    stdio: 'ignore',
  });
  const { status, stdout, stderr } = spawnSync(
    'npx',
    ['--no-install', 'girth', 'info', 'native/torus.obj'],
    { cwd: folder, encoding: 'utf8' },
  );
  const native = spawnSync(command, ['info', 'native/torus.obj'], {
    cwd: folder,
    encoding: 'utf8',
  });
  expect({ status, stdout, stderr }).toEqual({ status: 0, stdout: native.stdout, stderr: '' });
});
