// The module that `import ... from 'girth'` loads in Node.js: names and types are those of a page (kernel/index.ts).

import { openKernel } from '../kernel/page/kernel.js';
import type { Kernel, KernelOptions } from '../kernel/types/types.js';
import { nodeWorkers } from './kernel-workers.js';
import { node } from './platform.js';

export { GirthError } from '../kernel/types/errors.js';
export { type LengthUnit, findLengthUnit, lengthUnits } from '../kernel/types/length-units.js';
export { unitName, unitSymbol } from '../kernel/types/units.js';
export { version } from '../kernel/types/version.js';
export type * from '../kernel/types/types.js';

/** Starts the workers, and waits until one of them can read models. Errors: as on a page (kernel/page/kernel.ts). */
export function createKernel(options: KernelOptions = {}): Promise<Kernel> {
  return openKernel(options, nodeWorkers, node);
}
