// Content of files besides the surface.

import type { Loop, Tips } from '../../kernel/types/types.js';
import type { GivenField } from './given-fields.js';

/** Content of a model's file besides its surface. */
export interface FileContent {
  /** Values at the surface's vertices. */
  fields: readonly GivenField[];
  /** Loops at vertices. */
  loops: readonly Loop[];
  tips: Tips | undefined;
  /** The unit that lengths are written in, unless another one is wished for; '' for the model's. */
  ownUnit: string;
  /** Whether the first of its values are shown where nothing else is wished for. */
  leads: boolean;
  /** Nothing else can be computed of it: that takes the kernel, which has not read it. */
  isAll: boolean;
}

export const onlySurface: FileContent = {
  fields: [],
  loops: [],
  tips: undefined,
  ownUnit: '',
  leads: false,
  isAll: false,
};
