// Fields as workers are asked for them.

import { failure } from './errors.js';
import type { FieldRequest } from './protocol.js';
import type { FieldName, FieldOptions } from './types.js';

/** All fields; whether their values are lengths. */
const names: Record<FieldName, { isLength: boolean }> = {
  igf: { isLength: true },
  sdf: { isLength: true },
  geoaverage: { isLength: true },
  geofarthest: { isLength: true },
  angle: { isLength: false },
};

export const isLength = (name: string) =>
  Object.hasOwn(names, name) && names[name as FieldName].isLength;

/** Whether each value also says how it came about. */
export const hasKinds = ({ name }: FieldRequest) => name === 'igf';

/** The request with everything that the caller did not say. The core checks the numbers. */
export function fieldRequest(name: FieldName, options: FieldOptions): FieldRequest {
  if (!Object.hasOwn(names, name)) {
    const known = Object.keys(names).map((one) => `'${one}'`);
    throw failure('USAGE', `there is no field '${String(name)}'`, {
      hint: `use ${known.join(', ')}`,
    });
  }
  const { sdf: { coneAngle = (2 * Math.PI) / 3, rays = 30 } = {}, distances = 'fast-marching' } =
    options;
  return { name, coneAngle, rays, distances };
}
