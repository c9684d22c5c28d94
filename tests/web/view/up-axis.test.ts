// Which way is up: conventions, choices, and the guess from the shape.

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { guessedUp, rotationUp, upAxisOf, upNames } from '../../../web/src/view/up-axis.js';
import { boxes } from './boxes.js';

/** A long table on four thin legs, y upwards. */
const table = boxes(
  [
    [0, 4, 0],
    [10, 5, 5],
  ],
  ...[0, 9].flatMap((x) =>
    [0, 4].map((z): [number[], number[]] => [
      [x, 0, z],
      [x + 1, 4, z + 1],
    ]),
  ),
);

/** A surface with other coordinates for x, y and z. */
function turned(positions: Float32Array, turn: (x: number, y: number, z: number) => number[]) {
  const places = Array.from({ length: positions.length / 3 }, (_, i) =>
    turn(positions[3 * i]!, positions[3 * i + 1]!, positions[3 * i + 2]!),
  );
  return Float32Array.from(places.flat());
}

describe('the guess', () => {
  test('a table stands on its legs, whichever axis they are along', () => {
    expect(guessedUp(table.positions, table.indices).name).toBe('y');
    const zUp = turned(table.positions, (x, y, z) => [x, -z, y]);
    expect(guessedUp(zUp, table.indices).name).toBe('z');
  });

  test('far from the origin, tiny and huge it is the same', () => {
    for (const [scale, shift] of [
      [1e-20, 0],
      [1e20, 0],
      [1, 1e4],
    ] as const) {
      const zUp = turned(table.positions, (x, y, z) =>
        [x, -z, y].map((place) => place * scale + shift),
      );
      expect(guessedUp(zUp, table.indices).name).toBe('z');
    }
  });

  test('a rod that lies askew stands on its end', () => {
    const rod = boxes([
      [0, 0, 0],
      [1, 20, 1],
    ]);
    const askew = turned(rod.positions, (x, y, z) => [
      x,
      (y + z) / Math.SQRT2,
      (y - z) / Math.SQRT2,
    ]);
    const { direction, name } = guessedUp(askew, rod.indices);
    expect(name).toBeUndefined();
    expect(direction[1]).toBeCloseTo(Math.SQRT1_2, 2);
    expect(direction[2]).toBeCloseTo(Math.SQRT1_2, 2);
  });

  test('a point, or nothing, has an answer', () => {
    expect(guessedUp(new Float32Array(3), new Uint32Array(3)).name).toBe('y');
  });
});

test('a choice comes first, then the format', () => {
  const { positions, indices } = table;
  const up = (wished: string | null, format: string) => {
    const { name, by } = upAxisOf(wished, format, positions, indices);
    return [name, by];
  };
  expect(up('-z', 'GLB')).toEqual(['-z', 'choice']);
  expect(up('sideways', 'GLB')).toEqual(['y', 'format']);
  expect(up(null, 'STL')).toEqual(['z', 'format']);
  expect(up(null, 'OFF')).toEqual(['y', 'guess']);
});

test('every direction is turned upwards without a mirror', () => {
  for (const name of upNames) {
    const { direction } = upAxisOf(name, '', table.positions, table.indices);
    const rotation = rotationUp(direction);
    const up = new Vector3(...direction).applyQuaternion(rotation);
    expect(up.distanceTo(new Vector3(0, 1, 0))).toBeLessThan(1e-12);
    const { x, y, z, w } = rotation;
    expect(Math.hypot(x, y, z, w)).toBeCloseTo(1, 12);
    // The right stays on the right where it can.
    const right = new Vector3(1, 0, 0).applyQuaternion(rotation);
    if (!name.endsWith('x')) expect(right.x).toBeCloseTo(1, 12);
  }
});

const corpus = process.env['GIRTH_DATA'];
describe.skipIf(!corpus || !existsSync(corpus))('of the corpus', () => {
  const guess = (path: string) => {
    const words = readFileSync(join(corpus!, path), 'utf8').split(/\s+/).map(Number);
    const [vertices = 0, faces = 0] = words.slice(1);
    const positions = Float32Array.from(words.slice(4, 4 + 3 * vertices));
    const indices = words
      .slice(4 + 3 * vertices, 4 + 3 * vertices + 4 * faces)
      .filter((_, i) => i % 4 !== 0);
    return guessedUp(positions, Uint32Array.from(indices));
  };
  test('horse, cat and dancer stand on their feet', () => {
    expect(guess('models/horse_6000f.off').name).toBe('y');
    expect(guess('models/horse_39996f.off').name).toBe('z');
    expect(guess('retrieval/tosca_iso_5k/cat0.off').name).toBe('z');
    const { direction, name } = guess('models/dancer_49996f_g1.off');
    expect(name).toBeUndefined();
    expect(direction[1]).toBeGreaterThan(0.6);
    expect(direction[2]).toBeGreaterThan(0.6);
  });
});
