// From the description of an example to its file.

import { writeGlb } from './glb.ts';
import { measure, type Measures } from './measure.ts';
import type { Model } from './models/model.ts';
import { polygonise, type Triangles } from './polygonise.ts';
import { remesh } from './remesh.ts';

export interface Example {
  mesh: Triangles;
  measures: Measures;
  glb: Uint8Array;
}

/** Throws where the result is not a closed manifold in one piece, of the genus that the model states. */
export function generate(model: Model): Example {
  const rough = polygonise(model.solid, model.box, model.cell);
  const { positions, indices } = remesh(rough, model.solid, model.faces, model.sizing);
  const mesh = { positions: Float32Array.from(positions), indices: Uint32Array.from(indices) };
  const measures = measure(mesh);
  const { closedManifold, components, genus, volume } = measures;
  if (!closedManifold || components !== 1 || genus !== model.genus || !(volume > 0)) {
    throw new Error(
      `${model.name}: expected one closed manifold of genus ${model.genus}, found ` +
        JSON.stringify({ closedManifold, components, genus, volume }),
    );
  }
  return { mesh, measures, glb: writeGlb(model.name, mesh) };
}
