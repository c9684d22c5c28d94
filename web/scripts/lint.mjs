// `npm run lint` checks the format, the rules and the types of everything, with clang-tidy only what has
// changed where `--changed` stands behind it; `npm run format` mends the format and what the linters can mend.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { spawn } from 'node:child_process';
import { availableParallelism } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { checkOpenings } from './openings.mjs';
import { buildReference } from './reference.mjs';
import { Complaint, outputOf, repository, run, runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { filesBelow, hashOf } from './stale.mjs';

/** A build tree in which nothing is built: clang-tidy reads its compile commands. */
const tidyTree = 'build/tidy';

/** @param {RegExp} pattern */
const sources = (pattern) =>
  ['cpp', 'tests'].flatMap(filesBelow).filter((file) => pattern.test(file));

/** @param {boolean} fix */
function format(fix) {
  run('clang-format', [...(fix ? ['-i'] : ['--dry-run', '-Werror']), ...sources(/\.(cpp|h)$/)]);
  runTool('oxfmt', [...(fix ? [] : ['--check']), '.']);
}

/** @param {boolean} fix */
function lintWeb(fix) {
  // The compiler first: rules that ask for types look through the layers' declarations, which it writes.
  runTool('tsc', ['--build', 'web']);
  runTool('oxlint', ['--type-aware', ...(fix ? ['--fix'] : []), 'web', 'tests']);
}

/**
 * One file through clang-tidy; its complaints, or nothing.
 * @param {string} file
 * @returns {Promise<string>}
 */
function tidy(file) {
  return new Promise((done, fail) => {
    // The compile commands are GCC's, with warnings that clang may not know.
    const known = '--extra-arg=-Wno-unknown-warning-option';
    const args = ['--quiet', '--warnings-as-errors=*', known, '-p', tidyTree, file];
    const child = spawn('clang-tidy', args, { cwd: repository });
    let said = '';
    child.stdout.on('data', (text) => (said += text));
    child.on('error', fail);
    child.on('close', (code) => done(code === 0 ? '' : said || `${file}: clang-tidy failed\n`));
  });
}

/** The compile commands for clang-tidy: of each source alone, without what it cannot read, GCC's precompiled headers. */
function writeTidyCommands() {
  run(
    'cmake',
    [
      ...['-S', '.', '-B', tidyTree, '-G', 'Ninja'],
      ...['-DGIRTH_PRECOMPILE_HEADERS=OFF', '-DGIRTH_UNITY_BUILD=OFF'],
    ],
    { quiet: true },
  );
}

/**
 * The files that differ from where this branch left the main one; on the main one, from the commit before.
 * Nothing where Git does not know.
 * @returns {Set<string> | undefined}
 */
function changedFiles() {
  const head = outputOf('git', ['rev-parse', 'HEAD'])?.trim();
  const left = outputOf('git', ['merge-base', 'HEAD', 'origin/main'])?.trim();
  const base = left && left !== head ? left : 'HEAD~1';
  const changed = outputOf('git', ['diff', '--name-only', base]);
  if (changed === undefined) return undefined;
  const untracked = outputOf('git', ['ls-files', '--others', '--exclude-standard']) ?? '';
  return new Set(`${changed}\n${untracked}`.split('\n').filter(Boolean));
}

/**
 * The C++ sources that have not been found clean as they are, as many at once as there are cores.
 * @param {{ changedOnly: boolean }} which changedOnly: of them those that have changed (changedFiles), or
 *   whose header has
 */
export async function lintNative({ changedOnly }) {
  const changed = changedOnly ? changedFiles() : undefined;
  const stems =
    changed && new Set([...changed].map((file) => basename(file).replace(/\.\w+$/, '')));
  const common = hashOf(['.clang-tidy', ...sources(/\.(h|def)$/)]);
  // Bindings, other people's programs and sources for Windows include headers that may be absent here.
  const stale = sources(/^cpp\/(?!bind|python|bench\/peers|examples).*(?<!_windows)\.cpp$/).flatMap(
    (file) => {
      if (stems && !stems.has(basename(file, '.cpp'))) return [];
      const stamp = join(repository, 'build/stamps/tidy', file);
      const fingerprint = common + hashOf([file]);
      const isFresh = existsSync(stamp) && readFileSync(stamp, 'utf8') === fingerprint;
      return isFresh ? [] : [{ file, stamp, fingerprint }];
    },
  );
  if (stale.length > 0) writeTidyCommands();
  let failed = 0;
  const worker = async () => {
    for (let next = stale.pop(); next; next = stale.pop()) {
      const complaints = await tidy(next.file);
      process.stderr.write(complaints);
      if (complaints) {
        failed += 1;
        continue;
      }
      mkdirSync(dirname(next.stamp), { recursive: true });
      writeFileSync(next.stamp, next.fingerprint);
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, worker));
  if (failed > 0) throw new Complaint(`clang-tidy: ${failed} files are not clean`);
}

/**
 * Format, openings of comments, rules, types and public comments of everything, and whether each mutation still finds its line.
 * @param {{ changedOnly: boolean }} which of the C++ sources clang-tidy reads
 */
export async function lint(which) {
  format(false);
  checkOpenings();
  run('node', ['tests/mutation/run.mjs', '--check']);
  lintWeb(false);
  await buildReference();
  await lintNative(which);
}

async function main() {
  setUp();
  if (process.argv.includes('--fix')) {
    lintWeb(true);
    format(true);
  } else {
    await lint({ changedOnly: process.argv.includes('--changed') });
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await script(main);
