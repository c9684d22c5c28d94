// The model as a file: as it was repaired, remeshed, cut or scaled.

import type { ModelFormat } from '../../src/kernel/index.js';

/** Formats, and what each is for. */
export const modelFormats: Readonly<Record<Exclude<ModelFormat, 'off'>, string>> = {
  stl: 'for printing',
  obj: 'text, with all digits',
  ply: 'binary, with all digits',
  glb: 'in metres, for viewers',
};
