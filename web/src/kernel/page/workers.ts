// The kernel's workers. Each is made by an expression that Vite and webpack recognise.

import { failure } from '../types/errors.js';
import type { WorkerLike } from './worker-client.js';
import { openWorker } from '../workers/worker-from-elsewhere.js';

/** Makes the workers of a kernel. Tests have their own. */
export interface WorkerFactory {
  single(): WorkerLike;
  threads(): WorkerLike;
  job(): WorkerLike;
  studies(): WorkerLike;
}

export const moduleWorkers: WorkerFactory = {
  single: opening(
    () => new Worker(new URL('../workers/worker.js', import.meta.url), { type: 'module' }),
  ),
  threads: opening(
    () => new Worker(new URL('../workers/threads-worker.js', import.meta.url), { type: 'module' }),
  ),
  job: opening(
    () => new Worker(new URL('../workers/job-worker.js', import.meta.url), { type: 'module' }),
  ),
  studies: opening(
    () => new Worker(new URL('../workers/studies-worker.js', import.meta.url), { type: 'module' }),
  ),
};

/**
 * The workers of a copy of the package's folder `dist`. USAGE where `base` is no address.
 * @param base the folder's address, relative to the page
 */
export function workersIn(base: string | URL): WorkerFactory {
  const { document, location } = globalThis as {
    document?: { baseURI: string };
    location?: { href: string };
  };
  const page = document?.baseURI ?? location?.href;
  if (!URL.canParse(base, page)) {
    throw failure('USAGE', `the base of a kernel is no address: ${String(base)}`, {
      hint: `name the folder dist of the package as it is on the server, for example '/girth/dist/'`,
    });
  }
  const folder = new URL(base, page);
  if (!folder.pathname.endsWith('/')) folder.pathname += '/';
  const opened = (name: string) => () => {
    const script = new URL(`workers/${name}.js`, folder);
    return openWorker(() => new Worker(script, { type: 'module' }));
  };
  return {
    single: opened('worker'),
    threads: opened('threads-worker'),
    job: opened('job-worker'),
    studies: opened('studies-worker'),
  };
}

function opening(open: () => Worker): () => Worker {
  return () => openWorker(open);
}
