// Files that have their values in them: what is read of them, and that nothing else is taken for one.

import { expect, test } from 'vitest';
import { readFigure } from '../../../web/src/element/model/figure-file.js';
import { givenFields, carriedTo } from '../../../web/src/element/model/given-fields.js';
import { glbWith } from '../../browser/glb.js';
import { box } from '../../browser/meshes.js';

const values = { _IGF: (v: number) => v / 4, _HEAT: (v: number) => 20 - v, COLOR_9: () => 1 };
const whole = glbWith(box(1, 1, 1), values);

/** The file with its document changed. */
function changed(change: (document: Json) => void): ArrayBuffer {
  const view = new DataView(whole.buffer);
  const length = view.getUint32(12, true);
  const document = JSON.parse(new TextDecoder().decode(whole.subarray(20, 20 + length))) as Json;
  change(document);
  const text = JSON.stringify(document);
  const bytes = new TextEncoder().encode(text.padEnd(4 * Math.ceil(text.length / 4)));
  const file = new Uint8Array(20 + bytes.length + whole.length - 20 - length);
  file.set(whole.subarray(0, 20));
  new DataView(file.buffer).setUint32(12, bytes.length, true);
  file.set(bytes, 20);
  file.set(whole.subarray(20 + length), 20 + bytes.length);
  return file.buffer;
}
interface Json {
  [name: string]: unknown;
  accessors: Record<string, unknown>[];
  bufferViews: Record<string, unknown>[];
  meshes: { primitives: { attributes: Record<string, unknown> }[]; extras?: unknown }[];
  nodes: Record<string, unknown>[];
}

test('surface and values, by the names of their attributes; other attributes are left alone', () => {
  const figure = readFigure(whole.buffer)!;
  expect(figure.positions).toHaveLength(24);
  expect(figure.indices).toHaveLength(36);
  expect(figure.unit).toBe('metre');
  expect(figure.fields.map(({ attribute }) => attribute)).toEqual(['_IGF', '_HEAT']);
  expect([...figure.fields[0]!.values]).toEqual([0, 0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75]);
  const fields = givenFields(figure.fields);
  expect(fields.map(({ name, range }) => [name, range])).toEqual([
    ['igf', [0, 1.75]],
    ['_heat', [13, 20]],
  ]);
  // The first vertex of the file that became a vertex of the surface gives its value.
  const carried = carriedTo(fields, Uint32Array.of(7, 6, 5, 4, 3, 2, 1, 0), 8);
  expect([...carried[1]!.values]).toEqual([13, 14, 15, 16, 17, 18, 19, 20]);
  expect(carriedTo(fields, Uint32Array.of(0, 1, 2, 3, 4, 5, 6, 6), 8)).toEqual([]);
});

test('units: lengths become metres, and what has no value has none', () => {
  const file = changed(({ meshes, nodes }) => {
    nodes[0]!['scale'] = [0.001, 0.001, 0.001];
    const about = { unit: 'millimetre', method: 'exact', complete: false };
    meshes[0]!.extras = { unit: 'millimetre', fields: { _IGF: about } };
    // The heat is -1 at vertex 21, which there is not, and stands for itself where it is whole.
  });
  const { unit, ownUnit, fields, positions } = readFigure(file)!;
  expect([unit, ownUnit]).toEqual(['metre', 'mm']);
  expect(fields[0]!.unit).toBe('metre');
  expect(fields[0]!.values[4]).toBe(0.001);
  expect(Math.max(...positions)).toBeLessThan(0.01);
  expect(fields[1]!.values[4]).toBe(16);
  const unknown = readFigure(
    changed(({ meshes }) => (meshes[0]!.extras = { unit: '', fields: {} })),
  )!;
  expect([unknown.unit, unknown.ownUnit]).toEqual(['', '']);
  const absent = glbWith(box(1, 1, 1), { _IGF: (v) => (v === 3 ? -1 : 2) });
  expect(readFigure(absent.buffer)!.fields[0]!.values[3]).toBe(-1);
});

test('what is not just so is left to the kernel', () => {
  const wrong: Record<string, (document: Json) => void> = {
    'a compressed one': (document) =>
      (document['extensionsRequired'] = ['EXT_meshopt_compression']),
    'no values': ({ meshes }) => {
      meshes[0]!.primitives[0]!.attributes = { POSITION: 0 };
    },
    'a buffer elsewhere': (document) => (document['buffers'] = [{ uri: 'x.bin', byteLength: 9 }]),
    'a turned node': ({ nodes }) => (nodes[0]!['rotation'] = [0, 1, 0, 0]),
    'a flattened node': ({ nodes }) => (nodes[0]!['scale'] = [1, 1, 0]),
    'a node without a mesh': ({ nodes }) => (nodes[0]!['mesh'] = 3),
    'too many numbers': ({ accessors }) => (accessors[0]!['count'] = 1e9),
    'a negative count': ({ accessors }) => (accessors[0]!['count'] = -1),
    'a view beyond the end': ({ bufferViews }) => (bufferViews[1]!['byteOffset'] = 1e6),
    'half a number': ({ accessors }) => (accessors[0]!['count'] = 7.5),
    'fewer values': ({ accessors }) => (accessors[2]!['count'] = 7),
    'a strange type': ({ accessors }) => (accessors[2]!['componentType'] = 1),
    'no scene': (document) => (document['scenes'] = []),
    'a list that is none': (document) => (document.meshes = {} as never),
  };
  for (const [what, change] of Object.entries(wrong)) {
    expect(readFigure(changed(change)), what).toBeUndefined();
  }
  // Indices beyond the vertices.
  const beyond = whole.slice();
  const binary = 28 + new DataView(whole.buffer).getUint32(12, true);
  new DataView(beyond.buffer).setUint32(binary + 8 * 12, 99, true);
  expect(readFigure(beyond.buffer)).toBeUndefined();
});

test('cut short anywhere, and with any byte changed, it is read or it is not', () => {
  for (let length = 0; length < whole.length; length += 7) {
    expect(readFigure(whole.slice(0, length).buffer)).toBeUndefined();
  }
  let state = 1;
  for (let i = 0; i < 3000; ++i) {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    const damaged = whole.slice();
    damaged[state % whole.length] = state >>> 24;
    const figure = readFigure(damaged.buffer);
    if (!figure) continue;
    const count = figure.positions.length / 3;
    expect(figure.indices.every((vertex) => vertex < count)).toBe(true);
    expect(figure.fields.every(({ values }) => values.length === count)).toBe(true);
  }
});
