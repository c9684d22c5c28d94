// Operations of the module for analysis that other calls of a mesh need: carried values, and files.

import { takes } from './table.js';

interface OneFile {
  bytes: Uint8Array<ArrayBuffer>;
}
interface Files {
  files: Uint8Array<ArrayBuffer>[];
}

/** Operations behind calls of other names. */
export const serving = {
  /** An analysis of the table by its name; `wanted`: its options. */
  analyse: takes('surface', 'analysis', 'wanted', 'onProgress').gives<object>(),
  carryBack: takes('surface', 'remeshed', 'values', 'kinds').gives<{
    values: Float64Array<ArrayBuffer>;
    kinds: Uint8Array<ArrayBuffer>;
  }>(),
  writeModel: takes('surface', 'model', 'format').gives<OneFile>(),
  writeFields: takes('surface', 'model', 'named', 'format').gives<OneFile>(),
  writeLoops: takes('surface', 'model', 'points', 'format').gives<Files>(),
  writeCut: takes('surface', 'model', 'content', 'curves', 'cap', 'format').gives<Files>(),
  writeFound: takes('surface', 'model', 'found', 'format').gives<OneFile>(),
};
