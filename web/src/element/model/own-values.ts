// Values at the vertices of a GLB that was opened by hand, beside all that the kernel can compute.
// The module is fetched when a file is opened so, and uses functions that are handed to it.

import type { failure } from '../../kernel/types/errors.js';
import type { Mesh, MeshSource } from '../../kernel/types/types.js';
import type { readFigure } from './figure-file.js';
import type { GivenField, carriedTo, givenFields } from './given-fields.js';
import type { FileContent, onlySurface } from './file-content.js';

/** The functions that reading values uses. */
export interface ValuesKit {
  readFigure: typeof readFigure;
  givenFields: typeof givenFields;
  carriedTo: typeof carriedTo;
  onlySurface: typeof onlySurface;
}

/**
 * The values of a GLB at the vertices of its mesh, beside fields of the kernel; undefined for none,
 * and for other files. `scale`: how many times as large as the file the mesh is.
 */
export async function ownValues(
  source: MeshSource,
  { vertexOfInput, info }: Mesh,
  scale: number,
  { readFigure, givenFields, carriedTo, onlySurface }: ValuesKit,
): Promise<FileContent | undefined> {
  if (!(source instanceof File) || !/\.glb$/i.test(source.name)) return undefined;
  // The document says whether it is worth while to read the rest.
  const head = new DataView(await source.slice(0, 20).arrayBuffer());
  const length = head.byteLength === 20 ? head.getUint32(12, true) : 0;
  if (!/"_\w/.test(await source.slice(20, 20 + length).text())) return undefined;
  const file = readFigure(await source.arrayBuffer());
  const own = givenFields(file?.fields ?? []).filter(({ name }) => name.startsWith('_'));
  const fields = carriedTo(own, vertexOfInput, info.vertexCount).map((field) =>
    field.unit === 'metre' && scale !== 1 ? resized(field, scale) : field,
  );
  return fields.length > 0 ? { ...onlySurface, fields } : undefined;
}

/** Lengths on a surface that is so many times as large. */
function resized(field: GivenField, scale: number): GivenField {
  const values = field.values.map((length) => scale * length);
  return { ...field, values, range: [scale * field.range[0], scale * field.range[1]] };
}

/** The failure of a wish for values that the file has not. */
export function notGiven(name: string, known: readonly string[], fail: typeof failure): Error {
  return fail('USAGE', `the model has no values called ${name}`, {
    hint: known.length > 0 ? `it has ${known.join(', ')}` : 'only GLB files have values in them',
  });
}
