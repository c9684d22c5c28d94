// The kernel alone on a page without a word, for tests and measurements: `globalThis.girth` is
// `KernelPage`.

import { join } from 'node:path';
import { build } from 'vite';
import { repository, requireBuilt } from './support.js';

/** Where the page's files lie. */
export const kernelSite = join(repository, 'build/kernel-test');

export const kernelHtml =
  '<!doctype html><title>kernel</title><script type="module" src="/page.js"></script>';

/** Bundles the page's script with the kernel, its workers and its modules. */
export async function buildKernelSite(): Promise<void> {
  requireBuilt('web/src/kernel/wasm/girth.mjs', 'build:wasm');
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
