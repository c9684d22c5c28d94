// The services that a mesh asks of the kernel that made it.

import type { BarcodeRun } from './barcodes.js';
import type { JobNeeds } from './job-pool.js';
import type { PointArguments, PointOperation } from './loop-queue.js';
import type { JobOperations } from '../types/operations/job.js';
import type { StudiesOperations } from '../types/operations/studies.js';
import type {
  Answer,
  FieldRequest,
  FoundRefined,
  RefinedRequest,
  SingleOperations,
  SurfaceArrays,
} from '../types/protocol.js';
import type { SurfaceSource } from './surface-source.js';
import type { CallOptions, Field, FieldOptions, WatchedOptions } from '../types/types.js';
import type { WorkerClient } from './worker-client.js';

/** All promises fail with CANCELLED when a surface's life ends or the kernel is disposed of. */
export interface MeshHost {
  /** Numbers a surface, and prepares the worker that answers for loops. */
  introduce(arrays: SurfaceArrays, life: AbortSignal): SurfaceSource;
  /** A field of a surface. Fields are computed one after the other, each by all workers. */
  field(
    surface: SurfaceSource,
    request: FieldRequest,
    options: FieldOptions,
  ): Promise<Omit<Field, 'unit'>>;
  /** The refined girth, in the same way where workers can share it; otherwise `alone` computes it, by a job. */
  refined(
    surface: SurfaceSource,
    request: RefinedRequest,
    options: WatchedOptions,
    alone: (signal: AbortSignal) => Promise<FoundRefined>,
  ): Promise<FoundRefined>;
  /** The barcodes of all vertices, in the same way. */
  barcodes(
    surface: SurfaceSource,
    maxPersistence: number,
    options: WatchedOptions,
  ): Promise<BarcodeRun>;
  /** Answers for a point: its loop, or its barcode. */
  atPoint<K extends PointOperation>(
    surface: SurfaceSource,
    operation: K,
    args: PointArguments<K>,
    options: CallOptions,
  ): Promise<Answer<SingleOperations, K>>;
  /** Runs a job in a worker of its own. The worker is ended when the signal fires. */
  job<R>(
    needs: JobNeeds,
    signal: AbortSignal | undefined,
    job: (worker: WorkerClient<JobOperations>) => Promise<R>,
  ): Promise<R>;
  /** Runs a job that needs the surface's spectrum. */
  spectralJob<R>(
    needs: JobNeeds,
    signal: AbortSignal | undefined,
    job: (worker: WorkerClient<StudiesOperations>) => Promise<R>,
  ): Promise<R>;
  /** Frees a surface in the workers for fields and loops. */
  drop(surface: number): void;
}
