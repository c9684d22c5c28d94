// `npm run bench:page`: builds the page and measures it in Chromium, beside its goals.

import { buildPage } from './build.mjs';
import { runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';

await script(async () => {
  setUp();
  await buildPage();
  runTool('vitest', [
    ...['run', '--config', 'web/vitest.config.ts', '--project', 'bench'],
    ...['--reporter', 'dot', '--disable-console-intercept'],
  ]);
});
