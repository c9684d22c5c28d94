// The Python package: installed into an environment of its own, as pip does it without a network, and
// tested there.

import { existsSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { compilerCacheEnvironment } from './compiler-cache.mjs';
import { repository, run } from './run.mjs';

/** Debian's Python, which sees Debian's packages; elsewhere the one that PYTHON names. */
export const python = process.env.PYTHON ?? '/usr/bin/python3';
const environment = 'build/python/environment';

/** Python of the environment that the package is installed in. */
export const installedPython = join(environment, 'bin/python');

/**
 * Installs the package. It is compiled in the native build tree, where the core is already.
 * @param {string} tree
 */
export function installPythonPackage(tree = 'build/native') {
  if (!existsSync(join(repository, installedPython))) {
    run(python, ['-m', 'venv', '--system-site-packages', '--without-pip', environment]);
  }
  run(
    python,
    [
      ...['-m', 'pip', '--python', installedPython, 'install', '--no-index', '--force-reinstall'],
      ...['--no-deps', '--config-settings', `build-dir=${tree}`, './cpp/python'],
    ],
    { env: { ...compilerCacheEnvironment(), PIP_DISABLE_PIP_VERSION_CHECK: '1' } },
  );
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
