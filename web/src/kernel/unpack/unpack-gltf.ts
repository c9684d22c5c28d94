// Rewrites a compressed glTF document: packed buffer views and primitives refer to a new buffer with the
// unpacked bytes, the last one in the list of buffers. All else stays. This is written here because
// libraries that read and write whole documents renumber their elements, drop what they do not know, and
// refuse documents that the reader takes.

import type { DracoModule } from '../wasm/draco-decoder.mjs';
import type { MeshoptDecoder } from '../wasm/meshopt-decoder.mjs';
import { failure } from '../types/errors.js';
import { UnpackBudget } from './unpack-budget.js';
import { UnpackedDraco } from './unpack-draco.js';
import { unpackMeshopt } from './unpack-meshopt.js';

/** Returns a file that a model refers to by a relative name; undefined where there is none. */
export type Resource = (name: string) => Uint8Array | undefined;

export interface ModelBytes {
  bytes: Uint8Array;
  resource: Resource;
}

/** Where the decoders come from. */
export interface Decoders {
  /** An instance for one file. */
  draco(): Promise<DracoModule>;
  meshopt(): Promise<typeof MeshoptDecoder>;
}

type Members = Record<string, unknown>;

interface BufferView extends Members {
  buffer?: number;
  byteOffset?: number;
  byteLength?: number;
}

interface Accessor extends Members {
  bufferView?: number;
  componentType: number;
  count: number;
  type: string;
}

const dracoName = 'KHR_draco_mesh_compression';
/** Where a view has both, the first counts. */
const meshoptNames = ['KHR_meshopt_compression', 'EXT_meshopt_compression'];
const componentsOf: Record<string, number> = { VEC3: 3, VEC4: 4 };
const triangles = 4;
const unsignedInt = 5125;

const isObject = (value: unknown): value is Members =>
  typeof value === 'object' && value !== null && !Array.isArray(value);
const isCount = (value: unknown): value is number =>
  typeof value === 'number' && Number.isSafeInteger(value) && value >= 0;
const objects = (value: unknown): Members[] =>
  Array.isArray(value) ? value.filter((element) => isObject(element)) : [];
const extensionOf = (element: Members, name: string): Members | undefined => {
  const extensions = element['extensions'];
  const extension = isObject(extensions) ? extensions[name] : undefined;
  return isObject(extension) ? extension : undefined;
};
const malformed = (place: string, what: string) => failure('MALFORMED_FILE', `${place}: ${what}`);

/** The document with its compressed geometry unpacked. Throws the errors of the reader. */
export async function unpackGltf(model: ModelBytes, decoders: Decoders): Promise<ModelBytes> {
  const parts = partsOf(model.bytes);
  // The reader refuses invalid documents, and states where.
  if (!parts || !isObject(parts.document)) return model;
  const unpacking = new Unpacking(parts.document, parts.binary, model);
  await unpacking.run(decoders);
  return unpacking.result(parts.isGlb);
}

interface Parts {
  isGlb: boolean;
  document: unknown;
  binary: Uint8Array;
}

function partsOf(bytes: Uint8Array): Parts | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isGlb = bytes.length >= 20 && view.getUint32(0, true) === 0x46546c67;
  let json = bytes;
  let binary = new Uint8Array();
  if (isGlb) {
    const jsonEnd = 20 + view.getUint32(12, true);
    const isWhole = view.getUint32(4, true) === 2 && view.getUint32(16, true) === 0x4e4f534a;
    if (!isWhole || view.getUint32(8, true) > bytes.length || jsonEnd > bytes.length) return;
    json = bytes.subarray(20, jsonEnd);
    for (let at = jsonEnd; at + 8 <= view.getUint32(8, true);) {
      const end = at + 8 + view.getUint32(at, true);
      if (end > view.getUint32(8, true)) return;
      if (view.getUint32(at + 4, true) === 0x004e4942) {
        binary = bytes.slice(at + 8, end);
        break;
      }
      at = end;
    }
  }
  try {
    const text = new TextDecoder('utf-8', { fatal: true }).decode(json);
    return { isGlb, document: parsed(text), binary };
  } catch {
    return undefined;
  }
}

/** Throws where a number is too large for a double: it would be written as null. */
function parsed(text: string): unknown {
  const mayOverflow = /\d[eE]\+?\d{3}|\d{309}/.test(text);
  if (!mayOverflow) return JSON.parse(text) as unknown;
  return JSON.parse(text, (_, value: unknown) => {
    if (typeof value === 'number' && !Number.isFinite(value)) throw new RangeError();
    return value;
  }) as unknown;
}

const isListMode = (mode: unknown) => mode === undefined || mode === triangles;
const isDrawn = (mode: unknown) => isListMode(mode) || (isCount(mode) && mode > triangles);
/** Attributes with the positions of points. */
const isPlacing = (name: string) => /^(?:POSITION|(?:JOINTS|WEIGHTS)_\d+)$/.test(name);

class Unpacking {
  readonly #document: Members;
  readonly #binary: Uint8Array;
  readonly #resource: Resource;
  readonly #budget = new UnpackBudget();
  /** The number of the new buffer: the next after the existing ones. */
  readonly #newBuffer: number;
  readonly #fetched = new Map<string, Uint8Array>();
  /** Unpacked pieces, and where each begins in the new buffer. */
  readonly #unpacked: Uint8Array<ArrayBuffer>[] = [];
  #size = 0;

  constructor(document: Members, binary: Uint8Array, { bytes, resource }: ModelBytes) {
    this.#document = document;
    this.#newBuffer = this.#list('buffers').length;
    this.#binary = binary;
    this.#resource = resource;
    this.#budget.allowFor(bytes.length);
  }

  async run(decoders: Decoders): Promise<void> {
    const views = this.#packedViews();
    if (views.length > 0) {
      const decoder = await decoders.meshopt();
      for (const number of views) this.#unpackView(decoder, number);
    }
    const primitives = this.#primitives().filter(({ primitive }) =>
      extensionOf(primitive, dracoName),
    );
    if (primitives.length === 0) return;
    const module = await decoders.draco();
    const meshes = new Map<number, DracoSource>();
    try {
      for (const { place, primitive } of primitives) {
        this.#unpackPrimitive(module, primitive, place, meshes);
      }
    } catch (thrown) {
      // Draco's module aborts when it cannot allocate memory.
      if (!(thrown instanceof WebAssembly.RuntimeError)) throw thrown;
      const message = 'a Draco stream asks for more memory than there is';
      throw failure('LIMIT_EXCEEDED', message, { cause: thrown });
    }
  }

  result(isGlb: boolean): ModelBytes {
    if (this.#size === 0) return { bytes: this.#file(isGlb), resource: this.#resource };
    const buffers = this.#list('buffers');
    const uris = new Set(objects(buffers).map(({ uri }) => uri));
    let name = 'unpacked.bin';
    while (uris.has(name)) name = `_${name}`;
    buffers[this.#newBuffer] = { uri: name, byteLength: this.#size };
    const content = new Uint8Array(this.#size);
    let at = 0;
    for (const bytes of this.#unpacked) {
      content.set(bytes, at);
      at = aligned(at + bytes.length);
    }
    const resource = (asked: string) => (asked === name ? content : this.#resource(asked));
    return { bytes: this.#file(isGlb), resource };
  }

  #file(isGlb: boolean): Uint8Array {
    const json = new TextEncoder().encode(JSON.stringify(this.#document));
    if (!isGlb) return json;
    const jsonLength = Math.ceil(json.length / 4) * 4;
    const binaryLength = Math.ceil(this.#binary.length / 4) * 4;
    const binaryChunk = binaryLength > 0 ? 8 + binaryLength : 0;
    const bytes = new Uint8Array(20 + jsonLength + binaryChunk).fill(0x20, 20, 20 + jsonLength);
    const view = new DataView(bytes.buffer);
    const header = [0x46546c67, 2, bytes.length, jsonLength, 0x4e4f534a];
    header.forEach((word, i) => view.setUint32(4 * i, word, true));
    bytes.set(json, 20);
    if (binaryChunk > 0) {
      view.setUint32(20 + jsonLength, binaryLength, true);
      view.setUint32(24 + jsonLength, 0x004e4942, true);
      bytes.set(this.#binary, 28 + jsonLength);
    }
    return bytes;
  }

  /** A list of the document. It is added where there is none. */
  #list(name: string): unknown[] {
    const list = this.#document[name];
    if (Array.isArray(list)) return list;
    const made: unknown[] = [];
    this.#document[name] = made;
    return made;
  }

  #extensionOfView(number: number): [string, Members] | undefined {
    const view = this.#list('bufferViews')[number];
    if (!isObject(view)) return undefined;
    for (const name of meshoptNames) {
      const extension = extensionOf(view, name);
      if (extension) return [name, extension];
    }
    return undefined;
  }

  /** The packed buffer views that geometry needs. */
  #packedViews(): number[] {
    const needed = new Set<number>();
    const add = (view: unknown) => {
      if (isCount(view) && this.#extensionOfView(view)) needed.add(view);
    };
    const addAccessor = (number: unknown) => {
      const accessor = this.#accessor(number);
      if (!accessor) return;
      add(accessor.bufferView);
      const { sparse } = accessor;
      if (!isObject(sparse)) return;
      for (const part of [sparse['indices'], sparse['values']]) {
        if (isObject(part)) add(part['bufferView']);
      }
    };
    const addAttributes = (attributes: unknown) => {
      if (!isObject(attributes)) return;
      Object.keys(attributes)
        .filter(isPlacing)
        .forEach((name) => addAccessor(attributes[name]));
    };
    for (const { primitive } of this.#primitives()) {
      addAttributes(primitive['attributes']);
      addAccessor(primitive['indices']);
      objects(primitive['targets']).forEach(addAttributes);
    }
    objects(this.#document['skins']).forEach((skin) => addAccessor(skin['inverseBindMatrices']));
    for (const node of objects(this.#document['nodes'])) {
      const instancing = extensionOf(node, 'EXT_mesh_gpu_instancing')?.['attributes'];
      if (!isObject(instancing)) continue;
      ['TRANSLATION', 'ROTATION', 'SCALE'].forEach((name) => addAccessor(instancing[name]));
    }
    return [...needed];
  }

  #unpackView(decoder: typeof MeshoptDecoder, number: number): void {
    const view = this.#list('bufferViews')[number] as BufferView;
    const [name, extension] = this.#extensionOfView(number)!;
    const { buffer, byteOffset = 0, byteLength, byteStride, count, mode } = extension;
    const { filter = 'NONE' } = extension;
    const isValid =
      isCount(buffer) &&
      isCount(byteOffset) &&
      isCount(byteLength) &&
      isCount(byteStride) &&
      isCount(count) &&
      ['ATTRIBUTES', 'TRIANGLES', 'INDICES'].includes(mode as string) &&
      ['NONE', 'OCTAHEDRAL', 'QUATERNION', 'EXPONENTIAL', 'COLOR'].includes(filter as string);
    // The reader refuses members of other types.
    if (!isValid) return;
    const packing = { byteStride, count, mode: mode as string, filter: filter as string };
    const place = `/bufferViews/${number}/extensions/${name}`;
    const bytes = this.#range(buffer, byteOffset, byteLength, place);
    this.#budget.allowFor(bytes.length);
    const content = unpackMeshopt(decoder, packing, bytes, this.#budget, place);
    const wanted = view.byteLength;
    if (isCount(wanted) && wanted > content.length) {
      const what = `is ${wanted}, but unpacked there are ${content.length} bytes`;
      throw malformed(`/bufferViews/${number}/byteLength`, what);
    }
    const placed = this.#placed(content);
    Object.assign(view, { buffer: placed.buffer, byteOffset: placed.byteOffset });
    meshoptNames.forEach((other) => delete (view['extensions'] as Members)[other]);
  }

  /** The primitives that are made of triangles, and their places. */
  #primitives(): { primitive: Members; place: string }[] {
    return this.#list('meshes').flatMap((mesh, m) => {
      const primitives: unknown = isObject(mesh) ? mesh['primitives'] : undefined;
      if (!Array.isArray(primitives)) return [];
      return (primitives as unknown[]).flatMap((primitive, p) =>
        isObject(primitive) && isDrawn(primitive['mode'])
          ? [{ primitive, place: `/meshes/${m}/primitives/${p}` }]
          : [],
      );
    });
  }

  #unpackPrimitive(
    module: DracoModule,
    primitive: Members,
    place: string,
    sources: Map<number, DracoSource>,
  ): void {
    const extension = extensionOf(primitive, dracoName)!;
    const { bufferView, attributes: numbers } = extension;
    const { attributes, indices, mode } = primitive;
    // The reader refuses members of other types, and leaves out primitives without positions.
    if (!isCount(bufferView) || !isObject(attributes) || !isCount(attributes['POSITION'])) return;
    const source = this.#dracoSource(
      module,
      bufferView,
      `${place}/extensions/${dracoName}`,
      sources,
    );
    for (const name of Object.keys(attributes).filter(isPlacing)) {
      const number = isObject(numbers) ? numbers[name] : undefined;
      if (!isCount(number)) continue;
      attributes[name] = this.#unpackAttribute(
        source,
        number,
        attributes[name],
        name === 'POSITION' ? 'VEC3' : 'VEC4',
        `${place}/attributes/${name}`,
      );
    }
    const corners = 3 * source.mesh.faceCount;
    if (isListMode(mode) && isCount(indices)) {
      const { count } = this.#checkedAccessor(indices, 'SCALAR', `${place}/indices`);
      if (count !== corners) {
        const what = `is ${count}, but its Draco stream holds ${corners}`;
        throw malformed(`/accessors/${indices}/count`, what);
      }
    }
    source.faces ??= this.#newAccessor(source.mesh.faces(), {
      componentType: unsignedInt,
      count: corners,
      type: 'SCALAR',
    });
    primitive['indices'] = source.faces;
    primitive['mode'] = triangles;
    delete (primitive['extensions'] as Members)[dracoName];
  }

  #dracoSource(
    module: DracoModule,
    view: number,
    place: string,
    sources: Map<number, DracoSource>,
  ): DracoSource {
    const known = sources.get(view);
    if (known) return known;
    const bytes = this.#view(view, `${place}/bufferView`);
    const mesh = new UnpackedDraco(module, bytes, this.#budget, place);
    const source: DracoSource = { mesh, attributes: new Map(), faces: undefined };
    sources.set(view, source);
    return source;
  }

  /** The number of an accessor with the unpacked attribute. */
  #unpackAttribute(
    { mesh, attributes }: DracoSource,
    number: number,
    accessor: unknown,
    type: string,
    place: string,
  ): number {
    const { componentType, count, normalized } = this.#checkedAccessor(accessor, type, place);
    const key = `${number} ${componentType} ${String(normalized)} ${type}`;
    const known = attributes.get(key);
    if (known !== undefined) return known;
    const bytes = mesh.attribute(number, componentsOf[type]!, componentType);
    if (!bytes)
      throw malformed(place, `its Draco stream has no attribute ${number} of type ${type}`);
    if (count !== mesh.pointCount) {
      const what = `is ${count}, but its Draco stream holds ${mesh.pointCount}`;
      throw malformed(`/accessors/${String(accessor)}/count`, what);
    }
    const made = this.#newAccessor(bytes, {
      componentType,
      count,
      type,
      ...(normalized === undefined ? {} : { normalized }),
    });
    attributes.set(key, made);
    return made;
  }

  #newAccessor(bytes: Uint8Array<ArrayBuffer>, accessor: Accessor): number {
    const bufferView = this.#list('bufferViews').push(this.#placed(bytes)) - 1;
    return this.#list('accessors').push({ ...accessor, bufferView }) - 1;
  }

  #checkedAccessor(number: unknown, type: string, user: string): Accessor {
    const accessor = this.#accessor(number);
    if (!accessor) throw malformed(user, `there is no accessor ${String(number)}`);
    const place = `/accessors/${String(number)}`;
    if (accessor.type !== type) {
      throw malformed(`${place}/type`, `is ${accessor.type}, but ${user} needs ${type}`);
    }
    if (accessor.count === 0) throw malformed(`${place}/count`, 'is 0');
    return accessor;
  }

  /** The bytes of a buffer view that is not packed. */
  #view(number: number, user: string): Uint8Array {
    const view = this.#list('bufferViews')[number];
    if (!isObject(view)) throw malformed(user, `there is no buffer view ${number}`);
    const { buffer, byteOffset = 0, byteLength } = view as BufferView;
    if (!isCount(buffer) || !isCount(byteOffset) || !isCount(byteLength)) {
      throw malformed(`/bufferViews/${number}`, 'is not valid');
    }
    return this.#range(buffer, byteOffset, byteLength, `/bufferViews/${number}`);
  }

  #range(buffer: number, offset: number, length: number, user: string): Uint8Array {
    const description = this.#list('buffers')[buffer];
    if (!isObject(description)) throw malformed(`${user}/buffer`, `there is no buffer ${buffer}`);
    const bytes = this.#bufferBytes(description, buffer);
    if (offset + length > bytes.length) {
      throw malformed(user, `reaches beyond the end of buffer ${buffer}`);
    }
    return bytes.subarray(offset, offset + length);
  }

  #bufferBytes({ uri = '', byteLength }: Members, number: number): Uint8Array {
    const place = `/buffers/${number}`;
    if (typeof uri !== 'string' || !isCount(byteLength)) throw malformed(place, 'is not valid');
    let bytes = this.#binary;
    if (uri !== '') bytes = this.#fetchedBytes(uri, `${place}/uri`);
    else if (number !== 0) throw malformed(place, 'has no uri, and so no bytes');
    else if (bytes.length === 0) throw malformed(place, 'has neither a uri nor a binary chunk');
    if (byteLength > bytes.length) {
      const what = `promises ${byteLength} bytes, but there are ${bytes.length}`;
      throw malformed(`${place}/byteLength`, what);
    }
    return bytes.subarray(0, byteLength);
  }

  #fetchedBytes(uri: string, place: string): Uint8Array {
    const known = this.#fetched.get(uri);
    if (known) return known;
    let bytes: Uint8Array | undefined;
    if (uri.startsWith('data:')) {
      bytes = dataOf(uri);
      if (!bytes) throw malformed(place, 'is a data: URI that is not valid');
    } else {
      const name = percentDecoded(uri);
      if (!staysInside(name)) {
        const what = `it refers to ${shown(name)}, which is not a file beside the model`;
        throw failure('MISSING_RESOURCE', `${place}: ${what}`);
      }
      bytes = this.#resource(name);
      // Some exporters do not escape names, which may then contain a percent sign.
      if (name !== uri && staysInside(uri)) bytes ??= this.#resource(uri);
      if (!bytes) {
        const what = `the file ${shown(name)} is missing: the model refers to it`;
        throw failure('MISSING_RESOURCE', what);
      }
      this.#budget.allowFor(bytes.length);
    }
    this.#fetched.set(uri, bytes);
    return bytes;
  }

  #accessor(number: unknown): Accessor | undefined {
    const accessor = isCount(number) ? this.#list('accessors')[number] : undefined;
    return isObject(accessor) ? (accessor as Accessor) : undefined;
  }

  /** Puts unpacked bytes into the new buffer. Returns their place, as members of a buffer view. */
  #placed(bytes: Uint8Array<ArrayBuffer>): BufferView {
    const view = { buffer: this.#newBuffer, byteOffset: this.#size, byteLength: bytes.length };
    this.#unpacked.push(bytes);
    this.#size = aligned(this.#size + bytes.length);
    return view;
  }
}

/** A stream that several primitives may share. */
interface DracoSource {
  mesh: UnpackedDraco;
  /** Numbers of accessors. */
  attributes: Map<string, number>;
  faces: number | undefined;
}

const aligned = (size: number) => Math.ceil(size / 8) * 8;

const shown = (name: string) => JSON.stringify(name.length > 60 ? `${name.slice(0, 57)}...` : name);

/** Whether a name stays beside the model: relative, without scheme, and never up a folder. */
function staysInside(name: string): boolean {
  if (name === '' || /^[/\\]|[:\0]/.test(name)) return false;
  return !name.split(/[/\\]/).includes('..');
}

function percentDecoded(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

function dataOf(uri: string): Uint8Array | undefined {
  const comma = uri.indexOf(',');
  if (comma < 0) return undefined;
  const body = uri.slice(comma + 1);
  if (!uri.slice(0, comma).endsWith(';base64')) {
    return new TextEncoder().encode(percentDecoded(body));
  }
  try {
    const plain = body.replace(/=+$/, '').replaceAll('-', '+').replaceAll('_', '/');
    return Uint8Array.from(atob(plain), (byte) => byte.charCodeAt(0));
  } catch {
    return undefined;
  }
}
