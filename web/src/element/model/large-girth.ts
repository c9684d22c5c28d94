// The girth of surfaces with many triangles, computed on fewer and carried back.

import { linked } from '../../kernel/page/abort.js';
import type {
  Field,
  FieldOptions,
  Mesh,
  PartialField,
  WatchedOptions,
} from '../../kernel/types/types.js';
import { formatCount, nextTask } from '../../view/index.js';

/** Triangles that the girth is computed on first. */
const mostCoarseFaces = 10_000;
/** Surfaces of fewer triangles are computed exactly as they are. */
const fewFaces = 2_000;

/** So long exact values of some vertices are computed: then remeshing has the machine for itself. */
const someMilliseconds = 2_000;

/** The share of an exact value by which a carried one must differ to count as far off. */
const far = 0.05;

/** How the steps of the girth on fewer triangles share the progress. */
const [remeshed, computed] = [0.5, 0.9];

interface CoarseOptions extends WatchedOptions {
  persistence: number;
  /** Receives exact values of some vertices, as long as there are no others. */
  onPartial?: FieldOptions['onPartial'];
}

/** The girth of about 10,000 triangles at all vertices, as `girth igf --faces 10000` has it. */
export async function coarseGirth(
  mesh: Mesh,
  { signal, onProgress, onPartial, persistence }: CoarseOptions,
): Promise<Field> {
  const { faceCount } = mesh.info;
  const watched = (from: number, to: number): WatchedOptions => ({
    ...(signal && { signal }),
    onProgress: (share) => onProgress?.(from + (to - from) * share),
  });
  if (faceCount < fewFaces) return mesh.field('igf', { ...watched(0, 1), persistence });
  const faces = Math.min(mostCoarseFaces, Math.floor(faceCount / 4));
  const exact = new Map<number, number>();
  const received = (partial: PartialField): void => {
    partial.vertices.forEach((vertex, i) => exact.set(vertex, partial.values[i]!));
    onPartial?.(partial);
  };
  const stop = onPartial && someExact(mesh, { signal, onPartial: received, persistence });
  const coarse = await mesh.remesh(faces, watched(0, remeshed)).finally(stop);
  try {
    const field = await coarse.field('igf', { ...watched(remeshed, computed), persistence });
    const { note, ...carried } = await coarse.carryField(field, signal ? { signal } : {});
    onProgress?.(1);
    const words = [
      `computed on ${formatCount(coarse.info.faceCount)} triangles`,
      checkWords(carried.values, exact),
      note,
    ];
    return { ...carried, note: words.filter(Boolean).join('; ') };
  } finally {
    coarse.dispose();
  }
}

/** How many of some exact values are near those that were carried over; '' where there is none to compare. */
export function checkWords(carried: ArrayLike<number>, exact: ReadonlyMap<number, number>): string {
  const pairs = [...exact].filter(
    ([vertex, value]) => !Number.isNaN(value) && !Number.isNaN(carried[vertex]),
  );
  if (pairs.length === 0) return '';
  const isFar = ([vertex, value]: [number, number]): boolean =>
    Math.abs(carried[vertex]! - value) > far * value;
  const near = pairs.length - pairs.filter(isFar).length;
  const words = `${formatCount(near)} of ${formatCount(pairs.length)} exact values`;
  return `${words} ${near === 1 ? 'is' : 'are'} within ${Math.round(100 * far)}%`;
}

/** Computes exact values of some vertices, until what it returns is called at the latest: first colours, long before others. */
function someExact(
  mesh: Mesh,
  {
    signal,
    onPartial,
    persistence,
  }: Pick<CoarseOptions, 'onPartial' | 'persistence'> & {
    signal: AbortSignal | undefined;
  },
): () => void {
  // Each worker of a pool would have a surface of its own, which takes much memory.
  if (!globalThis.crossOriginIsolated) return () => undefined;
  const stop = new AbortController();
  const either = linked([signal, stop.signal]);
  const options = { signal: either.signal, persistence, ...(onPartial && { onPartial }) };
  // The computation is stopped before it ends.
  void mesh.field('igf', options).catch(() => undefined);
  const enough = setTimeout(() => stop.abort(), someMilliseconds);
  return () => {
    clearTimeout(enough);
    stop.abort();
    either.release();
  };
}

/** Work on so many values is a task of its own, after that of receiving them. */
export async function onItsOwn(girth: Promise<Field>): Promise<Field> {
  const field = await girth;
  await nextTask();
  return field;
}
