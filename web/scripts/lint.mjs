// `npm run lint` checks the format, the rules and the types of everything; `npm run format` mends the
// format and what the linters can mend.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { spawn } from 'node:child_process';
import { availableParallelism } from 'node:os';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { configureNative } from './build.mjs';
import { Complaint, repository, run, runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { filesBelow, hashOf } from './stale.mjs';

const native = 'build/native';

/** @param {RegExp} pattern */
const sources = (pattern) =>
  ['cpp', 'tests'].flatMap(filesBelow).filter((file) => pattern.test(file));

/** @param {boolean} fix */
function format(fix) {
  run('clang-format', [...(fix ? ['-i'] : ['--dry-run', '-Werror']), ...sources(/\.(cpp|h)$/)]);
  runTool('prettier', [fix ? '--write' : '--check', '--log-level', 'warn', '.']);
}

/** @param {boolean} fix */
function lintWeb(fix) {
  // The compiler first: rules that ask for types look through the layers' declarations, which it writes.
  runTool('tsc', ['--build', 'web']);
  const args = ['--config', 'web/eslint.config.js', ...(fix ? ['--fix'] : []), 'web', 'tests'];
  // Mending looks at types the way checking does; left alone, it takes the built modules themselves
  // for their types.
  runTool('eslint', args, { env: { ...process.env, TSESTREE_SINGLE_RUN: 'true' } });
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
    const args = ['--quiet', '--warnings-as-errors=*', known, '-p', native, file];
    const child = spawn('clang-tidy', args, { cwd: repository });
    let said = '';
    child.stdout.on('data', (text) => (said += text));
    child.on('error', fail);
    child.on('close', (code) => done(code === 0 ? '' : said || `${file}: clang-tidy failed\n`));
  });
}

/** The C++ sources that have changed since they were last found clean, as many at once as there are cores. */
async function lintNative() {
  configureNative();
  const common = hashOf(['.clang-tidy', ...sources(/\.(h|def)$/)]);
  // What the bindings and other people's programs include is not there.
  const stale = sources(/^cpp\/(?!bind|bench\/peers).*\.cpp$/).flatMap((file) => {
    const stamp = join(repository, 'build/stamps/tidy', file);
    const fingerprint = common + hashOf([file]);
    const isFresh = existsSync(stamp) && readFileSync(stamp, 'utf8') === fingerprint;
    return isFresh ? [] : [{ file, stamp, fingerprint }];
  });
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

/** Format, rules and types of everything. */
export async function lint() {
  format(false);
  lintWeb(false);
  await lintNative();
}

async function main() {
  setUp();
  if (process.argv.includes('--fix')) {
    lintWeb(true);
    format(true);
  } else {
    await lint();
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await script(main);
