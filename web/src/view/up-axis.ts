// Which way is up in a file: by the convention of its format, otherwise by a guess from the shape.
//
// The guess weighs the y and the z axis. A body stands where it is tall, where its middle is high and where its
// feet span much of its plan; each counts from 0 to 1, and z must have more than y. It guesses right for 64 of 76
// animals and people of the TOSCA models, whose z axis points up in all poses. A rod that lies askew to all three axes,
// such as a figure on tiptoe, stands on its end.

/** The directions that can be chosen, the usual ones first. */
export const upNames = ['y', 'z', '-y', '-z', 'x', '-x'] as const;
/** A direction of the file's coordinates. */
export type UpName = (typeof upNames)[number];

/** Which way is up, and how that is known. */
export interface UpAxis {
  /** The direction, of length 1, in the file's coordinates. */
  direction: readonly [number, number, number];
  /** Undefined for a direction that is none of the axes. */
  name: UpName | undefined;
  /** The format's convention, a guess from the shape, or what was asked for. */
  by: 'format' | 'guess' | 'choice';
}

/** Whether a word names a direction. */
export function isUpName(word: string | null | undefined): word is UpName {
  return (upNames as readonly (string | null | undefined)[]).includes(word);
}

const directions: Record<UpName, readonly [number, number, number]> = {
  y: [0, 1, 0],
  z: [0, 0, 1],
  '-y': [0, -1, 0],
  '-z': [0, 0, -1],
  x: [1, 0, 0],
  '-x': [-1, 0, 0],
};

/** glTF states it, exporters of OBJ keep to it, and for printers (STL) the bed is x and y. */
const conventions: Record<string, UpName> = { GLB: 'y', glTF: 'y', OBJ: 'y', STL: 'z' };

/** The chosen direction, or that of the format, or a guess. Linear in the vertices. */
export function upAxisOf(
  wished: string | null,
  format: string,
  positions: Float32Array,
  indices: Uint32Array,
): UpAxis {
  if (isUpName(wished)) return { direction: directions[wished], name: wished, by: 'choice' };
  const name = conventions[format];
  if (name) return { direction: directions[name], name, by: 'format' };
  return { ...guessedUp(positions, indices), by: 'guess' };
}

/** How a surface is turned: a quaternion of length 1. */
export interface Rotation {
  /** With y and z the axis, times the sine of half the angle. */
  readonly x: number;
  /** See `x`. */
  readonly y: number;
  /** See `x`. */
  readonly z: number;
  /** The cosine of half the angle. */
  readonly w: number;
}

/** Turns a direction of the file upwards, to y; what is to the right stays there for y and z, flipped or not. */
export function rotationUp([x, y, z]: readonly [number, number, number]): Rotation {
  // From straight below there is no shortest way.
  if (y < -0.999) return { x: 1, y: 0, z: 0, w: 0 };
  // About the axis across both, by half of the angle between them.
  const length = Math.hypot(z, x, y + 1);
  return { x: -z / length, y: 0, z: x / length, w: (y + 1) / length };
}

/** More vertices than these show no more of the shape. */
const enough = 60_000;
/** Points so near to the ground, as a share of the size, stand on it. */
const footing = 0.03;
/** A rod is so much longer than thick, in standard deviations, and its axis so far from all others. */
const rodLength = 3.5;
const rodCosine = Math.cos(Math.PI / 6);

type Point = readonly [number, number, number];

const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a: Point, b: Point): Point => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** A guess from the shape alone. */
export function guessedUp(
  positions: Float32Array,
  indices: Uint32Array,
): Pick<UpAxis, 'direction' | 'name'> {
  const points = sampled(positions);
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (const point of points) {
    point.forEach((x, k) => {
      low[k] = Math.min(low[k]!, x);
      high[k] = Math.max(high[k]!, x);
    });
  }
  const size = Math.hypot(...high.map((most, k) => most - low[k]!)) || 1;
  const { middle, axis, ratio } = momentsOf(positions, indices, low);
  if (ratio > rodLength && axis.every((share) => Math.abs(share) < rodCosine)) {
    // Rather as the axes of the file have it.
    const sign = Math.sign(axis[1] + axis[2]) || 1;
    const [x, y, z] = axis;
    return { direction: [sign * x, sign * y, sign * z], name: undefined };
  }
  const standing = (up: 1 | 2): number => {
    const height = high[up] - low[up];
    const across = (3 - up) as 1 | 2;
    const plan = points.map((point) => [point[0], point[across], point[up] - low[up]] as const);
    const feet = plan.filter(([, , above]) => above < footing * size);
    const span = Math.sqrt(spread(feet) / (spread(plan) || 1));
    return height / size + span + (middle[up]! - low[up]) / (height || 1);
  };
  const name = standing(2) > standing(1) ? 'z' : 'y';
  return { direction: directions[name], name };
}

function sampled(positions: Float32Array): Point[] {
  const count = positions.length / 3;
  const step = Math.max(1, Math.floor(count / enough));
  return Array.from({ length: Math.ceil(count / step) }, (_, i) => {
    const k = 3 * step * i;
    return [positions[k]!, positions[k + 1]!, positions[k + 2]!];
  });
}

/** The area of a polygon round points of a plane, through those that are extreme in 24 directions. */
function spread(points: readonly Point[]): number {
  if (points.length === 0) return 0;
  const corners = Array.from({ length: 24 }, (_, k) => {
    const [right, up] = [Math.cos((k * Math.PI) / 12), Math.sin((k * Math.PI) / 12)];
    let [most, corner] = [-Infinity, points[0]!];
    for (const point of points) {
      const reach = right * point[0] + up * point[1];
      if (reach > most) [most, corner] = [reach, point];
    }
    return corner;
  });
  return corners.reduce((area, [x, y], k) => {
    const [nextX, nextY] = corners[(k + 1) % corners.length]!;
    return area + 0.5 * (x * nextY - y * nextX);
  }, 0);
}

/** The middle of the surface, its longest axis, and how much longer that is than the next one. */
function momentsOf(positions: Float32Array, indices: Uint32Array, origin: Point) {
  const step = 3 * Math.max(1, Math.floor(indices.length / 3 / enough));
  const middle = [0, 0, 0];
  const second = [0, 1, 2].map(() => [0, 0, 0]);
  let area = 0;
  for (let i = 0; i < indices.length; i += step) {
    const corner = (k: number): Point => {
      const at = 3 * indices[i + k]!;
      return minus([positions[at]!, positions[at + 1]!, positions[at + 2]!], origin);
    };
    const [a, b, c] = [corner(0), corner(1), corner(2)];
    const weight = Math.hypot(...cross(minus(b, a), minus(c, a)));
    area += weight;
    const sum: Point = [a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2]];
    const places = [a, b, c, sum];
    for (let k = 0; k < 3; ++k) {
      middle[k]! += (weight * sum[k]!) / 3;
      // Exact for a triangle: a twelfth of the products of the corners and of their sum.
      for (let l = 0; l < 3; ++l) {
        for (const place of places) second[k]![l]! += (weight * place[k]! * place[l]!) / 12;
      }
    }
  }
  area ||= 1;
  const spreads = second.map((row, k) =>
    row.map((sum, l) => sum / area - (middle[k]! * middle[l]!) / area ** 2),
  );
  const [axis, longest] = greatestOf(spreads);
  const rest = spreads.map((row, k) => row.map((x, l) => x - longest * axis[k]! * axis[l]!));
  const [, next] = greatestOf(rest);
  return {
    middle: middle.map((sum, k) => sum / area + origin[k]!),
    axis,
    ratio: Math.sqrt(longest / (next || longest || 1)),
  };
}

/** The greatest eigenvalue of a symmetric matrix of no negative ones and its vector, by repeated products. */
function greatestOf(matrix: readonly (readonly number[])[]): [[number, number, number], number] {
  let [x, y, z] = [0.48, 0.6, 0.64];
  let length = 0;
  for (let i = 0; i < 100; ++i) {
    const [u, v, w] = matrix.map((row) => row[0]! * x + row[1]! * y + row[2]! * z);
    length = Math.hypot(u!, v!, w!);
    if (length === 0) break;
    [x, y, z] = [u! / length, v! / length, w! / length];
  }
  return [[x, y, z], length];
}

/** The positions of a surface that is turned; the same array where it is not. */
export function uprightPositions(positions: Float32Array, rotation: Rotation): Float32Array {
  if (rotation.w === 1) return positions;
  const turned = new Float32Array(positions.length);
  const { x, y, z, w } = rotation;
  // Three numbers for each product across: lists of them would be too many.
  for (let i = 0; i < positions.length; i += 3) {
    const [a, b, c] = [positions[i]!, positions[i + 1]!, positions[i + 2]!];
    const [u, v, t] = [y * c - z * b, z * a - x * c, x * b - y * a];
    turned[i] = a + 2 * (w * u + (y * t - z * v));
    turned[i + 1] = b + 2 * (w * v + (z * u - x * t));
    turned[i + 2] = c + 2 * (w * t + (x * v - y * u));
  }
  return turned;
}
