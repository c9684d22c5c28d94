// A worker with the module without threads: one of a pool, or the one that answers for the pointer.

import createModule, { type Described, type GirthModule, type Surface } from './wasm/girth.mjs';
import type { OpenedSurface, SingleOperations } from './protocol.js';
import type { MeshInfo } from './types.js';
import { checked, serveRequests } from './worker-loop.js';

let module: GirthModule;
const surfaces = new Map<number, Surface>();

function surfaceOf(number: number): Surface {
  const surface = surfaces.get(number);
  if (!surface) throw new Error(`surface ${number} is not known to this worker`);
  return surface;
}

/** What the page gets of a surface; `rest` is what the kind of source adds. */
function opened(
  described: Described,
  rest: Pick<MeshInfo, 'name' | 'format' | 'unit' | 'weldedVertices' | 'unreferencedVertices'>,
  vertexOfInput: Uint32Array<ArrayBuffer>,
): OpenedSurface {
  const { positions, indices, components, genus, area } = described;
  return {
    info: {
      ...rest,
      vertexCount: positions.length / 3,
      faceCount: indices.length / 3,
      edgeCount: indices.length / 2,
      components,
      genus,
      area,
    },
    arrays: { positions, indices },
    drawn: new Float32Array(positions),
    vertexOfInput,
  };
}

serveRequests<SingleOperations>({
  async start() {
    module = await createModule();
    return {};
  },

  read({ surface, bytes, name }) {
    const read = checked(module.readSurface(new Uint8Array(bytes), name));
    surfaces.set(surface, read.surface);
    const { format, weldedVertices, unreferencedVertices, vertexOfInput } = read;
    const unit = read.unit === 'metre' ? 'm' : read.unit;
    const rest = { name, format, unit, weldedVertices, unreferencedVertices };
    return opened(read, rest, vertexOfInput);
  },

  take({ surface, arrays }) {
    const described = checked(module.surfaceFromArrays(arrays.positions, arrays.indices));
    surfaces.set(surface, described.surface);
    const rest = {
      name: '',
      format: 'arrays',
      unit: '',
      weldedVertices: 0,
      unreferencedVertices: 0,
    } as const;
    const same = Uint32Array.from({ length: described.positions.length / 3 }, (_, v) => v);
    return opened(described, rest, same);
  },

  adopt({ surface, arrays }) {
    const described = checked(module.surfaceFromArrays(arrays.positions, arrays.indices));
    surfaces.set(surface, described.surface);
    return {};
  },

  order({ surface }) {
    return { order: checked(surfaceOf(surface).order()) };
  },

  values({ surface, vertices }) {
    const from = performance.now();
    const { values, kinds } = checked(surfaceOf(surface).values(vertices));
    return { values, kinds, milliseconds: performance.now() - from };
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
