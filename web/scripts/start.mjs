// `npm start [-- --port N] [--host H] [--no-isolation]`: sets up, builds what is stale, serves the page, and
// meanwhile builds the documentation, which it serves below.

import { spawn } from 'node:child_process';
import { parseArgs } from 'node:util';
import { buildPage } from './build.mjs';
import { Complaint, repository, script } from './run.mjs';
import { setUp } from './setup.mjs';

const usage = `npm start -- [options]
  --port N         the port, 4173 unless said; a taken one is an error where it was asked for
  --host H         the address to listen on, localhost unless said
  --no-isolation   without the two headers that allow threads, like a plain static host`;

function options() {
  try {
    return parseArgs({
      options: {
        port: { type: 'string' },
        host: { type: 'string', default: 'localhost' },
        'no-isolation': { type: 'boolean', default: false },
        help: { type: 'boolean', default: false },
      },
    }).values;
  } catch (error) {
    throw new Complaint(`${/** @type {Error} */ (error).message}\n${usage}`);
  }
}

async function main() {
  const { port, host, help, 'no-isolation': plain } = options();
  if (help) {
    console.log(usage);
    return;
  }
  if (port !== undefined && !/^\d{1,5}$/.test(port)) throw new Complaint(`not a port: ${port}`);
  const begin = performance.now();
  setUp();
  await buildPage();
  const { preview } = await import('vite');
  const server = await preview({
    configFile: `${repository}/web/vite.app.config.ts`,
    ...(plain ? { mode: 'no-isolation' } : {}),
    preview: {
      host,
      ...(port === undefined ? {} : { port: Number(port), strictPort: true }),
    },
  });
  for (const url of [
    ...(server.resolvedUrls?.local ?? []),
    ...(server.resolvedUrls?.network ?? []),
  ]) {
    console.log(`Girth is at ${url}`);
  }
  console.log(`It took ${Math.round((performance.now() - begin) / 1000)} s to get there.`);
  // A program of its own, so that this one can answer.
  const docs = spawn(process.execPath, ['web/scripts/build.mjs', 'docs'], {
    cwd: repository,
    stdio: 'inherit',
  });
  docs.on('close', (code) => {
    const [url = ''] = server.resolvedUrls?.local ?? [];
    if (code === 0) console.log(`Its documentation is at ${url}docs/`);
    else console.error('girth: the documentation could not be built; the page works without it');
  });
}

await script(main);
