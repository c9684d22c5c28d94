// Installs what is missing: Debian packages and npm packages. Runs before anything is installed, and so
// uses nothing but Node.js.

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { findEmscripten } from './emscripten.mjs';
import { Complaint, outputOf, repository, run, script } from './run.mjs';

/**
 * On other systems than Debian: what each thing is recognised by, a program or a header.
 * @type {[string, string[]][]}
 */
const elsewhere = [
  ['a C++20 compiler', ['c++', 'g++', 'clang++']],
  ['CMake', ['cmake']],
  ['Ninja', ['ninja']],
  ['pkg-config', ['pkg-config', 'pkgconf']],
  ['Chromium (or set CHROMIUM to its path)', [process.env.CHROMIUM ?? 'chromium', 'chromium']],
  ['clang', ['clang++']],
  ['clang-format', ['clang-format']],
  ['clang-tidy', ['clang-tidy']],
  ['Doxygen', ['doxygen']],
  ['Eigen 3', ['eigen3/Eigen/Core']],
  ['Spectra', ['Spectra/SymEigsSolver.h']],
  ['Draco', ['draco/compression/decode.h']],
  ['meshoptimizer', ['meshoptimizer.h']],
  ['nlohmann-json', ['nlohmann/json.hpp']],
  ['zlib', ['zlib.h']],
  ['GoogleTest', ['gtest/gtest.h']],
  ['google-benchmark', ['benchmark/benchmark.h']],
  ['Python 3 with NumPy and pytest (or set PYTHON to its path)', [process.env.PYTHON ?? 'python3']],
  ['pybind11', ['pybind11/pybind11.h']],
];

function isDebian() {
  if (!existsSync('/etc/os-release') || !existsSync('/usr/bin/dpkg-query')) return false;
  return /^ID(_LIKE)?=.*\b(debian|ubuntu)\b/m.test(readFileSync('/etc/os-release', 'utf8'));
}

/** @param {string} name a program, or a header where it ends in .h or .hpp or has a folder */
function isPresent(name) {
  if (name.startsWith('/')) return existsSync(name);
  const isHeader = name.includes('/') || name.endsWith('.h');
  const folders = isHeader
    ? ['/usr/include', '/usr/local/include', '/opt/homebrew/include']
    : (process.env.PATH ?? '').split(':');
  return folders.some((folder) => existsSync(join(folder, name)));
}

function checkElsewhere() {
  const missing = elsewhere.filter(([, names]) => !names.some(isPresent)).map(([what]) => what);
  if (!findEmscripten()) missing.push('Emscripten 3.1.6 or newer');
  if (missing.length > 0) {
    throw new Complaint(
      `this is not Debian, so nothing is installed here. Missing: ${missing.join(', ')}.`,
    );
  }
}

/** @param {string} list the file that names them */
function installDebianPackages(list) {
  const wanted = readFileSync(new URL(list, import.meta.url), 'utf8')
    .split('\n')
    .filter((line) => line !== '' && !line.startsWith('#'));
  const states = outputOf('dpkg-query', ['-W', '-f', '${Package} ${db:Status-Status}\n']) ?? '';
  const installed = new Set(
    states.split('\n').flatMap((line) => (line.endsWith(' installed') ? line.split(' ')[0] : [])),
  );
  const missing = wanted.filter(
    (name) => !installed.has(name) && !(name === 'emscripten' && findEmscripten()),
  );
  if (missing.length === 0) return;

  const isRoot = process.getuid?.() === 0;
  if (!isRoot && outputOf('sudo', ['--version']) === undefined) {
    throw new Complaint(`missing; as root: apt-get install ${missing.join(' ')}`);
  }
  console.log(`girth: installing ${missing.join(' ')}`);
  /** @param {string[]} args */
  const aptGet = (args) => {
    const command = ['env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', '-q', '-y', ...args];
    const [program, ...rest] = isRoot ? command : ['sudo', ...command];
    run(/** @type {string} */ (program), rest);
  };
  aptGet(['update']);
  aptGet(['install', '--no-install-recommends', ...missing]);
}

/**
 * Whether the folder of npm packages holds exactly what the lock file says; what is only for other
 * platforms may be absent.
 */
function npmPackagesAreFresh() {
  const present = join(repository, 'node_modules/.package-lock.json');
  if (!existsSync(present)) return false;
  /** @type {(path: string) => Record<string, { version?: string, optional?: boolean }>} */
  const packagesOf = (path) => JSON.parse(readFileSync(path, 'utf8')).packages;
  const have = packagesOf(present);
  const want = packagesOf(join(repository, 'package-lock.json'));
  return Object.entries(want).every(
    ([name, { version, optional }]) =>
      name === '' || have[name]?.version === version || (optional && !have[name]),
  );
}

/** Installs what is missing, or says what is. */
export function setUp() {
  if (isDebian()) installDebianPackages('debian-packages.txt');
  else checkElsewhere();
  if (!npmPackagesAreFresh()) run('npm', ['ci', '--no-audit', '--no-fund']);
}

/**
 * Installs what long tests need besides, where it is Debian's.
 * @param {'browsers' | 'clusters' | 'arm' | 'libcxx' | 'windows'} list
 */
export function setUpMore(list) {
  if (isDebian()) installDebianPackages(`debian-packages-${list}.txt`);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await script(setUp);
