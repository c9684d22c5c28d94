// The parts that tests consist of: what each runs, what it needs, and in which lane. `test.mjs` arranges
// them; `test-parts.mjs NAME` runs one and writes what it counted to build/reports/NAME.json.

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { buildDocs, buildNative, buildSavedPage, buildWasm } from './build.mjs';
import { replayFuzzers, runFuzzers } from './fuzz.mjs';
import { lint, lintNative } from './lint.mjs';
import {
  installBuiltPackage,
  installPythonPackage,
  runClusterTests,
  runPythonTests,
} from './python.mjs';
import { testOnMachine } from './other-machines.mjs';
import { Complaint, repository, run, runTool, script } from './run.mjs';
import { testPythonWithSanitizers, testWithSanitizers } from './sanitizers.mjs';
import { setUpMore } from './setup.mjs';
import { testSharedLibraries } from './shared-libraries.mjs';
import { filesBelow, hashOf } from './stale.mjs';

export const reports = join(repository, 'build/reports');

/**
 * @typedef {object} Count tests passed, failed and skipped
 * @property {number} passed
 * @property {number} failed
 * @property {number} skipped
 */

/**
 * @typedef {object} Part
 * @property {string} title as it is printed
 * @property {string[]} [needs] parts that must have succeeded before
 * @property {boolean} [background] runs beside the other lane, with what processor time that one leaves
 * @property {() => string} [fingerprint] of what it depends on: where it has succeeded on the same, `npm test`
 *   does not run it again
 * @property {(count: Count) => void | Promise<void>} run
 */

/**
 * Arguments of vitest to run a project of vitest.config.ts and to write a report as JSON.
 * @param {string} project its name, or a pattern of names
 * @param {{ report: string, workers: number }} options workers: processes that the files are shared out between
 */
export const vitestArguments = (project, { report, workers }) => [
  ...['run', '--config', 'web/vitest.config.ts', '--project', project],
  ...['--reporter', 'json', '--outputFile', report, `--maxWorkers=${workers}`],
];

/** Files that are tested at a time: Chromium waits for frames and workers, so that one more than cores keeps them busy. */
export const browserWorkers = availableParallelism() + 1;

/**
 * Runs a project of vitest.config.ts, several files at a time.
 * @param {string} project
 * @param {Count} count
 * @param {number} [workers]
 */
function vitest(project, count, workers = availableParallelism()) {
  const report = join(reports, `vitest-${project}.json`);
  rmSync(report, { force: true });
  try {
    runTool('vitest', [
      ...vitestArguments(project, { report, workers }),
      ...['--reporter', 'default'],
    ]);
  } finally {
    if (existsSync(report)) {
      const counted = JSON.parse(readFileSync(report, 'utf8'));
      count.passed += counted.numPassedTests;
      count.failed += counted.numFailedTests;
      count.skipped += counted.numPendingTests;
    }
  }
}

/**
 * Adds what a report in JUnit's XML has counted, where there is one.
 * @param {string} report
 * @param {Count} count
 */
function countJunit(report, count) {
  if (!existsSync(report)) return;
  const [suite = ''] = /<testsuite\b[^>]*>/.exec(readFileSync(report, 'utf8')) ?? [];
  /** @param {string} name */
  const counted = (name) => Number(new RegExp(`\\b${name}="(\\d+)"`).exec(suite)?.[1] ?? 0);
  const skipped = counted('skipped') + counted('disabled');
  const failed = counted('failures') + counted('errors');
  count.failed += failed;
  count.skipped += skipped;
  count.passed += counted('tests') - failed - skipped;
}

/** @param {Count} count */
function ctest(count) {
  const report = join(reports, 'ctest.xml');
  rmSync(report, { force: true });
  try {
    run('ctest', [
      ...['--test-dir', 'build/native', '--output-on-failure', '--output-junit', report],
      ...['--parallel', `${availableParallelism()}`],
    ]);
  } finally {
    countJunit(report, count);
  }
}

/** @param {Count} count */
async function pytest(count) {
  await buildSavedPage();
  installPythonPackage();
  const report = join(reports, 'pytest.xml');
  try {
    runPythonTests(report);
  } finally {
    countJunit(report, count);
  }
  vitest('python', count);
}

/**
 * The tests of the package as `npm run build:python` makes it of its source archive.
 * @param {Count} count
 */
async function builtPython(count) {
  const program = await installBuiltPackage();
  const report = join(reports, 'pytest-built.xml');
  try {
    runPythonTests(report, undefined, { program });
  } finally {
    countJunit(report, count);
  }
}

/** @param {Count} count */
function clusters(count) {
  setUpMore('clusters');
  const report = join(reports, 'pytest-clusters.xml');
  try {
    runClusterTests(report);
  } finally {
    countJunit(report, count);
  }
}

/**
 * The tests of the native code on another machine.
 * @param {'arm' | 'libcxx' | 'windows'} machine
 * @param {Count} count
 */
function otherMachine(machine, count) {
  const report = join(reports, `ctest-${machine}.xml`);
  rmSync(report, { force: true });
  try {
    testOnMachine(machine, report);
  } finally {
    countJunit(report, count);
  }
}

/**
 * Files that the tests of page and element look at, and of C++ its interface. The values that the core computes
 * are the matter of its own tests and of the kernel's.
 */
function pageFingerprint() {
  const made = ['web/src/kernel/wasm', 'web/app/public/examples'];
  const inputs = ['package.json', 'package-lock.json', 'web', 'tests/browser', 'tests/data'];
  const files = [...inputs, 'cpp/include', 'cpp/bind'].flatMap(filesBelow);
  return hashOf(files.filter((file) => made.every((folder) => !file.startsWith(`${folder}/`))));
}

/**
 * In the order in which they are begun. The table in tests/README.md says what is in which, and why.
 * @type {Record<string, Part>}
 */
export const parts = {
  'compile-native': { title: 'compile native', background: true, run: () => buildNative() },
  'compile-wasm': { title: 'compile wasm', run: buildWasm },
  lint: { title: 'lint', run: () => lint({ changedOnly: true }) },
  bundle: {
    title: 'bundle page, package, docs',
    needs: ['compile-wasm'],
    run: buildDocs,
  },
  web: { title: 'web', needs: ['bundle'], run: (count) => vitest('web', count) },
  native: {
    title: 'native tests',
    needs: ['compile-native'],
    background: true,
    run: ctest,
  },
  replay: {
    title: 'fuzz replay',
    needs: ['compile-native'],
    background: true,
    run: (count) => {
      count.passed += replayFuzzers();
    },
  },
  node: {
    title: 'package in Node.js',
    needs: ['bundle', 'compile-native'],
    run: (count) => vitest('node', count),
  },
  python: {
    title: 'Python package',
    needs: ['bundle', 'compile-native'],
    run: pytest,
  },
  'browser-kernel': {
    title: 'kernel in the browser',
    needs: ['bundle', 'compile-native'],
    run: (count) => vitest('browser-kernel', count, browserWorkers),
  },
  browser: {
    title: 'page and element',
    needs: ['bundle', 'compile-native'],
    fingerprint: pageFingerprint,
    run: (count) => vitest('browser', count, browserWorkers),
  },
};

/**
 * Parts that `npm run test:all` runs after them.
 * @type {Record<string, Part>}
 */
export const longParts = {
  tidy: { title: 'clang-tidy of everything', run: () => lintNative({ changedOnly: false }) },
  'sanitize-memory': {
    title: 'native tests with ASan and UBSan',
    run: () => testWithSanitizers('address'),
  },
  'sanitize-python': {
    title: 'random arrays through the Python package with ASan and UBSan',
    run: (count) => {
      const report = join(reports, 'pytest-sanitized.xml');
      try {
        testPythonWithSanitizers(report);
      } finally {
        countJunit(report, count);
      }
    },
  },
  fuzz: {
    title: 'fuzz for ten minutes',
    run: () => {
      const inputs = runFuzzers({ seconds: 600 });
      console.log(`${inputs.toLocaleString('en')} inputs in all, no finding`);
    },
  },
  'sanitize-threads': {
    title: 'native tests with TSan',
    run: () => testWithSanitizers('thread'),
  },
  shared: { title: 'shared libraries', run: testSharedLibraries },
  arm: { title: 'native tests on ARM', run: (count) => otherMachine('arm', count) },
  libcxx: {
    title: 'native tests with libc++',
    run: (count) => otherMachine('libcxx', count),
  },
  windows: {
    title: 'native tests on Windows',
    run: (count) => otherMachine('windows', count),
  },
  'built-python': {
    title: 'Python package of its source archive',
    needs: ['compile-native'],
    run: builtPython,
  },
  clusters: {
    title: 'collections on Dask, Slurm and Snakemake',
    needs: ['python'],
    run: clusters,
  },
  'browser-long': {
    title: 'page and element, long tests',
    needs: ['bundle', 'compile-native'],
    run: (count) => vitest('browser-long', count, browserWorkers),
  },
  long: { title: 'long tests', run: () => run('node', ['web/scripts/test-long.mjs']) },
  'other-browsers': {
    title: 'Firefox and WebKit',
    needs: ['bundle', 'compile-native'],
    run: (count) => {
      setUpMore('browsers');
      vitest('other-browsers', count);
    },
  },
  mutation: { title: 'mutation tests', run: () => run('node', ['tests/mutation/run.mjs']) },
};

/**
 * Seconds of processor time of this process and of all that it has waited for, where the system tells (Linux).
 * Beside other work they say more of what a part costs than the clock does.
 * @returns {number | undefined}
 */
function processorSeconds() {
  if (!existsSync('/proc/self/stat')) return undefined;
  const fields = readFileSync('/proc/self/stat', 'utf8')
    .replace(/^.*\) /s, '')
    .split(' ');
  // Own and children's, in the user's code and in the system's, in hundredths: fields 14 to 17, see proc(5).
  return fields.slice(11, 15).reduce((sum, ticks) => sum + Number(ticks), 0) / 100;
}

async function main() {
  const [name = ''] = process.argv.slice(2);
  const part = { ...parts, ...longParts }[name];
  if (!part) throw new Complaint(`test: no part ${name}`);
  const count = { passed: 0, failed: 0, skipped: 0 };
  mkdirSync(reports, { recursive: true });
  try {
    await part.run(count);
  } finally {
    const report = { ...count, processorSeconds: processorSeconds() };
    writeFileSync(join(reports, `${name}.json`), JSON.stringify(report));
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await script(main);
