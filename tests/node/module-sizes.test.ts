// How large the WebAssembly modules are by gzip. Whoever looks at the girth of a model fetches the first two, and the third
// where there are threads.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { expect, test } from 'vitest';

const folder = join(import.meta.dirname, '../../web/src/kernel/wasm');

test.each([
  ['girth-files', 315_000],
  ['girth', 120_000],
  ['girth-fields', 180_000],
  ['girth-threads', 250_000],
  ['girth-analysis', 840_000],
  ['girth-studies', 315_000],
])('%s.wasm is at most %i bytes', (name, most) => {
  const { length } = gzipSync(readFileSync(join(folder, `${name}.wasm`)), { level: 9 });
  console.info(`${name}.wasm: ${length} bytes by gzip`);
  expect(length).toBeLessThanOrEqual(most);
});
