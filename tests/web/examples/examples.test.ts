// The built-in models as they were built, and one of them made again.

import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { loadCore } from '../../../web/app/examples/core.ts';
import { generate } from '../../../web/app/examples/generate.ts';
import { measure } from '../../../web/app/examples/measure.ts';
import { models } from '../../../web/app/examples/models/index.ts';

/** The members of a glTF document that are looked at. */
interface Accessor {
  count: number;
  componentType: number;
  max?: number[];
}
interface BufferView {
  byteOffset: number;
}
interface Document {
  accessors: [Accessor, Accessor];
  bufferViews: [BufferView, BufferView];
}

/** The file that `npm run build:examples` has made. */
const built = (name: string): Uint8Array =>
  new Uint8Array(
    readFileSync(new URL(`../../../web/app/public/examples/${name}.glb`, import.meta.url)),
  );

/** The content of a GLB of one mesh. */
function parsed(glb: Uint8Array) {
  const view = new DataView(glb.buffer, glb.byteOffset);
  expect(view.getUint32(0, true)).toBe(0x46546c67);
  expect(view.getUint32(8, true)).toBe(glb.length);
  const jsonLength = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + jsonLength))) as Document;
  const data = glb.slice(28 + jsonLength).buffer;
  const [points, corners] = json.accessors;
  const [pointBytes, cornerBytes] = json.bufferViews;
  expect(corners.componentType).toBe(5123);
  return {
    highest: points.max![1]!,
    positions: new Float32Array(data, pointBytes.byteOffset, 3 * points.count),
    indices: Uint32Array.from(new Uint16Array(data, cornerBytes.byteOffset, corners.count)),
  };
}

const faceCounts: Record<string, [number, number]> = {
  chair: [9500, 10300],
  octopus: [9800, 10200],
  handles: [7500, 8500],
  dumbbell: [3000, 3400],
  cup: [4700, 5300],
  vessel: [7500, 8500],
  spine: [3000, 3400],
  hook: [3000, 3400],
};

/** Height and greatest width in metres, to within a tenth. */
const sizes: Record<string, [number, number]> = {
  chair: [0.9, 0.54],
  octopus: [0.29, 0.68],
  handles: [0.3, 0.4],
  dumbbell: [0.2, 0.465],
  cup: [0.096, 0.12],
  vessel: [0.36, 0.27],
  spine: [0.233, 0.381],
  hook: [0.059, 0.063],
};

describe.each(models.map((model) => [model.name, model] as const))('%s', (name, model) => {
  const mesh = parsed(built(name));
  const measures = measure(mesh);

  it('is one closed manifold, oriented outwards, of the genus stated', () => {
    expect(measures.closedManifold).toBe(true);
    expect(measures.components).toBe(1);
    expect(measures.genus).toBe(model.genus);
    expect(measures.volume).toBeGreaterThan(0);
  });

  it('has every edge in two faces, in opposite directions', () => {
    const { indices } = mesh;
    const directed = new Set<string>();
    for (let i = 0; i < indices.length; ++i) {
      const next = i % 3 === 2 ? i - 2 : i + 1;
      directed.add(`${indices[i]} ${indices[next]}`);
    }
    expect(directed.size).toBe(indices.length);
    const alone = [...directed].filter(
      (edge) => !directed.has(edge.split(' ').reverse().join(' ')),
    );
    expect(alone).toEqual([]);
  });

  it('has the number of faces stated, and no sliver among them', () => {
    const [fewest, most] = faceCounts[name]!;
    expect(measures.faces).toBeGreaterThanOrEqual(fewest);
    expect(measures.faces).toBeLessThanOrEqual(most);
    expect(measures.smallestAngle).toBeGreaterThan(30);
    expect(measures.largestAngle).toBeLessThan(110);
    expect(measures.smallestValence).toBeGreaterThanOrEqual(4);
    expect(measures.largestValence).toBeLessThanOrEqual(9);
  });

  it('has vertices on the surface, no two in one place', () => {
    const places = new Set<string>();
    let farthest = 0;
    for (let i = 0; i < mesh.positions.length; i += 3) {
      const [x, y, z] = [0, 1, 2].map((k) => mesh.positions[i + k]!) as [number, number, number];
      places.add(`${x} ${y} ${z}`);
      farthest = Math.max(farthest, Math.abs(model.solid(x, y, z)));
    }
    expect(farthest).toBeLessThan(0.02 * measures.longestEdge);
    expect(places.size).toBe(measures.vertices);
  });

  it('stands on the ground and has a plausible size', () => {
    const { positions } = mesh;
    const along = (axis: number) => Array.from(positions).filter((_, i) => i % 3 === axis);
    const extent = (axis: number) => Math.max(...along(axis)) - Math.min(...along(axis));
    const [height, width] = sizes[name]!;
    expect(Math.abs(Math.min(...along(1)))).toBeLessThan(0.02 * height);
    expect(Math.abs(extent(1) / height - 1)).toBeLessThan(0.1);
    expect(Math.abs(Math.max(extent(0), extent(2)) / width - 1)).toBeLessThan(0.1);
  });

  it('states its bounds', () => {
    expect(mesh.highest).toBe(Math.max(...mesh.positions.filter((_, i) => i % 3 === 1)));
  });
});

it('is made alike every time, and written as it was made', async () => {
  const { glb, mesh } = generate(
    models.find(({ name }) => name === 'dumbbell')!,
    await loadCore(),
  );
  expect(glb).toEqual(built('dumbbell'));
  expect(parsed(glb).positions).toEqual(mesh.positions);
  expect(parsed(glb).indices).toEqual(mesh.indices);
});
