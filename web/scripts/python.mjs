// The Python package: archives that pip installs, an environment of its own with one of them, as pip makes it without a
// network, and the tests there. `npm run build:python` makes the archives.

import { mkdirSync, readdirSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { buildSavedPage } from './build.mjs';
import { compilerCacheEnvironment } from './compiler-cache.mjs';
import { repository, run, script } from './run.mjs';
import { setUp } from './setup.mjs';

/** Debian's Python, which sees Debian's packages; elsewhere the one that PYTHON names. */
export const python = process.env.PYTHON ?? '/usr/bin/python3';
const environment = 'build/python/environment';

/** Python of the environment that the package is installed in. */
export const installedPython = join(environment, 'bin/python');

/** Where `npm run build:python` puts the archives. */
const archives = 'build/python/dist';

/**
 * Runs pip without a network.
 * @param {string[]} words
 */
const pip = (...words) =>
  run(python, ['-m', 'pip', ...words], {
    env: { ...compilerCacheEnvironment(), PIP_DISABLE_PIP_VERSION_CHECK: '1' },
  });

/**
 * Makes a wheel, and nothing else, in a folder; its path.
 * @param {string} source the folder with the project file
 * @param {string} tree where it is compiled
 * @param {string} folder
 */
function makeWheel(source, tree, folder) {
  const target = join(repository, folder);
  const wheels = () => readdirSync(target).filter((name) => name.endsWith('.whl'));
  mkdirSync(target, { recursive: true });
  for (const old of wheels()) rmSync(join(target, old));
  const building = ['--config-settings', `build-dir=${join(repository, tree)}`];
  pip('wheel', '--no-index', '--no-deps', '--wheel-dir', folder, ...building, source);
  const [made = ''] = wheels();
  return join(folder, made);
}

/**
 * Makes an environment with the package of a wheel, and nothing of an earlier one; its Python.
 * @param {string} wheel
 * @param {string} folder
 */
function installWheel(wheel, folder) {
  rmSync(join(repository, folder), { recursive: true, force: true });
  run(python, ['-m', 'venv', '--system-site-packages', '--without-pip', folder]);
  const program = join(folder, 'bin/python');
  pip('--python', program, 'install', '--no-index', '--no-deps', wheel);
  return program;
}

/**
 * Installs the package from a wheel. It is compiled in the native build tree, where the core is already.
 * @param {string} tree
 */
export function installPythonPackage(tree = 'build/native') {
  installWheel(makeWheel('./cpp/python', tree, 'build/python/wheel'), environment);
}

/** Makes the source archive, and of what is in that, and of nothing else, the wheel; the wheel's path. */
export async function buildPythonPackage() {
  await buildSavedPage();
  mkdirSync(join(repository, archives), { recursive: true });
  for (const old of readdirSync(join(repository, archives)))
    rmSync(join(repository, archives, old));
  const making = "import sys; sys.path[:0] = ['cpp/python/backend']; import girth_build as backend";
  run(python, ['-B', '-c', `${making}; backend.build_sdist('${archives}')`]);
  const [archive = ''] = readdirSync(join(repository, archives));
  const unpacked = 'build/python/source';
  rmSync(join(repository, unpacked), { recursive: true, force: true });
  mkdirSync(join(repository, unpacked), { recursive: true });
  run('tar', ['--extract', '--touch', '--file', join(archives, archive), '--directory', unpacked]);
  const source = join(unpacked, basename(archive, '.tar.gz'));
  return makeWheel(`./${source}`, 'build/python/tree', archives);
}

/** Builds the archives, and installs the wheel in an environment of its own; that one's Python. */
export async function installBuiltPackage() {
  return installWheel(await buildPythonPackage(), 'build/python/built');
}

/** Tests that take long or need other programs. */
const long = 'tests/python/long';

/**
 * Runs tests of tests/python.
 * @param {string} report where the results go, as JUnit's XML
 * @param {string[]} files what is run; by default the tests of `npm test`
 * @param {{ program?: string, env?: NodeJS.ProcessEnv }} options which Python, and what its environment has besides
 */
export function runPythonTests(
  report,
  files = ['tests/python', `--ignore=${long}`],
  { program = installedPython, env = {} } = {},
) {
  rmSync(report, { force: true });
  run(
    program,
    [
      ...['-m', 'pytest', '-q', '-p', 'no:cacheprovider', '-o', 'junit_family=xunit1'],
      ...[`--junitxml=${report}`, ...files],
    ],
    { env: { ...process.env, PYTHONDONTWRITEBYTECODE: '1', ...env } },
  );
}

/**
 * Runs the tests of collections on several machines, as far as one machine can be several.
 * @param {string} report where the results go, as JUnit's XML
 */
export const runClusterTests = (report) => runPythonTests(report, [long]);

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  await script(async () => {
    setUp();
    console.log(`girth: ${await buildPythonPackage()} and the source archive beside it`);
  });
}
