// The kernel alone on a page without a word, for tests and measurements: `globalThis.girth` is
// `KernelPage`.

import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { build } from 'vite';
import { afterAll, beforeAll, expect } from 'vitest';
import {
  type OpenPage,
  type StaticServer,
  type chromiumForTests,
  repository,
  requireBuilt,
  serve,
  strictPolicy,
} from './support.js';

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

/**
 * Opens the kernel's page for the tests of one mode, under a strict content security policy, and hands
 * it and its server over. They fail if anything went wrong on it that nobody caught, files that are missing apart.
 */
export function onKernelPage(
  openPage: ReturnType<typeof chromiumForTests>,
  mode: 'threads' | 'pool',
  receive: (page: Page, server: StaticServer) => void,
): void {
  let server: StaticServer;
  let opened: OpenPage;
  beforeAll(async () => {
    server = await serve(kernelSite, {
      isolated: mode === 'threads',
      policy: strictPolicy,
      pages: { '/': kernelHtml },
    });
    opened = await openPage(server.url);
    await opened.page.waitForFunction('globalThis.girth');
    receive(opened.page, server);
  });
  afterAll(async () => {
    expect(opened.complaints.filter((line) => !line.includes('404'))).toEqual([]);
    await opened.context.close();
    await server.close();
  });
}
