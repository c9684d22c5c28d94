// ccache, where it is installed: what has been compiled once, in any checkout, is not compiled again.

import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { repository } from './run.mjs';

/**
 * The path of ccache, if it is installed.
 * @returns {string | undefined}
 */
export function compilerCache() {
  return (process.env.PATH ?? '')
    .split(delimiter)
    .map((folder) => join(folder, 'ccache'))
    .find(existsSync);
}

/**
 * The environment in which ccache recognises the same source in another checkout, and sources that use a
 * precompiled header.
 * @returns {NodeJS.ProcessEnv}
 */
export function compilerCacheEnvironment() {
  return {
    CCACHE_BASEDIR: repository,
    CCACHE_NOHASHDIR: '1',
    CCACHE_SLOPPINESS: 'pch_defines,time_macros,include_file_mtime,include_file_ctime',
    ...process.env,
  };
}
