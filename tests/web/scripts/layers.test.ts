// The arrows between the parts run one way (ARCHITECTURE.md, Rules): who includes or imports what, read
// from the sources. Linking and the linter check the same; here it is also found where nothing is linked.

import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { expect, test } from 'vitest';
import { repository } from '../../../web/scripts/run.mjs';

/** All files below a folder with one of the endings, as paths in the repository. */
function filesBelow(folder: string, endings: RegExp): string[] {
  if (!existsSync(join(repository, folder))) return [];
  return readdirSync(join(repository, folder), { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return entry.name === 'wasm' ? [] : filesBelow(path, endings);
    return endings.test(entry.name) ? [path] : [];
  });
}

const text = (path: string) => readFileSync(join(repository, path), 'utf8');

/** Lines of C++ that include something that matches, as "file: header". */
function includes(folder: string, header: RegExp): string[] {
  return filesBelow(folder, /\.(cpp|h|inl)$/).flatMap((path) =>
    [...text(path).matchAll(/^\s*#\s*include\s*[<"]([^>"]+)[>"]/gm)]
      .map(([, name]) => name!)
      .filter((name) => header.test(name))
      .map((name) => `${path}: ${name}`),
  );
}

const files = /^(fstream|filesystem|unistd\.h|fcntl\.h|sys\/stat\.h)$/;

test.each([
  ['cpp/src', 'the core uses none of the others', /^girth\/(io|study)\/|^emscripten|tiny_?gltf/],
  ['cpp/io', 'reading uses the core only', /^girth\/study\/|^emscripten|^Eigen|^Spectra/],
  ['cpp/study', 'studies use core and reading only', /^emscripten|tiny_?gltf/],
  ['cpp/cli', 'the command does not know WebAssembly', /^emscripten|tiny_?gltf/],
  ['cpp/bind', 'the bindings do not know tinygltf', /tiny_?gltf/],
  [
    'cpp/python',
    'the bindings for Python use public headers only',
    /^emscripten|tiny_?gltf|^Eigen|^Spectra|^(?!girth\/|pybind11\/).*\//,
  ],
])('%s: %s', (folder, _, header) => {
  expect(includes(folder, header)).toEqual([]);
});

test.each(['cpp/src', 'cpp/study', 'cpp/bind', 'cpp/python'])('%s touches no files', (folder) => {
  expect(includes(folder, files)).toEqual([]);
});

test('readers and writers touch no files but those of files/; tinygltf does not compile without naming one', () => {
  const openers = includes('cpp/io', files).filter((line) => !line.startsWith('cpp/io/files/'));
  expect(openers).toEqual(['cpp/io/gltf/document/tinygltf_model.cpp: fstream']);
  const users = includes('cpp/io', /^(tiny_gltf\.h|gltf\/document\/tinygltf)/);
  expect(users.filter((line) => !/^cpp\/io\/(gltf|write)\//.test(line))).toEqual([]);
});

test('public headers include public headers and the standard library only', () => {
  expect(includes('cpp/include', /^(?!girth\/)(.*\/|.*\.h)/)).toEqual([]);
  const core = includes('cpp/include/girth', /^girth\/(io|study)\//);
  expect(core.filter((line) => !/^cpp\/include\/girth\/(io|study)\//.test(line))).toEqual([]);
  expect(includes('cpp/include/girth/io', /^girth\/study\//)).toEqual([]);
});

/** The modules of our own that a module imports, types included, at once or when they are needed. */
function importsOf(path: string): string[] {
  const imports = /(?:(?:^|\n)\s*(?:import|export)\s[^;'"]*?from\s*|\bimport\(\s*)'(\.[^']+)'/g;
  return [...text(path).matchAll(imports)]
    .map(([, name]) => normalize(join(dirname(path), name!)).replace(/\.js$/, '.ts'))
    .filter((name) => existsSync(join(repository, name)));
}

test('modules do not import each other in circles', () => {
  const modules = [...filesBelow('web/src', /\.ts$/), ...filesBelow('web/app', /\.ts$/)];
  const circles: string[] = [];
  const done = new Set<string>();
  const visit = (path: string, trail: string[]) => {
    const at = trail.indexOf(path);
    if (at >= 0) circles.push([...trail.slice(at), path].join(' → '));
    if (at >= 0 || done.has(path)) return;
    for (const next of importsOf(path)) visit(next, [...trail, path]);
    done.add(path);
  };
  for (const path of modules) visit(path, []);
  expect(circles).toEqual([]);
});
