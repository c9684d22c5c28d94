// The worker that hosts the module with threads. A field is one call that blocks this worker; the
// page stops it through the flag in shared memory.

import createModule, { type GirthThreadsModule, type Surface } from '../wasm/girth-threads.mjs';
import { loadedModule } from './loading-failure.js';
import type { FinishedValues, ThreadsOperations } from '../types/protocol.js';
import { SurfaceStore } from './surface-store.js';
import { workerFromAnywhere } from './worker-from-elsewhere.js';
import { checked, progressTo, serveRequests } from './worker-loop.js';

// Emscripten makes the threads of it.
globalThis.Worker = workerFromAnywhere(globalThis.Worker);

/** The first that the machine has room for, in pages of 64 KB: the refined girth of a large surface takes more than 1 GB. */
const mostPages = [32_768, 16_384];
/** Pages of memory that the module begins with. */
const firstPages = 256;

function sharedMemory([maximum = 0, ...less] = mostPages): WebAssembly.Memory {
  try {
    return new WebAssembly.Memory({ initial: firstPages, maximum, shared: true });
  } catch (thrown) {
    if (less.length === 0) throw thrown;
    return sharedMemory(less);
  }
}

let module: GirthThreadsModule;
const surfaces = new SurfaceStore<Surface>();

serveRequests<ThreadsOperations>(surfaces, {
  async start({ threads }) {
    const load = () => createModule({ girthThreads: threads, wasmMemory: sharedMemory() });
    module = await loadedModule(load, import.meta.url);
    const { buffer, byteOffset } = module.cancelFlag();
    return { cancelFlag: { buffer, byteOffset } };
  },

  adopt({ surface, arrays }) {
    const { positions, indices } = arrays;
    surfaces.add(surface, checked(module.exactSurface(positions, indices)).surface);
    return {};
  },

  field({ surface, field, known, threads }, report) {
    const onPartial = (partial: FinishedValues) => report({ partial });
    return checked(surfaces.get(surface).field(field, known, threads, onPartial));
  },

  refinedGirth({ surface, request, threads }, report) {
    const progress = progressTo(report);
    return checked(surfaces.get(surface).refinedGirth(request, threads, progress));
  },
});
