// Products that have to be made again: one is fresh while it exists and its inputs have the content they
// had when it was made.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { repository } from './run.mjs';

/**
 * All files below a path, in order; the path itself where it is a file.
 * @param {string} path relative to the top of the repository
 * @returns {string[]}
 */
export function filesBelow(path) {
  const full = join(repository, path);
  if (!existsSync(full)) return [];
  try {
    return readdirSync(full, { withFileTypes: true })
      .sort((a, b) => (a.name < b.name ? -1 : 1))
      .flatMap((entry) =>
        entry.isDirectory() ? filesBelow(join(path, entry.name)) : [join(path, entry.name)],
      );
  } catch (error) {
    if (/** @type {NodeJS.ErrnoException} */ (error).code === 'ENOTDIR') return [path];
    throw error;
  }
}

/**
 * A hash of the names and contents of files.
 * @param {string[]} files
 */
export function hashOf(files) {
  const hash = createHash('sha256');
  for (const file of files) {
    const content = readFileSync(join(repository, file));
    hash.update(`${file}\0${content.length}\0`).update(content);
  }
  return hash.digest('hex');
}

/**
 * Makes a product where it is stale.
 * @param {{ name: string, inputs: string[], outputs: string[], make: () => void | Promise<void> }} product
 *   inputs: files and folders; outputs: files that must exist
 */
export async function refresh({ name, inputs, outputs, make }) {
  const stamp = join(repository, 'build/stamps', name);
  const fingerprint = hashOf(inputs.flatMap(filesBelow));
  const fresh =
    existsSync(stamp) &&
    readFileSync(stamp, 'utf8') === fingerprint &&
    outputs.every((output) => existsSync(join(repository, output)));
  if (fresh) return;
  console.log(`girth: building ${name}`);
  rmSync(stamp, { force: true });
  await make();
  mkdirSync(dirname(stamp), { recursive: true });
  writeFileSync(stamp, fingerprint);
}
