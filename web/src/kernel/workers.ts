// The kernel's workers. Each is made by an expression that Vite and webpack recognise.

import type { WorkerLike } from './worker-client.js';
import { openWorker } from './worker-from-elsewhere.js';

/** Makes the workers of a kernel. Tests have their own. */
export interface WorkerFactory {
  single(): WorkerLike;
  threads(): WorkerLike;
  job(): WorkerLike;
  studies(): WorkerLike;
}

export const moduleWorkers: WorkerFactory = {
  single: opening(() => new Worker(new URL('./worker.js', import.meta.url), { type: 'module' })),
  threads: opening(
    () => new Worker(new URL('./threads-worker.js', import.meta.url), { type: 'module' }),
  ),
  job: opening(() => new Worker(new URL('./job-worker.js', import.meta.url), { type: 'module' })),
  studies: opening(
    () => new Worker(new URL('./studies-worker.js', import.meta.url), { type: 'module' }),
  ),
};

function opening(open: () => Worker): () => Worker {
  return () => openWorker(open, import.meta.url);
}
