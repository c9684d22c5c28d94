// Surfaces of the module in the form that the page receives.

import type { Described, ModuleOptions, Prepared } from '../wasm/girth-files.mjs';
import type { FileContent, OpenedSurface } from '../types/protocol.js';
import type { MeshInfo, PrepareOptions } from '../types/types.js';

/** The options in the module's form. Numbers that no component can have stay invalid. */
export function moduleOptions(options: PrepareOptions): ModuleOptions {
  const { scale = 1, weldDistance = 0, closeHoles = false, minComponent = 0 } = options;
  const { components = [] } = options;
  const none = 0xffffffff;
  const number = (n: number) => (Number.isInteger(n) && n >= 0 && n < none ? n : none);
  const kept = Uint32Array.from(components, number);
  return { scale, weldDistance, closeHoles, components: kept, minComponent };
}

export function openedSurface(
  prepared: Prepared,
  source: Pick<MeshInfo, 'name' | 'models' | 'unreadable'>,
): OpenedSurface {
  const { vertexOfInput, inputOfVertex, content, unit, report, notes, parts, format } = prepared;
  const said = { format, unit, report, notes, parts };
  const surface = surfaceWith(prepared, { ...source, ...said });
  return { ...surface, vertexOfInput, inputOfVertex, content };
}

/** A surface that was made of another one, whose `info` is given. Its input are its own vertices and faces. */
export function remeshedSurface(described: Described, info: MeshInfo): OpenedSurface {
  const made = surfaceWith(described, info);
  const { vertexCount, faceCount } = made.info;
  const same = upTo(vertexCount);
  const content: FileContent = {
    faceCount,
    inputOfFace: upTo(faceCount),
    attributes: [],
    rowOfCorner: new Uint32Array(0),
    values: new Float64Array(0),
  };
  return { ...made, vertexOfInput: same, inputOfVertex: same.slice(), content };
}

/** 0, 1, 2, … */
const upTo = (count: number) => Uint32Array.from({ length: count }, (_, number) => number);

function surfaceWith(
  described: Described,
  said: Pick<
    MeshInfo,
    'name' | 'models' | 'unreadable' | 'format' | 'unit' | 'report' | 'notes' | 'parts'
  >,
) {
  const { positions, origin, indices, boundary, genus, boundaries, area } = described;
  const info: MeshInfo = {
    ...said,
    vertexCount: positions.length / 3,
    faceCount: indices.length / 3,
    // Inner edges have two halfedges, those of the boundary one.
    edgeCount: (indices.length + boundary.length / 2) / 2,
    components: genus.length,
    genus,
    boundaries,
    area,
    size: extent(positions),
  };
  const drawn = drawnFrom(origin, positions);
  return { info, arrays: { positions, indices }, origin, drawn, boundary };
}

/** Positions relative to the origin. They are rounded to 32 bits only after the subtraction. */
function drawnFrom(origin: readonly number[], positions: Float64Array): Float32Array<ArrayBuffer> {
  const drawn = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; ++i) drawn[i] = positions[i]! - origin[i % 3]!;
  return drawn;
}

function extent(positions: Float64Array): [number, number, number] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; ++i) {
    const k = i % 3;
    const x = positions[i]!;
    if (x < low[k]!) low[k] = x;
    if (x > high[k]!) high[k] = x;
  }
  return [high[0]! - low[0]!, high[1]! - low[1]!, high[2]! - low[2]!];
}
