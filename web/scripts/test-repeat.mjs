// `npm run test:repeat [-- FILE...] [-- --times N] [-- --loaded N] [-- --delay MS]`: runs the browser tests again
// and again, to find those that do not hold: N times (20 by default) as they are, then N times (as often by
// default) on one core with two busy loops beside them. With a delay, messages of workers and scripts of the
// server come up to that many milliseconds late, each time another number of them: races show that a quick
// machine hides. The tests run on the present build. Prints every failure with its test, and how often each failed; how far a run is
// stands in build/reports/repeat.log.

import { spawn, spawnSync } from 'node:child_process';
import { closeSync, existsSync, mkdirSync, openSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { Complaint, outputOf, repository, script } from './run.mjs';
import { browserWorkers, reports, vitestArguments } from './test-parts.mjs';

/** The progress of the run that goes on. */
const progress = join(reports, 'repeat.log');
/** @type {Map<string, number>} */
const failures = new Map();
let [runs, tests] = [0, 0];

/**
 * One run of the browser tests.
 * @param {string[]} files
 * @param {{ label: string, before?: string[], workers: number }} how before: the program that starts it
 */
function runOnce(files, { label, before = [], workers }) {
  const report = join(reports, 'repeat.json');
  rmSync(report, { force: true });
  const begun = performance.now();
  const [program = '', ...args] = [
    ...before,
    join(repository, 'node_modules/.bin/vitest'),
    ...vitestArguments('browser*', { report, workers }),
    ...['--reporter', 'default'],
    ...files,
  ];
  const log = openSync(progress, 'w');
  spawnSync(program, args, { cwd: repository, stdio: ['ignore', log, log] });
  closeSync(log);
  const seconds = ((performance.now() - begun) / 1000).toFixed(0);
  ++runs;
  if (!existsSync(report)) {
    console.log(`${label}: nothing was run\n${readFileSync(progress, 'utf8')}`);
    failures.set('(no report)', (failures.get('(no report)') ?? 0) + 1);
    return;
  }
  const { testResults, numPassedTests, numFailedTests } = JSON.parse(readFileSync(report, 'utf8'));
  tests += numPassedTests + numFailedTests;
  console.log(`${label}: ${numPassedTests} passed, ${numFailedTests} failed, ${seconds} s`);
  for (const { name, status, message, assertionResults } of testResults) {
    const failed = assertionResults.filter(
      (/** @type {{ status: string }} */ result) => result.status === 'failed',
    );
    if (status === 'failed' && failed.length === 0) {
      failed.push({ fullName: '(the file)', failureMessages: [message] });
    }
    for (const { fullName, failureMessages } of failed) {
      const test = `${name.slice(repository.length)}: ${fullName}`;
      failures.set(test, (failures.get(test) ?? 0) + 1);
      console.log(
        `  ${test}\n    ${failureMessages.join('\n').split('\n').slice(0, 12).join('\n    ')}`,
      );
    }
  }
}

await script(() => {
  const { values, positionals: files } = parseArgs({
    allowPositionals: true,
    options: {
      times: { type: 'string', default: '20' },
      loaded: { type: 'string' },
      delay: { type: 'string', default: '0' },
    },
  });
  process.env['GIRTH_TEST_DELAY'] = values.delay;
  const [times, loaded] = [values.times, values.loaded ?? values.times].map(Number);
  const numbers = [times, loaded, Number(values.delay)];
  if (!numbers.every((count) => Number.isInteger(count) && Number(count) >= 0)) {
    throw new Complaint('test:repeat: --times, --loaded and --delay take whole numbers');
  }
  mkdirSync(reports, { recursive: true });
  for (let i = 1; i <= Number(times); ++i) {
    runOnce(files, { label: `run ${i} of ${times}`, workers: browserWorkers });
  }
  if (Number(loaded) > 0) {
    if (outputOf('taskset', ['--version']) === undefined) {
      throw new Complaint('test:repeat: taskset, which gives a program one core, is missing');
    }
    const oneCore = ['taskset', '-c', '0'];
    const busy = [1, 2].map(() =>
      spawn('taskset', ['-c', '0', process.execPath, '-e', 'for (;;);']),
    );
    try {
      for (let i = 1; i <= Number(loaded); ++i) {
        runOnce(files, { label: `loaded ${i} of ${loaded}`, before: oneCore, workers: 1 });
      }
    } finally {
      for (const loop of busy) loop.kill();
    }
  }
  for (const [test, count] of failures) console.log(`${count} of ${runs} runs: ${test}`);
  console.log(
    `${runs} runs, ${tests} tests, ${[...failures.values()].reduce((a, b) => a + b, 0)} failures`,
  );
  if (failures.size > 0) process.exitCode = 1;
});
