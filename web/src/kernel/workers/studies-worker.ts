// A worker for jobs that computes spectra and what follows from them, and compares shapes. A surface keeps
// its latest spectrum.

import createModule, { type GirthStudiesModule, type Surface } from '../wasm/girth-studies.mjs';
import { loadedModule } from './loading-failure.js';
import { type StudiesOperations, studying } from '../types/operations/studies.js';
import { forwards } from './forwards.js';
import { SurfaceStore } from './surface-store.js';
import { checked, serveRequests } from './worker-loop.js';

let module: GirthStudiesModule;
const surfaces = new SurfaceStore<Surface>();

serveRequests<StudiesOperations>(surfaces, {
  async start() {
    module = await loadedModule(() => createModule(), import.meta.url);
    return {};
  },

  adopt({ surface, arrays }) {
    const { positions, indices } = arrays;
    surfaces.add(surface, checked(module.exactSurface(positions, indices)).surface);
    return {};
  },

  ...forwards(studying, () => module, surfaces),
});
