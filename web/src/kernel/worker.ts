// A worker with the module without threads: one of a pool, or the one that answers for the pointer.

import createModule, { type GirthModule, type Surface } from './wasm/girth.mjs';
import type { SingleOperations } from './protocol.js';
import { checked, serveRequests } from './worker-loop.js';

let module: GirthModule;
const surfaces = new Map<number, Surface>();

function surfaceOf(number: number): Surface {
  const surface = surfaces.get(number);
  if (!surface) throw new Error(`surface ${number} is not known to this worker`);
  return surface;
}

serveRequests<SingleOperations>({
  async start() {
    module = await createModule();
    return {};
  },

  adopt({ surface, arrays }) {
    const { positions, indices } = arrays;
    surfaces.set(surface, checked(module.exactSurface(positions, indices)).surface);
    return {};
  },

  order({ surface }) {
    return { order: checked(surfaceOf(surface).order()) };
  },

  values({ surface, field, vertices }) {
    const from = performance.now();
    const { values, kinds } = checked(surfaceOf(surface).values(field, vertices));
    return { values, kinds, milliseconds: performance.now() - from };
  },

  about({ surface, field, withoutValue }) {
    return checked(surfaceOf(surface).about(field, withoutValue));
  },

  loop({ surface: number, point }) {
    const surface = surfaceOf(number);
    return checked(
      typeof point === 'number'
        ? surface.loopAtVertex(point)
        : surface.loopInFace(point.face, ...point.weights),
    );
  },

  drop({ surface }) {
    surfaces.get(surface)?.delete();
    surfaces.delete(surface);
    return {};
  },
});
