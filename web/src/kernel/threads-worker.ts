// The worker that hosts the module with threads. A field is one call that blocks this worker; the
// page stops it through the flag in shared memory.

import createModule, { type GirthThreadsModule, type Surface } from './wasm/girth-threads.mjs';
import type { ThreadsOperations } from './protocol.js';
import { checked, serveRequests } from './worker-loop.js';

let module: GirthThreadsModule;
const surfaces = new Map<number, Surface>();

serveRequests<ThreadsOperations>({
  async start({ threads }) {
    module = await createModule({ girthThreads: threads });
    const { buffer, byteOffset } = module.cancelFlag();
    return { cancelFlag: { buffer, byteOffset } };
  },

  adopt({ surface, arrays }) {
    const { positions, indices } = arrays;
    surfaces.set(surface, checked(module.exactSurface(positions, indices)).surface);
    return {};
  },

  field({ surface: number, field, threads }, report) {
    const surface = surfaces.get(number);
    if (!surface) throw new Error(`surface ${number} is not known to this worker`);
    return checked(surface.field(field, threads, (partial) => report({ partial })));
  },

  drop({ surface }) {
    surfaces.get(surface)?.delete();
    surfaces.delete(surface);
    return {};
  },
});
