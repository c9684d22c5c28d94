// `npm test`: sets up, then lints, builds and runs all tests; `test.mjs native fuzz web browser` only those
// named. A part that fails does not keep the others from running. The last line is the sum.

import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative, buildPackage, buildPage, buildWasm } from './build.mjs';
import { runFuzzers } from './fuzz.mjs';
import { lint } from './lint.mjs';
import { Complaint, repository, run, runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';

const reports = join(repository, 'build/reports');

/** What a part counted: tests passed, failed and skipped. */
const sum = { passed: 0, failed: 0, skipped: 0 };

/** @param {'web' | 'browser'} project */
function vitest(project) {
  const report = join(reports, `${project}.json`);
  rmSync(report, { force: true });
  try {
    runTool('vitest', [
      ...['run', '--config', 'web/vitest.config.ts', '--project', project],
      ...['--reporter', 'default', '--reporter', 'json', '--outputFile', report],
    ]);
  } finally {
    if (existsSync(report)) {
      const counted = JSON.parse(readFileSync(report, 'utf8'));
      sum.passed += counted.numPassedTests;
      sum.failed += counted.numFailedTests;
      sum.skipped += counted.numPendingTests;
    }
  }
}

function ctest() {
  const report = join(reports, 'native.xml');
  rmSync(report, { force: true });
  try {
    run('ctest', [
      ...['--test-dir', 'build/native', '--output-on-failure', '--parallel', '2', '--progress'],
      ...['--output-junit', report],
    ]);
  } finally {
    if (existsSync(report)) {
      const [suite = ''] = /<testsuite[^>]*>/.exec(readFileSync(report, 'utf8')) ?? [];
      /** @param {string} name */
      const count = (name) => Number(new RegExp(`\\b${name}="(\\d+)"`).exec(suite)?.[1] ?? 0);
      const skipped = count('skipped') + count('disabled');
      sum.failed += count('failures');
      sum.skipped += skipped;
      sum.passed += count('tests') - count('failures') - skipped;
    }
  }
}

/** @type {Record<string, () => void | Promise<void>>} */
const parts = {
  lint,
  native: () => {
    buildNative();
    ctest();
  },
  fuzz: () => {
    const inputs = runFuzzers({ seconds: 60 });
    console.log(`girth: fuzz: ${inputs.toLocaleString('en')} inputs in all, no finding`);
  },
  web: () => {
    buildWasm();
    vitest('web');
  },
  browser: async () => {
    await buildPage();
    await buildPackage();
    buildNative();
    vitest('browser');
  },
};

async function main() {
  const wanted = process.argv.slice(2);
  const unknown = wanted.find((name) => !(name in parts));
  if (unknown)
    throw new Complaint(`test: no ${unknown}; there are ${Object.keys(parts).join(', ')}`);
  setUp();
  mkdirSync(reports, { recursive: true });
  /** @type {string[]} */
  const failed = [];
  for (const [name, part] of Object.entries(parts)) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    console.log(`\ngirth: ${name}`);
    try {
      await part();
    } catch (error) {
      if (!(error instanceof Complaint)) throw error;
      console.error(`girth: ${error.message}`);
      failed.push(name);
    }
  }
  console.log(failed.length > 0 ? `\nNot in order: ${failed.join(', ')}` : '\nAll in order');
  console.log(`${sum.passed} passed, ${sum.failed} failed, ${sum.skipped} skipped`);
  if (failed.length > 0) process.exitCode = 1;
}

await script(main);
