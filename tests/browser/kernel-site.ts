// The kernel alone on a page without a word, for tests and measurements: `globalThis.girth` is
// `KernelPage`.

import type { Page } from 'playwright-core';
import { afterAll, beforeAll, expect } from 'vitest';
import { kernelSite } from './build-kernel-site.js';
import {
  type OpenPage,
  type StaticServer,
  type chromiumForTests,
  serve,
  strictPolicy,
} from './support.js';

export const kernelHtml =
  '<!doctype html><title>kernel</title><script type="module" src="/page.js"></script>';

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
