// What the page's service worker keeps: every file of the built page, with its hash.

import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const worker = 'service-worker.js';
/** Documentation is read beside the page; it is larger than the page and comes with other files. */
const others = /^docs\//;

/**
 * Files below a folder, relative to it, in order.
 * @param {string} folder
 * @param {string} [below]
 * @returns {string[]}
 */
function filesBelow(folder, below = '') {
  return readdirSync(join(folder, below), { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) => {
      const path = below + entry.name;
      return entry.isDirectory() ? filesBelow(folder, `${path}/`) : [path];
    });
}

/**
 * Writes the list of files into the service worker of a built page, as its first line: another list is another worker,
 * which browsers take as a new version.
 * @param {string} folder of the built page
 */
export function writeFileList(folder) {
  const files = filesBelow(folder).filter((path) => path !== worker && !others.test(path));
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
