// Surfaces for the kernel's tests, drawn by formulas and written as OBJ: page and command read the
// same bytes.

type Point = [number, number, number];

function objOf(points: Point[], faces: number[][]): string {
  const lines = points.map((point) => `v ${point.join(' ')}`);
  for (const face of faces) lines.push(`f ${face.map((v) => v + 1).join(' ')}`);
  return `${lines.join('\n')}\n`;
}

/** A torus of 2 * rings * sides faces, round and uneven. */
export function torus(rings: number, sides: number): string {
  const points: Point[] = [];
  const faces: number[][] = [];
  for (let i = 0; i < rings; ++i) {
    for (let k = 0; k < sides; ++k) {
      const u = (2 * Math.PI * (i + 0.2 * Math.sin(3 * k))) / rings;
      const v = (2 * Math.PI * (k + 0.2 * Math.cos(5 * i))) / sides;
      const r = 2 + 0.7 * Math.cos(v);
      points.push([r * Math.cos(u), r * Math.sin(u), 0.7 * Math.sin(v) * (1 + 0.2 * Math.cos(u))]);
      const at = (a: number, b: number) => ((i + a) % rings) * sides + ((k + b) % sides);
      faces.push([at(0, 0), at(1, 0), at(1, 1)], [at(0, 0), at(1, 1), at(0, 1)]);
    }
  }
  return objOf(points, faces);
}

/** A thin ring of 2 * rings * sides even faces: its loops are short, and so is the work for each of them. */
export function thinRing(rings: number, sides: number): string {
  const radius = 0.5 / Math.sin(Math.PI / sides);
  const large = 0.5 / Math.sin(Math.PI / rings);
  const points: Point[] = [];
  const faces: number[][] = [];
  for (let i = 0; i < rings; ++i) {
    for (let k = 0; k < sides; ++k) {
      const [u, v] = [(2 * Math.PI * i) / rings, (2 * Math.PI * k) / sides];
      const r = large + radius * Math.cos(v);
      points.push([r * Math.cos(u), r * Math.sin(u), radius * Math.sin(v)]);
      const at = (a: number, b: number) => ((i + a) % rings) * sides + ((k + b) % sides);
      faces.push([at(0, 0), at(1, 0), at(1, 1)], [at(0, 0), at(1, 1), at(0, 1)]);
    }
  }
  return objOf(points, faces);
}

/** A surface of revolution about x, closed by a vertex at each end: a dumbbell. */
export function dumbbell(rings: number, sides: number): string {
  const points: Point[] = [[-2.4, 0, 0]];
  const faces: number[][] = [];
  for (let i = 0; i < rings; ++i) {
    const x = -2.3 + (4.6 * i) / (rings - 1);
    const radius = 0.25 + 0.7 * Math.exp(-((Math.abs(x) - 1.5) ** 2) * 3);
    for (let k = 0; k < sides; ++k) {
      const angle = (2 * Math.PI * (k + 0.5 * (i % 2))) / sides;
      points.push([x, radius * Math.cos(angle), radius * Math.sin(angle)]);
    }
  }
  points.push([2.4, 0, 0]);
  const last = points.length - 1;
  for (let k = 0; k < sides; ++k) {
    const ring = (i: number, j: number) => 1 + i * sides + ((k + j) % sides);
    faces.push([0, ring(0, 1), ring(0, 0)], [last, ring(rings - 1, 0), ring(rings - 1, 1)]);
    for (let i = 0; i + 1 < rings; ++i) {
      faces.push([ring(i, 0), ring(i, 1), ring(i + 1, 0)]);
      faces.push([ring(i, 1), ring(i + 1, 1), ring(i + 1, 0)]);
    }
  }
  return objOf(points, faces);
}

/** A plate, two thick, whose hole a needle passes through that does not touch it: no film has room in the hole. */
export function plateWithNeedle(): string {
  const points: Point[] = [];
  const faces: number[][] = [];
  const square = (a: number, b: number, c: number, d: number): void => {
    faces.push([a, b, c], [a, c, d]);
  };
  const at = (x: number, y: number, isTop: boolean): number => 4 * y + x + (isTop ? 16 : 0);
  for (const z of [0, 2]) {
    for (let i = 0; i < 16; ++i) points.push([i % 4, Math.floor(i / 4), z]);
  }
  /** The side that goes up from an edge, seen with what is solid to its left. */
  const side = ([ax, ay]: readonly number[], [bx, by]: readonly number[]): void =>
    square(at(ax!, ay!, false), at(bx!, by!, false), at(bx!, by!, true), at(ax!, ay!, true));
  for (let y = 0; y < 3; ++y) {
    for (let x = 0; x < 3; ++x) {
      if (x === 1 && y === 1) continue;
      const corners = [
        [x, y],
        [x + 1, y],
        [x + 1, y + 1],
        [x, y + 1],
      ] as const;
      const [a, b, c, d] = corners.map(([u, v]) => at(u, v, true)) as [
        number,
        number,
        number,
        number,
      ];
      square(a, b, c, d);
      square(d - 16, c - 16, b - 16, a - 16);
    }
  }
  const round = (low: number, high: number): (readonly [number, number])[] => {
    const ring: [number, number][] = [];
    for (let i = low; i < high; ++i) ring.push([i, low]);
    for (let i = low; i < high; ++i) ring.push([high, i]);
    for (let i = high; i > low; --i) ring.push([i, high]);
    for (let i = high; i > low; --i) ring.push([low, i]);
    return ring;
  };
  const [outer, inner] = [round(0, 3), round(1, 2).reverse()];
  for (const ring of [outer, inner]) {
    ring.forEach((corner, i) => side(corner, ring[(i + 1) % ring.length]!));
  }
  const first = points.length;
  for (const z of [-1, 3]) {
    for (const [x, y] of [
      [1.4, 1.45],
      [1.6, 1.45],
      [1.6, 1.55],
      [1.4, 1.55],
    ] as const) {
      points.push([x, y, z]);
    }
  }
  const n = (i: number): number => first + i;
  square(n(3), n(2), n(1), n(0));
  square(n(4), n(5), n(6), n(7));
  for (let i = 0; i < 4; ++i) square(n(i), n((i + 1) % 4), n(4 + ((i + 1) % 4)), n(4 + i));
  return objOf(points, faces);
}

/** A box of unit squares, each cut in two: flat vertices and windows that end exactly on vertices. */
export function box(nx: number, ny: number, nz: number): string {
  const size = [nx, ny, nz];
  const points: Point[] = [];
  const faces: number[][] = [];
  const numbers = new Map<string, number>();
  const vertex = (point: Point) => {
    const key = point.join(' ');
    let number = numbers.get(key);
    if (number === undefined) {
      number = points.push(point) - 1;
      numbers.set(key, number);
    }
    return number;
  };
  for (let axis = 0; axis < 3; ++axis) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3] as const;
    for (const side of [0, size[axis]!]) {
      for (let i = 0; i < size[u]!; ++i) {
        for (let k = 0; k < size[v]!; ++k) {
          const corner = (a: number, b: number) => {
            const point: Point = [0, 0, 0];
            point[axis] = side;
            point[u] = i + a;
            point[v] = k + b;
            return vertex(point);
          };
          const quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          if (side === 0) quad.reverse();
          faces.push([quad[0]!, quad[1]!, quad[2]!], [quad[0]!, quad[2]!, quad[3]!]);
        }
      }
    }
  }
  return objOf(points, faces);
}

/** The surface of a union of unit cubes, each given by its lowest corner; every square has four triangles. */
function blocks(cubes: readonly Point[]): string {
  const filled = new Set(cubes.map(String));
  const points: Point[] = [];
  const faces: number[][] = [];
  const numbers = new Map<string, number>();
  const vertex = (point: Point): number => {
    const key = String(point);
    const number = numbers.get(key) ?? points.push(point) - 1;
    numbers.set(key, number);
    return number;
  };
  for (const cube of cubes) {
    for (let axis = 0; axis < 3; ++axis) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3] as const;
      for (const side of [0, 1]) {
        const beyond: Point = [...cube];
        beyond[axis]! += 2 * side - 1;
        if (filled.has(String(beyond))) continue;
        const at = (a: number, b: number): number => {
          const point: Point = [...cube];
          point[axis]! += side;
          point[u]! += a;
          point[v]! += b;
          return vertex(point);
        };
        const rim = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
        if (side === 0) rim.reverse();
        const middle = at(0.5, 0.5);
        rim.forEach((corner, i) => faces.push([corner, rim[(i + 1) % 4]!, middle]));
      }
    }
  }
  return objOf(points, faces);
}

/** A palm with square fingers of girth 8 and these lengths: two units wide, two apart. */
export function hand(lengths: readonly number[]): string {
  const cubes: Point[] = [];
  const fill = (x: number, y: number, z: number, size: Point): void => {
    for (let i = 0; i < size[0]; ++i) {
      for (let j = 0; j < size[1]; ++j) {
        for (let k = 0; k < size[2]; ++k) cubes.push([x + i, y + j, z + k]);
      }
    }
  };
  fill(0, 0, 0, [4 * lengths.length, 6, 4]);
  lengths.forEach((length, i) => fill(1 + 4 * i, 2, 4, [2, 2, length]));
  return blocks(cubes);
}

/** A tube about z, open at both ends, with `sides` sides; without a radius at each height, a prism of unit radius. */
export function tube(
  rings: number,
  sides: number,
  length: number,
  radiusAt: (height: number) => number = () => 1,
): string {
  const points: Point[] = [];
  const faces: number[][] = [];
  for (let i = 0; i < rings; ++i) {
    for (let k = 0; k < sides; ++k) {
      const angle = (2 * Math.PI * k) / sides;
      const height = (length * i) / (rings - 1);
      const radius = radiusAt(height);
      points.push([radius * Math.cos(angle), radius * Math.sin(angle), height]);
      if (i === 0) continue;
      const at = (a: number, b: number) => (i - 1 + a) * sides + ((k + b) % sides);
      faces.push([at(0, 0), at(0, 1), at(1, 1)], [at(0, 0), at(1, 1), at(1, 0)]);
    }
  }
  return objOf(points, faces);
}

/** The numbers in such a text. */
export function arraysOf(obj: string): { positions: Float64Array; indices: Uint32Array } {
  const numbers = (letter: string) =>
    obj
      .split('\n')
      .filter((line) => line.startsWith(`${letter} `))
      .flatMap((line) => line.slice(2).split(' ').map(Number));
  const indices = Uint32Array.from(numbers('f'), (one) => one - 1);
  return { positions: Float64Array.from(numbers('v')), indices };
}

/** Two surfaces in one file, the second one moved along x. */
export function beside(one: string, other: string, distance: number): string {
  const [a, b] = [arraysOf(one), arraysOf(other)];
  const points: Point[] = [];
  const faces: number[][] = [];
  for (const [{ positions, indices }, moved] of [
    [a, 0],
    [b, distance],
  ] as const) {
    const first = points.length;
    for (let v = 0; v < positions.length; v += 3) {
      points.push([positions[v]! + moved, positions[v + 1]!, positions[v + 2]!]);
    }
    for (let f = 0; f < indices.length; f += 3) {
      faces.push([...indices.slice(f, f + 3)].map((vertex) => first + vertex));
    }
  }
  return objOf(points, faces);
}

/** A surface as glTF, its numbers in a file that is called `buffer`. */
export function gltf(obj: string, buffer: string): { json: string; bin: Uint8Array<ArrayBuffer> } {
  const { positions, indices } = arraysOf(obj);
  const places = new Float32Array(positions);
  const [low, high] = [Math.min, Math.max].map((extreme) =>
    [0, 1, 2].map((k) => places.filter((_, i) => i % 3 === k).reduce((a, b) => extreme(a, b))),
  );
  const bin = new Uint8Array(places.byteLength + indices.byteLength);
  bin.set(new Uint8Array(places.buffer));
  bin.set(new Uint8Array(indices.buffer), places.byteLength);
  const json = JSON.stringify({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    buffers: [{ uri: buffer, byteLength: bin.length }],
    bufferViews: [
      { buffer: 0, byteLength: places.byteLength },
      { buffer: 0, byteOffset: places.byteLength, byteLength: indices.byteLength },
    ],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: places.length / 3,
        type: 'VEC3',
        min: low,
        max: high,
      },
      { bufferView: 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
  });
  return { json, bin };
}

/** A surface as binary STL, every corner for itself. */
export function stl(obj: string): Uint8Array<ArrayBuffer> {
  const { positions, indices } = arraysOf(obj);
  const count = indices.length / 3;
  const view = new DataView(new ArrayBuffer(84 + 50 * count));
  view.setUint32(80, count, true);
  indices.forEach((vertex, corner) => {
    const at = 84 + 50 * Math.floor(corner / 3) + 12 + 12 * (corner % 3);
    for (let k = 0; k < 3; ++k) view.setFloat32(at + 4 * k, positions[3 * vertex + k]!, true);
  });
  return new Uint8Array(view.buffer);
}

/** A surface with every coordinate of every vertex put elsewhere. */
export function placed(obj: string, place: (coordinate: number, axis: number) => number): string {
  return obj.replace(/^v (.*)$/gm, (_, numbers: string) =>
    ['v', ...numbers.split(' ').map((number, axis) => place(Number(number), axis))].join(' '),
  );
}

/** A surface moved elsewhere. */
export function moved(obj: string, by: Point): string {
  return placed(obj, (coordinate, axis) => coordinate + by[axis]!);
}

/** A shape made larger. */
export function scaled(obj: string, by: number): string {
  return placed(obj, (coordinate) => by * coordinate);
}

/** A surface with its faces turned over. */
export function turnedOver(obj: string): string {
  return obj.replace(/^f (\S+) (\S+) (\S+)$/gm, 'f $1 $3 $2');
}

/** A Möbius strip, which has one side only. */
export function moebius(count: number): string {
  const points: Point[] = [];
  const faces: number[][] = [];
  for (let i = 0; i < count; ++i) {
    const angle = (2 * Math.PI * i) / count;
    for (const across of [-0.4, 0.4]) {
      const out = 2 + across * Math.cos(angle / 2);
      points.push([out * Math.cos(angle), out * Math.sin(angle), across * Math.sin(angle / 2)]);
    }
    // After half a turn of the strip its two rims change places.
    const [a, b] = [2 * i, 2 * i + 1];
    const [c, d] = i + 1 < count ? [a + 2, b + 2] : [1, 0];
    faces.push([a, c, b], [b, c, d]);
  }
  return objOf(points, faces);
}

/** A flat square of unit squares; with two sides, a plate without volume. */
export function sheet(size: number, sides: 1 | 2): string {
  const points: Point[] = [];
  const faces: number[][] = [];
  for (let i = 0; i <= size; ++i) {
    for (let k = 0; k <= size; ++k) {
      points.push([i, k, 0]);
      if (i === 0 || k === 0) continue;
      const at = (a: number, b: number) => (i - 1 + a) * (size + 1) + (k - 1 + b);
      faces.push([at(0, 0), at(1, 0), at(1, 1)], [at(0, 0), at(1, 1), at(0, 1)]);
    }
  }
  const front = objOf(points, faces);
  if (sides === 1) return front;
  // Each side has its own vertices: they are welded along the rim as well as inside.
  return beside(front, turnedOver(front), 0);
}
