// The outline of a surface as lines on the canvas, with what it hides left out: for drawings on paper.

/** The surface to be drawn, and how it is seen. */
export interface OutlineScene {
  /** x, y, z of each vertex, and three vertices for each face. */
  positions: ArrayLike<number>;
  indices: ArrayLike<number>;
  /** Where one looks from, in the same coordinates. */
  eye: readonly [number, number, number];
  /** Where a point is on the canvas, in CSS pixels. */
  place(this: void, x: number, y: number, z: number): { x: number; y: number };
  /** Whether the surface hides a point that lies on it. */
  hides(this: void, x: number, y: number, z: number): boolean;
}

/** Points on the canvas that a line joins: x, y, x, y, … */
export type Stroke = number[];

export interface Outline {
  /** Where the surface turns away, and its boundary. */
  contours: Stroke[];
  /** Sharp edges between two faces that are both seen. */
  creases: Stroke[];
}

/** CSS pixels of a line that are seen or hidden together. */
const piece = 2;
/** Faces that meet at a larger angle have a sharp edge between them; its cosine. */
const sharp = Math.cos((60 * Math.PI) / 180);

/**
 * The outline. Whole pieces of 2 pixels of each edge are seen or not. Time: a look at each face, and a question what
 * hides it for each piece.
 */
export function outlineOf(scene: OutlineScene): Outline {
  const { positions, indices, eye } = scene;
  const faceCount = indices.length / 3;
  const normals = new Float64Array(3 * faceCount);
  const isFront = new Uint8Array(faceCount);
  /** The first face at an edge, by the numbers of its two vertices. */
  const faceAt = new Map<number, number>();
  const vertexCount = positions.length / 3;
  const contours: Stroke[] = [];
  const creases: Stroke[] = [];
  const add = (lines: Stroke[], a: number, b: number): void => {
    lines.push(...seenPieces(scene, [...pointOf(positions, a), ...pointOf(positions, b)]).seen);
  };
  const keyOf = (a: number, b: number): number =>
    a < b ? a * vertexCount + b : b * vertexCount + a;

  for (let f = 0; f < faceCount; ++f) {
    const [a, b, c] = [0, 1, 2].map((k) => pointOf(positions, indices[3 * f + k]!));
    const [u, v] = [minus(b!, a!), minus(c!, a!)];
    const normal = [
      u[1] * v[2] - u[2] * v[1],
      u[2] * v[0] - u[0] * v[2],
      u[0] * v[1] - u[1] * v[0],
    ] as const;
    const length = Math.hypot(...normal) || 1;
    const to = minus(eye, a!);
    isFront[f] = normal[0] * to[0] + normal[1] * to[1] + normal[2] * to[2] > 0 ? 1 : 0;
    normals.set(
      normal.map((one) => one / length),
      3 * f,
    );
    for (let k = 0; k < 3; ++k) {
      const [from, next] = [indices[3 * f + k]!, indices[3 * f + ((k + 1) % 3)]!];
      const key = keyOf(from, next);
      const other = faceAt.get(key);
      if (other === undefined) {
        faceAt.set(key, f);
        continue;
      }
      faceAt.delete(key);
      let cosine = 0;
      for (let axis = 0; axis < 3; ++axis) {
        cosine += normals[3 * f + axis]! * normals[3 * other + axis]!;
      }
      if (isFront[f] !== isFront[other]) add(contours, from, next);
      else if (cosine < sharp && isFront[f] === 1) add(creases, from, next);
    }
  }
  // Edges that have found no second face are the boundary.
  for (const key of faceAt.keys()) {
    add(contours, Math.floor(key / vertexCount), key % vertexCount);
  }
  return { contours: joined(contours), creases: joined(creases) };
}

/** The pieces of a line on the surface, given by x, y, z of its points, that are seen, and the others. */
export function seenPieces(
  { place, hides }: OutlineScene,
  line: ArrayLike<number>,
): { seen: Stroke[]; hidden: Stroke[] } {
  const strokes = { seen: [] as Stroke[], hidden: [] as Stroke[] };
  let last: { isHidden: boolean; stroke: Stroke } | undefined;
  for (let i = 0; i + 5 < line.length; i += 3) {
    const [from, to] = [pointOf(line, i / 3), pointOf(line, i / 3 + 1)];
    const [start, end] = [place(...from), place(...to)];
    const count = Math.max(1, Math.ceil(Math.hypot(end.x - start.x, end.y - start.y) / piece));
    for (let k = 0; k < count; ++k) {
      const at = (share: number): [number, number, number] => [
        from[0] + share * (to[0] - from[0]),
        from[1] + share * (to[1] - from[1]),
        from[2] + share * (to[2] - from[2]),
      ];
      const isHidden = hides(...at((k + 0.5) / count));
      if (last?.isHidden !== isHidden) {
        const begin = place(...at(k / count));
        last = { isHidden, stroke: [begin.x, begin.y] };
        strokes[isHidden ? 'hidden' : 'seen'].push(last.stroke);
      }
      const reached = place(...at((k + 1) / count));
      // A straight run is one line.
      if (k > 0 && last.stroke.length > 2) last.stroke.splice(-2);
      last.stroke.push(reached.x, reached.y);
    }
  }
  return strokes;
}

/** Strokes that end where others begin, as few long ones. */
function joined(strokes: readonly Stroke[]): Stroke[] {
  const nameOf = (x: number, y: number): string => `${x.toFixed(2)} ${y.toFixed(2)}`;
  const ends = new Map<string, Set<Stroke>>();
  const endsOf = (stroke: Stroke): [string, string] => [
    nameOf(stroke[0]!, stroke[1]!),
    nameOf(stroke.at(-2)!, stroke.at(-1)!),
  ];
  for (const stroke of strokes) {
    for (const end of endsOf(stroke)) ends.set(end, (ends.get(end) ?? new Set()).add(stroke));
  }
  const free = new Set(strokes);
  const take = (end: string): Stroke | undefined => {
    const [next] = [...(ends.get(end) ?? [])].filter((one) => free.has(one));
    if (next) free.delete(next);
    return next;
  };
  const lines: Stroke[] = [];
  for (const stroke of strokes) {
    if (!free.delete(stroke)) continue;
    let line = [...stroke];
    for (let turn = 0; turn < 2; ++turn) {
      for (let next = take(endsOf(line)[1]); next; next = take(endsOf(line)[1])) {
        const isForward = endsOf(next)[0] === endsOf(line)[1];
        line.push(...(isForward ? next : reversed(next)).slice(2));
      }
      // The line goes on at its other end.
      line = reversed(line);
    }
    lines.push(line);
  }
  return lines;
}

function reversed(stroke: Stroke): Stroke {
  const back: Stroke = [];
  for (let i = stroke.length - 2; i >= 0; i -= 2) back.push(stroke[i]!, stroke[i + 1]!);
  return back;
}

const pointOf = (numbers: ArrayLike<number>, i: number): [number, number, number] => [
  numbers[3 * i]!,
  numbers[3 * i + 1]!,
  numbers[3 * i + 2]!,
];

const minus = (
  p: readonly [number, number, number],
  q: readonly [number, number, number],
): [number, number, number] => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
