// `npm version ...` runs this: writes the version of package.json where the package exports it.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { repository, script } from './run.mjs';

const path = join(repository, 'web/src/kernel/version.ts');

await script(() => {
  const { version } = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8'));
  const text = readFileSync(path, 'utf8');
  writeFileSync(path, text.replace(/'\d[^']*'/g, `'${version}'`));
});
