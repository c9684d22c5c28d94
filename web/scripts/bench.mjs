// `npm run bench [-- NAME...] [-- --benchmark_...]`: builds and runs the native benchmarks.

import { basename } from 'node:path';
import { buildNative } from './build.mjs';
import { run, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { filesBelow } from './stale.mjs';

await script(() => {
  const names = process.argv.slice(2).filter((argument) => !argument.startsWith('--'));
  const flags = process.argv.slice(2).filter((argument) => argument.startsWith('--'));
  const all = filesBelow('cpp/bench')
    .filter((file) => /^cpp.bench.\w+\.cpp$/.test(file))
    .map((file) => basename(file, '.cpp'));
  setUp();
  buildNative();
  for (const name of names.length > 0 ? names : all) run(`build/native/cpp/bench/${name}`, flags);
});
