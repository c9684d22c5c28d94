// Builds what is stale: `build.mjs [native] [wasm] [examples] [page] [package]`, everything by default.

import { cpSync, existsSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { emscriptenEnvironment, findEmscripten } from './emscripten.mjs';
import { Complaint, repository, run, runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { refresh } from './stale.mjs';

const configuration = ['package-lock.json', 'web/tsconfig.base.json'];

/**
 * Configures a build tree unless it is, and builds it; Ninja knows what is stale.
 * @param {string} tree
 * @param {string} compiler
 * @param {{ program: string, args: string[], env: NodeJS.ProcessEnv }} cmake
 */
function cmakeBuild(tree, compiler, { program, args, env }) {
  const cache = join(repository, tree, 'CMakeCache.txt');
  const isConfigured =
    existsSync(join(repository, tree, 'build.ninja')) &&
    readFileSync(cache, 'utf8').includes(compiler);
  if (!isConfigured) {
    rmSync(cache, { force: true });
    const warnings = `-DGIRTH_WERROR=${process.env.CI ? 'ON' : 'OFF'}`;
    run(program, [...args, '-S', '.', '-B', tree, '-G', 'Ninja', warnings], { env });
  }
  run('cmake', ['--build', tree], { env });
}

/** The libraries, the command, the tests and the benchmarks. */
export function buildNative() {
  cmakeBuild('build/native', '', { program: 'cmake', args: [], env: process.env });
}

/** Both WebAssembly modules. */
export function buildWasm() {
  const emscripten = findEmscripten();
  if (!emscripten) throw new Complaint('Emscripten (em++) is missing');
  cmakeBuild('build/wasm', join(emscripten.folder, 'em++'), {
    program: join(emscripten.folder, 'emcmake'),
    args: ['cmake'],
    env: emscriptenEnvironment(emscripten),
  });
}

/** The built-in example models. */
export async function buildExamples() {
  await refresh({
    name: 'examples',
    inputs: [...configuration, 'web/app/examples'],
    outputs: ['web/app/public/examples/index.json'],
    make: () => {
      runTool('vite', [
        ...['build', '--ssr', 'web/app/examples/build.ts', '--outDir', 'build/examples'],
        ...['--logLevel', 'warn'],
      ]);
      rmSync(join(repository, 'web/app/public/examples'), { recursive: true, force: true });
      run('node', ['build/examples/build.js', 'web/app/public/examples']);
    },
  });
}

/** The page, with the modules and the examples that it needs. */
export async function buildPage() {
  buildWasm();
  await buildExamples();
  await refresh({
    name: 'page',
    inputs: [...configuration, 'web/vite.app.config.ts', 'web/src', 'web/app'],
    outputs: ['build/page/index.html'],
    make: () => runTool('vite', ['build', '--config', 'web/vite.app.config.ts']),
  });
}

/** The npm package: the kernel's modules one by one, the element, and the element with everything. */
export async function buildPackage() {
  buildWasm();
  await refresh({
    name: 'package',
    inputs: [...configuration, 'package.json', 'web/vite.package.config.ts', 'web/src'],
    outputs: ['dist/kernel/index.js', 'dist/element.js', 'dist/girth-viewer.js'],
    make: () => {
      rmSync(join(repository, 'dist'), { recursive: true, force: true });
      const vite = ['build', '--config', 'web/vite.package.config.ts', '--mode'];
      runTool('vite', [...vite, 'element']);
      runTool('vite', [...vite, 'bundle']);
    },
  });
}

const builds = {
  native: buildNative,
  wasm: buildWasm,
  examples: buildExamples,
  page: buildPage,
  package: buildPackage,
};

async function main() {
  const wanted = process.argv.slice(2);
  const unknown = wanted.find((name) => !(name in builds));
  if (unknown) throw new Complaint(`build: no ${unknown}; there are ${Object.keys(builds).join(', ')}`);
  setUp();
  for (const [name, build] of Object.entries(builds)) {
    if (wanted.length === 0 || wanted.includes(name)) await build();
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await script(main);
