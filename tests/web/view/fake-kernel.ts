// A small kernel without WebAssembly for tests of the view: the interface is the real one, the
// values are not. The 'loop' at a vertex is the shortest of the plane sections through it.

import type {
  Field,
  FieldOptions,
  Kernel,
  Loop,
  Mesh,
  MeshInfo,
  MeshSource,
} from '../../../web/src/kernel/types.js';

type Point = [number, number, number];

/** A torus about the y axis, `around` by `across` quadrilaterals in two triangles each. */
export function torus(around: number, across: number, big = 1, small = 0.4) {
  const positions = new Float32Array(3 * around * across);
  const indices: number[] = [];
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      const u = (2 * Math.PI * i) / around;
      const v = (2 * Math.PI * j) / across;
      // Thicker on one side, so that there is a field to see.
      const r = small * (1 + 0.45 * Math.cos(u));
      const at: Point = [
        (big + r * Math.cos(v)) * Math.cos(u),
        r * Math.sin(v),
        (big + r * Math.cos(v)) * Math.sin(u),
      ];
      positions.set(at, 3 * (i * across + j));
      const [a, b] = [i * across + j, i * across + ((j + 1) % across)];
      const [c, d] = [a, b].map((k) => (k + across) % (around * across)) as [number, number];
      indices.push(a, b, c, b, d, c);
    }
  }
  return { positions, indices: Uint32Array.from(indices) };
}

/** The closed section of a surface with the plane through a vertex, from the vertex and back. */
function section(
  positions: Float32Array,
  indices: Uint32Array,
  facesOf: number[][],
  vertex: number,
  normal: Point,
): number[] | undefined {
  const origin = positions.subarray(3 * vertex, 3 * vertex + 3);
  const side = (v: number): number => {
    const value = [0, 1, 2].reduce(
      (sum, k) => sum + normal[k]! * (positions[3 * v + k]! - origin[k]!),
      0,
    );
    return v === vertex ? 0 : value || 1e-12;
  };
  const crossing = (a: number, b: number): number[] => {
    const [s, t] = [side(a), side(b)];
    const f = s / (s - t);
    return [0, 1, 2].map((k) => positions[3 * a + k]! * (1 - f) + positions[3 * b + k]! * f);
  };
  const opposite = (face: number): [number, number] => {
    const corners = [0, 1, 2].map((k) => indices[3 * face + k]!);
    const at = corners.indexOf(vertex);
    return [corners[(at + 1) % 3]!, corners[(at + 2) % 3]!];
  };
  const start = facesOf[vertex]!.find((face) => {
    const [a, b] = opposite(face);
    return side(a) < 0 && side(b) > 0;
  });
  if (start === undefined) return undefined;
  const line = [...origin];
  let face = start;
  let [a, b] = opposite(start);
  for (let step = 0; step < 2000; ++step) {
    line.push(...crossing(a, b));
    const next = facesOf[a]!.find((f) => f !== face && facesOf[b]!.includes(f));
    if (next === undefined) return undefined;
    face = next;
    const third = [0, 1, 2].map((k) => indices[3 * face + k]!).find((v) => v !== a && v !== b)!;
    if (third === vertex) return [...line, ...origin];
    if (side(third) < 0) a = third;
    else b = third;
  }
  return undefined;
}

function lengthOf(line: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 3; i < line.length; ++i) {
    if (i % 3 === 0) {
      sum += Math.hypot(
        line[i]! - line[i - 3]!,
        line[i + 1]! - line[i - 2]!,
        line[i + 2]! - line[i - 1]!,
      );
    }
  }
  return sum;
}

const directions: Point[] = Array.from({ length: 16 }, (_, i) => {
  const y = 1 - (i + 0.5) / 16;
  const angle = 2.4 * i;
  const r = Math.sqrt(1 - y * y);
  return [r * Math.cos(angle), y, r * Math.sin(angle)];
});

class FakeMesh implements Mesh {
  readonly info: MeshInfo;
  readonly vertexOfInput: Uint32Array;
  private readonly facesOf: number[][];

  constructor(
    name: string,
    readonly geometry: Mesh['geometry'],
    private readonly pace: number,
  ) {
    const vertexCount = geometry.positions.length / 3;
    const faceCount = geometry.indices.length / 3;
    this.facesOf = Array.from({ length: vertexCount }, () => []);
    geometry.indices.forEach((v, i) => this.facesOf[v]!.push(Math.floor(i / 3)));
    this.vertexOfInput = Uint32Array.from({ length: vertexCount }, (_, i) => i);
    this.info = {
      name,
      format: 'arrays',
      vertexCount,
      faceCount,
      edgeCount: (faceCount * 3) / 2,
      components: 1,
      genus: [1],
      area: 1,
      unit: 'm',
      weldedVertices: 214,
      unreferencedVertices: 0,
    };
  }

  private loopAt(vertex: number): Loop {
    const { positions, indices } = this.geometry;
    const lines = directions
      .map((normal) => section(positions, indices, this.facesOf, vertex, normal))
      .filter((line) => line !== undefined);
    const line = lines.reduce((a, b) => (lengthOf(a) < lengthOf(b) ? a : b));
    const middle = 3 * Math.floor(line.length / 6);
    return {
      length: lengthOf(line),
      kind: vertex % 7 === 3 ? 'antipodal' : 'loop',
      vertex,
      polyline: Float32Array.from(line),
      midpoint: [line[middle]!, line[middle + 1]!, line[middle + 2]!],
      angle: Math.PI,
      unit: 'm',
    };
  }

  async field(name: 'igf', options: FieldOptions = {}): Promise<Field> {
    const { vertexCount } = this.info;
    const values = new Float64Array(vertexCount);
    const kinds = new Uint8Array(vertexCount);
    // A stride coprime to the count visits all vertices, spread out.
    let stride = Math.floor(vertexCount * 0.618) | 1;
    const gcd = (a: number, b: number): number => (b ? gcd(b, a % b) : a);
    while (gcd(stride, vertexCount) !== 1) stride += 2;
    const batch = Math.ceil(vertexCount / 100);
    for (let done = 0; done < vertexCount; done += batch) {
      await new Promise((resolve) => setTimeout(resolve, this.pace));
      options.signal?.throwIfAborted();
      const count = Math.min(batch, vertexCount - done);
      const vertices = Uint32Array.from(
        { length: count },
        (_, i) => ((done + i) * stride) % vertexCount,
      );
      const part = Float64Array.from(vertices, (v) => this.loopAt(v).length);
      vertices.forEach((v, i) => (values[v] = part[i]!));
      options.onPartial?.({ vertices, values: part, kinds: new Uint8Array(count) });
      options.onProgress?.(Math.min(1, (done + count) / vertexCount));
    }
    const range: [number, number] = [Math.min(...values), Math.max(...values)];
    return { name, values, kinds, range, unit: 'm' };
  }

  async loop(vertex: number): Promise<Loop> {
    await new Promise((resolve) => setTimeout(resolve, 2));
    return this.loopAt(vertex);
  }

  dispose(): void {
    this.facesOf.length = 0;
  }
}

/** `pace`: milliseconds between two of the hundred batches of a field. */
export async function createKernel({ pace = 10 } = {}): Promise<Kernel> {
  return {
    mode: 'pool',
    threads: 1,
    load: async (source: MeshSource) => {
      const name = source instanceof File ? source.name : String(source).split('/').pop()!;
      if (name.includes('broken')) {
        throw Object.assign(new Error('the file ends in the middle of its data, at byte 812'), {
          code: 'MALFORMED_FILE',
          element: 812,
          hint: 'export the model again',
        });
      }
      return new FakeMesh(name, torus(64, 24), pace);
    },
    dispose: () => undefined,
  };
}
