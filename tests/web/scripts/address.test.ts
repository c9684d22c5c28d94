// The project's address: CITATION.cff has it, and all that is released takes it from there.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { addressIn, withAddress } from '../../../web/scripts/address.mjs';
import { repository } from '../../../web/scripts/run.mjs';

const text = (path: string) => readFileSync(join(repository, path), 'utf8');

test('a citation with an address gives it to the manifest', () => {
  const citation = "title: Girth\nrepository-code: 'https://example.org/girth'\n";
  const filled = withAddress({ name: 'girth', bugs: 'old', license: 'MIT' }, citation);
  expect(filled).toEqual({
    name: 'girth',
    repository: { type: 'git', url: 'git+https://example.org/girth.git' },
    homepage: 'https://example.org/girth#readme',
    bugs: 'https://example.org/girth/issues',
    license: 'MIT',
  });
  expect(withAddress(filled, 'title: Girth\n')).toEqual({ name: 'girth', license: 'MIT' });
});

test('the manifest has the address of the citation', () => {
  const manifest = JSON.parse(text('package.json')) as Record<string, unknown>;
  expect(manifest).toEqual(withAddress(manifest, text('CITATION.cff')));
});

test.each(['README.md', 'SECURITY.md', 'CITATION.cff'])(
  '%s says that the project has no public address, as long as it has none',
  (path) => {
    const words = text(path).replace(/\s+#?\s*/g, ' ');
    const without = addressIn(text('CITATION.cff')) === undefined;
    expect(words.includes('no public address yet')).toBe(without);
  },
);
