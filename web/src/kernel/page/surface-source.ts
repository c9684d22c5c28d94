// A surface as the page knows it: what any worker needs to make the same one.

import type { SurfaceArrays } from '../types/protocol.js';

export interface SurfaceSource<A extends SurfaceArrays = SurfaceArrays> {
  /** Identifies the surface in every worker of every kernel of the page. */
  readonly number: number;
  readonly arrays: A;
  /** Fires when the mesh is disposed of. No worker is given the surface after that. */
  readonly life: AbortSignal;
}

/** Bytes of the surface's arrays. A worker needs several times as many. */
export function bytesOf({ arrays }: SurfaceSource): number {
  return sizeOf(Object.values(arrays) as ArrayBufferView[]);
}

/** Bytes of arrays. */
export function sizeOf(arrays: readonly ArrayBufferView[]): number {
  return arrays.reduce((sum, { byteLength }) => sum + byteLength, 0);
}
