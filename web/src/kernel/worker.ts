// A worker with the module without threads: one of a pool, or the one that answers requests for loops.

import createModule, { type GirthModule, type Surface } from './wasm/girth.mjs';
import { loadedModule } from './loading-failure.js';
import type { SingleOperations } from './protocol.js';
import { SurfaceStore } from './surface-store.js';
import { checked, serveRequests } from './worker-loop.js';

let module: GirthModule;
const surfaces = new SurfaceStore<Surface>();

serveRequests<SingleOperations>({
  async start() {
    module = await loadedModule(() => createModule(), import.meta.url);
    return {};
  },

  adopt({ surface, arrays }) {
    const { positions, indices } = arrays;
    surfaces.add(surface, checked(module.exactSurface(positions, indices)).surface);
    return {};
  },

  order({ surface }) {
    return { order: checked(surfaces.get(surface).order()) };
  },

  values({ surface, field, vertices }) {
    const from = performance.now();
    const found = checked(surfaces.get(surface).values(field, vertices));
    return { ...found, milliseconds: performance.now() - from };
  },

  about({ surface, field, withoutValue }) {
    return checked(surfaces.get(surface).about(field, withoutValue));
  },

  loop({ surface, point, persistence }) {
    return checked(surfaces.get(surface).loop(point, persistence));
  },

  barcode({ surface, point, maxPersistence, maxSaddles, loops }) {
    const found = surfaces.get(surface).barcode(point, maxPersistence, maxSaddles, loops);
    return checked(found);
  },

  drop({ surface }) {
    surfaces.drop(surface);
    return {};
  },
});
