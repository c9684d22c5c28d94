// Where models come from: files, addresses, bytes and arrays become files or arrays for a worker.

import { failure } from '../types/errors.js';
import type { SurfaceArrays } from '../types/protocol.js';
import type { FileWithPath, MeshSource } from '../types/types.js';

/** Content for a worker. The arrays are copies, and may be transferred. */
export type SourceContent = { files: FileWithPath[]; address?: string } | { arrays: SurfaceArrays };

/** Gives the content that an address stands for. Errors: FILE_NOT_FOUND, FILE_UNREADABLE. */
export type ContentAt = (address: string, signal: AbortSignal) => Promise<SourceContent>;

export async function contentOf(
  source: MeshSource,
  signal: AbortSignal,
  contentAt: ContentAt,
): Promise<SourceContent> {
  if (typeof source === 'string' || source instanceof URL) return contentAt(String(source), signal);
  if (source instanceof Blob) return { files: [withPath(source)] };
  if (typeof source !== 'object' || source === null) {
    throw failure('USAGE', `${String(source)} is no model`, {
      hint: 'pass an address, a file, several files, bytes with a name, or arrays',
    });
  }
  if (isList(source)) {
    if (source.length === 0) {
      throw failure('FILE_NOT_FOUND', 'there is no file', { hint: 'choose a model' });
    }
    return { files: source.map((file) => (file instanceof Blob ? withPath(file) : file)) };
  }
  if ('bytes' in source) {
    return {
      files: [{ path: source.name || 'model', content: new Blob([source.bytes as ArrayBuffer]) }],
    };
  }
  if (!('positions' in source && 'indices' in source)) {
    throw failure('USAGE', 'an object without positions and indices is no model', {
      hint: 'pass both arrays',
    });
  }
  return {
    arrays: {
      positions: new Float64Array(source.positions),
      indices: new Uint32Array(source.indices),
    },
  };
}

/** Bytes of all of it, before anything is unpacked. */
export function sizeOf(source: SourceContent): number {
  if ('files' in source) return source.files.reduce((sum, { content }) => sum + content.size, 0);
  return source.arrays.positions.byteLength + source.arrays.indices.byteLength;
}

const isList = (source: object): source is readonly (File | FileWithPath)[] =>
  Array.isArray(source);

/** A file's path within the folder that was chosen, or its name. */
function withPath(content: Blob): FileWithPath {
  const { name, webkitRelativePath } = content as Partial<File>;
  return { path: webkitRelativePath || name || 'model', content };
}

/** The content at an address of the network. */
export const fetched: ContentAt = async (address, signal) => {
  let response: Response;
  let content: Blob;
  const shown = address.length > 120 ? `${address.slice(0, 117)}...` : address;
  try {
    response = await fetch(address, { signal });
    content = await response.blob();
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
  const whole = response.url || address;
  return { files: [{ path: nameOf(whole), content }], address: whole };
};

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
