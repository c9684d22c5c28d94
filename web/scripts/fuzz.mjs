// `npm run fuzz [-- NAME...] [-- --seconds N]`: builds the fuzzers of tests/fuzz and runs them in turn, N
// seconds in all (600 by default). Says how many inputs were tried; a finding ends it.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { buildSanitized } from './sanitizers.mjs';
import { Complaint, repository, run, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { filesBelow } from './stale.mjs';

const tree = 'build/fuzz';
const replays = 'build/native/tests/fuzz';
const regressions = 'tests/data/regressions';

/** The names of all fuzzers. */
const all = () =>
  filesBelow('tests/fuzz').flatMap((file) => /^fuzz_(\w+)\.cpp$/.exec(basename(file))?.[1] ?? []);

/**
 * Runs one fuzzer; how many inputs it has tried.
 * @param {string} folder where the programs lie
 * @param {string} name
 * @param {number} seconds
 */
function fuzz(folder, name, seconds) {
  const [corpus, seeds, findings] = ['corpus', 'seeds', 'findings'].map((kind) => {
    const folder = join(repository, tree, kind, name);
    mkdirSync(folder, { recursive: true });
    return folder;
  });
  const before = readdirSync(String(findings)).length;
  const known = existsSync(join(repository, regressions)) ? [join(repository, regressions)] : [];
  const result = spawnSync(
    join(folder, `fuzz_${name}`),
    [
      ...['-max_len=16384', '-timeout=20', '-rss_limit_mb=2048', '-malloc_limit_mb=512'],
      ...['-print_final_stats=1', '-verbosity=1', `-max_total_time=${seconds}`],
      ...[`-dict=tests/fuzz/${name}.dict`, `-artifact_prefix=${String(findings)}/`],
      ...[String(corpus), String(seeds), ...known],
    ],
    { cwd: repository, encoding: 'utf8', maxBuffer: 1 << 28 },
  );
  if (result.error) throw new Complaint(`fuzz ${name}: ${result.error.message}`);
  const tried = Number(/stat::number_of_executed_units:\s*(\d+)/.exec(result.stderr)?.[1] ?? 0);
  if (result.status !== 0) {
    process.stderr.write(result.stderr.split('\n').slice(-60).join('\n'));
    const found = readdirSync(String(findings)).length > before;
    throw new Complaint(`fuzz ${name}: ${found ? `a finding in ${String(findings)}` : 'failed'}`);
  }
  console.log(`girth: fuzz ${name}: ${tried.toLocaleString('en')} inputs in ${seconds} s`);
  return tried;
}

/**
 * Builds and runs fuzzers in turn; gives the number of inputs tried.
 * @param {{ names?: string[], seconds: number }} what
 */
export function runFuzzers({ names = [], seconds }) {
  const known = all();
  const unknown = names.find((name) => !known.includes(name));
  if (unknown) throw new Complaint(`fuzz: no ${unknown}; there are ${known.join(', ')}`);
  const programs = buildSanitized(
    'address',
    known.map((name) => `fuzz_${name}`),
  );
  run('node', ['tests/fuzz/seeds.mjs', join(tree, 'seeds')]);
  const wanted = names.length > 0 ? names : known;
  const share = Math.max(1, Math.floor(seconds / wanted.length));
  return wanted.reduce((sum, name) => sum + fuzz(join(programs, 'tests/fuzz'), name, share), 0);
}

/**
 * Gives every fuzzer its seeds, the inputs that were findings once, and what earlier runs have kept, without
 * sanitizers and without making new ones; the number of inputs.
 */
export function replayFuzzers() {
  run('node', ['tests/fuzz/seeds.mjs', join(tree, 'seeds')]);
  let sum = 0;
  for (const name of all()) {
    const inputs = [join(tree, 'seeds', name), join(tree, 'corpus', name), regressions].flatMap(
      filesBelow,
    );
    run(join(replays, `replay_${name}`), inputs);
    sum += inputs.length;
  }
  return sum;
}

function main() {
  const args = process.argv.slice(2).filter((argument) => argument !== '--');
  const at = args.indexOf('--seconds');
  const seconds = at < 0 ? 600 : Number(args[at + 1]);
  if (!(seconds >= 1)) throw new Complaint('fuzz: --seconds takes a number');
  const names = at < 0 ? args : [...args.slice(0, at), ...args.slice(at + 2)];
  setUp();
  const tried = runFuzzers({ names, seconds });
  console.log(`girth: ${tried.toLocaleString('en')} inputs, no finding`);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await script(main);
