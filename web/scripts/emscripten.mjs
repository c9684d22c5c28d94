// Which Emscripten compiles: the newest em++ on the PATH, be it Debian's or an emsdk's.

import { existsSync, realpathSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { compilerCache, compilerCacheEnvironment } from './compiler-cache.mjs';
import { outputOf } from './run.mjs';

/** Debian 12's; older ones are not tried. */
const oldest = [3, 1, 6];

/** Where Debian keeps its Node.js modules, of which its em++ needs one. */
const debianModules = '/usr/share/nodejs';

/**
 * @param {readonly number[]} a
 * @param {readonly number[]} b
 */
function isNewer(a, b) {
  const first = a.findIndex((part, i) => part !== b[i]);
  return first >= 0 && Number(a[first]) > Number(b[first]);
}

/**
 * The newest Emscripten on the PATH, if there is one that is new enough.
 * @returns {{ folder: string, version: number[] } | undefined} folder: where em++ and emcmake lie
 */
export function findEmscripten() {
  let best;
  for (const folder of new Set((process.env.PATH ?? '').split(delimiter))) {
    if (!folder || !existsSync(join(folder, 'em++'))) continue;
    const said = outputOf(join(folder, 'em++'), ['--version']) ?? '';
    const version = /(\d+)\.(\d+)\.(\d+)/.exec(said)?.slice(1).map(Number);
    if (!version || isNewer(oldest, version)) continue;
    if (!best || isNewer(version, best.version)) best = { folder, version };
  }
  return best;
}

/**
 * The environment in which that Emscripten runs.
 * @param {{ folder: string }} emscripten
 * @returns {NodeJS.ProcessEnv}
 */
export function emscriptenEnvironment({ folder }) {
  const environment = compilerCacheEnvironment();
  const cache = compilerCache();
  if (cache) environment.EM_COMPILER_WRAPPER ??= cache;
  const isDebians = realpathSync(join(folder, 'em++')).startsWith('/usr/');
  if (isDebians) {
    environment.NODE_PATH = [process.env.NODE_PATH, debianModules].filter(Boolean).join(delimiter);
  }
  return environment;
}
