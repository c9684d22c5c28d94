// A worker that computes spectra and what is made of them (it keeps the latest spectrum), and compares
// shapes.

import createModule, {
  type GirthStudiesModule,
  type SpectralSurface,
} from './wasm/girth-studies.mjs';
import type { StudiesOperations } from './protocol.js';
import { checked, progressTo, serveRequests } from './worker-loop.js';

let module: GirthStudiesModule;
const surfaces = new Map<number, SpectralSurface>();

/** The surface; spectra of others are let go of. */
function surfaceOf(number: number): SpectralSurface {
  const surface = surfaces.get(number);
  if (!surface) throw new Error(`surface ${number} is not known to this worker`);
  for (const other of surfaces.values()) if (other !== surface) other.forget();
  return surface;
}

serveRequests<StudiesOperations>({
  async start() {
    module = await createModule();
    return {};
  },

  adopt({ surface, arrays }) {
    surfaces.set(surface, checked(module.spectralSurface(arrays)).surface);
    return {};
  },

  spectralField({ surface, field }, report) {
    return checked(surfaceOf(surface).field(field, progressTo(report)));
  },

  heatMaxima({ surface, field }, report) {
    return checked(surfaceOf(surface).heatMaxima(field, progressTo(report)));
  },

  fieldGroups({ descriptors }) {
    return checked(module.fieldGroups(descriptors));
  },

  studyFields({ arrays, group, faces }, report) {
    return checked(module.studyFields(arrays, group, faces, progressTo(report)));
  },

  compare({ models, descriptors }, report) {
    return checked(module.compare(models, descriptors, progressTo(report)));
  },

  drop({ surface }) {
    surfaces.get(surface)?.delete();
    surfaces.delete(surface);
    return {};
  },
});
