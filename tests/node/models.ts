// Models for the tests of the package in Node.js: surfaces that are given as OBJ, in every format.

import { createRequire } from 'node:module';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { dracoDocument } from '../web/kernel/draco-document.js';

export const tetrahedron = `v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n`;

interface Surface {
  positions: Float32Array;
  indices: Uint32Array;
}

/** The surface of vertices and triangles, without anything else. */
function surfaceOf(obj: string): Surface {
  const numbers = (mark: string) =>
    obj
      .split('\n')
      .filter((line) => line.startsWith(`${mark} `))
      .flatMap((line) => line.slice(2).split(' ').map(Number));
  const corners = numbers('f').map((number) => number - 1);
  return { positions: Float32Array.from(numbers('v')), indices: Uint32Array.from(corners) };
}

const triples = (list: ArrayLike<number>): number[][] =>
  Array.from({ length: list.length / 3 }, (_, i) => [
    list[3 * i]!,
    list[3 * i + 1]!,
    list[3 * i + 2]!,
  ]);

export function off(obj: string): string {
  const { positions, indices } = surfaceOf(obj);
  const points = triples(positions).map((point) => point.join(' '));
  const faces = triples(indices).map((face) => `3 ${face.join(' ')}`);
  return [`OFF\n${points.length} ${faces.length} 0`, ...points, ...faces, ''].join('\n');
}

export function ply(obj: string): string {
  const { positions, indices } = surfaceOf(obj);
  const points = triples(positions).map((point) => point.join(' '));
  const faces = triples(indices).map((face) => `3 ${face.join(' ')}`);
  const header = [
    ...['ply', 'format ascii 1.0', `element vertex ${points.length}`],
    ...['property double x', 'property double y', 'property double z'],
    ...[`element face ${faces.length}`, 'property list uchar int vertex_indices', 'end_header'],
  ];
  return [...header, ...points, ...faces, ''].join('\n');
}

/** Binary. */
export function stl(obj: string): Uint8Array {
  const { positions, indices } = surfaceOf(obj);
  const faces = triples(indices);
  const view = new DataView(new ArrayBuffer(84 + 50 * faces.length));
  view.setUint32(80, faces.length, true);
  faces.forEach((face, f) =>
    face.forEach((v, corner) => {
      for (let axis = 0; axis < 3; ++axis) {
        const at = 84 + 50 * f + 12 + 12 * corner + 4 * axis;
        view.setFloat32(at, positions[3 * v + axis]!, true);
      }
    }),
  );
  return new Uint8Array(view.buffer);
}

function joined(...pieces: Uint8Array[]): Uint8Array {
  const all = new Uint8Array(pieces.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const piece of pieces) {
    all.set(piece, at);
    at += piece.length;
  }
  return all;
}

const bytesOf = ({ buffer, byteOffset, byteLength }: ArrayBufferView) =>
  new Uint8Array(buffer as ArrayBuffer, byteOffset, byteLength);

/** Whole words, as GLB has them. */
function padded(bytes: Uint8Array, filler: number): Uint8Array {
  return joined(bytes, new Uint8Array(-bytes.length & 3).fill(filler));
}

function glbOf(document: object, content: Uint8Array): Uint8Array {
  const json = padded(new TextEncoder().encode(JSON.stringify(document)), 0x20);
  const bin = padded(content, 0);
  const words = (...numbers: number[]) => bytesOf(Uint32Array.from(numbers));
  const length = 12 + 8 + json.length + 8 + bin.length;
  const header = words(0x46546c67, 2, length, json.length, 0x4e4f534a);
  return joined(header, json, words(bin.length, 0x004e4942), bin);
}

/** A document whose buffer has points and triangles, one after the other. */
function plainDocument({ positions, indices }: Surface) {
  const [first, second] = [positions.byteLength, indices.byteLength];
  return {
    asset: { version: '2.0' },
    buffers: [{ byteLength: first + second }],
    bufferViews: [
      { buffer: 0, byteLength: first },
      { buffer: 0, byteOffset: first, byteLength: second },
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, count: positions.length / 3, type: 'VEC3' },
      { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    nodes: [{ mesh: 0 }],
    scenes: [{ nodes: [0] }],
    scene: 0,
  };
}

export function glb(obj: string): Uint8Array {
  const surface = surfaceOf(obj);
  const content = joined(bytesOf(surface.positions), bytesOf(surface.indices));
  return glbOf(plainDocument(surface), content);
}

/** A glTF with its buffer in a file of its own, whose name it states. */
export function splitGltf(obj: string, name: string): { gltf: string; bin: Uint8Array } {
  const surface = surfaceOf(obj);
  const document = plainDocument(surface);
  const uri = name.split('/').map(encodeURIComponent).join('/');
  const buffers = [{ ...document.buffers[0], uri }];
  const bin = joined(bytesOf(surface.positions), bytesOf(surface.indices));
  return { gltf: JSON.stringify({ ...document, buffers }), bin };
}

/** The encoder of Draco, as far as it is used here. */
interface DracoEncoder {
  Encoder: new () => {
    SetEncodingMethod(method: number): void;
    EncodeMeshToDracoBuffer(mesh: object, into: { GetValue(at: number): number }): number;
  };
  Mesh: new () => object;
  MeshBuilder: new () => {
    AddFacesToMesh(mesh: object, faces: number, indices: Uint32Array): boolean;
    AddFloatAttribute(
      ...args: [
        mesh: object,
        type: number,
        points: number,
        components: number,
        values: Float32Array,
      ]
    ): number;
  };
  DracoInt8Array: new () => { GetValue(at: number): number };
  POSITION: number;
  MESH_SEQUENTIAL_ENCODING: number;
}

const { createEncoderModule } = createRequire(import.meta.url)('draco3dgltf') as {
  createEncoderModule: (this: void, options: object) => Promise<DracoEncoder>;
};

/** Packed by Draco without loss, its points in their order. */
export async function dracoGlb(obj: string): Promise<Uint8Array> {
  const { positions, indices } = surfaceOf(obj);
  const draco = await createEncoderModule({});
  const [encoder, mesh] = [new draco.Encoder(), new draco.Mesh()];
  const [builder, packed] = [new draco.MeshBuilder(), new draco.DracoInt8Array()];
  builder.AddFacesToMesh(mesh, indices.length / 3, indices);
  builder.AddFloatAttribute(mesh, draco.POSITION, positions.length / 3, 3, positions);
  encoder.SetEncodingMethod(draco.MESH_SEQUENTIAL_ENCODING);
  const length = encoder.EncodeMeshToDracoBuffer(mesh, packed);
  const bytes = Uint8Array.from({ length }, (_, i) => packed.GetValue(i));
  const extension = { extensionsUsed: ['KHR_draco_mesh_compression'] };
  const document = dracoDocument(length, positions.length / 3, indices.length);
  return glbOf({ ...document, ...extension, extensionsRequired: extension.extensionsUsed }, bytes);
}

/** Packed with EXT_meshopt_compression. */
export async function meshoptGlb(obj: string): Promise<Uint8Array> {
  await MeshoptEncoder.ready;
  const surface = surfaceOf(obj);
  const points = surface.positions.length / 3;
  const packed = [
    MeshoptEncoder.encodeGltfBuffer(bytesOf(surface.positions), points, 12, 'ATTRIBUTES'),
    MeshoptEncoder.encodeGltfBuffer(
      bytesOf(surface.indices),
      surface.indices.length,
      4,
      'TRIANGLES',
    ),
  ];
  const packings = [
    { count: points, byteStride: 12, mode: 'ATTRIBUTES' },
    { count: surface.indices.length, byteStride: 4, mode: 'TRIANGLES' },
  ];
  const document = plainDocument(surface);
  const starts = [0, packed[0]!.length];
  const views = document.bufferViews.map((view, i) => ({
    ...{ ...view, buffer: 1 },
    extensions: {
      EXT_meshopt_compression: {
        ...{ buffer: 0, byteOffset: starts[i], byteLength: packed[i]!.length },
        ...packings[i],
      },
    },
  }));
  const content = joined(...packed);
  const names = ['EXT_meshopt_compression'];
  const fallback = {
    ...document.buffers[0],
    extensions: { EXT_meshopt_compression: { fallback: true } },
  };
  return glbOf(
    {
      ...document,
      ...{ extensionsUsed: names, extensionsRequired: names },
      ...{ buffers: [{ byteLength: content.length }, fallback], bufferViews: views },
    },
    content,
  );
}
