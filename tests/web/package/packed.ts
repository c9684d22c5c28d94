// The npm package as users get it: packed and unpacked once for all tests, until something in it changes.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const repository = fileURLToPath(new URL('../../..', import.meta.url));

export interface Packed {
  /** The package's files, as they lie in `node_modules/girth`. */
  folder: string;
  /** The file that `npm pack` has made. */
  tarball: string;
}

/** Packs what has been built. Several processes may ask at once. */
export function packed(): Packed {
  if (!existsSync(join(repository, 'dist/girth-viewer.js'))) {
    throw new Error('first: npm run build:package');
  }
  const all = join(repository, 'build/packed');
  const there = join(all, fingerprint());
  if (!existsSync(there)) {
    mkdirSync(all, { recursive: true });
    const making = mkdtempSync(join(all, 'making-'));
    execFileSync('npm', ['pack', '--ignore-scripts', '--pack-destination', making], {
      cwd: repository,
      stdio: 'ignore',
    });
    const [name] = readdirSync(making);
    renameSync(join(making, name!), join(making, 'girth.tgz'));
    execFileSync('tar', ['-xzf', 'girth.tgz'], { cwd: making });
    try {
      renameSync(making, there);
    } catch (error) {
      // Another process was faster.
      if (!existsSync(there)) throw error;
      rmSync(making, { recursive: true });
    }
  }
  return { folder: join(there, 'package'), tarball: join(there, 'girth.tgz') };
}

export interface Manifest {
  version: string;
  exports: Record<string, string | { types: string; default: string }>;
  dependencies: Record<string, string>;
  peerDependencies: Record<string, string>;
  repository?: { url: string };
  homepage?: string;
  bugs?: string;
}

/** Puts the package into a folder's `node_modules`, with what npm would install beside it. */
export function install(folder: string): Manifest {
  const modules = join(folder, 'node_modules');
  cpSync(packed().folder, join(modules, 'girth'), { recursive: true });
  const manifest = JSON.parse(
    readFileSync(join(modules, 'girth/package.json'), 'utf8'),
  ) as Manifest;
  for (const name of Object.keys({ ...manifest.dependencies, ...manifest.peerDependencies })) {
    symlinkSync(join(repository, 'node_modules', name), join(modules, name));
  }
  writeFileSync(join(folder, 'package.json'), JSON.stringify({ type: 'module', private: true }));
  return manifest;
}

/** A hash of everything that the package may contain: names, sizes and times. */
function fingerprint(): string {
  const hash = createHash('sha256');
  const add = (path: string) => {
    const { size, mtimeMs } = statSync(path);
    hash.update(`${path}\0${size}\0${mtimeMs}\0`);
  };
  for (const folder of ['dist', 'web/docs', 'web/examples']) {
    const options = { recursive: true, withFileTypes: true } as const;
    const entries = readdirSync(join(repository, folder), options);
    for (const { name, parentPath } of entries) add(join(parentPath, name));
  }
  for (const name of readdirSync(repository)) {
    if (/\.(md|cff|json)$|^LICENSE$/.test(name)) add(join(repository, name));
  }
  return hash.digest('hex').slice(0, 16);
}
