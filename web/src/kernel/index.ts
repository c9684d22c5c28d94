/**
 * The kernel: `import { createKernel } from 'girth'`. Everything is computed in workers.
 * @module girth
 */

export { createKernel } from './kernel.js';
export { GirthError } from './errors.js';
export { version } from './version.js';
export { type ZipFile, readZip } from './zip.js';
export type * from './types.js';
