// The kernel's test page, bundled once, before the first test.

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';

const repository = fileURLToPath(new URL('../..', import.meta.url));

/** Where the page's files lie. */
export const kernelSite = join(repository, 'build/kernel-test');

/** Bundles the page's script with the kernel, its workers and its modules. */
export async function setup(): Promise<void> {
  if (!existsSync(join(repository, 'web/src/kernel/wasm/girth.mjs'))) {
    throw new Error('first: npm run build:wasm');
  }
  await build({
    configFile: false,
    root: repository,
    base: './',
    logLevel: 'warn',
    publicDir: false,
    build: {
      outDir: kernelSite,
      emptyOutDir: true,
      target: 'es2022',
      assetsInlineLimit: 0,
      modulePreload: false,
      rolldownOptions: {
        input: { page: join(repository, 'tests/browser/kernel-page.ts') },
        output: { entryFileNames: '[name].js' },
      },
    },
    worker: { format: 'es' },
  });
}
