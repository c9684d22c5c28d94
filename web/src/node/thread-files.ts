// How a worker reads files in Node.js, at once. A content that only promises give is fetched by a thread of its own,
// for which the worker waits.

import { readFileSync, realpathSync } from 'node:fs';
import { dirname, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import { MessageChannel, receiveMessageOnPort, Worker } from 'node:worker_threads';
import { addressBeside, type WorkerFiles } from '../kernel/workers/worker-files.js';
import type { Fetching } from './fetching.js';

export const threadFiles: WorkerFiles = {
  bytesOf(content) {
    const bytes = fetchedNow(content);
    if (!bytes) throw new Error('it has changed, or is gone');
    return bytes;
  },

  beside(address, name) {
    try {
      const wanted = addressBeside(address, name);
      return wanted.protocol === 'file:'
        ? fileWithin(dirname(fileURLToPath(address)), fileURLToPath(wanted))
        : fetchedNow(wanted.href);
    } catch {
      return undefined;
    }
  },
};

/** A file of a folder or of one in it; undefined where it is elsewhere, be it by way of a symbolic link. */
function fileWithin(folder: string, path: string): Uint8Array | undefined {
  const target = realpathSync(path);
  const isWithin = target.startsWith(realpathSync(folder).replace(/[\\/]*$/, sep));
  return isWithin ? readFileSync(target) : undefined;
}

/** The bytes of a file, or of what an address stands for; undefined where they cannot be had. */
function fetchedNow(wanted: Blob | string): Uint8Array<ArrayBuffer> | undefined {
  const { port1, port2 } = new MessageChannel();
  const isDone = new Int32Array(new SharedArrayBuffer(4));
  const workerData: Fetching = { wanted, isDone, port: port2 };
  const options = { workerData, transferList: [port2], execArgv: [] };
  const worker = new Worker(new URL('./fetching.js', import.meta.url), options);
  Atomics.wait(isDone, 0, 0);
  const answer = receiveMessageOnPort(port1);
  port1.close();
  void worker.terminate();
  return answer?.message as Uint8Array<ArrayBuffer> | undefined;
}
