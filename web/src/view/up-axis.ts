// Which way is up in a file: by the convention of its format, otherwise by a guess from the shape.
//
// The guess weighs the y and the z axis. A body stands where it is tall, where its middle is high and where its
// feet span much of its plan; each counts from 0 to 1, and z must have more than y. Of 76 animals and people
// of the TOSCA models, whose z axis points up in all poses, 64 are guessed right. A rod that lies askew to all
// three axes, such as a figure on tiptoe, stands on its end.

import { Quaternion, Vector3 } from 'three';

/** The directions that can be chosen, the usual ones first. */
export const upNames = ['y', 'z', '-y', '-z', 'x', '-x'] as const;
/** A direction of the file's coordinates. */
export type UpName = (typeof upNames)[number];

/** Which way is up, and how that is known. */
export interface UpAxis {
  /** Of length 1, in the file's coordinates. */
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
  const up = new Vector3(0, 1, 0);
  // From straight below there is no shortest way.
  if (y < -0.999) return new Quaternion(1, 0, 0, 0);
  return new Quaternion().setFromUnitVectors(new Vector3(x, y, z), up);
}

/** More vertices than these show no more of the shape. */
const enough = 60_000;
/** What is so near to the ground, as a share of the size, stands on it. */
const footing = 0.03;
/** A rod is so much longer than thick, in standard deviations, and its axis so far from all others. */
const rodLength = 3.5;
const rodCosine = Math.cos(Math.PI / 6);

type Point = readonly [number, number, number];

/** A guess from the shape alone. */
export function guessedUp(
  positions: Float32Array,
  indices: Uint32Array,
): Pick<UpAxis, 'direction' | 'name'> {
  const points = sampled(positions);
  const [low, high] = [Array<number>(3).fill(Infinity), Array<number>(3).fill(-Infinity)];
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
    const height = high[up]! - low[up]!;
    const across = (3 - up) as 1 | 2;
    const plan = points.map((point) => [point[0], point[across], point[up] - low[up]!] as const);
    const feet = plan.filter(([, , above]) => above < footing * size);
    const span = Math.sqrt(spread(feet) / (spread(plan) || 1));
    return height / size + span + (middle[up]! - low[up]!) / (height || 1);
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
function momentsOf(positions: Float32Array, indices: Uint32Array, origin: readonly number[]) {
  const step = 3 * Math.max(1, Math.floor(indices.length / 3 / enough));
  const middle = [0, 0, 0];
  const second = [0, 1, 2].map(() => [0, 0, 0]);
  const corners = [new Vector3(), new Vector3(), new Vector3()] as const;
  const [one, other] = [new Vector3(), new Vector3()];
  const shift = new Vector3().fromArray(origin);
  let area = 0;
  for (let i = 0; i < indices.length; i += step) {
    corners.forEach((corner, k) => corner.fromArray(positions, 3 * indices[i + k]!).sub(shift));
    const [a, b, c] = corners;
    const weight = one.subVectors(b, a).cross(other.subVectors(c, a)).length();
    area += weight;
    const sum = a.clone().add(b).add(c).toArray();
    const places = [...corners.map((corner) => corner.toArray()), sum];
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
  const point = new Vector3();
  for (let i = 0; i < positions.length; i += 3) {
    point.fromArray(positions, i).applyQuaternion(rotation).toArray(turned, i);
  }
  return turned;
}
