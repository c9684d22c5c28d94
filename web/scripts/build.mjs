// Builds what is stale: `build.mjs [native] [wasm] [examples] [page] [package] [docs] [shown]`, everything by default.

import {
  cpSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { compilerCache, compilerCacheEnvironment } from './compiler-cache.mjs';
import { copyDecoders } from './decoders.mjs';
import { emscriptenEnvironment, findEmscripten } from './emscripten.mjs';
import { buildReference } from './reference.mjs';
import { Complaint, repository, run, runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { refresh } from './stale.mjs';

const configuration = ['package-lock.json', 'web/tsconfig.base.json'];

/**
 * A build tree of CMake. Configuring sees to it that the tree is for this compiler; after that, Ninja
 * knows what is stale.
 * @param {{ tree: string, compiler?: string, wrapper?: string[], options?: string[], env?: NodeJS.ProcessEnv }} tree
 */
export function configure({ tree, compiler = '', wrapper = [], options = [], env }) {
  const cache = join(repository, tree, 'CMakeCache.txt');
  const isConfigured =
    existsSync(join(repository, tree, 'build.ninja')) &&
    readFileSync(cache, 'utf8').includes(compiler);
  const warnings = process.env.CI ? ['-DGIRTH_WERROR=ON'] : [];
  if (isConfigured && warnings.length === 0) return;
  if (!isConfigured) rmSync(cache, { force: true });
  const [program = '', ...args] = [...wrapper, 'cmake', '-S', '.', '-B', tree, '-G', 'Ninja'];
  // Emscripten starts the compiler itself; its environment names the cache.
  const launcher = compilerCache();
  if (launcher && wrapper.length === 0) args.push(`-DCMAKE_CXX_COMPILER_LAUNCHER=${launcher}`);
  run(program, [...args, ...options, ...warnings], {
    env: env ?? compilerCacheEnvironment(),
    quiet: isConfigured,
  });
}

/** The native build tree, ready to be built. */
export function configureNative() {
  configure({ tree: 'build/native' });
}

/**
 * The libraries, the command and the tests; other targets by name, such as long_tests or benchmarks.
 * @param {string[]} targets
 */
export function buildNative(targets = []) {
  configureNative();
  const named = targets.length > 0 ? ['--target', ...targets] : [];
  run('cmake', ['--build', 'build/native', ...named], { env: compilerCacheEnvironment() });
}

/** The build tree of the WebAssembly modules, for the newest Emscripten there is. */
export function wasmTree() {
  const emscripten = findEmscripten();
  if (!emscripten) throw new Complaint('Emscripten (em++) is missing');
  const { folder } = emscripten;
  return {
    tree: 'build/wasm',
    compiler: join(folder, 'em++'),
    wrapper: [join(folder, 'emcmake')],
    env: emscriptenEnvironment(emscripten),
  };
}

/** Both WebAssembly modules, and beside them the decoders of compressed glTF. */
export function buildWasm() {
  const tree = wasmTree();
  configure(tree);
  run('cmake', ['--build', tree.tree], { env: tree.env });
  copyDecoders();
}

/** Where the command lies as a WebAssembly module for Node.js, with what starts it. */
const commandModule = 'build/wasm/command';

/** The command as a WebAssembly module: a target of its own, since the page does not need it. */
export function buildCommandModule() {
  const tree = wasmTree();
  configure(tree);
  run('cmake', ['--build', tree.tree, '--target', 'girth_command_wasm'], { env: tree.env });
}

/** The built-in example models, by the core's remeshing. */
export async function buildExamples() {
  buildWasm();
  await refresh({
    name: 'examples',
    inputs: [...configuration, 'web/app/examples', 'cpp/src/mesh/remesh'],
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
  await buildExamples();
  await buildSavedPage();
  await refresh({
    name: 'page',
    inputs: [
      ...[...configuration, 'package.json', 'web/vite.app.config.ts', 'web/src', 'web/app'],
      'web/scripts/offline.mjs',
    ],
    outputs: ['build/page/index.html', 'build/page/service-worker.js'],
    make: () =>
      runTool('vite', ['build', '--config', 'web/vite.app.config.ts', '--logLevel', 'warn']),
  });
}

/**
 * Names that stay for the bundled workers, whose own names are of their content: `createKernel({ base })` asks for them.
 * @param {string} folder of the package
 */
function nameWorkers(folder) {
  const assets = readdirSync(join(folder, 'assets'));
  mkdirSync(join(folder, 'workers'));
  for (const name of ['worker', 'threads-worker', 'job-worker', 'studies-worker']) {
    const scripts = assets.filter((file) => new RegExp(`^${name}-[\\w-]{8}\\.js$`).test(file));
    if (scripts.length !== 1) throw new Complaint(`build: ${scripts.length} scripts of ${name}`);
    writeFileSync(join(folder, 'workers', `${name}.js`), `import '../assets/${scripts[0]}';\n`);
  }
}

/**
 * Modules that the bundled workers have copies of: they take those of the kernel's own, so that the package has each once.
 * @param {string} folder of the package
 */
function shareModules(folder) {
  const assets = join(folder, 'assets');
  const names = readdirSync(assets);
  for (const copy of names.filter((name) => name.endsWith('.wasm'))) {
    const own = copy.replace(/-[\w-]{8}\.wasm$/, '.wasm');
    const [copied, kept] = [join(assets, copy), join(folder, 'kernel/wasm', own)];
    if (!readFileSync(copied).equals(readFileSync(kept)))
      throw new Complaint(`build: ${copy} is not the kernel's ${own}`);
    for (const script of names.filter((name) => name.endsWith('.js'))) {
      const path = join(assets, script);
      const text = readFileSync(path, 'utf8');
      if (text.includes(copy)) writeFileSync(path, text.replaceAll(copy, `../kernel/wasm/${own}`));
    }
    rmSync(copied);
  }
}

/** The npm package: the kernel's modules one by one, the element, both with everything, the plots, the command. */
export async function buildPackage() {
  buildWasm();
  buildCommandModule();
  await refresh({
    name: 'package',
    inputs: [
      ...[...configuration, 'package.json', 'web/vite.package.config.ts', 'web/src'],
      ...['package.json', 'girth.cjs', 'girth-command.js', 'girth-command.wasm'].map((name) =>
        join(commandModule, name),
      ),
      ...[
        'bundle-types',
        'bundled-packages',
        'element-manifest',
        'framework-types',
        'lean-three',
        'package-papers',
      ].map((name) => `web/scripts/${name}.mjs`),
    ],
    outputs: [
      ...['dist/kernel/index.js', 'dist/node/index.js', 'dist/girth-kernel.js', 'dist/element.js'],
      ...['dist/girth-viewer.js', 'dist/plots.js', 'dist/command/girth.cjs'],
    ],
    make: async () => {
      for (const folder of ['dist', 'build/bundled']) {
        rmSync(join(repository, folder), { recursive: true, force: true });
      }
      // Not bundled: whoever bundles the package recognises the workers and the modules by the way
      // in which the kernel names them. Node.js takes them as they are.
      runTool('tsc', ['--build', 'web/tsconfig.node.json']);
      // Their types are checked where the declarations are made.
      for (const layer of ['kernel', 'node']) {
        runTool('tsc', [
          ...['--project', `web/tsconfig.${layer}.json`, '--emitDeclarationOnly', 'false'],
          ...['--composite', 'false', '--incremental', 'false', '--declaration', 'false'],
          ...['--noCheck', '--outDir', 'dist'],
        ]);
      }
      cpSync(join(repository, 'web/src/kernel/wasm'), join(repository, 'dist/kernel/wasm'), {
        recursive: true,
      });
      cpSync(join(repository, commandModule), join(repository, 'dist/command'), {
        recursive: true,
      });
      runTool('tsc', ['--build', 'web/tsconfig.element.json']);
      // Uses TypeScript, which is there only after the set-up.
      const { bundlePackageTypes } = await import('./bundle-types.mjs');
      bundlePackageTypes({ from: join(repository, 'build/types'), to: join(repository, 'dist') });
      const vite = ['build', '--config', 'web/vite.package.config.ts', '--logLevel', 'warn'];
      for (const mode of ['element', 'kernel', 'viewer', 'plots']) {
        runTool('vite', [...vite, '--mode', mode]);
      }
      nameWorkers(join(repository, 'dist'));
      shareModules(join(repository, 'dist'));
      const { writePackagePapers } = await import('./package-papers.mjs');
      writePackagePapers(join(repository, 'dist'));
    },
  });
}

/** The documentation, beside the page whose figures it shows and which links to it, with the references. */
export async function buildDocs() {
  await buildPage();
  await buildPackage();
  await buildReference();
  await refresh({
    name: 'docs',
    inputs: [
      ...[...configuration, 'web/docs', 'web/app/icon.svg', 'web/app/public/examples', 'dist'],
      ...['README.md', 'ARCHITECTURE.md', 'CONTRIBUTING.md', 'SECURITY.md', 'CHANGELOG.md'],
      ...['cpp/bench/README.md', 'tests/README.md', 'tests/fuzz/README.md'],
      ...['cpp/include/girth/error_codes.def', 'cpp/python/pygirth'],
      ...['build/reference/cpp/index.html', 'build/reference/js/index.html'],
    ],
    outputs: ['build/page/docs/index.html', 'build/page/docs/site/search.json'],
    make: () => {
      rmSync(join(repository, 'build/page/docs'), { recursive: true, force: true });
      runTool('eleventy', ['--config=web/docs/site/eleventy.config.mjs', '--quiet']);
    },
  });
}

/** Sources of the kernel that the element has, beside types. */
const usedOfKernel = [
  'page/abort',
  'types/disposal',
  'types/errors',
  'unpack/crc',
  'workers/trusted-script',
  'workers/worker-from-elsewhere',
];

/** The program of pages that the page and `pygirth.show` of the Python package save: the element without the kernel, in one file. */
export async function buildSavedPage() {
  await refresh({
    name: 'saved-page',
    inputs: [
      ...[...configuration, 'package.json', 'web/vite.shown.config.ts', 'web/src/element'],
      ...['web/src/view', ...usedOfKernel.map((name) => `web/src/kernel/${name}.ts`)],
    ],
    outputs: ['build/shown/girth-shown.js', 'build/shown/girth-shown.html'],
    make: () => {
      runTool('vite', ['build', '--config', 'web/vite.shown.config.ts', '--logLevel', 'warn']);
      const template = join(repository, 'web/src/element/saved-page.html.in');
      cpSync(template, join(repository, 'build/shown/girth-shown.html'));
    },
  });
}

const builds = {
  native: () => buildNative(),
  wasm: buildWasm,
  examples: buildExamples,
  page: buildPage,
  package: buildPackage,
  docs: buildDocs,
  shown: buildSavedPage,
};

async function main() {
  const wanted = process.argv.slice(2);
  const unknown = wanted.find((name) => !(name in builds));
  if (unknown)
    throw new Complaint(`build: no ${unknown}; there are ${Object.keys(builds).join(', ')}`);
  setUp();
  for (const [name, build] of Object.entries(builds)) {
    if (wanted.length === 0 || wanted.includes(name)) await build();
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await script(main);
