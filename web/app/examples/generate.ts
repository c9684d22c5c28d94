// Generates the file of an example from its description.

import type { Core } from './core.ts';
import { writeGlb } from './glb.ts';
import { measure, type Measures } from './measure.ts';
import type { Model } from './models/model.ts';
import { polygonise, type Triangles } from './polygonise.ts';
import { project } from './project.ts';

export interface Example {
  mesh: Triangles;
  measures: Measures;
  glb: Uint8Array;
}

/** Points may move this share of a cell onto the surface; farther ones are between two parts. */
const reach = 0.3;
/** The triangles of the grid are uneven: made even first with so many times the faces, then with those. */
const first = 5;

/** Throws where the result is not a closed manifold in one piece, of the genus that the model states. */
export function generate(model: Model, core: Core): Example {
  const { solid, cell, faces } = model;
  const rough = polygonise(solid, model.box, cell);
  const points = Float64Array.from(rough.positions);
  project(points, solid, reach * cell);
  const fine = core.remeshEvenly({ ...rough, positions: points }, first * faces);
  const { positions, indices } = core.remeshEvenly(fine, faces);
  project(positions, solid, reach * cell);
  const mesh = { positions: Float32Array.from(positions), indices };
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
