// The messages of a worker for jobs.

import type {
  CommonOperations,
  OpenedSurface,
  SurfaceArrays,
  SurfaceWithInput,
} from '../protocol.js';
import type { FileWithPath, MeshInfo, PrepareOptions } from '../types.js';
import type { analysing, makingSurfaces } from './analysis.js';
import type { serving } from './serving.js';
import type { GivenBy, MessagesOf, Sent } from './table.js';

/** Messages for the operations that make surfaces. `info`: of the original. */
type MakingMessages = {
  [K in keyof typeof makingSurfaces]: [
    Sent<(typeof makingSurfaces)[K]> & { info: MeshInfo },
    { opened: OpenedSurface } & Omit<GivenBy<(typeof makingSurfaces)[K]>, 'described'>,
  ];
};

/** A worker for jobs: it reads models, and analyses, remeshes and writes surfaces. */
export interface JobOperations
  extends CommonOperations, MakingMessages, MessagesOf<typeof analysing & typeof serving> {
  /** Builds a surface and keeps it under this number. */
  adopt: [{ surface: number; arrays: SurfaceWithInput }, object];
  /** Reads the model of the path `model`, or the first one, and prepares its surface. */
  read: [
    { files: FileWithPath[]; address?: string; model?: string; prepare: PrepareOptions },
    OpenedSurface,
  ];
  /** Prepares the caller's arrays. */
  take: [{ arrays: SurfaceArrays; prepare: PrepareOptions }, OpenedSurface];
}
