// Compressed glTF is unpacked before the C++ reader receives it, by the decoders' own WebAssembly modules,
// which are loaded when they are needed. All but geometry stays as it is, and all elements of the document keep their
// numbers, so that the reader's messages are those of the command.

import type { ModelBytes, Resource } from './unpack-gltf.js';

export type { ModelBytes, Resource } from './unpack-gltf.js';

const decoderNames = /"(?:KHR_draco_mesh_compression|(?:EXT|KHR)_meshopt_compression)"/;

/**
 * A model without compression. `resource` returns the files that the model refers to, by their relative
 * names. The result has a `resource` that returns the unpacked bytes as well. Files that are not
 * compressed, not glTF or not valid are returned as they are.
 */
export async function unpackIfCompressed(
  bytes: Uint8Array,
  resource: Resource,
): Promise<ModelBytes> {
  const asGiven = { bytes, resource };
  const json = jsonOf(bytes);
  if (!json || !decoderNames.test(new TextDecoder('latin1').decode(json))) return asGiven;
  const { unpackGltf } = await import('./unpack-gltf.js');
  return unpackGltf(asGiven, {
    draco: async () => (await import('./unpack-decoders.js')).draco(),
    meshopt: async () => (await import('./unpack-decoders.js')).meshopt(),
  });
}

/** The JSON of a GLB or glTF file, if it can be one. */
function jsonOf(bytes: Uint8Array): Uint8Array | undefined {
  const isGlb = bytes.length >= 20 && String.fromCharCode(...bytes.subarray(0, 4)) === 'glTF';
  if (isGlb) {
    const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
    return bytes.subarray(20, 20 + length);
  }
  const hasMark = bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
  const first = bytes.subarray(hasMark ? 3 : 0).find((byte) => byte > 0x20);
  return first === 0x7b ? bytes : undefined;
}
