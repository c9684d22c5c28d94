// Build trees in which the whole library carries sanitizers, by clang, and the native tests in them.

import { cpSync, readdirSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { configure } from './build.mjs';
import { compilerCacheEnvironment } from './compiler-cache.mjs';
import { python, runPythonTests } from './python.mjs';
import { outputOf, repository, run } from './run.mjs';

const address = [
  '-DGIRTH_SANITIZERS=address,undefined,float-cast-overflow',
  '-DGIRTH_BUILD_FUZZERS=ON',
];

/**
 * Options of CMake. `address`: AddressSanitizer and UndefinedBehaviorSanitizer, with the fuzzers;
 * `python`: the same libraries, so that the compiler's cache has them, in the Python package's module;
 * `thread`: ThreadSanitizer.
 * @type {Record<'address' | 'python' | 'thread', string[]>}
 */
const options = {
  address,
  python: [
    ...[...address, '-DGIRTH_BUILD_TESTS=OFF', '-DGIRTH_BUILD_PYTHON=ON'],
    `-DPython_EXECUTABLE=${python}`,
  ],
  thread: ['-DGIRTH_SANITIZERS=thread'],
};

/**
 * Builds targets with sanitizers; the build tree.
 * @param {'address' | 'python' | 'thread'} kind
 * @param {string[]} targets
 */
export function buildSanitized(kind, targets) {
  const tree = `build/sanitize-${kind}`;
  configure({
    tree,
    compiler: 'clang++',
    options: [
      ...['-DCMAKE_CXX_COMPILER=clang++', '-DCMAKE_BUILD_TYPE=Debug'],
      ...['-DGIRTH_BUILD_COMMAND=OFF', '-DGIRTH_BUILD_BENCHMARKS=OFF'],
      '-DGIRTH_PRECOMPILE_HEADERS=OFF',
      ...options[kind],
    ],
  });
  run('cmake', ['--build', tree, '--target', ...targets], { env: compilerCacheEnvironment() });
  return tree;
}

/**
 * Runs the tests of the core and of reading and writing with sanitizers, shared out between the cores.
 * @param {'address' | 'thread'} kind
 */
export function testWithSanitizers(kind) {
  const tree = buildSanitized(kind, ['core_tests', 'io_tests']);
  run('ctest', [
    ...['--test-dir', join(tree, 'tests/cpp'), '--tests-regex', '^(core|io):', '--no-tests=error'],
    ...['--parallel', `${availableParallelism()}`, '--output-on-failure', '--progress'],
  ]);
}

/**
 * Runs ten thousand random arrays through the Python package, whose module carries sanitizers.
 * @param {string} report where the results go, as JUnit's XML
 */
export function testPythonWithSanitizers(report) {
  const tree = join(repository, buildSanitized('python', ['girth_python']));
  const packages = join(tree, 'packages');
  rmSync(packages, { recursive: true, force: true });
  cpSync(join(repository, 'cpp/python/pygirth'), join(packages, 'pygirth'), { recursive: true });
  for (const name of readdirSync(join(tree, 'python'))) {
    cpSync(join(tree, 'python', name), join(packages, 'pygirth', name));
  }
  // Python has none: the sanitizer comes first, and what throws exceptions has to be there when it looks for that.
  const runtime = outputOf('clang++', ['-print-file-name=libclang_rt.asan-x86_64.so'])?.trim();
  const library = outputOf('clang++', ['-print-file-name=libstdc++.so.6'])?.trim();
  runPythonTests(report, ['tests/python/test_random_arrays.py'], {
    program: python,
    env: {
      GIRTH_RANDOM_ARRAYS: '10000',
      PYTHONPATH: packages,
      LD_PRELOAD: `${runtime} ${library}`,
      // Python itself leaks, and memory that there is not is an error of ours.
      ASAN_OPTIONS: 'detect_leaks=0:allocator_may_return_null=1',
    },
  });
}
