/**
 * The kernel: `import { createKernel } from 'girth'`. Everything is computed in workers.
 * @module girth
 */

export { createKernel } from './kernel.js';
export { GirthError } from './errors.js';
export {
  type SignatureNumbers,
  fieldListTitles,
  fieldMeanings,
  fieldTitles,
  persistentFields,
  signatureNumbers,
  usualTime,
} from './fields.js';
export { type LengthUnit, findLengthUnit, lengthUnits } from './length-units.js';
export { version } from './version.js';
export { type ZipFile, readZip } from './zip.js';
export type * from './types.js';
