// Results of a surface for the same surface in another size: lengths grow with it, and nothing is computed again.

import type { Field, MeshGeometry } from '../../src/kernel/index.js';
import { fieldUnits } from '../../src/kernel/types/fields.js';
import { type GirthViewer, fieldNames } from '../../src/element/index.js';
import { type PageState, spectralIn } from '../state/address-state.js';
import type { ComputedFields } from './computed-fields.js';

/** How far positions may be off the grown ones, as a share of the size: they are rounded to 24 bits. */
const rounding = 1e-6;

/** The ratio of the sizes of two surfaces that differ in nothing else; undefined for others. */
export function growthOf(before: MeshGeometry, now: MeshGeometry): number | undefined {
  const [from, to] = [before.positions, now.positions];
  if (from.length !== to.length || before.indices.length !== now.indices.length) return undefined;
  if (before.indices.some((vertex, i) => vertex !== now.indices[i])) return undefined;
  const size = largest(to);
  const ratio = size / largest(from);
  if (!(ratio > 0 && ratio < Infinity)) return undefined;
  const most = rounding * size;
  const isGrown = from.every((number, i) => Math.abs(ratio * number - to[i]!) <= most);
  return isGrown ? ratio : undefined;
}

/** The largest absolute coordinate. */
function largest(positions: Float32Array): number {
  let most = 0;
  for (const number of positions) most = Math.max(most, Math.abs(number));
  return most;
}

/** The power of a length that a field's values are. */
const powers = { Length: 1, PerArea: -2, Radian: 0, Number: 0 } as const;

/** A field of a surface that is `ratio` times as large. */
export function grownField(field: Field, ratio: number): Field {
  const factor = ratio ** powers[fieldUnits[field.name]];
  const [low, high] = field.range;
  return {
    ...field,
    values: field.values.map((value) => value * factor),
    range: [low * factor, high * factor],
    ...(field.persistence === undefined ? {} : { persistence: field.persistence * ratio }),
  };
}

/**
 * Takes the fields that are computed of the shown surface. The returned function hands them to the next surface, if
 * that is the same in another size.
 */
export function takeResults(
  viewer: GirthViewer,
  computed: ComputedFields,
  state: PageState,
): () => void {
  const before = viewer.geometry;
  const taken: Field[] = [];
  for (const name of fieldNames) {
    if (!computed.has(name)) continue;
    void viewer.fieldOf(name).then(
      (field) => taken.push(field),
      // Without it the next surface computes its own.
      () => undefined,
    );
  }
  return () => {
    if (taken.length === 0) return;
    const ratio = growthOf(before, viewer.geometry);
    if (ratio === undefined) return;
    for (const field of taken) {
      viewer.adopt(grownField(field, ratio), spectralIn(state, field.name));
    }
  };
}
