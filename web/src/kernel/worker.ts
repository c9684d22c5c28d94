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
    const { values, kinds } = checked(surfaces.get(surface).values(field, vertices));
    return { values, kinds, milliseconds: performance.now() - from };
  },

  about({ surface, field, withoutValue }) {
    return checked(surfaces.get(surface).about(field, withoutValue));
  },

  loop({ surface: number, point }) {
    const surface = surfaces.get(number);
    return checked(
      typeof point === 'number'
        ? surface.loopAtVertex(point)
        : surface.loopInFace(point.face, ...point.weights),
    );
  },

  drop({ surface }) {
    surfaces.drop(surface);
    return {};
  },
});
