// A GLB with numbers at its vertices, as others than Girth may write it.

import { arraysOf, gltf } from './meshes.js';

const padded = (bytes: Uint8Array, filler: number): Uint8Array => {
  const whole = new Uint8Array(4 * Math.ceil(bytes.length / 4)).fill(filler);
  whole.set(bytes);
  return whole;
};

/** A surface, given as OBJ, and values at its vertices by the names of their attributes. */
export function glbWith(
  obj: string,
  values: Record<string, (vertex: number) => number>,
): Uint8Array<ArrayBuffer> {
  const count = arraysOf(obj).positions.length / 3;
  const { json, bin } = gltf(obj, '');
  const document = JSON.parse(json) as {
    buffers: { uri?: string; byteLength: number }[];
    bufferViews: { buffer: number; byteOffset?: number; byteLength: number }[];
    accessors: { bufferView: number; componentType: number; count: number; type: string }[];
    meshes: { primitives: { attributes: Record<string, number> }[] }[];
  };
  const parts: Uint8Array[] = [bin];
  let length = bin.length;
  for (const [name, valueAt] of Object.entries(values)) {
    const numbers = Float32Array.from({ length: count }, (_, vertex) => valueAt(vertex));
    document.bufferViews.push({ buffer: 0, byteOffset: length, byteLength: 4 * count });
    document.accessors.push({
      bufferView: document.bufferViews.length - 1,
      componentType: 5126,
      count,
      type: 'SCALAR',
    });
    document.meshes[0]!.primitives[0]!.attributes[name] = document.accessors.length - 1;
    parts.push(new Uint8Array(numbers.buffer));
    length += 4 * count;
  }
  document.buffers = [{ byteLength: length }];
  const text = padded(new TextEncoder().encode(JSON.stringify(document)), 0x20);
  const glb = new Uint8Array(28 + text.length + length);
  const view = new DataView(glb.buffer);
  [0x46546c67, 2, glb.length, text.length, 0x4e4f534a].forEach((word, i) =>
    view.setUint32(4 * i, word, true),
  );
  glb.set(text, 20);
  view.setUint32(20 + text.length, length, true);
  view.setUint32(24 + text.length, 0x004e4942, true);
  let at = 28 + text.length;
  for (const part of parts) {
    glb.set(part, at);
    at += part.length;
  }
  return glb;
}
