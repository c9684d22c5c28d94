// Files that the page's service worker keeps: all of the built page, with their hashes.

import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const worker = 'service-worker.js';
/** Documentation is read beside the page; it is larger than the page and comes with other files. */
const others = /^docs\//;

/**
 * Writes the list of files into the service worker of a built page, as its first line: another list is another worker,
 * which browsers take as a new version.
 * @param {string} folder of the built page
 */
export function writeFileList(folder) {
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((path) => path !== worker && !others.test(path))
    .filter((path) => statSync(join(folder, path)).isFile())
    .sort();
  const hashes = files.map((path) => [
    path,
    createHash('sha256')
      .update(readFileSync(join(folder, path)))
      .digest('base64'),
  ]);
  const program = readFileSync(join(folder, worker), 'utf8').replace(/^self\.girthFiles=.*\n/, '');
  const list = JSON.stringify(Object.fromEntries(hashes));
  writeFileSync(join(folder, worker), `self.girthFiles=${list};\n${program}`);
}
