// Where models come from: files, addresses, bytes and arrays, as bytes or arrays that a worker can
// be given.

import { failure } from './errors.js';
import type { SurfaceArrays } from './protocol.js';
import type { MeshSource } from './types.js';

/** Content that belongs to the kernel: it may be transferred. */
export type SourceContent = { bytes: ArrayBuffer; name: string } | { arrays: SurfaceArrays };

export async function contentOf(source: MeshSource, signal: AbortSignal): Promise<SourceContent> {
  if (typeof source === 'string' || source instanceof URL) return fetched(String(source), signal);
  if (source instanceof Blob) {
    const name = 'name' in source && typeof source.name === 'string' ? source.name : 'model';
    try {
      return { bytes: await source.arrayBuffer(), name };
    } catch (cause) {
      throw failure('FILE_UNREADABLE', `${name} cannot be read`, { cause });
    }
  }
  if ('bytes' in source) return { bytes: source.bytes.slice(0), name: source.name };
  return {
    arrays: {
      positions: new Float64Array(source.positions),
      indices: new Uint32Array(source.indices),
    },
  };
}

async function fetched(address: string, signal: AbortSignal): Promise<SourceContent> {
  let response: Response;
  let bytes: ArrayBuffer;
  const shown = address.length > 120 ? `${address.slice(0, 117)}...` : address;
  try {
    response = await fetch(address, { signal });
    bytes = await response.arrayBuffer();
  } catch (cause) {
    throw failure('FILE_UNREADABLE', `${shown} cannot be fetched`, {
      cause,
      hint: 'check the address and the connection; another site must allow it (CORS)',
    });
  }
  if (!response.ok) {
    const code =
      response.status === 404 || response.status === 410 ? 'FILE_NOT_FOUND' : 'FILE_UNREADABLE';
    throw failure(code, `${shown} cannot be fetched: status ${response.status}`, {
      hint: 'check the address',
    });
  }
  return { bytes, name: nameOf(response.url || address) };
}

/** The last part of an address's path. */
function nameOf(address: string): string {
  if (/^(data|blob):/.test(address)) return 'model';
  const last =
    address
      .replace(/[?#].*$/, '')
      .split('/')
      .pop() || 'model';
  try {
    return decodeURIComponent(last);
  } catch {
    return last;
  }
}
