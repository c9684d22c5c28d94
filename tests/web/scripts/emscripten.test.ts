// Which Emscripten compiles, with several on the PATH: shims that say their version and nothing else.

import { chmodSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { wasmTree } from '../../../web/scripts/build.mjs';
import { emscriptenEnvironment, findEmscripten } from '../../../web/scripts/emscripten.mjs';

let folder: string;

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'girth-emscripten-'));
  vi.stubEnv('NODE_PATH', '/mine');
});
afterEach(() => {
  vi.unstubAllEnvs();
  rmSync(folder, { recursive: true });
});

/** A folder with an em++ of that version, as emsdk or Debian install it. */
function shim(name: string, version: string): string {
  const there = join(folder, name);
  mkdirSync(there);
  const words = `emcc (Emscripten gcc/clang-like replacement) ${version} (1234abcd)`;
  for (const program of ['em++', 'emcc', 'emcmake']) {
    writeFileSync(join(there, program), `#!/bin/sh\necho '${words}'\n`);
    chmodSync(join(there, program), 0o755);
  }
  return there;
}

/** `/usr/bin` last: it has the shell, and perhaps Debian's Emscripten. */
const search = (...folders: string[]) =>
  vi.stubEnv('PATH', [...folders, '/usr/bin', '/bin'].join(delimiter));

test('the newest is chosen, wherever it stands on the PATH; the build calls it', () => {
  const older = shim('older', '3.1.20');
  const newer = shim('newer', '9.0.10');
  const middle = shim('middle', '9.0.9');
  search(older, newer, middle);
  expect(findEmscripten()).toEqual({ folder: newer, version: [9, 0, 10] });
  const tree = wasmTree();
  expect(tree.compiler).toBe(join(newer, 'em++'));
  expect(tree.wrapper).toEqual([join(newer, 'emcmake')]);
  // An emsdk brings its own Node.js modules.
  expect(tree.env['NODE_PATH']).toBe('/mine');
});

test('one that is too old, or says no version, is passed over', () => {
  search(shim('old', '3.1.5'), shim('ancient', '1.39.20'), shim('mute', 'unknown'));
  expect(findEmscripten()?.folder).not.toContain(folder);
});

test('an older one does not take the place of Debian’s', ({ skip }) => {
  search();
  const debians = findEmscripten();
  if (!debians) return skip('Debian’s Emscripten is not installed');
  search(shim('older', '3.1.5'));
  expect(findEmscripten()).toEqual(debians);
});

test('Debian’s finds its Node.js modules', ({ skip }) => {
  search();
  const debians = findEmscripten();
  if (!debians) return skip('Debian’s Emscripten is not installed');
  expect(emscriptenEnvironment(debians)['NODE_PATH']).toBe('/mine:/usr/share/nodejs');
  // Also through a link from elsewhere.
  symlinkSync(join(debians.folder, 'em++'), join(folder, 'em++'));
  expect(emscriptenEnvironment({ folder })['NODE_PATH']).toContain('/usr/share/nodejs');
});
