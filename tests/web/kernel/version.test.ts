import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { version } from '../../../web/src/kernel/index.js';
import { repository } from '../../../web/scripts/run.mjs';

const text = (path: string) => readFileSync(join(repository, path), 'utf8');

test('the version is that of package.json everywhere: `npm version` writes all', () => {
  const now = (JSON.parse(text('package.json')) as { version: string }).version;
  expect(version).toBe(now);
  expect(text('CITATION.cff')).toContain(`\nversion: ${now}\n`);
  expect(text('CHANGELOG.md')).toContain(`\n## [${now}] - `);
  for (const example of ['esbuild', 'vite', 'webpack']) {
    expect(text(`web/examples/${example}/package.json`)).toContain(`"girth": "^${now}"`);
  }
});
