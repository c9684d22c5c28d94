// `npm version ...` runs this: writes the version of package.json where the package exports it, into the
// citation and the examples, and over what the change log has as unreleased; and the citation's address into package.json.

import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { withAddress } from './address.mjs';
import { repository, script } from './run.mjs';

const date = new Date().toISOString().slice(0, 10);

/**
 * @param {string} path
 * @param {(text: string) => string} change
 */
function rewrite(path, change) {
  const full = join(repository, path);
  writeFileSync(full, change(readFileSync(full, 'utf8')));
}

await script(() => {
  const { version } = JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8'));
  rewrite('web/src/kernel/types/version.ts', (text) => text.replace(/'\d[^']*'/g, `'${version}'`));
  rewrite('CITATION.cff', (text) =>
    text
      .replace(/^version: .*$/m, `version: ${version}`)
      .replace(/^date-released: .*$/m, `date-released: '${date}'`),
  );
  for (const example of readdirSync(join(repository, 'web/examples'))) {
    const path = `web/examples/${example}/package.json`;
    if (!existsSync(join(repository, path))) continue;
    rewrite(path, (text) => text.replace(/"girth": "\^[^"]*"/, `"girth": "^${version}"`));
  }
  const citation = readFileSync(join(repository, 'CITATION.cff'), 'utf8');
  rewrite(
    'package.json',
    (text) => `${JSON.stringify(withAddress(JSON.parse(text), citation), null, 2)}\n`,
  );
  rewrite('CHANGELOG.md', (text) =>
    text.replace(/^## \[Unreleased\]$/m, `$&\n\n## [${version}] - ${date}`),
  );
});
