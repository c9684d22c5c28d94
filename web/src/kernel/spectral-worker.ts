// A worker that computes spectra and what is made of them; it keeps the latest spectrum.

import createModule, {
  type GirthSpectralModule,
  type SpectralSurface,
} from './wasm/girth-spectral.mjs';
import type { SpectralOperations } from './protocol.js';
import { checked, progressTo, serveRequests } from './worker-loop.js';

let module: GirthSpectralModule;
const surfaces = new Map<number, SpectralSurface>();

/** The surface; spectra of others are let go of. */
function surfaceOf(number: number): SpectralSurface {
  const surface = surfaces.get(number);
  if (!surface) throw new Error(`surface ${number} is not known to this worker`);
  for (const other of surfaces.values()) if (other !== surface) other.forget();
  return surface;
}

serveRequests<SpectralOperations>({
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

  drop({ surface }) {
    surfaces.get(surface)?.delete();
    surfaces.delete(surface);
    return {};
  },
});
