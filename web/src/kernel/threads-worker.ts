// The worker that hosts the module with threads. A field is one call that blocks this worker; the
// page stops it through the flag in shared memory.

import createModule, { type GirthThreadsModule, type Surface } from './wasm/girth-threads.mjs';
import { loadedModule } from './loading-failure.js';
import type { FinishedValues, ThreadsOperations } from './protocol.js';
import { SurfaceStore } from './surface-store.js';
import { workerFromAnywhere } from './worker-from-elsewhere.js';
import { checked, progressTo, serveRequests } from './worker-loop.js';

// Emscripten makes the threads of it.
globalThis.Worker = workerFromAnywhere(globalThis.Worker);

let module: GirthThreadsModule;
const surfaces = new SurfaceStore<Surface>();

serveRequests<ThreadsOperations>({
  async start({ threads }) {
    module = await loadedModule(() => createModule({ girthThreads: threads }), import.meta.url);
    const { buffer, byteOffset } = module.cancelFlag();
    return { cancelFlag: { buffer, byteOffset } };
  },

  adopt({ surface, arrays }) {
    const { positions, indices } = arrays;
    surfaces.add(surface, checked(module.exactSurface(positions, indices)).surface);
    return {};
  },

  field({ surface, field, threads }, report) {
    const onPartial = (partial: FinishedValues) => report({ partial });
    return checked(surfaces.get(surface).field(field, threads, onPartial));
  },

  refinedGirth({ surface, request, threads }, report) {
    const progress = progressTo(report);
    return checked(surfaces.get(surface).refinedGirth(request, threads, progress));
  },

  drop({ surface }) {
    surfaces.drop(surface);
    return {};
  },
});
