// A mesh as the element asks for it, of which everything is known already and nothing is computed.

import { disposal } from '../../kernel/types/disposal.js';
import { cancelled } from '../../kernel/types/errors.js';
import type { Field, FieldName, Loop, Mesh, MeshInfo } from '../../kernel/types/types.js';
import { nothingPrepared } from './nothing-prepared.js';
import { refusedCalls } from '../attributes/refused-calls.js';

/** The content that a saved page shows. */
export interface ShownContent {
  name: string;
  /** The name of the unit of lengths; '' where it is not known. */
  unit: string;
  origin: [number, number, number];
  /** Extent along x, y and z. */
  size: [number, number, number];
  area: number;
  /** The positions, as of `MeshGeometry`. */
  positions: Float32Array;
  indices: Uint32Array;
  boundary: Uint32Array;
  /** The area that each vertex stands for. */
  areas: Float64Array;
  /** The one field whose values are there. */
  field: Pick<Field, 'name' | 'values' | 'kinds' | 'unit' | 'method'> | undefined;
  /** The loops that are there, each at its point `base`. */
  loops: readonly Loop[];
}

/** Why nothing else can be had. It is no failure: the element shows what there is. */
const isNotThere = () => Promise.reject(cancelled('this page carries values and computes none'));

export function shownMesh(content: ShownContent): Mesh {
  const { positions, indices, boundary, origin } = content;
  const info: MeshInfo = {
    name: content.name,
    models: [],
    unreadable: [],
    format: 'arrays',
    vertexCount: positions.length / 3,
    faceCount: indices.length / 3,
    edgeCount: (indices.length + boundary.length / 2) / 2,
    // Facts that the page does not carry, and the element does not ask for.
    components: 0,
    genus: [],
    boundaries: [],
    parts: [],
    area: content.area,
    size: content.size,
    unit: content.unit,
    report: {
      ...nothingPrepared,
      inputVertices: positions.length / 3,
      inputFaces: indices.length / 3,
      boundaryEdges: boundary.length / 2,
    },
    notes: [],
  };
  return {
    info,
    geometry: { positions, indices, boundary, origin },
    vertexOfInput: Uint32Array.from({ length: info.vertexCount }, (_, vertex) => vertex),
    ...refusedCalls(isNotThere),
    field: (name: FieldName) =>
      content.field?.name === name ? Promise.resolve(wholeField(content.field)) : isNotThere(),
    loop: (point) => {
      const wanted = JSON.stringify(point);
      const found = content.loops.find(({ base }) => JSON.stringify(base) === wanted);
      return found ? Promise.resolve(found) : isNotThere();
    },
    vertexAreas: () => Promise.resolve(content.areas),
    dispose: () => undefined,
    [disposal]: () => undefined,
  };
}

function wholeField(field: NonNullable<ShownContent['field']>): Field {
  const range: [number, number] = [Infinity, -Infinity];
  let withoutValue = 0;
  for (const value of field.values) {
    if (Number.isNaN(value)) ++withoutValue;
    else {
      range[0] = Math.min(range[0], value);
      range[1] = Math.max(range[1], value);
    }
  }
  const isEmpty = withoutValue === field.values.length;
  return { ...field, range: isEmpty ? [NaN, NaN] : range, withoutValue, note: '' };
}
