// `npm run test:mutation [name…]`: breaks one rule of the engine at a time, and requires that some
// test of the core notices. The list is mutations.json: `find` must occur exactly once in `file`;
// `--check` looks at nothing but that.
//
// Works on a copy of the sources, in build/mutation; a build tree of its own, lightly optimised,
// where only what depends on the file is compiled again.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { dirname, join } from 'node:path';
import { Complaint, repository, run, script } from '../../web/scripts/run.mjs';
import { setUp } from '../../web/scripts/setup.mjs';
import { filesBelow } from '../../web/scripts/stale.mjs';

/**
 * @typedef {object} Mutation
 * @property {string} name
 * @property {string} file
 * @property {string} find
 * @property {string} replace
 * @property {string} why what the rule is for
 */

const sources = join(repository, 'build/mutation/sources');
const tree = join(repository, 'build/mutation/tree');

/** Quick tests that between them touch every rule; random meshes among them. */
const tests = [
  ...['ClosedForm.*', 'Invariance.*', 'Solver.*', 'Shapes/Against*', 'FirstSaddle.*'],
  ...['BadInput.TheSmallest*', 'BadInput.Points*', 'Field.*', '*Geodesic*', '*Boundaries*'],
  ...['RandomMeshes/*', 'Barcode.IsThat*', 'SaddleCount.*', 'LoopCheck.*', 'VerificationQueue.*'],
  ...['ClearCap.*', 'MovedLoop.*', 'RegularTube.*', 'OnceFailed/RegularShapes*'],
  ...['CutSurface.*', 'PathProfile.*', 'RemoveHandles.*'],
].join(':');

/** A test that runs longer than this, in seconds, does so because of the mutation. */
const patience = 600;

/** The sources as they are; files that have not changed keep their time, so that they stay built. */
function copySources() {
  const folders = ['cpp', 'tests/cpp', 'tests/data', 'tests/fuzz'];
  const files = ['CMakeLists.txt', 'package.json', ...folders.flatMap(filesBelow)];
  for (const file of files) {
    const content = readFileSync(join(repository, file));
    const copy = join(sources, file);
    if (existsSync(copy) && readFileSync(copy).equals(content)) continue;
    mkdirSync(dirname(copy), { recursive: true });
    writeFileSync(copy, content);
  }
  const wanted = new Set(files);
  for (const folder of ['cpp', 'tests']) {
    for (const file of filesBelow(join('build/mutation/sources', folder))) {
      const original = file.slice('build/mutation/sources/'.length);
      if (!wanted.has(original)) rmSync(join(repository, file));
    }
  }
}

/** @returns {boolean} whether it compiles */
function build() {
  const args = ['--build', tree, '--target', 'core_tests'];
  return spawnSync('cmake', args, { cwd: repository, stdio: 'pipe' }).status === 0;
}

/**
 * The first test that fails.
 * @returns {string | undefined}
 */
function firstFailure() {
  const args = [`--gtest_filter=${tests}`, '--gtest_fail_fast', '--gtest_brief=1'];
  const result = spawnSync(join(tree, 'tests/cpp/core_tests'), args, {
    cwd: repository,
    encoding: 'utf8',
    timeout: patience * 1000,
    maxBuffer: 1 << 28,
  });
  if (result.error) return `no end within ${patience} s`;
  if (result.status === 0) return undefined;
  return /\[ {2}FAILED {2}\] ([^ ,]+)/.exec(result.stdout)?.[1] ?? `ended by ${result.signal}`;
}

/**
 * The file with the mutation in it.
 * @param {Mutation} mutation
 */
function mutated({ name, file, find, replace }) {
  const text = readFileSync(join(repository, file), 'utf8');
  const times = text.split(find).length - 1;
  if (times !== 1) throw new Complaint(`${name}: found ${times} times in ${file}, not once`);
  return text.replace(find, () => replace);
}

async function main() {
  /** @type {Mutation[]} */
  const all = JSON.parse(readFileSync(join(repository, 'tests/mutation/mutations.json'), 'utf8'));
  const words = process.argv.slice(2);
  const names = words.filter((word) => word !== '--check');
  const unknown = names.find((name) => !all.some((mutation) => mutation.name === name));
  if (unknown) throw new Complaint(`no mutation ${unknown}`);
  const wanted = all.filter(({ name }) => names.length === 0 || names.includes(name));
  const texts = wanted.map(mutated); // all of them can be made, or none is tried
  if (words.includes('--check')) return;

  setUp();
  copySources();
  if (!existsSync(join(tree, 'build.ninja'))) {
    run('cmake', [
      ...['-S', sources, '-B', tree, '-G', 'Ninja'],
      ...['-DCMAKE_BUILD_TYPE=Release', '-DCMAKE_CXX_FLAGS_RELEASE=-O1'],
      ...['-DGIRTH_BUILD_COMMAND=OFF', '-DGIRTH_BUILD_BENCHMARKS=OFF'],
      ...['-DGIRTH_UNITY_BUILD=OFF', '-DGIRTH_INSTALL=OFF'],
    ]);
  }
  console.log(`girth: building, on ${availableParallelism()} cores`);
  if (!build()) throw new Complaint('the sources do not compile as they are');
  const before = firstFailure();
  if (before) throw new Complaint(`a test fails as it is: ${before}`);

  /** @type {string[]} */
  const survivors = [];
  wanted.forEach((mutation, i) => {
    const { name, file, why } = mutation;
    const copy = join(sources, file);
    const original = readFileSync(copy);
    let by;
    try {
      writeFileSync(copy, texts[i] ?? '');
      by = build() ? firstFailure() : 'the compiler';
    } finally {
      writeFileSync(copy, original);
    }
    if (!by) survivors.push(name);
    console.log(`${by ? 'killed  ' : 'SURVIVED'}  ${name.padEnd(36)}  ${by ?? why}`);
  });
  console.log(`${wanted.length - survivors.length} of ${wanted.length} mutations killed`);
  if (survivors.length > 0) throw new Complaint(`no test notices ${survivors.join(', ')}`);
}

await script(main);
