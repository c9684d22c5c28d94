// Buffer views packed with EXT_meshopt_compression or KHR_meshopt_compression, with the rules of the C++
// reader.

import type { MeshoptDecoder } from '../wasm/meshopt-decoder.mjs';
import { failure } from '../types/errors.js';
import type { UnpackBudget } from './unpack-budget.js';

/** The extension's members that state how bytes are packed. */
export interface Packing {
  byteStride: number;
  count: number;
  mode: string;
  filter: string;
}

/** Which requirement of the extensions is violated; '' if none is. */
function faultOf({ byteStride, count, mode, filter }: Packing): string {
  if (count === 0) return 'has a count of 0';
  const bad = `has a byteStride of ${byteStride}, which its`;
  if (mode === 'ATTRIBUTES') {
    if (byteStride < 4 || byteStride > 256 || byteStride % 4 !== 0)
      return `${bad} mode does not allow`;
  } else {
    if (byteStride !== 2 && byteStride !== 4) return `${bad} mode does not allow`;
    if (filter !== 'NONE') return 'has a filter, which its mode does not allow';
    if (mode === 'TRIANGLES' && count % 3 !== 0) {
      return `has a count of ${count}, which is not a whole number of triangles`;
    }
  }
  const isAnything = filter === 'NONE' || filter === 'EXPONENTIAL';
  const isEight = byteStride === 8;
  const fits = isAnything || (filter === 'QUATERNION' ? isEight : isEight || byteStride === 4);
  return fits ? '' : `${bad} filter does not allow`;
}

/** The least number of bytes that so many elements can be packed into. */
function leastBytes({ byteStride, count, mode }: Packing, bytes: Uint8Array): number {
  if (mode === 'TRIANGLES') return 1 + count / 3 + 16;
  if (mode === 'INDICES') return 1 + count + 4;
  const block = Math.min(Math.floor(8192 / byteStride / 16) * 16, 256);
  if (bytes[0] === 0xa1) {
    const tail = Math.max(byteStride + byteStride / 4, 24);
    return 1 + (Math.ceil(count / block) * byteStride) / 4 + tail;
  }
  const header = (vertices: number) => Math.ceil(Math.ceil(vertices / 16) / 4);
  const headers = Math.floor(count / block) * header(block) + header(count % block);
  return 1 + headers * byteStride + Math.max(byteStride, 32);
}

export function unpackMeshopt(
  decoder: typeof MeshoptDecoder,
  packing: Packing,
  bytes: Uint8Array,
  budget: UnpackBudget,
  place: string,
): Uint8Array<ArrayBuffer> {
  const malformed = (what: string, cause?: unknown) =>
    failure('MALFORMED_FILE', `${place}: ${what}`, { cause });
  const fault = faultOf(packing);
  if (fault !== '') throw malformed(fault);
  const { byteStride, count, mode, filter } = packing;
  if (bytes.length < leastBytes(packing, bytes)) {
    throw malformed(`claims ${count} elements, which do not fit into its ${bytes.length} bytes`);
  }
  if (!budget.take(Math.floor((count * byteStride) / 16) + 1)) {
    const message = `${place}: its ${count} elements make the model far larger than its file`;
    throw failure('LIMIT_EXCEEDED', message);
  }
  const content = new Uint8Array(count * byteStride);
  try {
    decoder.decodeGltfBuffer(content, count, byteStride, bytes, mode, filter);
  } catch (cause) {
    throw malformed('its packed bytes are not valid', cause);
  }
  return content;
}
