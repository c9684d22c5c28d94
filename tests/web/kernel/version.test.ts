import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { version } from '../../../web/src/kernel/index.js';
import { repository } from '../../../web/scripts/run.mjs';

test('the version is that of package.json: `npm version` writes both', () => {
  const text = readFileSync(join(repository, 'package.json'), 'utf8');
  expect(version).toBe((JSON.parse(text) as { version: string }).version);
});
