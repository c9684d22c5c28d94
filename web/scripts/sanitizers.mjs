// Build trees in which the whole library carries sanitizers, by clang, and the native tests in them.

import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { configure } from './build.mjs';
import { compilerCacheEnvironment } from './compiler-cache.mjs';
import { run } from './run.mjs';

/**
 * What CMake is asked for. `address`: AddressSanitizer and UndefinedBehaviorSanitizer, with the fuzzers;
 * `thread`: ThreadSanitizer.
 * @type {Record<'address' | 'thread', string[]>}
 */
const options = {
  address: ['-DGIRTH_SANITIZERS=address,undefined,float-cast-overflow', '-DGIRTH_BUILD_FUZZERS=ON'],
  thread: ['-DGIRTH_SANITIZERS=thread'],
};

/**
 * Builds targets with sanitizers; the build tree.
 * @param {'address' | 'thread'} kind
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
