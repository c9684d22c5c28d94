// Models of the figures that are no examples of the page: made by the package itself, from an example or from a profile.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { repository } from '../../scripts/run.mjs';

/** Vertices of a ring of surfaces of revolution. */
const segments = 30;

/**
 * A round cushion with a hill in its middle, as rings of vertices: lengths in metres.
 * @param {number} height of the hill
 */
function cushion(height) {
  const [radius, half, width] = [0.24, 0.05, 0.045];
  /** @type {[number, number][]} radius and height of each ring, from the top down */
  const rings = [];
  for (let r = 0.012; r < radius - half; r += 0.018) {
    rings.push([r, half + height * Math.exp(-((r / width) ** 2))]);
  }
  for (let turn = 0; turn <= 6; ++turn) {
    const angle = (Math.PI * turn) / 6;
    rings.push([radius - half + half * Math.sin(angle), half * Math.cos(angle)]);
  }
  for (let r = radius - half - 0.02; r > 0.02; r -= 0.034) rings.push([r, -half]);
  const positions = [0, half + height, 0];
  for (const [i, [r, y]] of rings.entries()) {
    for (let k = 0; k < segments; ++k) {
      // Every second ring is turned by half a step, so that triangles are even.
      const angle = (2 * Math.PI * (k + (i % 2) / 2)) / segments;
      positions.push(r * Math.cos(angle), y, r * Math.sin(angle));
    }
  }
  const last = positions.length / 3;
  positions.push(0, -half, 0);
  /** @type {number[]} */
  const indices = [];
  const at = (/** @type {number} */ ring, /** @type {number} */ k) =>
    1 + ring * segments + ((k + segments) % segments);
  for (let k = 0; k < segments; ++k) indices.push(0, at(0, k + 1), at(0, k));
  for (let ring = 0; ring + 1 < rings.length; ++ring) {
    for (let k = 0; k < segments; ++k) {
      const shift = ring % 2;
      indices.push(at(ring, k), at(ring, k + 1), at(ring + 1, k + shift));
      indices.push(at(ring, k + 1), at(ring + 1, k + 1 + shift), at(ring + 1, k + shift));
    }
  }
  for (let k = 0; k < segments; ++k) {
    indices.push(last, at(rings.length - 1, k), at(rings.length - 1, k + 1));
  }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

/** @type {Record<string, (kernel: any) => Promise<any>>} */
const makers = {
  /** Triangles large enough to be seen. */
  'dumbbell-coarse': async (kernel) => {
    const path = join(repository, 'web/app/public/examples/dumbbell.glb');
    const whole = await kernel.load({ name: 'dumbbell.glb', bytes: readFileSync(path) });
    return whole.remesh(500);
  },
  'hill-high': (kernel) => kernel.load(cushion(0.16)),
  'hill-low': (kernel) => kernel.load(cushion(0.03)),
};

/** Names of the models that are made here. */
export const madeModels = Object.keys(makers);

/** Each of them as GLB, with its girth. */
export async function makeModels() {
  const script = join(repository, 'dist/node/index.js');
  const { createKernel } = await import(script);
  const kernel = await createKernel();
  /** @type {Record<string, Uint8Array>} */
  const models = {};
  for (const [name, make] of Object.entries(makers)) {
    const mesh = await make(kernel);
    models[name] = await mesh.exportField(await mesh.field('igf'), 'glb');
  }
  kernel.dispose();
  return models;
}
