// The kernel's public API.

export { createKernel } from './kernel.js';
export { GirthError } from './errors.js';
export type * from './types.js';
