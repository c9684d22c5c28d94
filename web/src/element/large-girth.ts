// The girth of surfaces with many triangles, computed on fewer and carried back.

import type { Field, Mesh, WatchedOptions } from '../kernel/types.js';
import { formatCount, nextTask } from '../view/index.js';
import { onFewer } from './girth-method.js';

/** Triangles that the girth is computed on first. */
const mostCoarseFaces = 10_000;
/** Surfaces of fewer triangles are computed exactly as they are. */
const fewFaces = 2_000;

/** How the steps of the girth on fewer triangles share the progress. */
const [remeshed, computed] = [0.5, 0.9];

interface CoarseOptions extends WatchedOptions {
  persistence: number;
}

/** The girth of about 10,000 triangles at all vertices, as `girth igf --faces 10000` has it. */
export async function coarseGirth(
  mesh: Mesh,
  { signal, onProgress, persistence }: CoarseOptions,
): Promise<Field> {
  const { faceCount } = mesh.info;
  const watched = (from: number, to: number): WatchedOptions => ({
    ...(signal && { signal }),
    onProgress: (share) => onProgress?.(from + (to - from) * share),
  });
  if (faceCount < fewFaces) return mesh.field('igf', { ...watched(0, 1), persistence });
  const faces = Math.min(mostCoarseFaces, Math.floor(faceCount / 4));
  const coarse = await mesh.remesh(faces, watched(0, remeshed));
  try {
    const field = await coarse.field('igf', { ...watched(remeshed, computed), persistence });
    const { note, ...carried } = await coarse.carryField(field, signal ? { signal } : {});
    onProgress?.(1);
    const where = `computed on ${formatCount(coarse.info.faceCount)} triangles`;
    return {
      ...carried,
      method: `${onFewer}${coarse.info.faceCount} faces`,
      note: note ? `${where}; ${note}` : where,
    };
  } finally {
    coarse.dispose();
  }
}

/** What comes of so many values is work of its own, after that of receiving them. */
export async function onItsOwn(girth: Promise<Field>): Promise<Field> {
  const field = await girth;
  await nextTask();
  return field;
}
