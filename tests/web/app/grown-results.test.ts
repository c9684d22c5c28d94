// Results of a surface for the same surface in another size.

import { expect, test } from 'vitest';
import { grownField, growthOf } from '../../../web/app/model/grown-results.js';
import type { Field, MeshGeometry } from '../../../web/src/kernel/index.js';

const geometry = (scale: number, more: Partial<MeshGeometry> = {}): MeshGeometry => ({
  positions: Float32Array.of(0, 0, 0, 1 / 3, 0, 0, 0, -0.7, 0).map((one) =>
    Math.fround(one * scale),
  ),
  indices: Uint32Array.of(0, 1, 2),
  boundary: new Uint32Array(),
  origin: [0, 0, 0],
  ...more,
});

const field = (name: Field['name'], values: number[]): Field => ({
  ...{ name, kinds: new Uint8Array(), unit: '', method: 'exact', withoutValue: 1, note: '' },
  values: Float64Array.from(values),
  range: [values[0]!, values[1]!],
});

test.each([25.4, 1e-6, 3e7, 1])('the same surface, %d times as large', (scale) => {
  expect(growthOf(geometry(1), geometry(scale))! / scale).toBeCloseTo(1, 6);
});

test('a surface of other triangles, other places or no size is another one', () => {
  const before = geometry(1);
  expect(growthOf(before, geometry(2, { indices: Uint32Array.of(0, 2, 1) }))).toBe(undefined);
  expect(growthOf(before, geometry(2, { indices: new Uint32Array() }))).toBe(undefined);
  const moved = geometry(2);
  moved.positions[4] = 1e-3;
  expect(growthOf(before, moved)).toBe(undefined);
  expect(growthOf(before, geometry(0))).toBe(undefined);
});

test('lengths grow with a surface, angles stay, and shares of an area fall', () => {
  const values = [1, 4, NaN];
  expect([...grownField(field('igf', values), 10).values]).toEqual([10, 40, NaN]);
  expect(grownField(field('thickness', values), 10).range).toEqual([10, 40]);
  expect([...grownField(field('angle', values), 10).values]).toEqual(values);
  expect([...grownField(field('hks', values), 10).values]).toEqual([0.01, 0.04, NaN]);
  const persistent = { ...field('igf', values), persistence: 0.5 };
  expect(grownField(persistent, 10).persistence).toBe(5);
});
