import { expect, test } from 'vitest';
import {
  type OutlineScene,
  type Stroke,
  outlineOf,
  seenPieces,
} from '../../../web/src/view/outline.js';

/** CSS pixels for each unit. */
const scale = 100;
/** So far away that one looks straight down the z axis. */
const far = 1e7;

interface Soup {
  positions: number[];
  indices: number[];
}

/** A square in a plane of z, its front upwards. */
const square = (low: number, high: number, z: number): Soup => ({
  positions: [low, low, z, high, low, z, high, high, z, low, high, z],
  indices: [0, 1, 2, 0, 2, 3],
});

function together(...soups: Soup[]): Soup {
  const all: Soup = { positions: [], indices: [] };
  for (const { positions, indices } of soups) {
    const first = all.positions.length / 3;
    all.positions.push(...positions);
    all.indices.push(...indices.map((vertex) => vertex + first));
  }
  return all;
}

/** Seen from above, where `covers` says what lies over a point. */
const fromAbove = (
  soup: Soup,
  covers: (x: number, y: number, z: number) => boolean,
): OutlineScene => ({
  ...soup,
  eye: [0, 0, far],
  place: (x, y) => ({ x: scale * x, y: scale * y }),
  hides: covers,
});

const lengthOf = (strokes: readonly Stroke[]): number =>
  strokes.reduce((sum, stroke) => {
    let length = 0;
    for (let i = 2; i < stroke.length; i += 2) {
      length += Math.hypot(stroke[i]! - stroke[i - 2]!, stroke[i + 1]! - stroke[i - 1]!);
    }
    return sum + length;
  }, 0);

/** A cube, its faces outwards, turned so that three of them are seen. */
function cube(): Soup {
  const corner = (i: number): number[] => [i & 1, (i >> 1) & 1, i >> 2].map((one) => 2 * one - 1);
  const turned = ([x = 0, y = 0, z = 0]: number[]): number[] => {
    const [a, b] = [0.5, 0.7];
    const [u, v] = [x * Math.cos(a) - y * Math.sin(a), x * Math.sin(a) + y * Math.cos(a)];
    return [u, v * Math.cos(b) - z * Math.sin(b), v * Math.sin(b) + z * Math.cos(b)];
  };
  const quads = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  return {
    positions: Array.from({ length: 8 }, (_, i) => turned(corner(i))).flat(),
    indices: quads.flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!]),
  };
}

test('of a square the boundary is drawn, as one line; a diagonal is no edge of it', () => {
  const { contours, creases } = outlineOf(fromAbove(square(0, 1, 0), () => false));
  expect(creases).toEqual([]);
  expect(contours).toHaveLength(1);
  expect(lengthOf(contours)).toBeCloseTo(4 * scale, 6);
});

test('of a cube that hides its far side, six edges are contours and three are sharp', () => {
  const soup = cube();
  // The lowest corner is the one that is not seen: all that is lower than the middle of three edges to it.
  const corners = Array.from({ length: 8 }, (_, i) => soup.positions.slice(3 * i, 3 * i + 3));
  const lowest = corners.reduce((low, one) => (one[2]! < low[2]! ? one : low));
  const isAtLowest = (x: number, y: number, z: number): boolean => {
    const away = Math.hypot(x - lowest[0]!, y - lowest[1]!, z - lowest[2]!);
    return corners.some((corner) => {
      const length = Math.hypot(...corner.map((one, k) => one - lowest[k]!));
      const rest = Math.hypot(x - corner[0]!, y - corner[1]!, z - corner[2]!);
      return Math.abs(length - 2) < 1e-9 && Math.abs(away + rest - 2) < 1e-9;
    });
  };
  const { contours, creases } = outlineOf(fromAbove(soup, isAtLowest));
  const edgesAt = (corner: number[]): number =>
    corners
      .filter((other) => Math.abs(Math.hypot(...other.map((x, k) => x - corner[k]!)) - 2) < 1e-9)
      .reduce((sum, other) => sum + Math.hypot(other[0]! - corner[0]!, other[1]! - corner[1]!), 0);
  const highest = corners.reduce((high, one) => (one[2]! > high[2]! ? one : high));
  // Four edges of each direction, of which one ends at the highest corner and one at the lowest.
  expect(lengthOf(creases)).toBeCloseTo(scale * edgesAt(highest), 6);
  expect(lengthOf(contours)).toBeCloseTo(2 * scale * edgesAt(highest), 6);
  expect(contours).toHaveLength(1);
});

test('what lies below something else is left out, to two pixels', () => {
  // The upper square covers a corner of the lower one.
  const soup = together(square(0, 1, 0), square(0.5, 2, 1));
  const covers = (x: number, y: number, z: number): boolean => z < 0.5 && x > 0.5 && y > 0.5;
  const { contours } = outlineOf(fromAbove(soup, covers));
  expect(contours).toHaveLength(2);
  expect(Math.abs(lengthOf(contours) - scale * (4 * 1.5 + 3))).toBeLessThan(4);
});

test('a line is seen and hidden by turns, and nothing of it is lost', () => {
  const line = [0, 0, 0, 10, 0, 0, 10, 10, 0];
  const scene = fromAbove(square(0, 1, 0), (x, y) => Math.floor(x + y) % 2 === 1);
  const { seen, hidden } = seenPieces(scene, line);
  expect([seen.length, hidden.length]).toEqual([10, 10]);
  expect(lengthOf(seen) + lengthOf(hidden)).toBeCloseTo(20 * scale, 6);
  expect(lengthOf(seen)).toBeCloseTo(10 * scale, 6);
  // A straight run is two points, and a bend a third one.
  for (const stroke of [...seen, ...hidden]) expect(stroke.length).toBeLessThanOrEqual(6);
  expect(seenPieces(scene, [])).toEqual({ seen: [], hidden: [] });
});
