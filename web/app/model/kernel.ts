// The page's one kernel, for the surface and for what it is compared with.

import { type Kernel, createKernel } from '../../src/kernel/index.js';
import { useKernel } from '../../src/element/index.js';

export const kernel: Promise<Kernel> = createKernel({ threads: 'auto' });
useKernel(kernel);
// Whoever uses it reports why it did not start.
kernel.catch(() => undefined);
