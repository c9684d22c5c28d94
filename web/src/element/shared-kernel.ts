// One kernel for all elements of a page.

import { createKernel } from '../kernel/index.js';
import type { Kernel } from '../kernel/types.js';

let kernel: Promise<Kernel> | undefined;

/** The page's kernel, started when it is first asked for and kept as long as the page. */
export function sharedKernel(): Promise<Kernel> {
  kernel ??= createKernel({ threads: 'auto' }).catch((error: unknown) => {
    kernel = undefined;
    throw error;
  });
  return kernel;
}

/** Lets all elements use a kernel that the page has created itself. Call it before any element loads. */
export function useKernel(own: Kernel | Promise<Kernel>): void {
  kernel = Promise.resolve(own);
}
