// The libraries built as shared ones, installed, moved, asked what they show, and used by the scripts of
// tests/cpp/package.

import { renameSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { configure } from './build.mjs';
import { compilerCacheEnvironment } from './compiler-cache.mjs';
import { repository, run } from './run.mjs';
import { checkShownFunctions } from './shown-symbols.mjs';

const tree = 'build/shared';

/** Installs them into a folder and tries them in another one: nothing may know where it was built. */
export function testSharedLibraries() {
  configure({ tree, options: ['-DBUILD_SHARED_LIBS=ON'] });
  run('cmake', ['--build', tree], { env: compilerCacheEnvironment() });
  const [installed = '', moved = ''] = ['installed', 'moved'].map((name) =>
    join(repository, tree, name),
  );
  for (const folder of [installed, moved]) rmSync(folder, { recursive: true, force: true });
  run('cmake', ['--install', tree, '--prefix', installed], { quiet: true });
  renameSync(installed, moved);
  checkShownFunctions(
    ['core', 'io', 'study'].map((name) => join(moved, `lib/libgirth_${name}.so`)),
  );
  const scripts = join(repository, 'tests/cpp/package');
  const work = join(repository, tree, 'run');
  run(join(scripts, 'command.sh'), [moved, join(repository, 'tests/data'), work]);
  for (const name of ['readme', 'strict', 'plugin']) {
    run(join(scripts, `${name}.sh`), [moved, repository, work, 'c++']);
  }
  run(join(scripts, 'components.sh'), [moved, work, 'c++']);
}
