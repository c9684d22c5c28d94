// A worker for jobs that computes spectra and what follows from them, and compares shapes. A surface keeps
// its latest spectrum.

import createModule, { type GirthStudiesModule, type Surface } from '../wasm/girth-studies.mjs';
import { loadedModule } from './loading-failure.js';
import type { StudiesOperations } from '../types/protocol.js';
import { SurfaceStore } from './surface-store.js';
import { checked, progressTo, serveRequests } from './worker-loop.js';

let module: GirthStudiesModule;
const surfaces = new SurfaceStore<Surface>();

serveRequests<StudiesOperations>({
  async start() {
    module = await loadedModule(() => createModule(), import.meta.url);
    return {};
  },

  adopt({ surface, arrays }) {
    const { positions, indices } = arrays;
    surfaces.add(surface, checked(module.exactSurface(positions, indices)).surface);
    return {};
  },

  spectralField({ surface, field }, report) {
    return checked(module.spectralField(surfaces.get(surface), field, progressTo(report)));
  },

  heatMaxima({ surface, field }, report) {
    return checked(module.heatMaxima(surfaces.get(surface), field, progressTo(report)));
  },

  fieldGroups({ descriptors }) {
    return checked(module.fieldGroups(descriptors));
  },

  studyFields({ surface, group, faces, smooth }, report) {
    return checked(
      module.studyFields(surfaces.get(surface), group, faces, smooth, progressTo(report)),
    );
  },

  compare({ models, descriptors }, report) {
    return checked(module.compare(models, descriptors, progressTo(report)));
  },

  drop({ surface }) {
    surfaces.drop(surface);
    return {};
  },
});
