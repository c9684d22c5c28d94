// Small files of every format for the fuzzers to begin with, made here. `seeds.mjs FOLDER` writes
// FOLDER/NAME/... for each fuzz_NAME.cpp.

import { Buffer } from 'node:buffer';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { deflateRawSync, gzipSync } from 'node:zlib';
import draco3d from 'draco3dgltf';
import { MeshoptEncoder } from 'meshoptimizer';

/** A tetrahedron. */
const points = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const triangles = [
  [0, 2, 1],
  [0, 1, 3],
  [0, 3, 2],
  [1, 2, 3],
];
const vertexLines = points.map((p) => `${p.join(' ')}\n`).join('');
const faceLines = triangles.map((t) => `3 ${t.join(' ')}\n`).join('');

/** @typedef {'u8' | 'u16' | 'u32' | 'f32' | 'f64'} Type */

/**
 * Numbers as bytes.
 * @param {[Type, number[]][]} parts
 * @param {{ big?: boolean }} [order]
 */
function packed(parts, { big = false } = {}) {
  const sizes = { u8: 1, u16: 2, u32: 4, f32: 4, f64: 8 };
  const length = parts.reduce((sum, [type, numbers]) => sum + sizes[type] * numbers.length, 0);
  const bytes = Buffer.alloc(length);
  const view = new DataView(bytes.buffer, bytes.byteOffset, length);
  let at = 0;
  for (const [type, numbers] of parts) {
    for (const number of numbers) {
      if (type === 'u8') view.setUint8(at, number);
      if (type === 'u16') view.setUint16(at, number, !big);
      if (type === 'u32') view.setUint32(at, number, !big);
      if (type === 'f32') view.setFloat32(at, number, !big);
      if (type === 'f64') view.setFloat64(at, number, !big);
      at += sizes[type];
    }
  }
  return bytes;
}

/** @param {(string | Uint8Array)[]} parts */
const joined = (...parts) => Buffer.concat(parts.map((part) => Buffer.from(part)));

/** @type {Record<string, string | Uint8Array>} */
const obj = {
  triangles:
    points.map((p) => `v ${p.join(' ')}\n`).join('') + 'f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n',
  negative: 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n',
  early: 'f 1/1/1 2//2 3/3\nv 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 2\n',
  concave: 'v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n',
  quadrilaterals: 'v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n',
  continued: 'v 0 0 \\\n0\nv 1e-3 +.5 -5.\nv 1 2 3\n# a comment\\\ng a b\nf 1 \\\r\n2 3\r\n',
  textured: 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nf 1/1 2/2 4/-1 3/9\n',
  others: 'mtllib a.mtl\no a\nvt 0 0\nvn 0 0 1\nusemtl b\ns off\nl 1 2\np 1\ncurv 0 1 1 2\n',
};

/**
 * A PLY file's header.
 * @param {string} format
 * @param {string} [scalar]
 */
const plyHeader = (format, scalar = 'float') =>
  `ply\nformat ${format} 1.0\ncomment seed\nelement vertex 4\nproperty ${scalar} x\n` +
  `property ${scalar} y\nproperty ${scalar} z\nelement face 4\n` +
  'property list uchar int vertex_indices\nend_header\n';

/** @param {boolean} big */
const plyBody = (big) =>
  packed(
    [
      ['f32', points.flat()],
      ...triangles.flatMap(
        (t) =>
          /** @type {[Type, number[]][]} */ ([
            ['u8', [3]],
            ['u32', t],
          ]),
      ),
    ],
    { big },
  );

/** @type {Record<string, string | Uint8Array>} */
const ply = {
  ascii: plyHeader('ascii') + vertexLines + faceLines,
  little: joined(plyHeader('binary_little_endian'), plyBody(false)),
  big: joined(plyHeader('binary_big_endian').replaceAll('\n', '\r\n'), plyBody(true)),
  double: joined(
    plyHeader('binary_little_endian', 'double'),
    packed([['f64', points.flat()]]),
    plyBody(false).subarray(48),
  ),
  lists:
    'ply\nformat ascii 1.0\nobj_info a\nelement other 1\nproperty list uint8 double a\n' +
    'element face 1\nproperty uint8 flags\nproperty list int8 uint16 vertex_index\n' +
    'property list uchar float texcoord\nelement vertex 3\nproperty int16 x\nproperty float64 y\n' +
    'property list short ushort b\nproperty char z\nend_header\n2 0.5 1e9\n7 3 0 1 2 1 0.5\n' +
    '0 0 0 0\n1 0 1 5 0\n0 1 2 6 7 0\n',
  strips:
    'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n' +
    'property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n' +
    `${vertexLines}9 0 1 2 3 -1 1 2 3 0\n`,
  undeclared: plyHeader('ascii') + vertexLines + faceLines.replaceAll('\n', ' 3 255 0 0\n'),
  splats:
    'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n' +
    'property float z\nproperty float opacity\nproperty float scale_0\nproperty float rot_0\n' +
    'end_header\n0 0 0 1 1 1\n',
  points:
    'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n' +
    `property float z\nend_header\n${vertexLines}`,
};

const facets = triangles.map(
  (t) =>
    'facet normal 0 0 1\n  outer loop\n' +
    t.map((v) => `    vertex ${(points[v] ?? []).join(' ')}\n`).join('') +
    '  endloop\nendfacet\n',
);

/** @param {string} begin */
const binaryStl = (begin) =>
  joined(
    begin.padEnd(80),
    packed([
      ['u32', [triangles.length]],
      ...triangles.flatMap(
        (t) =>
          /** @type {[Type, number[]][]} */ ([
            ['f32', [0, 0, 0, ...t.flatMap((v) => points[v] ?? [])]],
            ['u16', [0]],
          ]),
      ),
    ]),
  );

/** @type {Record<string, string | Uint8Array>} */
const stl = {
  ascii: `solid seed\n${facets.join('')}endsolid seed\n`,
  capitals: `SOLID A\n${facets.join('').toUpperCase()}ENDSOLID\nsolid b\nendsolid b\n`,
  square:
    'solid\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n',
  behind: `solid\n${facets.join('').replaceAll('endfacet', 'endfacet part 7')}endsolid\n`,
  binary: binaryStl('seed'),
  solid: binaryStl('solid'),
  trailing: joined(binaryStl('seed'), 'more'),
};

/** @type {Record<string, string | Uint8Array>} */
const off = {
  ascii: `OFF\n4 4 6\n${vertexLines}${faceLines}`,
  comments: `# a\nOFF 4 4 # b\n${vertexLines}${faceLines.replaceAll('\n', ' 255 0 0 # red\n')}`,
  homogeneous: `4OFF\n4 4 0\n${points.map((p) => `${p.join(' ')} 2\n`).join('')}${faceLines}`,
  everything: 'STCN4OFF\n1 1 0\n0 0 0 1 0 0 1 1 1 1 1 0 0\n3 0 0 0\n',
  bare: `4 4 6\n${vertexLines}${faceLines}`,
  polygons: 'OFF\n5 3 0\n0 0 0\n4 0 0\n4 4 0\n2 1 0\n0 4 0\n5 0 1 2 3 4\n2 0 1\n1 0\n',
  binary: joined(
    'OFF BINARY\n',
    packed(
      [
        ['u32', [4, 4, 6]],
        ['f32', points.flat()],
        ['u32', triangles.flatMap((t) => [3, ...t, 0])],
      ],
      { big: true },
    ),
  ),
};

const buffer = packed([
  ['f32', points.flat()],
  ['u16', triangles.flat()],
]);

/**
 * The tetrahedron as a glTF document.
 * @param {Record<string, unknown>} [changes] top-level members
 * @param {Record<string, unknown>} [primitive] members of the primitive
 */
const document = (changes = {}, primitive = {}) => ({
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0 }],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1, ...primitive }] }],
  accessors: [
    { bufferView: 0, componentType: 5126, count: 4, type: 'VEC3' },
    { bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR' },
  ],
  bufferViews: [
    { buffer: 0, byteLength: 48 },
    { buffer: 0, byteOffset: 48, byteLength: 24 },
  ],
  buffers: [{ byteLength: buffer.length }],
  ...changes,
});

/** @type {Record<string, object>} */
const documents = {
  plain: document(),
  nodes: document({
    nodes: [
      { children: [1, 2], scale: [-1, 2, 1], rotation: [0, 0, 0.7071, 0.7071] },
      { mesh: 0, translation: [1, 2, 3] },
      { mesh: 0, matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1] },
    ],
  }),
  strip: document({}, { mode: 5 }),
  fan: document({}, { mode: 6, indices: undefined }),
  lines: document({}, { mode: 1 }),
  sparse: document({
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: 4,
        type: 'VEC3',
        sparse: {
          count: 1,
          indices: { bufferView: 1, componentType: 5123 },
          values: { bufferView: 0 },
        },
      },
      { bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR' },
    ],
  }),
  quantized: document({
    extensionsUsed: ['KHR_mesh_quantization'],
    extensionsRequired: ['KHR_mesh_quantization'],
    accessors: [
      { bufferView: 0, componentType: 5122, normalized: true, count: 6, type: 'VEC3' },
      { bufferView: 1, componentType: 5121, count: 6, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteLength: 48, byteStride: 8 },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
    ],
  }),
  morphed: document({}, { targets: [{ POSITION: 0 }] }),
  skinned: document({
    nodes: [{ mesh: 0, skin: 0 }, { translation: [0, 0, 1] }],
    skins: [{ joints: [1] }],
    scenes: [{ nodes: [0, 1] }],
  }),
  instanced: document({
    extensionsUsed: ['EXT_mesh_gpu_instancing'],
    nodes: [
      { mesh: 0, extensions: { EXT_mesh_gpu_instancing: { attributes: { TRANSLATION: 0 } } } },
    ],
  }),
  attributes: document(
    {
      accessors: [
        { bufferView: 0, componentType: 5126, count: 4, type: 'VEC3' },
        { bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR' },
        { bufferView: 0, componentType: 5121, normalized: true, count: 4, type: 'VEC4' },
        { bufferView: 0, componentType: 5126, count: 4, type: 'VEC2' },
        { bufferView: 0, componentType: 5126, count: 4, type: 'SCALAR' },
      ],
      materials: [{ pbrMetallicRoughness: { baseColorFactor: [1, 0.5, 0.25, 1] } }],
    },
    { attributes: { POSITION: 0, COLOR_0: 2, TEXCOORD_0: 3, _A: 4 }, material: 0 },
  ),
  draco: document(
    { extensionsUsed: ['KHR_draco_mesh_compression'] },
    {
      extensions: {
        KHR_draco_mesh_compression: { bufferView: 0, attributes: { POSITION: 0 } },
      },
    },
  ),
  meshopt: document({
    extensionsUsed: ['EXT_meshopt_compression'],
    bufferViews: [
      {
        buffer: 0,
        byteLength: 48,
        extensions: {
          EXT_meshopt_compression: {
            buffer: 0,
            byteLength: 48,
            byteStride: 12,
            count: 4,
            mode: 'ATTRIBUTES',
          },
        },
      },
      { buffer: 0, byteOffset: 48, byteLength: 24 },
    ],
  }),
  cycle: document({ nodes: [{ mesh: 0, children: [0] }] }),
  old: { asset: { version: '1.0' }, meshes: {} },
};

/** The tetrahedron's positions and triangles in one buffer, compressed by Draco. */
async function dracoBuffer() {
  const draco = await draco3d.createEncoderModule();
  const mesh = new draco.Mesh();
  const builder = new draco.MeshBuilder();
  builder.AddFacesToMesh(mesh, triangles.length, new Uint32Array(triangles.flat()));
  builder.AddFloatAttributeToMesh(
    mesh,
    draco.POSITION,
    points.length,
    3,
    new Float32Array(points.flat()),
  );
  const encoded = new draco.DracoInt8Array();
  const length = new draco.Encoder().EncodeMeshToDracoBuffer(mesh, encoded);
  return Buffer.from(Array.from({ length }, (_, i) => encoded.GetValue(i)));
}

/** Buffers by meshopt, one after the other, each from a multiple of four bytes on. */
async function meshoptBuffers() {
  await MeshoptEncoder.ready;
  return /** @type {const} */ ([
    [buffer.subarray(0, 48), 4, 12, 'ATTRIBUTES'],
    [buffer.subarray(48), 12, 2, 'TRIANGLES'],
    [buffer.subarray(48), 12, 2, 'INDICES'],
  ]).map(([bytes, count, byteStride, mode]) => ({
    count,
    byteStride,
    mode,
    bytes: MeshoptEncoder.encodeGltfBuffer(bytes, count, byteStride, mode),
  }));
}

/**
 * Documents whose geometry is really compressed, each with its buffer.
 * @returns {Promise<Record<string, { json: object, binary: Uint8Array }>>}
 */
async function compressed() {
  const binary = await dracoBuffer();
  const [attributes, ...indices] = await meshoptBuffers();
  if (!attributes) throw new Error('seeds: nothing was encoded');
  const begin = 4 * Math.ceil(attributes.bytes.length / 4);
  /** @type {Record<string, { json: object, binary: Uint8Array }>} */
  const all = {
    'draco-real': {
      json: document(
        {
          extensionsUsed: ['KHR_draco_mesh_compression'],
          extensionsRequired: ['KHR_draco_mesh_compression'],
          accessors: [
            { componentType: 5126, count: 4, type: 'VEC3' },
            { componentType: 5125, count: 12, type: 'SCALAR' },
          ],
          bufferViews: [{ buffer: 0, byteLength: binary.length }],
          buffers: [{ byteLength: binary.length }],
        },
        {
          extensions: {
            KHR_draco_mesh_compression: { bufferView: 0, attributes: { POSITION: 0 } },
          },
        },
      ),
      binary,
    },
  };
  for (const [number, index] of indices.entries()) {
    const both = Buffer.alloc(begin + index.bytes.length);
    both.set(attributes.bytes);
    both.set(index.bytes, begin);
    const extension = number === 0 ? 'EXT_meshopt_compression' : 'KHR_meshopt_compression';
    /** @param {typeof attributes} part @param {number} byteOffset */
    const view = ({ bytes, count, byteStride, mode }, byteOffset) => ({
      buffer: 1,
      byteLength: count * byteStride,
      extensions: {
        [extension]: { buffer: 0, byteOffset, byteLength: bytes.length, byteStride, count, mode },
      },
    });
    all[`meshopt-real-${number}`] = {
      json: document({
        extensionsUsed: [extension],
        extensionsRequired: [extension],
        bufferViews: [view(attributes, 0), view(index, begin)],
        buffers: [
          { byteLength: both.length },
          { byteLength: 72, extensions: { [extension]: { fallback: true } } },
        ],
      }),
      binary: both,
    };
  }
  return all;
}

/** @param {object} json @param {Uint8Array} binary */
function glb(json, binary) {
  const text = JSON.stringify(json);
  const padded = text.padEnd(4 * Math.ceil(text.length / 4));
  const header = packed([['u32', [2, 28 + padded.length + binary.length, padded.length]]]);
  return joined(
    'glTF',
    header,
    'JSON',
    padded,
    packed([['u32', [binary.length]]]),
    'BIN\0',
    binary,
  );
}

/** @type {(change: (json: object) => string | Uint8Array) => Record<string, string | Uint8Array>} */
const fromDocuments = (change) =>
  Object.fromEntries(Object.entries(documents).map(([name, json]) => [name, change(json)]));

const gltf = fromDocuments((json) => {
  const uri = `data:application/octet-stream;base64,${buffer.toString('base64')}`;
  return JSON.stringify({ ...json, buffers: [{ byteLength: buffer.length, uri }] });
});
gltf.beside = JSON.stringify(document({ buffers: [{ byteLength: 72, uri: 'a%20b.bin' }] }));
gltf.absent = JSON.stringify(document({ buffers: [{ byteLength: 72, uri: '../a.bin' }] }));

const glbs = fromDocuments((json) => glb(json, buffer));
for (const [name, { json, binary }] of Object.entries(await compressed())) {
  glbs[name] = glb(json, Buffer.concat([binary], 4 * Math.ceil(binary.length / 4)));
  const uri = `data:;base64,${Buffer.from(binary).toString('base64')}`;
  const { buffers, ...rest } = /** @type {{ buffers: object[] }} */ (json);
  const [first, ...others] = buffers;
  gltf[name] = JSON.stringify({ ...rest, buffers: [{ ...first, uri }, ...others] });
}

/** @type {Record<string, Record<string, string | Uint8Array>>} */
const seeds = { obj, ply, stl, off, gltf, glb: glbs };

// The first byte is the fuzzer's: which name, what is asked of the preparation.
/** @type {Record<string, Uint8Array>} */
const mesh = {};
Object.entries(seeds).forEach(([format, files]) => {
  Object.entries(files).forEach(([name, content], number) => {
    mesh[`${format}-${name}`] = joined(Buffer.of(8 * (number % 8)), content);
  });
});
seeds.mesh = {
  ...mesh,
  fan: '\x08v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n',
  twice: '\x00v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\nf 3 2 1\nf 1 1 2\n',
  needle: '\x10v 0 0 0\nv 1 0 0\nv 2 0 0\nv 1 1 0\nv 1 -1 0\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 1 3 5\n',
  strip:
    '\x00v 0 0 0\nv 1 0 0\nv 2 0 1\nv 0 1 0\nv 1 1 0\nv 2 1 1\nf 1 2 5 4\nf 2 3 6 5\nf 3 4 1 6\n',
};

/**
 * A zip of one file, whose directory may claim another size; `wide`: with numbers of 64 bits.
 * @param {string} name
 * @param {Buffer} content
 * @param {{ method?: number, claimed?: number, wide?: boolean }} [how]
 */
function zip(name, content, { method = 8, claimed = content.length, wide = false } = {}) {
  const data = method === 8 ? deflateRawSync(content) : content;
  /** @type {[Type, number[]][]} */
  const about = [
    ['u16', [20, 0, method, 0, 0]],
    ['u32', [crc32(content), data.length, wide ? 0xffffffff : claimed]],
    ['u16', [name.length, wide ? 12 : 0]],
  ];
  const extra = packed(
    wide
      ? [
          ['u16', [1, 8]],
          ['u32', [claimed, 0]],
        ]
      : [],
  );
  const file = joined('PK\x03\x04', packed(about), name, extra, data);
  const entry = joined(
    ...['PK\x01\x02', packed([['u16', [20]], ...about])],
    ...[packed([['u16', [0, 0, 0, 0, 0, 0, 0]]]), name, extra],
  );
  const end = packed([
    ['u16', [0, 0, 1, 1]],
    ['u32', [entry.length, file.length]],
    ['u16', [0]],
  ]);
  return joined(file, entry, 'PK\x05\x06', end);
}

/**
 * CRC-32 by its definition, bit by bit.
 * @param {Uint8Array} bytes
 */
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  }
  return ~crc >>> 0;
}

const text = Buffer.from(obj.triangles ?? '');
seeds.archive = {
  gzip: gzipSync(text),
  members: joined(gzipSync(text), gzipSync(text)),
  cut: gzipSync(text).subarray(0, 40),
  zeros: gzipSync(Buffer.alloc(1 << 23)),
  deflated: zip('a/b.obj', text),
  stored: zip('b.obj', text, { method: 0 }),
  wide: zip('b.obj', text, { wide: true }),
  outside: zip('../b.obj', text),
  claims: zip('b.obj', text, { claimed: 1 << 20 }),
};

const folder = process.argv[2];
if (!folder) throw new Error('seeds: name a folder');
for (const [target, files] of Object.entries(seeds)) {
  mkdirSync(join(folder, target), { recursive: true });
  for (const [name, content] of Object.entries(files)) {
    writeFileSync(join(folder, target, name), content);
  }
}
