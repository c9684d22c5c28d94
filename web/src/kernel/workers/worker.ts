// A worker with the module without threads: one of a pool, or the one that answers requests for loops. All beyond the
// girth and its loops is in a larger module, loaded when it is first asked for.

import createModule, { type GirthModule, type Surface } from '../wasm/girth.mjs';
import createFields, { type FieldsModule, type FieldsSurface } from '../wasm/girth-fields.mjs';
import { isPlainGirth } from '../types/field-request.js';
import { loadedModule } from './loading-failure.js';
import type { FieldRequest, SingleOperations } from '../types/protocol.js';
import { SurfaceStore } from './surface-store.js';
import { checked, serveRequests } from './worker-loop.js';

let module: GirthModule;
let fields: FieldsModule | undefined;
const surfaces = new SurfaceStore<Surface>();

const hasFields = (surface: Surface): surface is FieldsSurface => 'barcode' in surface;

/** A surface in the larger module. It takes the place of the one that this worker has held. */
async function withFields(number: number): Promise<FieldsSurface> {
  const held = surfaces.get(number);
  if (hasFields(held)) return held;
  fields ??= await loadedModule(() => createFields(), import.meta.url);
  const { positions, indices } = checked(held.arrays());
  const { surface } = checked(fields.exactSurface(positions, indices));
  surfaces.add(number, surface);
  return surface;
}

/** A surface with this field. */
const surfaceFor = (number: number, field: FieldRequest) =>
  isPlainGirth(field) ? surfaces.get(number) : withFields(number);

serveRequests<SingleOperations>(surfaces, {
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

  async values({ surface, field, vertices }) {
    const on = await surfaceFor(surface, field);
    const from = performance.now();
    const found = checked(on.values(field, vertices));
    return { ...found, milliseconds: performance.now() - from };
  },

  async about({ surface, field, withoutValue }) {
    const on = await surfaceFor(surface, field);
    return checked(on.about(field, withoutValue));
  },

  async loop({ surface, point, persistence }) {
    if (persistence === 0) return checked(surfaces.get(surface).loop(point));
    const on = await withFields(surface);
    return checked(on.persistentLoop(point, persistence));
  },

  async barcode({ surface, point, maxPersistence, maxSaddles, loops }) {
    const on = await withFields(surface);
    return checked(on.barcode(point, maxPersistence, maxSaddles, loops));
  },
});
