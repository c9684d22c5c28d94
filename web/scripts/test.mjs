// `npm test`: sets up, then lints, builds and runs the tests; `test.mjs NAME...` only those parts, with what
// they need; `--all` everything (`npm run test:all`). A part that fails does not keep the others from
// running. A part is not run again on sources that it has passed on, but in continuous integration, by name and with
// `--whole`. Two lanes run at once: what has to wait for its own steps goes first, and compiling and testing the native
// code takes the processor time that is left. Prints what each part took, and writes it to build/reports/times.json;
// the output of each part is in build/reports/NAME.log.

import { spawn } from 'node:child_process';
import {
  createWriteStream,
  existsSync,
  mkdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { constants, setPriority } from 'node:os';
import { dirname, join } from 'node:path';
import { Complaint, repository, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { longParts, parts, reports } from './test-parts.mjs';

/** @typedef {import('./test-parts.mjs').Part} Part */
/** @typedef {import('./test-parts.mjs').Count} Count */

/** Lines of a failed part's output that are shown. */
const shownLines = 200;

/**
 * Runs one part as a program of its own.
 * @param {string} name
 * @param {Part} part
 * @param {boolean} shown whether its output is shown as it comes
 * @returns {Promise<boolean>} whether it succeeded
 */
function runPart(name, part, shown) {
  const log = join(reports, `${name}.log`);
  rmSync(join(reports, `${name}.json`), { force: true });
  return new Promise((done, fail) => {
    const child = spawn(process.execPath, ['web/scripts/test-parts.mjs', name], {
      cwd: repository,
      stdio: shown ? 'inherit' : ['ignore', 'pipe', 'pipe'],
    });
    if (part.background && child.pid) setPriority(child.pid, constants.priority.PRIORITY_LOW);
    if (!shown) {
      const stream = createWriteStream(log);
      child.stdout?.pipe(stream, { end: false });
      child.stderr?.pipe(stream, { end: false });
    }
    child.on('error', fail);
    child.on('close', (code) => {
      if (code !== 0 && !shown) {
        const lines = readFileSync(log, 'utf8').trimEnd().split('\n');
        console.error(`\n${lines.slice(-shownLines).join('\n')}\n`);
      }
      done(code === 0);
    });
  });
}

/**
 * Where it is noted on what a part has succeeded.
 * @param {string} name
 */
const stampOf = (name) => join(repository, 'build/stamps', `test-${name}`);

/** @param {number} milliseconds */
const seconds = (milliseconds) => `${(milliseconds / 1000).toFixed(0)} s`.padStart(7);

/**
 * The wanted parts with all that they need, in the order of the table.
 * @param {string[]} wanted
 * @param {Record<string, Part>} all
 */
function withNeeds(wanted, all) {
  const chosen = new Set(wanted);
  for (const name of chosen) for (const need of all[name]?.needs ?? []) chosen.add(need);
  return Object.keys(all).filter((name) => chosen.has(name));
}

/**
 * Runs parts in two lanes, each as soon as what it needs is there.
 * @param {string[]} names
 * @param {Record<string, Part>} all
 * @param {{ shown: boolean, whole: boolean }} how shown: the parts' output, as it comes; whole: also what has succeeded on
 *   the same
 * @returns {Promise<{ name: string, title: string, succeeded: boolean, milliseconds: number }[]>}
 */
async function runParts(names, all, { shown, whole }) {
  /** @type {{ name: string, title: string, succeeded: boolean, milliseconds: number }[]} */
  const ended = [];
  /** @type {Map<string, Promise<boolean>>} */
  const outcomes = new Map();
  let [front, back] = [Promise.resolve(true), Promise.resolve(true)];
  for (const name of names) {
    const part = /** @type {Part} */ (all[name]);
    const { title, needs = [], background } = part;
    const lane = background ? back : front;
    const outcome = (async () => {
      const needed = await Promise.all(needs.flatMap((need) => outcomes.get(need) ?? []));
      await lane;
      const begun = performance.now();
      let succeeded = false;
      if (needed.every(Boolean)) {
        const stamp = stampOf(name);
        const fingerprint = part.fingerprint?.();
        if (
          !whole &&
          fingerprint &&
          existsSync(stamp) &&
          readFileSync(stamp, 'utf8') === fingerprint
        ) {
          console.log(
            `girth: ${title.padEnd(26)}  passed before, and what it looks at has not changed (--whole runs it)`,
          );
          return true;
        }
        console.log(`girth: ${title}`);
        rmSync(stamp, { force: true });
        succeeded = await runPart(name, part, shown);
        if (succeeded && fingerprint) {
          mkdirSync(dirname(stamp), { recursive: true });
          writeFileSync(stamp, fingerprint);
        }
      }
      const milliseconds = performance.now() - begun;
      ended.push({ name, title, succeeded, milliseconds });
      const words = succeeded ? 'in order' : needed.every(Boolean) ? 'FAILED' : 'not run';
      console.log(`girth: ${title.padEnd(26)} ${seconds(milliseconds)}  ${words}`);
      return succeeded;
    })();
    outcomes.set(name, outcome);
    if (background) back = outcome;
    else front = outcome;
  }
  await Promise.all([front, back]);
  return ended;
}

async function main() {
  const words = process.argv.slice(2);
  const everything = words.includes('--all');
  const wanted = words.filter((word) => !['--all', '--whole'].includes(word));
  const shown = wanted.length > 0;
  const whole = shown || everything || words.includes('--whole') || !!process.env['CI'];
  const all = { ...parts, ...longParts };
  const unknown = wanted.find((name) => !(name in all));
  if (unknown) {
    throw new Complaint(`test: no ${unknown}; there are ${Object.keys(all).join(', ')}`);
  }
  const began = performance.now();
  setUp();
  const setUpTook = performance.now() - began;
  mkdirSync(reports, { recursive: true });
  const names = wanted.length > 0 ? wanted : Object.keys(everything ? all : parts);
  const ended = await runParts(withNeeds(names, all), all, { shown, whole });
  const took = performance.now() - began;

  /** @type {Count} */
  const sum = { passed: 0, failed: 0, skipped: 0 };
  /** @type {{ part: string, seconds: number, processorSeconds?: number | undefined }[]} */
  const times = [{ part: 'set-up', seconds: setUpTook / 1000 }];
  let processor = 0;
  for (const { name, title, milliseconds } of ended) {
    const report = join(reports, `${name}.json`);
    /** @type {Partial<Count> & { processorSeconds?: number }} */
    const said = existsSync(report) ? JSON.parse(readFileSync(report, 'utf8')) : {};
    const { passed = 0, failed = 0, skipped = 0, processorSeconds } = said;
    sum.passed += passed;
    sum.failed += failed;
    sum.skipped += skipped;
    processor += processorSeconds ?? 0;
    times.push({ part: title, seconds: milliseconds / 1000, processorSeconds });
  }
  const total = { seconds: (took - setUpTook) / 1000, processorSeconds: processor };
  times.push({ part: 'in all, set-up apart', ...total });
  writeFileSync(join(reports, 'times.json'), `${JSON.stringify(times, null, 2)}\n`);
  console.log(
    '\nWhat each part took, two at a time, and of processors (build/reports/times.json):',
  );
  for (const { part, seconds: took, processorSeconds } of times) {
    const ofProcessors = processorSeconds ? seconds(processorSeconds * 1000) : '';
    console.log(`  ${part.padEnd(34)} ${seconds(took * 1000)} ${ofProcessors}`);
  }
  const failed = ended.filter(({ succeeded }) => !succeeded).map(({ title }) => title);
  console.log(failed.length > 0 ? `\nNot in order: ${failed.join(', ')}` : '\nAll in order');
  console.log(`${sum.passed} passed, ${sum.failed} failed, ${sum.skipped} skipped`);
  if (failed.length > 0) process.exitCode = 1;
}

await script(main);
