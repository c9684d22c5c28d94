// The requests for fields that workers receive.

import { failure } from './errors.js';
import type { FieldRequest, SpectralRequest } from './protocol.js';
import type {
  FieldName,
  FieldOptions,
  SpectralFieldName,
  SpectralOptions,
  VertexFieldName,
} from './types.js';

type Kind = 'length' | 'angle' | 'density' | 'number';

/** All fields, and what their values are. */
const kinds: Record<FieldName, Kind> = {
  igf: 'length',
  sdf: 'length',
  thickness: 'length',
  geoaverage: 'length',
  geofarthest: 'length',
  angle: 'angle',
  hks: 'density',
  wks: 'density',
  sihks: 'number',
};

export const isLength = (name: string) =>
  Object.hasOwn(kinds, name) && kinds[name as FieldName] === 'length';

export const isSpectral = (name: FieldName): name is SpectralFieldName =>
  name === 'hks' || name === 'wks' || name === 'sihks';

/** Whether it is the girth or the angle of its loops, with no regard to how long saddles last. */
export const isPlainGirth = ({ name, persistence }: FieldRequest) =>
  (name === 'igf' || name === 'angle') && persistence === 0;

/** Whether each value has a kind. */
export const hasKinds = ({ name }: FieldRequest) => name === 'igf' || name === 'barcode';

/** Throws where there is no such field. */
export function checkName(name: string): void {
  if (Object.hasOwn(kinds, name)) return;
  const known = Object.keys(kinds).map((one) => `'${one}'`);
  throw failure('USAGE', `there is no field '${name}'`, { hint: `use ${known.join(', ')}` });
}

/** The unit of a field on a model with the unit `unit`. */
export function unitOf(name: FieldName, unit: string): string {
  const kind = kinds[name];
  if (kind === 'length') return unit;
  if (kind === 'angle') return 'rad';
  return kind === 'density' && unit !== '' ? `1/${unit}²` : '';
}

/** The request with defaults for what the caller left out. The core checks the numbers. */
export function fieldRequest(name: VertexFieldName, options: FieldOptions): FieldRequest {
  const {
    sdf: { coneAngle = (2 * Math.PI) / 3, rays = 30 } = {},
    thickness: { sharpAngle = (5 * Math.PI) / 12 } = {},
    distances = 'fast-marching',
    persistence = 0,
  } = options;
  return { name, coneAngle, rays, sharpAngle, distances, persistence };
}

/** The request for the barcodes of all vertices. */
export const barcodeRequest = (maxPersistence: number): FieldRequest => ({
  ...fieldRequest('igf', { persistence: maxPersistence }),
  name: 'barcode',
});

/** The same for a spectral field. */
export function spectralRequest(
  name: SpectralFieldName,
  { pairs = 300, time = 2e-3, component = name === 'wks' ? 20 : 1 }: SpectralOptions = {},
): SpectralRequest {
  return { name, pairs, time, component };
}

/** Which number of its signature a field is, in words; '' for the default. */
export function spectralNote({ name, time, component }: SpectralRequest): string {
  const usual = spectralRequest(name);
  if (name === 'hks') return time === usual.time ? '' : `heat after the time ${time} of the area`;
  if (component === usual.component) return '';
  return name === 'wks' ? `energy ${component} of 100` : `frequency ${component} of 19`;
}
