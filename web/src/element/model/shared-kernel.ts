// One kernel for all elements of a page.

import type { Kernel } from '../../kernel/types/types.js';

let kernel: Promise<Kernel> | undefined;

/** The page's kernel, started when it is first asked for and kept as long as the page. */
export function sharedKernel(): Promise<Kernel> {
  // Fetched only when something is computed.
  kernel ??= started().catch((error: unknown) => {
    kernel = undefined;
    throw error;
  });
  return kernel;
}

async function started(): Promise<Kernel> {
  const { createKernel } = await import('../../kernel/index.js');
  return createKernel({ threads: 'auto' });
}

/** Lets all elements use a kernel that the page has created itself. Call it before any element loads. */
export function useKernel(own: Kernel | Promise<Kernel>): void {
  kernel = Promise.resolve(own);
}
