// The npm package as a stranger gets it: packed, put into a fresh folder, type-checked by a strict project
// and imported as an ES module.

import { execFileSync, spawnSync } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, expect, test } from 'vitest';
import { packed } from './packed.js';

const repository = fileURLToPath(new URL('../../..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'girth-tarball-'));
const packageFolder = join(folder, 'node_modules/girth');

interface Manifest {
  version: string;
  exports: Record<string, string | { types: string; default: string }>;
  dependencies: Record<string, string>;
}
let manifest: Manifest;

/** A page's own code: the kernel with all its types, without the DOM of three.js. */
const kernelCode = `
import { createKernel, GirthError, type Kernel, type Mesh } from 'girth';

export async function measure(file: File): Promise<number> {
  const kernel: Kernel = await createKernel({ threads: 'auto' });
  try {
    const mesh: Mesh = await kernel.load(file);
    const field = await mesh.field('igf', { onProgress: (fraction: number) => console.log(fraction) });
    const values: Float64Array = field.values;
    const loop = await mesh.loop({ face: 0, weights: [0.2, 0.3, 0.5] });
    const points: Float32Array = loop.polyline;
    mesh.dispose();
    return loop.length + points.length + (values[0] ?? 0);
  } catch (error) {
    if (error instanceof GirthError) console.error(error.code, error.message);
    throw error;
  } finally {
    kernel.dispose();
  }
}

// @ts-expect-error There is no such field.
export const wrong = (mesh: Mesh) => mesh.field('no field');
`;

/** A page with the element in its own three.js, and with plots. */
const elementCode = `
import 'girth/element';
import { histogram } from 'girth/plots';

export async function show(source: string): Promise<void> {
  const viewer = document.createElement('girth-viewer');
  document.body.append(viewer);
  await viewer.load(source);
}

export const plotted = histogram;
`;

/** What a project that uses the package checks its types with. */
function typeCheck(module: 'NodeNext' | 'ESNext', moduleResolution: 'NodeNext' | 'Bundler') {
  const compilerOptions = {
    ...{ target: 'ES2022', lib: ['ES2022', 'DOM', 'DOM.Iterable'], types: [], noEmit: true },
    ...{ strict: true, noUncheckedIndexedAccess: true },
    ...{ module, moduleResolution },
  };
  writeFileSync(
    join(folder, 'tsconfig.json'),
    JSON.stringify({ compilerOptions, files: ['kernel.ts', 'element.ts'] }),
  );
  return spawnSync(process.execPath, [join(repository, 'node_modules/typescript/bin/tsc')], {
    cwd: folder,
    encoding: 'utf8',
  });
}

beforeAll(() => {
  cpSync(packed().folder, packageFolder, { recursive: true });
  manifest = JSON.parse(readFileSync(join(packageFolder, 'package.json'), 'utf8')) as Manifest;
  // What npm would install beside it.
  for (const name of [...Object.keys(manifest.dependencies), 'three']) {
    symlinkSync(join(repository, 'node_modules', name), join(folder, 'node_modules', name));
  }
  mkdirSync(join(folder, 'node_modules/@types'));
  symlinkSync(
    join(repository, 'node_modules/@types/three'),
    join(folder, 'node_modules/@types/three'),
  );
  writeFileSync(join(folder, 'package.json'), JSON.stringify({ type: 'module', private: true }));
  writeFileSync(join(folder, 'kernel.ts'), kernelCode);
  writeFileSync(join(folder, 'element.ts'), elementCode);
}, 120_000);

afterAll(() => {
  rmSync(folder, { recursive: true });
});

test('everything that the package exports is in it, with licence, readme and change log', () => {
  const files = Object.values(manifest.exports).flatMap((entry) =>
    typeof entry === 'string' ? [entry] : [entry.types, entry.default],
  );
  for (const file of [...files, 'LICENSE', 'README.md', 'CHANGELOG.md']) {
    expect(existsSync(join(packageFolder, file)), file).toBe(true);
  }
  expect(existsSync(join(packageFolder, 'dist/kernel/wasm'))).toBe(true);
});

test.each([
  ['NodeNext', 'NodeNext'],
  ['ESNext', 'Bundler'],
] as const)('a strict project compiles against its types: %s, %s', (module, moduleResolution) => {
  const { status, stdout } = typeCheck(module, moduleResolution);
  expect(stdout).toBe('');
  expect(status).toBe(0);
});

test('Node.js imports it as an ES module', () => {
  const code = `
    import { createKernel, GirthError } from 'girth';
    import manifest from 'girth/package.json' with { type: 'json' };
    const error = new GirthError({ code: 'OPEN_EDGE', element: 3, message: 'm', hint: 'h' });
    console.log(JSON.stringify([typeof createKernel, error instanceof Error, error.code, manifest.version]));
  `;
  const printed = execFileSync(
    process.execPath,
    ['--no-warnings', '--input-type=module', '--eval', code],
    { cwd: folder, encoding: 'utf8' },
  );
  expect(JSON.parse(printed)).toEqual(['function', true, 'OPEN_EDGE', manifest.version]);
});
