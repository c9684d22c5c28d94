// `npm run build:reference` makes the reference of the C++ library (Doxygen, from its headers) and of the
// npm package (TypeDoc, from its types) in build/reference. Whatever is public and has no comment, or
// whose comment names what does not exist, is an error.

import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { repository, run, runTool, script } from './run.mjs';
import { setUp } from './setup.mjs';
import { refresh } from './stale.mjs';

const settings = 'web/docs/reference';
const output = 'build/reference';

/** build/reference/cpp, from the headers. */
async function buildNativeReference() {
  await refresh({
    name: 'reference-cpp',
    inputs: [settings, 'cpp/include/girth'],
    outputs: [`${output}/cpp/index.html`],
    make: () => {
      const folder = join(repository, output, 'cpp');
      rmSync(folder, { recursive: true, force: true });
      mkdirSync(folder, { recursive: true });
      const configuration = join(folder, 'Doxyfile');
      const lines = [
        `@INCLUDE = ${settings}/Doxyfile`,
        `OUTPUT_DIRECTORY = ${output}/cpp`,
        'HTML_OUTPUT = .',
      ];
      writeFileSync(configuration, `${lines.join('\n')}\n`);
      run('doxygen', [configuration]);
    },
  });
}

/** build/reference/js, from the package's public entry points. */
async function buildPackageReference() {
  await refresh({
    name: 'reference-js',
    inputs: ['package-lock.json', 'web/tsconfig.base.json', settings, 'web/src'],
    outputs: [`${output}/js/index.html`],
    make: () =>
      runTool('typedoc', [
        ...['--options', `${settings}/typedoc.json`, '--logLevel', 'Warn'],
        ...['--out', `${output}/js`],
      ]),
  });
}

/** Both, where they are stale. */
export async function buildReference() {
  await buildNativeReference();
  await buildPackageReference();
}

async function main() {
  setUp();
  await buildReference();
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await script(main);
