// Compressed glTF, packed by the encoders of Draco and meshoptimizer, and what the unpacking makes of
// it: a plain document for the reader.

import { createRequire } from 'node:module';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { MeshoptEncoder } from 'meshoptimizer/encoder';
import { beforeAll, describe, expect, test } from 'vitest';
import { unpackIfCompressed } from '../../../web/src/kernel/unpack/unpack.js';
import { unpackGltf, type Decoders } from '../../../web/src/kernel/unpack/unpack-gltf.js';
import { dracoDocument } from './draco-document.js';

interface Encoding {
  GetValue(at: number): number;
}
interface DracoEncoders {
  Encoder: new () => {
    SetEncodingMethod(method: number): void;
    SetAttributeQuantization(type: number, bits: number): void;
    EncodeMeshToDracoBuffer(mesh: object, to: object): number;
  };
  MeshBuilder: new () => {
    AddFacesToMesh(mesh: object, faces: number, indices: Uint32Array): void;
    AddFloatAttributeToMesh(
      mesh: object,
      type: number,
      points: number,
      components: number,
      values: Float32Array,
    ): number;
  };
  Mesh: new () => object;
  DracoInt8Array: new () => Encoding;
  POSITION: number;
  MESH_SEQUENTIAL_ENCODING: number;
  MESH_EDGEBREAKER_ENCODING: number;
}
const draco3d = createRequire(import.meta.url)('draco3dgltf') as {
  createDecoderModule(): Promise<never>;
  createEncoderModule(): Promise<DracoEncoders>;
};

const decoders: Decoders = {
  draco: () => draco3d.createDecoderModule(),
  async meshopt() {
    await MeshoptDecoder.ready;
    return MeshoptDecoder;
  },
};
const nothing = () => undefined;

/** A bumpy square of size × size vertices. */
function grid(size: number) {
  const positions = new Float32Array(3 * size * size);
  const indices: number[] = [];
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      const at = y * size + x;
      positions.set([x, y, Math.sin(x) * Math.cos(y)], 3 * at);
      if (x + 1 === size || y + 1 === size) continue;
      const above = at + size;
      indices.push(at, at + 1, above + 1, at, above + 1, above);
    }
  }
  return { positions, indices: Uint32Array.from(indices) };
}

const bytesOf = (array: Float32Array | Uint32Array) =>
  new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
const encoded = (document: object) => new TextEncoder().encode(JSON.stringify(document));

function glb(document: object, binary: Uint8Array): Uint8Array {
  const json = encoded(document);
  const jsonLength = Math.ceil(json.length / 4) * 4;
  const binaryLength = Math.ceil(binary.length / 4) * 4;
  const bytes = new Uint8Array(28 + jsonLength + binaryLength).fill(0x20, 20, 20 + jsonLength);
  const view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, jsonLength, 0x4e4f534a].forEach((word, i) =>
    view.setUint32(4 * i, word, true),
  );
  bytes.set(json, 20);
  view.setUint32(20 + jsonLength, binaryLength, true);
  view.setUint32(24 + jsonLength, 0x004e4942, true);
  bytes.set(binary, 28 + jsonLength);
  return bytes;
}

interface Plain {
  buffers: { uri?: string; byteLength: number }[];
  bufferViews: { buffer: number; byteOffset: number; byteLength: number; extensions?: object }[];
  accessors: { bufferView: number; componentType: number; count: number }[];
  meshes: { primitives: { attributes: { POSITION: number }; indices: number; mode?: number }[] }[];
}

/** The geometry that the reader would see: positions and indices of the first primitive. */
function geometryOf({ bytes, resource }: { bytes: Uint8Array; resource: typeof nothing }) {
  const isGlb = bytes[0] === 0x67;
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  const text = new TextDecoder().decode(isGlb ? bytes.subarray(20, 20 + length) : bytes);
  const document = JSON.parse(text) as Plain;
  const bytesBehind = (number: number) => {
    const { buffer, byteOffset, byteLength } =
      document.bufferViews[document.accessors[number]!.bufferView]!;
    const find = resource as (name: string) => Uint8Array | undefined;
    const all = find(document.buffers[buffer]!.uri!)!;
    return all.slice(byteOffset, byteOffset + byteLength).buffer;
  };
  const primitive = document.meshes[0]!.primitives[0]!;
  return {
    document,
    positions: new Float32Array(bytesBehind(primitive.attributes.POSITION)),
    indices: new Uint32Array(bytesBehind(primitive.indices)),
  };
}

const codeOf = async (work: Promise<unknown>) => {
  try {
    await work;
  } catch (error) {
    return (error as { code?: string; message: string }).code;
  }
  return 'nothing was refused';
};
const messageOf = async (work: Promise<unknown>) =>
  work.then(
    () => '',
    (error: unknown) => (error as Error).message,
  );

describe('files without compression', () => {
  test.each([
    ['nothing', new Uint8Array()],
    ['OBJ', new TextEncoder().encode('v 0 0 0\n# KHR_draco_mesh_compression\n')],
    ['broken JSON', new TextEncoder().encode('{"KHR_draco_mesh_compression"')],
    ['glTF', encoded({ asset: { version: '2.0' } })],
    ['a short GLB', glb({ asset: { version: '2.0' } }, new Uint8Array(4)).subarray(0, 21)],
  ])('%s comes back as it is', async (_, bytes) => {
    const unpacked = await unpackIfCompressed(bytes, nothing);
    expect(unpacked.bytes).toBe(bytes);
    expect(unpacked.resource).toBe(nothing);
  });

  test('numbers that no double can hold are left to the reader', async () => {
    const bytes = new TextEncoder().encode('{"extras":1e999}');
    const unpacked = await unpackGltf({ bytes, resource: nothing }, decoders);
    expect(unpacked.bytes).toBe(bytes);
  });
});

describe('meshopt', () => {
  beforeAll(() => MeshoptEncoder.ready);
  const { positions, indices } = grid(20);
  const points = positions.length / 3;

  function packed(name: string, version: number) {
    const vertices = MeshoptEncoder.encodeVertexBufferLevel(
      bytesOf(positions),
      points,
      12,
      2,
      version,
    );
    const corners = MeshoptEncoder.encodeIndexSequence(bytesOf(indices), indices.length, 4);
    const start = Math.ceil(vertices.length / 4) * 4;
    const binary = new Uint8Array(start + corners.length);
    binary.set(vertices);
    binary.set(corners, start);
    const view = (offset: number, length: number, packing: object, byteLength: number) => ({
      buffer: 1,
      byteLength,
      extensions: { [name]: { buffer: 0, byteOffset: offset, byteLength: length, ...packing } },
    });
    const document = {
      asset: { version: '2.0' },
      buffers: [{ byteLength: binary.length }, { byteLength: 1e6 }],
      bufferViews: [
        view(
          0,
          vertices.length,
          { byteStride: 12, count: points, mode: 'ATTRIBUTES', filter: 'NONE' },
          12 * points,
        ),
        view(
          start,
          corners.length,
          { byteStride: 4, count: indices.length, mode: 'INDICES' },
          4 * indices.length,
        ),
      ],
      accessors: [
        { bufferView: 0, componentType: 5126, count: points, type: 'VEC3' },
        { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
      ],
      meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    };
    return { document, binary };
  }

  test.each([
    ['EXT_meshopt_compression', 0],
    ['KHR_meshopt_compression', 1],
  ])('%s is unpacked exactly', async (name, version) => {
    const { document, binary } = packed(name, version);
    const bytes = glb(document, binary);
    const unpacked = geometryOf(
      (await unpackGltf({ bytes, resource: nothing }, decoders)) as Parameters<
        typeof geometryOf
      >[0],
    );
    expect(unpacked.positions).toEqual(positions);
    expect(unpacked.indices).toEqual(indices);
    // Everything else keeps its number.
    expect(unpacked.document.buffers.slice(0, 2)).toEqual(document.buffers);
    expect(unpacked.document.accessors).toEqual(document.accessors);
    expect(unpacked.document.bufferViews[0]!.extensions).toEqual({});
  });

  test('the packed bytes may be in a file or in the document', async () => {
    const { document, binary } = packed('EXT_meshopt_compression', 0);
    const data = `data:application/octet-stream;base64,${Buffer.from(binary).toString('base64')}`;
    for (const uri of ['some%20file.bin', data]) {
      const asked: string[] = [];
      const resource = (name: string) => {
        asked.push(name);
        return binary;
      };
      const [first, second] = document.buffers;
      const bytes = encoded({ ...document, buffers: [{ ...first, uri }, second] });
      const unpacked = await unpackGltf({ bytes, resource }, decoders);
      expect(geometryOf(unpacked as Parameters<typeof geometryOf>[0]).indices).toEqual(indices);
      expect(asked).toEqual(uri === data ? [] : ['some file.bin']);
    }
  });

  test('a missing file is named; names that lead outside are not asked for', async () => {
    const { document } = packed('EXT_meshopt_compression', 0);
    const withUri = (uri: string) =>
      unpackGltf(
        {
          bytes: encoded({ ...document, buffers: [{ byteLength: 10, uri }] }),
          resource: () => {
            if (uri.includes('..')) throw new Error('asked for');
            return undefined;
          },
        },
        decoders,
      );
    expect(await codeOf(withUri('lost.bin'))).toBe('MISSING_RESOURCE');
    expect(await messageOf(withUri('lost.bin'))).toContain('"lost.bin"');
    for (const uri of ['../a.bin', '..%2Fa.bin', 'b/../../a.bin']) {
      expect(await codeOf(withUri(uri))).toBe('MISSING_RESOURCE');
    }
  });

  test('broken streams and claims that do not fit are refused', async () => {
    const { document, binary } = packed('KHR_meshopt_compression', 1);
    const refused = (change: (binary: Uint8Array, view: Record<string, unknown>) => void) => {
      const copy = structuredClone(document);
      const bytes = binary.slice();
      change(bytes, copy.bufferViews[0]!.extensions['KHR_meshopt_compression']!);
      return codeOf(unpackGltf({ bytes: glb(copy, bytes), resource: nothing }, decoders));
    };
    expect(await refused(() => undefined)).toBe('nothing was refused');
    expect(await refused((bytes) => (bytes[0] = 0xa9))).toBe('MALFORMED_FILE');
    expect(await refused((_, view) => (view['count'] = 1e8))).toBe('MALFORMED_FILE');
    expect(await refused((_, view) => (view['byteLength'] = 40))).toBe('MALFORMED_FILE');
    expect(await refused((_, view) => (view['byteStride'] = 10))).toBe('MALFORMED_FILE');
    expect(await refused((_, view) => (view['buffer'] = 9))).toBe('MALFORMED_FILE');
    expect(await refused((_, view) => (view['byteOffset'] = 1e9))).toBe('MALFORMED_FILE');
  });
});

describe('Draco', () => {
  const { positions, indices } = grid(20);
  const points = positions.length / 3;
  let encoders: DracoEncoders;
  beforeAll(async () => {
    encoders = await draco3d.createEncoderModule();
  });

  function stream(method: number): Uint8Array {
    const mesh = new encoders.Mesh();
    const builder = new encoders.MeshBuilder();
    builder.AddFacesToMesh(mesh, indices.length / 3, indices);
    builder.AddFloatAttributeToMesh(mesh, encoders.POSITION, points, 3, positions);
    const encoder = new encoders.Encoder();
    encoder.SetEncodingMethod(method);
    const buffer = new encoders.DracoInt8Array();
    const length = encoder.EncodeMeshToDracoBuffer(mesh, buffer);
    return Uint8Array.from({ length }, (_, i) => buffer.GetValue(i));
  }

  const unpack = (bytes: Uint8Array, count = points, corners = indices.length) =>
    unpackGltf(
      { bytes: glb(dracoDocument(bytes.length, count, corners), bytes), resource: nothing },
      decoders,
    );

  test('without quantisation, in its own order, everything comes back exactly', async () => {
    const unpacked = await unpack(stream(encoders.MESH_SEQUENTIAL_ENCODING));
    const geometry = geometryOf(unpacked as Parameters<typeof geometryOf>[0]);
    expect(geometry.positions).toEqual(positions);
    expect(geometry.indices).toEqual(indices);
  });

  test('edgebreaker gives as many points and corners', async () => {
    const unpacked = await unpack(stream(encoders.MESH_EDGEBREAKER_ENCODING));
    const geometry = geometryOf(unpacked as Parameters<typeof geometryOf>[0]);
    expect(geometry.positions.length).toBe(positions.length);
    expect(geometry.indices.length).toBe(indices.length);
    expect(Math.max(...geometry.positions)).toBe(19);
  });

  test('counts have to agree with the accessors', async () => {
    const bytes = stream(encoders.MESH_EDGEBREAKER_ENCODING);
    expect(await messageOf(unpack(bytes, 7))).toBe(
      '/accessors/0/count: is 7, but its Draco stream holds 400',
    );
    expect(await messageOf(unpack(bytes, 400, 3))).toContain('/accessors/1/count: is 3');
  });

  test('broken streams are refused, and billions of faces before memory is asked for', async () => {
    const bytes = stream(encoders.MESH_EDGEBREAKER_ENCODING);
    expect(await codeOf(unpack(bytes.subarray(0, 9)))).toBe('MALFORMED_FILE');
    expect(await codeOf(unpack(bytes.subarray(0, bytes.length - 20)))).toBe('MALFORMED_FILE');
    const old = bytes.slice();
    old[6] = 1;
    expect(await codeOf(unpack(old))).toBe('UNSUPPORTED_FEATURE');
    const start = [...new TextEncoder().encode('DRACO'), 2, 2, 1, 1, 0, 0, 0];
    const billions = Uint8Array.from([
      ...start,
      ...[3, 255, 255, 255, 255, 7, 0, 1, 0],
      ...Array.from({ length: 20 }, () => 0),
    ]);
    expect(await codeOf(unpack(billions, 3, 3))).toBe('LIMIT_EXCEEDED');
  });
});
