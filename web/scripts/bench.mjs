// `npm run bench [-- NAME... --FLAG...]`: builds and runs the native benchmarks. All words from the first flag on go to
// the programs as they are.

import { basename } from 'node:path';
import { buildNative } from './build.mjs';
import { run, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { filesBelow } from './stale.mjs';

await script(() => {
  const words = process.argv.slice(2);
  const firstFlag = words.findIndex((word) => word.startsWith('--'));
  const names = firstFlag < 0 ? words : words.slice(0, firstFlag);
  const flags = words.slice(names.length);
  const all = filesBelow('cpp/bench')
    .filter((file) => /^cpp.bench.\w+\.cpp$/.test(file))
    .map((file) => basename(file, '.cpp'));
  setUp();
  const wanted = names.length > 0 ? names : all;
  buildNative(wanted);
  for (const name of wanted) run(`build/native/cpp/bench/${name}`, flags);
});
