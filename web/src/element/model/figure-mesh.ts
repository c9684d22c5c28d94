// The surface of a file that has its values in it, as a mesh that nothing can be computed on: whoever wants that
// loads the file anew, by the kernel.

import { disposal } from '../../kernel/types/disposal.js';
import { failure } from '../../kernel/types/errors.js';
import type { Mesh, MeshInfo } from '../../kernel/types/types.js';
import { inSlices } from '../../view/index.js';
import { type FigureFile, readFigure } from './figure-file.js';
import { givenFields } from './given-fields.js';
import type { FileContent } from './file-content.js';
import { nothingPrepared } from './nothing-prepared.js';
import { refusedCalls } from '../attributes/refused-calls.js';
import { countSurface, vertexAreasOf } from './surface-counts.js';

/** Surfaces farther from the origin than so many times their size are left to the kernel, which moves them. */
const farthest = 64;

/** The content of a file, with its surface. */
export interface Figure {
  /** The surface as it is; undefined where the kernel would have something to mend. */
  mesh: Mesh | undefined;
  content: FileContent;
}

/** The surface and values in a file's bytes; undefined where they have no values. */
export async function figureOf(
  bytes: ArrayBuffer,
  name: string,
  signal: AbortSignal,
): Promise<Figure | undefined> {
  const file = readFigure(bytes);
  if (!file) return undefined;
  const { loops, tips, ownUnit } = file;
  const fields = givenFields(file.fields);
  const mesh = await meshOf(file, name, signal);
  return { mesh, content: { fields, loops, tips, ownUnit, leads: true, isAll: true } };
}

async function meshOf(
  file: FigureFile,
  name: string,
  signal: AbortSignal,
): Promise<Mesh | undefined> {
  const { positions, indices, tips, unit } = file;
  const counts = await inSlices(countSurface(positions, indices), signal);
  if (!counts || isFar(positions, Math.max(...counts.size))) return undefined;
  const { boundary, ...known } = counts;
  const [vertexCount, faceCount] = [positions.length / 3, indices.length / 3];
  const info: MeshInfo = {
    ...known,
    ...{ name, models: [name], unreadable: [], format: 'GLB', notes: [], unit },
    ...{ vertexCount, faceCount },
    report: {
      ...nothingPrepared,
      inputVertices: vertexCount,
      inputFaces: faceCount,
      components: counts.components,
      keptComponents: counts.components,
      boundaryCurves: counts.boundaries.reduce((sum, curves) => sum + curves, 0),
      boundaryEdges: boundary.length / 2,
    },
  };
  const refused = (): Promise<never> =>
    Promise.reject(failure('USAGE', 'the file was not read by the kernel', { hint: 'load it' }));
  return {
    ...refusedCalls(refused),
    info,
    geometry: { positions, indices, boundary, origin: [0, 0, 0] },
    vertexOfInput: Uint32Array.from({ length: vertexCount }, (_, vertex) => vertex),
    vertexAreas: ({ signal } = {}) => inSlices(vertexAreasOf(positions, indices), signal),
    ...(tips ? { tips: () => Promise.resolve(tips) } : {}),
    dispose: () => undefined,
    [disposal]: () => undefined,
  };
}

function isFar(positions: Float32Array, size: number): boolean {
  return positions.some((coordinate) => Math.abs(coordinate) > farthest * size);
}
