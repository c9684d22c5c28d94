// The requests for fields that workers receive. A parameter that the caller has left out stays so: C++ has the
// defaults.

import { failure } from './errors.js';
import {
  fieldUnits,
  girthModuleFields,
  parameterPaths,
  signatureNumbers,
  usualTime,
} from './fields.js';
import type { FieldRequest, SpectralRequest } from './protocol.js';
import type {
  FieldName,
  FieldOptions,
  SpectralFieldName,
  SpectralOptions,
  VertexFieldName,
} from './types.js';

const isField = (name: string): name is FieldName => Object.hasOwn(fieldUnits, name);

export const isLength = (name: string) => isField(name) && fieldUnits[name] === 'Length';

export const isSpectral = (name: FieldName): name is SpectralFieldName =>
  Object.hasOwn(signatureNumbers, name);

/** Whether the small module has it. */
export const isPlainGirth = ({ name, persistence = 0 }: FieldRequest) =>
  girthModuleFields.includes(name) && persistence === 0;

/** Whether each value has a kind. */
export const hasKinds = ({ name }: FieldRequest) => name === 'igf' || name === 'barcode';

/** Throws where there is no such field. */
export function checkName(name: string): void {
  if (isField(name)) return;
  const known = Object.keys(fieldUnits).map((one) => `'${one}'`);
  throw failure('USAGE', `there is no field '${name}'`, { hint: `use ${known.join(', ')}` });
}

/** The request for a field. The core checks the numbers. */
export function fieldRequest(name: VertexFieldName, options: FieldOptions): FieldRequest {
  const parameters = parameterPaths.map((path) => {
    const found = path
      .split('.')
      .reduce<unknown>(
        (held, key) => (held as Record<string, unknown> | undefined)?.[key],
        options,
      );
    return [path, found] as const;
  });
  return { name, ...(Object.fromEntries(parameters) as Omit<FieldRequest, 'name'>) };
}

/** The request for the barcodes of all vertices. */
export const barcodeRequest = (maxPersistence: number): FieldRequest => ({
  name: 'barcode',
  persistence: maxPersistence,
});

/** The request for a spectral field. */
export const spectralRequest = (
  name: SpectralFieldName,
  { pairs, time, component }: SpectralOptions = {},
): SpectralRequest => ({ name, pairs, time, component });

/** Which number of its signature a field is, in words; '' for the default. */
export function spectralNote({ name, time, component }: SpectralRequest): string {
  const { count, usual } = signatureNumbers[name];
  if (name === 'hks') {
    return time === undefined || time === usualTime
      ? ''
      : `heat after the time ${time} of the area`;
  }
  if (component === undefined || component === usual) return '';
  return `${name === 'wks' ? 'energy' : 'frequency'} ${component} of ${count}`;
}
