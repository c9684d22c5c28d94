// The kernel's workers in Node.js. A worker keeps the process alive while it has something to do, and no longer.

import type { Reply, Request } from '../kernel/types/protocol.js';
import type { WorkerLike } from '../kernel/page/worker-client.js';
import type { WorkerFactory } from '../kernel/page/workers.js';
import { WebWorker } from './web-worker.js';

class KernelWorker extends WebWorker {
  #pending = 0;

  constructor(script: URL) {
    super(script);
    this.thread.unref();
  }

  override postMessage(request: Request, transfer: ArrayBuffer[]): void {
    super.postMessage(request, transfer);
    if (++this.#pending === 1) this.thread.ref();
  }

  protected override receive(reply: Reply): void {
    if (!('report' in reply) && --this.#pending === 0) this.thread.unref();
    super.receive(reply);
  }
}

const opening = (script: string) => (): WorkerLike =>
  new KernelWorker(new URL(`../kernel/workers/${script}`, import.meta.url));

export const nodeWorkers: WorkerFactory = {
  single: opening('worker.js'),
  threads: opening('threads-worker.js'),
  job: opening('job-worker.js'),
  studies: opening('studies-worker.js'),
};
