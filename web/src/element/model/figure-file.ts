// A GLB that has its values in it, as the command and the page write it (`write_field.h`): the surface with numbers
// at its vertices, and lines on it. It is read here, without the kernel, so that nothing has to be fetched to show
// it. Whatever is not just so is left to the kernel, which reads any glTF and reports what is wrong.

import type { ContourLine, Loop, LoopKind, Tips } from '../../kernel/types/types.js';
import { findLengthUnit } from '../../kernel/types/length-units.js';

/** Numbers at the vertices, as they are named in the file. */
export interface FigureValues {
  /** `_IGF`, `_TEMPERATURE`. */
  attribute: string;
  /** One for each vertex, in units of metres where the file states the unit; NaN where there is none. */
  values: Float64Array;
  /** The kind of loop behind each value of the girth; empty for all other fields. */
  kinds: Uint8Array;
  /** '' where the file states none; lengths are in metres where it states their unit. */
  unit: string;
  /** The method of their computation, in a word; may be ''. */
  method: string;
}

/** The content of the file. Lengths are in metres where it states their unit. */
export interface FigureFile {
  positions: Float32Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
  /** The fields in the file's order; at least one. */
  fields: FigureValues[];
  loops: Loop[];
  tips: Tips | undefined;
  /** 'metre' where the file states a unit, otherwise ''. */
  unit: string;
  /** The symbol of the unit that the file states; '' for none. */
  ownUnit: string;
}

/** A file that is not just as it has to be. */
class Unfit extends Error {}

function must(holds: unknown): asserts holds {
  if (!holds) throw new Unfit();
}

type Json = Record<string, unknown>;

const objectOf = (value: unknown): Json => {
  must(typeof value === 'object' && value !== null && !Array.isArray(value));
  return value as Json;
};
const optional = (value: unknown): Json => (value === undefined ? {} : objectOf(value));
const listOf = (value: unknown): unknown[] => {
  must(Array.isArray(value));
  return value as unknown[];
};
const numberOf = (value: unknown): number => {
  must(typeof value === 'number' && Number.isFinite(value));
  return value;
};
const countOf = (value: unknown, most: number): number => {
  const number = numberOf(value);
  must(Number.isInteger(number) && number >= 0 && number <= most);
  return number;
};
const textOf = (value: unknown): string => (typeof value === 'string' ? value : '');

const littleEndian = true;
const magic = 0x46546c67;
const chunkKinds = { json: 0x4e4f534a, binary: 0x004e4942 };
const triangles = 4;
const lineStrip = 3;

const components = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const widths: Record<string, number> = { SCALAR: 1, VEC3: 3 };
/** Names of a length's inverse square, as files have them. */
const density = '^-2';

const symbolOf = (name: string): string => findLengthUnit(name)?.symbol ?? '';

/** The document of a GLB and its binary chunk. */
function chunksOf(bytes: ArrayBuffer): { document: Json; binary: ArrayBuffer } {
  const view = new DataView(bytes);
  must(bytes.byteLength >= 28 && view.getUint32(0, littleEndian) === magic);
  must(view.getUint32(4, littleEndian) === 2);
  const jsonLength = view.getUint32(12, littleEndian);
  const binaryAt = 20 + jsonLength;
  must(view.getUint32(16, littleEndian) === chunkKinds.json && jsonLength % 4 === 0);
  must(binaryAt + 8 <= bytes.byteLength);
  const binaryLength = view.getUint32(binaryAt, littleEndian);
  must(view.getUint32(binaryAt + 4, littleEndian) === chunkKinds.binary);
  must(binaryAt + 8 + binaryLength <= bytes.byteLength);
  const text = new TextDecoder().decode(new Uint8Array(bytes, 20, jsonLength));
  const document = objectOf(JSON.parse(text));
  return { document, binary: bytes.slice(binaryAt + 8, binaryAt + 8 + binaryLength) };
}

class Reader {
  readonly #document: Json;
  readonly #binary: ArrayBuffer;

  constructor(bytes: ArrayBuffer) {
    ({ document: this.#document, binary: this.#binary } = chunksOf(bytes));
    must(this.#document['extensionsRequired'] === undefined);
    const buffers = listOf(this.#document['buffers']);
    must(buffers.length === 1 && objectOf(buffers[0])['uri'] === undefined);
  }

  #entry(list: string, index: unknown): Json {
    const entries = listOf(this.#document[list]);
    return objectOf(entries[countOf(index, entries.length - 1)]);
  }

  /** The numbers of an accessor, packed. */
  numbers(index: unknown, type: 'SCALAR' | 'VEC3') {
    const accessor = this.#entry('accessors', index);
    must(accessor['type'] === type && accessor['sparse'] === undefined);
    const kind = countOf(accessor['componentType'], 1e4) as keyof typeof components;
    const Array = components[kind];
    must(Array && !accessor['normalized']);
    const view = this.#entry('bufferViews', accessor['bufferView']);
    const width = widths[type]!;
    const bytes = width * Array.BYTES_PER_ELEMENT;
    must(view['buffer'] === 0 && (view['byteStride'] ?? bytes) === bytes);
    const most = this.#binary.byteLength;
    const count = countOf(accessor['count'], most / bytes);
    const within = countOf(accessor['byteOffset'] ?? 0, most);
    const begin = countOf(view['byteOffset'] ?? 0, most) + within;
    must(within + count * bytes <= countOf(view['byteLength'], most));
    must(begin + count * bytes <= most);
    return new Array(this.#binary.slice(begin, begin + count * bytes));
  }

  /** Numbers of 32 bits. */
  floats(index: unknown, type: 'SCALAR' | 'VEC3'): Float32Array {
    const numbers = this.numbers(index, type);
    must(numbers instanceof Float32Array && numbers.every(Number.isFinite));
    return numbers;
  }

  /** The primitives of the scene that is shown, with how their nodes scale them. */
  primitives(): { primitive: Json; extras: Json; scale: number }[] {
    const scene = this.#entry('scenes', this.#document['scene'] ?? 0);
    return listOf(scene['nodes']).map((index) => {
      const node = this.#entry('nodes', index);
      for (const other of ['children', 'matrix', 'rotation', 'translation', 'skin']) {
        must(node[other] === undefined);
      }
      const [x = 1, y = x, z = x] = listOf(node['scale'] ?? [1, 1, 1]).map(numberOf);
      must(x > 0 && x === y && x === z);
      const mesh = this.#entry('meshes', node['mesh']);
      const primitives = listOf(mesh['primitives']);
      must(primitives.length === 1);
      const primitive = objectOf(primitives[0]);
      must(primitive['extensions'] === undefined && primitive['targets'] === undefined);
      return { primitive, extras: optional(mesh['extras']), scale: x };
    });
  }
}

type Primitive = ReturnType<Reader['primitives']>[number];

const modeOf = ({ primitive }: Primitive): unknown => primitive['mode'] ?? triangles;

/**
 * The surface and values of a GLB; undefined for one without values, and for all that the kernel
 * has to look at.
 */
export function readFigure(bytes: ArrayBuffer): FigureFile | undefined {
  try {
    return figureOf(new Reader(bytes));
  } catch {
    return undefined;
  }
}

function figureOf(reader: Reader): FigureFile {
  const all = reader.primitives();
  const surfaces = all.filter((one) => modeOf(one) === triangles);
  const lines = all.filter((one) => modeOf(one) === lineStrip);
  must(surfaces.length === 1 && lines.length === all.length - 1);
  const [surface] = surfaces as [Primitive];
  const { scale, extras } = surface;
  const attributes = objectOf(surface.primitive['attributes']);
  const positions = scaled(reader.floats(attributes['POSITION'], 'VEC3'), scale);
  const vertexCount = positions.length / 3;
  const indices = Uint32Array.from(reader.numbers(surface.primitive['indices'], 'SCALAR'));
  must(indices.length > 0 && indices.length % 3 === 0);
  must(indices.every((vertex) => vertex < vertexCount));

  const ownUnit = symbolOf(textOf(extras['unit']));
  // Files of other programs that say nothing of units are in metres, by the rules of glTF.
  const unit = ownUnit || extras['unit'] === undefined ? 'metre' : '';
  const abouts = optional(extras['fields']);
  const names = Object.keys(attributes).filter(
    (name) => /^_\w{1,60}$/.test(name) && (name !== '_KIND' || !('_IGF' in attributes)),
  );
  const fields = names.map((attribute): FigureValues => {
    const about = optional(abouts[attribute]);
    const said = textOf(about['unit']);
    const isLength = symbolOf(said) !== '';
    const isDensity = said.endsWith(density) && symbolOf(said.slice(0, -3)) !== '';
    const factor = isLength ? scale : isDensity ? scale ** -2 : 1;
    const raw = reader.floats(attributes[attribute], 'SCALAR');
    must(raw.length === vertexCount);
    // glTF has no NaN: where a field is not complete, -1 stands for no value.
    const isWhole = about['complete'] !== false;
    const values = Float64Array.from(raw, (value) =>
      !isWhole && value === -1 ? NaN : factor * value,
    );
    const unit = isLength ? 'metre' : isDensity ? 'metre^-2' : said;
    const isGirth = attribute === '_IGF' && '_KIND' in attributes;
    const kinds = isGirth
      ? kindsOf(reader.floats(attributes['_KIND'], 'SCALAR'), vertexCount)
      : new Uint8Array(0);
    return { attribute, values, kinds, unit, method: textOf(about['method']) };
  });
  must(fields.length > 0);

  return {
    ...{ positions, indices, fields, unit, ownUnit },
    ...linesOf(reader, surface, lines, unit),
  };
}

function kindsOf(numbers: Float32Array, vertexCount: number): Uint8Array {
  must(numbers.length === vertexCount && numbers.every((kind) => [-1, 0, 1, 2].includes(kind)));
  // Vertices without a value have the kind 0, as in the kernel.
  return Uint8Array.from(numbers, (kind) => Math.max(0, kind));
}

/** Positions in metres: rounded once, as the kernel does it. */
function scaled(positions: Float32Array, scale: number): Float32Array<ArrayBuffer> {
  return Float32Array.from(positions, (coordinate) => scale * coordinate);
}

function linesOf(
  reader: Reader,
  { extras, scale, primitive }: Primitive,
  lines: readonly Primitive[],
  unit: string,
): Pick<FigureFile, 'loops' | 'tips'> {
  const most = reader.numbers(objectOf(primitive['attributes'])['POSITION'], 'VEC3').length / 3 - 1;
  const loops: Loop[] = [];
  const tips = extras['tips'] === undefined ? undefined : tipsOf(extras, scale, most);
  for (const { primitive, extras, scale: own } of lines) {
    must(own === scale && primitive['indices'] === undefined);
    const polyline = scaled(
      reader.floats(objectOf(primitive['attributes'])['POSITION'], 'VEC3'),
      scale,
    );
    must(polyline.length >= 6);
    if (extras['loop'] !== undefined) {
      const loop = objectOf(extras['loop']);
      const kind = textOf(loop['kind']) as LoopKind;
      must(kind === 'loop' || kind === 'antipodal');
      const [x, y, z] = listOf(loop['midpoint']).map((coordinate) => scale * numberOf(coordinate));
      must(z !== undefined);
      loops.push({
        ...{ kind, polyline, unit, points: [], midpoint: [x!, y!, z] },
        length: scale * numberOf(loop['length']),
        base: countOf(loop['vertex'], most),
        angle: numberOf(loop['angle']),
      });
    } else if (extras['contour'] !== undefined) {
      const contour = objectOf(extras['contour']);
      const tip = tips?.tips[countOf(contour['tip'], most)];
      must(tip);
      tip.contour.push(contourOf(polyline, contour['closed'] === true));
    } else if (extras['arc'] !== undefined && tips) {
      const arc = objectOf(extras['arc']);
      const [length, jump] = [arc['length'], arc['jump']].map((one) => scale * numberOf(one));
      tips.arcs.push({ line: contourOf(polyline, false), length: length!, jump: jump! });
    } else {
      throw new Unfit();
    }
  }
  return { loops, tips };
}

/** Closed lines end in the file where they begin. */
const contourOf = (polyline: Float32Array, closed: boolean): ContourLine => ({
  closed,
  polyline: closed ? polyline.subarray(0, -3) : polyline,
});

function tipsOf(extras: Json, scale: number, most: number): Tips {
  const tips = listOf(extras['tips']).map((one) => {
    const tip = objectOf(one);
    const length = (name: string): number => scale * numberOf(tip[name]);
    return {
      vertices: Uint32Array.from(listOf(tip['vertices']), (vertex) => countOf(vertex, most)),
      contour: [],
      area: scale * length('area'),
      boundaryLength: length('boundaryLength'),
      apex: countOf(tip['apex'], most),
      apexDistance: length('apexDistance'),
      jump: length('jump'),
    };
  });
  return { tips, arcs: [], crossedEdges: countOf(extras['crossedEdges'], 2 ** 32) };
}
