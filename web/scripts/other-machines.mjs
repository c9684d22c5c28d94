// The libraries, and where it goes the command, for machines that this one is not: compiled for them, and their tests run
// here. Compressed glTF is left out: Draco and meshoptimizer are not there for them.

import { existsSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { configure } from './build.mjs';
import { compilerCacheEnvironment } from './compiler-cache.mjs';
import { Complaint, outputOf, run } from './run.mjs';
import { setUpMore } from './setup.mjs';

/**
 * @typedef {object} Machine
 * @property {string} compiler of C++
 * @property {string[]} options what CMake is told of it
 * @property {string[]} folders of tests/cpp whose tests run there
 * @property {string} [without] a regular expression of tests that do not run there
 * @property {NodeJS.ProcessEnv} [env] what the tests find in the environment
 */

/** Debian's sources of GoogleTest, which each compiler compiles for itself. */
const googleTest = '/usr/src/googletest';

/**
 * Tests of the core that take seconds here take minutes in an emulator, and more where they reckon in `long double`: these
 * suites of tests look at many surfaces, or at large ones, which others look at one by one.
 */
const emulatedForMinutes = [
  ...['Ascent', 'BadInput', 'Barcode', 'Bottleneck', 'Boundaries', 'Corpus', 'FlatVertices'],
  ...['Handles', 'HeatKernel', 'HeatMaxima', 'Limbs', 'MarchedGirth', 'MovedLoop', 'PrintCheck'],
  ...['RandomMeshes/Properties', 'RefinedGirth', 'Remesh', 'RemoveHandles', 'SaddleCount'],
  ...['Shapes/AgainstBruteForce', 'Solver', 'Spectrum', 'TextbookMmp', 'VertexFunction'],
  'WaveKernel',
];

/**
 * @type {Record<'arm' | 'libcxx' | 'windows', Machine>}
 */
const machines = {
  arm: {
    compiler: 'aarch64-linux-gnu-g++',
    options: [
      ...['-DCMAKE_SYSTEM_NAME=Linux', '-DCMAKE_SYSTEM_PROCESSOR=aarch64'],
      '-DCMAKE_CROSSCOMPILING_EMULATOR=qemu-aarch64;-L;/usr/aarch64-linux-gnu',
      // It needs zlib, which Debian has for ARM only where that is one of the system's own architectures.
      '-DGIRTH_BUILD_COMMAND=OFF',
    ],
    folders: ['core', 'io'],
    without: `^core: ?(${emulatedForMinutes.join('|')})\\.`,
  },
  libcxx: {
    compiler: 'clang++',
    options: ['-DCMAKE_CXX_FLAGS=-stdlib=libc++', '-DGIRTH_BUILD_COMMAND=ON'],
    folders: ['core', 'io'],
  },
  windows: {
    compiler: 'x86_64-w64-mingw32-g++-posix',
    options: [
      ...['-DCMAKE_SYSTEM_NAME=Windows', '-DCMAKE_SYSTEM_PROCESSOR=AMD64'],
      '-DCMAKE_C_COMPILER=x86_64-w64-mingw32-gcc-posix',
      '-DCMAKE_CROSSCOMPILING_EMULATOR=/usr/lib/wine/wine64',
      // Programs that need no libraries beside them.
      ...['-DCMAKE_EXE_LINKER_FLAGS=-static', '-DZLIB_USE_STATIC_LIBS=ON'],
      ...['-DCMAKE_FIND_ROOT_PATH=/usr/x86_64-w64-mingw32'],
      ...['INCLUDE', 'LIBRARY', 'PACKAGE'].map(
        (kind) => `-DCMAKE_FIND_ROOT_PATH_MODE_${kind}=ONLY`,
      ),
      '-DGIRTH_BUILD_COMMAND=ON',
    ],
    folders: ['core', 'io'],
    // It makes symbolic links, which this library has not.
    without: 'BuffersAreFoundInTheModelsFolderAndNowhereElse',
    env: { WINEDEBUG: '-all', LC_ALL: 'C.UTF-8' },
  },
};

/**
 * Builds the tests for a machine and runs them.
 * @param {keyof typeof machines} name
 * @param {string} report where the results go, as JUnit's XML
 */
export function testOnMachine(name, report) {
  setUpMore(name);
  const { compiler, options, folders, without, env } = machines[name];
  const missing = outputOf(compiler, ['--version']) === undefined ? compiler : googleTest;
  if (missing === compiler || !existsSync(googleTest)) {
    throw new Complaint(
      `${missing} is missing; the packages are in web/scripts/debian-packages-${name}.txt`,
    );
  }
  const tree = `build/${name}`;
  configure({
    tree,
    compiler,
    options: [
      ...[`-DCMAKE_CXX_COMPILER=${compiler}`, `-DGIRTH_GOOGLETEST=${googleTest}`],
      ...['-DGIRTH_GLTF_CODECS=OFF', '-DGIRTH_BUILD_BENCHMARKS=OFF', '-DGIRTH_INSTALL=OFF'],
      ...options,
    ],
  });
  const command = options.includes('-DGIRTH_BUILD_COMMAND=ON');
  const targets = folders.map((folder) => `${folder}_tests`);
  run('cmake', ['--build', tree, '--target', ...targets, ...(command ? ['girth'] : [])], {
    env: compilerCacheEnvironment(),
  });
  run(
    'ctest',
    [
      ...['--test-dir', `${tree}/tests/cpp`, '--tests-regex', `^(${folders.join('|')}):`],
      ...(without ? ['--exclude-regex', without] : []),
      ...['--no-tests=error', '--output-on-failure', '--progress', '--output-junit', report],
      ...['--parallel', `${availableParallelism()}`],
    ],
    // Files of the corpus are this machine's matter.
    { env: { ...process.env, ...env, GIRTH_DATA: '' } },
  );
}
