// The WebAssembly modules as `cpp/bind` makes them; the build writes them into the folder `wasm`.

/** Functions return this in place of their result when they fail. */
interface Failed {
  code: string;
  element: number;
  message: string;
  hint: string;
}

declare module '*/girth.mjs' {
  export interface FoundLoop {
    length: number;
    kind: 'loop' | 'antipodal' | 'unresolved';
    polyline: Float32Array<ArrayBuffer>;
    midpoint: [number, number, number];
    angle: number;
  }

  export interface Surface {
    values(
      vertices: Uint32Array,
    ): { values: Float64Array<ArrayBuffer>; kinds: Uint8Array<ArrayBuffer> } | Failed;
    loopAtVertex(vertex: number): FoundLoop | Failed;
    loopInFace(face: number, a: number, b: number, c: number): FoundLoop | Failed;
    order(): Uint32Array<ArrayBuffer> | Failed;
    delete(): void;
  }

  export interface Described {
    surface: Surface;
    positions: Float64Array<ArrayBuffer>;
    indices: Uint32Array<ArrayBuffer>;
    components: number;
    genus: number[];
    area: number;
  }

  export interface Read extends Described {
    format: 'GLB' | 'glTF' | 'OBJ';
    /** 'metre' or ''. */
    unit: string;
    vertexOfInput: Uint32Array<ArrayBuffer>;
    weldedVertices: number;
    unreferencedVertices: number;
  }

  export interface GirthModule {
    readSurface(bytes: Uint8Array, name: string): Read | Failed;
    surfaceFromArrays(positions: Float64Array, indices: Uint32Array): Described | Failed;
  }

  export default function createModule(): Promise<GirthModule>;
}

declare module '*/girth-threads.mjs' {
  export interface Surface {
    field(
      threads: number,
      onPartial: (partial: {
        vertices: Uint32Array<ArrayBuffer>;
        values: Float64Array<ArrayBuffer>;
        kinds: Uint8Array<ArrayBuffer>;
      }) => void,
    ): { complete: boolean } | Failed;
    delete(): void;
  }

  export interface GirthThreadsModule {
    surfaceFromArrays(positions: Float64Array, indices: Uint32Array): { surface: Surface } | Failed;
    /** A view of one byte of the shared memory. */
    cancelFlag(): Uint8Array<SharedArrayBuffer>;
  }

  export default function createModule(options: {
    girthThreads: number;
  }): Promise<GirthThreadsModule>;
}
