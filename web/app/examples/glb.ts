// A triangle mesh as binary glTF 2.0: one node, one primitive, positions and indices only.

import type { Triangles } from './polygonise.ts';

const magic = 0x46546c67;
const jsonChunk = 0x4e4f534a;
const binaryChunk = 0x004e4942;
const arrayBuffer = 34962;
const elementArrayBuffer = 34963;
const float = 5126;
const unsignedShort = 5123;
const unsignedInt = 5125;

/** Positions are rounded to 32-bit floats. Indices take 16 bits where that is enough. */
export function writeGlb(name: string, { positions, indices }: Triangles): Uint8Array {
  const vertices = positions.length / 3;
  const points = Float32Array.from(positions);
  const short = vertices < 0xffff;
  const corners = short ? Uint16Array.from(indices) : Uint32Array.from(indices);
  const extreme = (k: number, pick: (a: number, b: number) => number): number =>
    points.reduce((value, point, i) => (i % 3 === k ? pick(value, point) : value), points[k]!);
  const json = {
    asset: { version: '2.0', generator: 'girth examples' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name, mesh: 0 }],
    meshes: [{ name, primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      {
        bufferView: 0,
        componentType: float,
        count: vertices,
        type: 'VEC3',
        min: [0, 1, 2].map((k) => extreme(k, Math.min)),
        max: [0, 1, 2].map((k) => extreme(k, Math.max)),
      },
      {
        bufferView: 1,
        componentType: short ? unsignedShort : unsignedInt,
        count: corners.length,
        type: 'SCALAR',
      },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: points.byteLength, target: arrayBuffer },
      {
        buffer: 0,
        byteOffset: points.byteLength,
        byteLength: corners.byteLength,
        target: elementArrayBuffer,
      },
    ],
    buffers: [{ byteLength: points.byteLength + corners.byteLength }],
  };
  const text = new TextEncoder().encode(JSON.stringify(json));
  const textLength = roundedUp(text.length);
  const dataLength = roundedUp(points.byteLength + corners.byteLength);
  const bytes = new Uint8Array(12 + 8 + textLength + 8 + dataLength);
  const view = new DataView(bytes.buffer);
  const header = [magic, 2, bytes.length, textLength, jsonChunk];
  header.forEach((word, i) => view.setUint32(4 * i, word, true));
  bytes.fill(0x20, 20, 20 + textLength);
  bytes.set(text, 20);
  let at = 20 + textLength;
  view.setUint32(at, dataLength, true);
  view.setUint32(at + 4, binaryChunk, true);
  at += 8;
  points.forEach((value, i) => view.setFloat32(at + 4 * i, value, true));
  at += points.byteLength;
  corners.forEach((value, i) => {
    if (short) view.setUint16(at + 2 * i, value, true);
    else view.setUint32(at + 4 * i, value, true);
  });
  return bytes;
}

function roundedUp(length: number): number {
  return Math.ceil(length / 4) * 4;
}
