/**
 * The kernel: `import { createKernel } from 'girth'`. Everything is computed in workers.
 * @module girth
 */

export { createKernel } from './page/kernel.js';
export { GirthError } from './types/errors.js';
export {
  type SignatureNumbers,
  fieldListTitles,
  fieldMeanings,
  fieldTitles,
  persistentFields,
  signatureNumbers,
  usualTime,
} from './types/fields.js';
export { type LengthUnit, findLengthUnit, lengthUnits } from './types/length-units.js';
export { unitName, unitSymbol } from './types/units.js';
export { version } from './types/version.js';
export { type ZipFile, readZip } from './unpack/zip.js';
export type * from './types/types.js';
