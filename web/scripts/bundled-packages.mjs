// Which npm packages a bundle has something of, for the list of materials that the package carries.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { repository } from './run.mjs';

/** Where the lists lie until the package is put together, one for each build and each worker. */
export const bundledLists = join(repository, 'build/bundled');

/**
 * A plugin that writes the list of a build.
 * @param {string} build its name
 * @returns {import('vite').Plugin}
 */
export function listBundledPackages(build) {
  return {
    name: 'list-bundled-packages',
    generateBundle(_options, bundle) {
      const modules = Object.values(bundle).flatMap((file) =>
        file.type === 'chunk' ? file.moduleIds : [],
      );
      const names = modules.flatMap((id) => {
        const found = /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(id);
        return found?.[1] ? [found[1]] : [];
      });
      mkdirSync(bundledLists, { recursive: true });
      const first = Object.keys(bundle)[0]?.replaceAll('/', '-') ?? '';
      const list = join(bundledLists, `${build}-${first}.json`);
      writeFileSync(list, JSON.stringify([...new Set(names)].sort()));
    },
  };
}
