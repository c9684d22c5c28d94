// The built-in models: every one is made once, and one of them twice.

import { beforeAll, describe, expect, it } from 'vitest';
import { generate, type Example } from '../../../web/app/examples/generate.ts';
import { models } from '../../../web/app/examples/models/index.ts';

const patience = 300_000;

/** What is looked at of a glTF document. */
interface Accessor {
  count: number;
  componentType: number;
  max?: number[];
}
interface BufferView {
  byteOffset: number;
}
interface Document {
  accessors: Accessor[];
  bufferViews: BufferView[];
}

const faceCounts: Record<string, [number, number]> = {
  chair: [9500, 10300],
  octopus: [9800, 10200],
  handles: [7500, 8500],
  dumbbell: [3000, 3400],
  cup: [4700, 5300],
  vessel: [7500, 8500],
};

/** Height and greatest width in metres, to within a tenth. */
const sizes: Record<string, [number, number]> = {
  chair: [0.9, 0.54],
  octopus: [0.29, 0.68],
  handles: [0.3, 0.4],
  dumbbell: [0.2, 0.465],
  cup: [0.096, 0.12],
  vessel: [0.36, 0.27],
};

const made = new Map<string, Example>();

beforeAll(() => {
  for (const model of models) made.set(model.name, generate(model));
}, patience);

describe.each(models.map((model) => [model.name, model] as const))('%s', (name, model) => {
  it('is one closed manifold, oriented outwards, of the genus stated', () => {
    const { measures } = made.get(name)!;
    expect(measures.closedManifold).toBe(true);
    expect(measures.components).toBe(1);
    expect(measures.genus).toBe(model.genus);
    expect(measures.volume).toBeGreaterThan(0);
  });

  it('has every edge in two faces, in opposite directions', () => {
    const { indices } = made.get(name)!.mesh;
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
    const { measures } = made.get(name)!;
    const [fewest, most] = faceCounts[name]!;
    expect(measures.faces).toBeGreaterThanOrEqual(fewest);
    expect(measures.faces).toBeLessThanOrEqual(most);
    expect(measures.smallestAngle).toBeGreaterThan(22);
    expect(measures.largestAngle).toBeLessThan(120);
    expect(measures.smallestValence).toBeGreaterThanOrEqual(4);
    expect(measures.largestValence).toBeLessThanOrEqual(9);
  });

  it('has vertices on the surface, no two in one place', () => {
    const { mesh, measures } = made.get(name)!;
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
    const { positions } = made.get(name)!.mesh;
    const along = (axis: number) => Array.from(positions).filter((_, i) => i % 3 === axis);
    const extent = (axis: number) => Math.max(...along(axis)) - Math.min(...along(axis));
    const [height, width] = sizes[name]!;
    expect(Math.abs(Math.min(...along(1)))).toBeLessThan(0.02 * height);
    expect(Math.abs(extent(1) / height - 1)).toBeLessThan(0.1);
    expect(Math.abs(Math.max(extent(0), extent(2)) / width - 1)).toBeLessThan(0.1);
  });

  it('is written as a GLB that holds exactly this mesh', () => {
    const { glb, mesh } = made.get(name)!;
    const view = new DataView(glb.buffer);
    expect(view.getUint32(0, true)).toBe(0x46546c67);
    expect(view.getUint32(8, true)).toBe(glb.length);
    const jsonLength = view.getUint32(12, true);
    const json = JSON.parse(
      new TextDecoder().decode(glb.subarray(20, 20 + jsonLength)),
    ) as Document;
    const data = glb.slice(28 + jsonLength).buffer;
    const [points, corners] = json.accessors as [Accessor, Accessor];
    const [pointBytes, cornerBytes] = json.bufferViews as [BufferView, BufferView];
    const heights = Array.from(mesh.positions).filter((_, i) => i % 3 === 1);
    expect(points.max![1]).toBe(Math.max(...heights));
    expect(new Float32Array(data, pointBytes.byteOffset, 3 * points.count)).toEqual(mesh.positions);
    expect(corners.componentType).toBe(5123);
    const indices = new Uint16Array(data, cornerBytes.byteOffset, corners.count);
    expect(Uint32Array.from(indices)).toEqual(mesh.indices);
  });
});

it(
  'gives the same bytes every time',
  () => {
    const again = generate(models.find(({ name }) => name === 'dumbbell')!);
    expect(again.glb).toEqual(made.get('dumbbell')!.glb);
  },
  patience,
);
