// Services that a kernel asks of the program that it runs in: a page here, Node.js in `web/src/node`. The kernel's
// workers ask more, in `worker-files.ts`.

import { fetched, type ContentAt } from './source.js';

export interface Platform {
  /** Whether memory can be shared with workers, which threads need. */
  readonly sharesMemory: boolean;
  /** Processors that workers may run on. */
  readonly cores: number;
  /** Reads what is not handed over itself. */
  readonly contentAt: ContentAt;
}

export const page: Platform = {
  get sharesMemory() {
    return globalThis.crossOriginIsolated === true;
  },
  get cores() {
    return globalThis.navigator?.hardwareConcurrency ?? 1;
  },
  contentAt: fetched,
};
