// `npm run bench:page [-- NAME]`: measures the page in Chromium and the modules against the command,
// beside their goals; `page` or `wasm` alone where named.

import { buildNative, buildPage } from './build.mjs';
import { runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';

await script(async () => {
  setUp();
  await buildPage();
  buildNative();
  runTool('vitest', [
    ...['run', '--config', 'web/vitest.config.ts', '--project', 'bench'],
    ...['--reporter', 'dot', '--disable-console-intercept'],
    ...process.argv.slice(2),
  ]);
});
