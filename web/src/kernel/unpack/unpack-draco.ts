// Draco's streams. The sizes that a stream claims are checked before memory is allocated, and the result is
// checked afterwards.

import type { DracoAttribute, DracoMesh, DracoModule } from '../wasm/draco-decoder.mjs';
import { failure } from '../types/errors.js';
import type { UnpackBudget } from './unpack-budget.js';

/** Half a bit per face. No real mesh is more regular. */
const mostFacesPerByte = 16;

/** glTF's component types, and Draco's names for them. */
const types = {
  5120: ['DT_INT8', 1],
  5121: ['DT_UINT8', 1],
  5122: ['DT_INT16', 2],
  5123: ['DT_UINT16', 2],
  5124: ['DT_INT32', 4],
  5125: ['DT_UINT32', 4],
  5126: ['DT_FLOAT32', 4],
} as const;

interface Claims {
  faces: number;
  points: number;
  /** Attributes with seams of their own. */
  seamLists: number;
}

/** Reads numbers from the front of a stream; throws a RangeError at its end. */
class Front {
  #at = 0;
  readonly #bytes: Uint8Array;
  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }
  byte(): number {
    const byte = this.#bytes[this.#at++];
    if (byte === undefined) throw new RangeError('the stream breaks off');
    return byte;
  }
  skip(count: number): void {
    this.#at += count;
    if (this.#at > this.#bytes.length) throw new RangeError('the stream breaks off');
  }
  /** Seven bits per byte, the lowest first. */
  varint(): number {
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = this.byte();
      value += (byte & 127) * scale;
      if (byte < 128) return value;
      if (scale > 2 ** 35) throw new RangeError('a number is too long');
    }
  }
  /** Skips names and values, which may contain such lists. */
  skipMetadata(): void {
    for (let pending = 1, isOutermost = true; pending > 0; --pending, isOutermost = false) {
      if (!isOutermost) this.skip(this.byte());
      for (let entries = this.varint(); entries > 0; --entries) {
        this.skip(this.byte());
        this.skip(this.varint());
      }
      pending += this.varint();
    }
  }
}

function claimsOf(bytes: Uint8Array, place: string): Claims {
  const front = new Front(bytes);
  const mark = [0, 0, 0, 0, 0].map(() => front.byte());
  const version = [front.byte(), front.byte()];
  const isMesh = front.byte() === 1;
  const isEdgebreaker = front.byte() === 1;
  front.byte();
  const hasMetadata = (front.byte() & 0x80) !== 0;
  if (String.fromCharCode(...mark) !== 'DRACO') throw new RangeError('not Draco');
  if (version[0] !== 2 || version[1] !== 2) {
    const message = `${place}: its Draco stream is not of version 2.2, which glTF prescribes`;
    throw failure('UNSUPPORTED_FEATURE', message);
  }
  if (!isMesh) throw new RangeError('not a mesh');
  if (hasMetadata) {
    for (let lists = front.varint(); lists > 0; --lists) {
      front.varint();
      front.skipMetadata();
    }
    front.skipMetadata();
  }
  if (!isEdgebreaker) return { faces: front.varint(), points: front.varint(), seamLists: 0 };
  front.byte();
  const vertices = front.varint();
  const faces = front.varint();
  const seamLists = front.byte();
  front.varint();
  return { faces, points: vertices + front.varint(), seamLists };
}

/** A mesh in the memory of an instance of Draco, freed with it. */
export class UnpackedDraco {
  readonly #module: DracoModule;
  readonly #decoder: InstanceType<DracoModule['Decoder']>;
  readonly #mesh: DracoMesh;

  constructor(module: DracoModule, bytes: Uint8Array, budget: UnpackBudget, place: string) {
    const invalid = (cause?: unknown) =>
      failure('MALFORMED_FILE', `${place}: its Draco stream is not valid`, { cause });
    let claims: Claims;
    try {
      claims = claimsOf(bytes, place);
    } catch (thrown) {
      throw thrown instanceof RangeError ? invalid(thrown) : thrown;
    }
    const { faces, points, seamLists } = claims;
    budget.allowFor(mostFacesPerByte * bytes.length);
    if (!budget.take(points + 3 * faces * (1 + seamLists))) {
      const message = `${place}: its Draco stream claims ${faces} faces, far more than fit into its ${bytes.length} bytes`;
      throw failure('LIMIT_EXCEEDED', message);
    }
    this.#module = module;
    this.#decoder = new module.Decoder();
    this.#mesh = new module.Mesh();
    const buffer = new module.DecoderBuffer();
    buffer.Init(new Int8Array(bytes.buffer, bytes.byteOffset, bytes.length), bytes.length);
    const isDone = this.#decoder.DecodeBufferToMesh(buffer, this.#mesh).ok();
    module.destroy(buffer);
    if (!isDone) throw invalid();
  }

  get pointCount(): number {
    return this.#mesh.num_points();
  }

  get faceCount(): number {
    return this.#mesh.num_faces();
  }

  /** Three points per face, as unsigned 32-bit numbers. */
  faces(): Uint8Array<ArrayBuffer> {
    const size = 12 * this.faceCount;
    return this.#copied(size, (at) => this.#decoder.GetTrianglesUInt32Array(this.#mesh, size, at))!;
  }

  /**
   * The attribute of that number for all points, as components of that type without gaps; undefined where
   * there is none with so many components.
   */
  attribute(number: number, components: number, type: number): Uint8Array<ArrayBuffer> | undefined {
    if (!(type in types)) return undefined;
    const [name, bytes] = types[type as keyof typeof types];
    const attribute: DracoAttribute = this.#decoder.GetAttributeByUniqueId(this.#mesh, number);
    if (attribute.ptr === 0 || attribute.num_components() !== components) return undefined;
    const size = bytes * components * this.pointCount;
    return this.#copied(size, (at) =>
      this.#decoder.GetAttributeDataArrayForAllPoints(
        this.#mesh,
        attribute,
        this.#module[name],
        size,
        at,
      ),
    );
  }

  /** The bytes that `write` puts into memory of the module. */
  #copied(size: number, write: (at: number) => boolean): Uint8Array<ArrayBuffer> | undefined {
    const at = this.#module._malloc(size);
    const isDone = write(at);
    const bytes = isDone ? this.#module.HEAPU8.slice(at, at + size) : undefined;
    this.#module._free(at);
    return bytes;
  }
}
