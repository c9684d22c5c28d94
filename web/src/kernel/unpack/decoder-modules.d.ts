// The decoders of compressed glTF, as far as they are used here.

declare module '*/draco-decoder.mjs' {
  interface Pointer {
    readonly ptr: number;
  }
  interface DracoBuffer {
    Init(bytes: Int8Array, length: number): void;
  }
  interface DracoMesh extends Pointer {
    num_faces(): number;
    num_points(): number;
  }
  interface DracoAttribute extends Pointer {
    num_components(): number;
  }
  interface DracoStatus {
    ok(): boolean;
  }
  interface DracoDecoder {
    DecodeBufferToMesh(buffer: DracoBuffer, mesh: DracoMesh): DracoStatus;
    GetTrianglesUInt32Array(mesh: DracoMesh, bytes: number, to: number): boolean;
    GetAttributeByUniqueId(mesh: DracoMesh, number: number): DracoAttribute;
    GetAttributeDataArrayForAllPoints(
      mesh: DracoMesh,
      attribute: DracoAttribute,
      type: number,
      bytes: number,
      to: number,
    ): boolean;
  }
  export interface DracoModule {
    Decoder: new () => DracoDecoder;
    DecoderBuffer: new () => DracoBuffer;
    Mesh: new () => DracoMesh;
    readonly DT_INT8: number;
    readonly DT_UINT8: number;
    readonly DT_INT16: number;
    readonly DT_UINT16: number;
    readonly DT_INT32: number;
    readonly DT_UINT32: number;
    readonly DT_FLOAT32: number;
    /** Replaced when the memory grows. */
    readonly HEAPU8: Uint8Array;
    _malloc(bytes: number): number;
    _free(at: number): void;
    destroy(object: object): void;
  }
  export default function createDraco(options: { wasmBinary: ArrayBuffer }): Promise<DracoModule>;
}

declare module '*/meshopt-decoder.mjs' {
  export const MeshoptDecoder: {
    readonly ready: Promise<void>;
    /** Throws where the source is not valid. */
    decodeGltfBuffer(
      target: Uint8Array,
      count: number,
      stride: number,
      source: Uint8Array,
      mode: string,
      filter?: string,
    ): void;
  };
}
