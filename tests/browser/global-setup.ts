// What the files of the browser tests share is made once, before the first of them.

export { buildKernelSite as setup } from './build-kernel-site.js';
