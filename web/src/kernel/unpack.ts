// Compressed glTF is unpacked before the C++ reader sees it: by the decoders' own WebAssembly modules,
// which are loaded only then. What is not geometry stays as it is, and so does every number by which
// the document knows its elements: the reader says of an unpacked file what the command would say.

import type { ModelBytes, Resource } from './unpack-gltf.js';

export type { ModelBytes, Resource } from './unpack-gltf.js';

const decoderNames = /"(?:KHR_draco_mesh_compression|(?:EXT|KHR)_meshopt_compression)"/;

/**
 * A model without compression. `resource` brings the files that it refers to, by their relative names;
 * what comes back has one of its own, which brings the unpacked bytes as well. Files that are not
 * compressed, not glTF or not valid come back as they are.
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
