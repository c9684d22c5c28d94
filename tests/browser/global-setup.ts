// What the files of the browser tests share is made once, before the first of them.

import { buildKernelSite } from './build-kernel-site.js';
import { makeSmallExamples } from './small-examples.js';

export async function setup(): Promise<void> {
  makeSmallExamples();
  await buildKernelSite();
}
