// `npm run bench:page [-- NAME...]`: measures the page in Chromium and the modules against the command,
// beside their goals; of the files tests/bench/NAME.bench.ts only those named.

import { buildNative, buildPackage, buildPage } from './build.mjs';
import { runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';

await script(async () => {
  setUp();
  await buildPage();
  await buildPackage();
  buildNative();
  runTool('vitest', [
    ...['run', ...process.argv.slice(2).map((name) => `${name}.bench`)],
    ...['--config', 'web/vitest.config.ts', '--project', 'bench'],
    ...['--reporter', 'dot', '--disable-console-intercept'],
  ]);
});
