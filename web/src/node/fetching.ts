// The thread that fetches what another one waits for (thread-files.ts).

import { workerData, type MessagePort } from 'node:worker_threads';

export interface Fetching {
  /** A file, or an address of the network. */
  wanted: Blob | string;
  /** Becomes 1 at the end. */
  isDone: Int32Array;
  /** Where the bytes go to, if there are any. */
  port: MessagePort;
}

const { wanted, isDone, port } = workerData as Fetching;
try {
  const response = typeof wanted === 'string' ? await fetch(wanted) : undefined;
  const source = response ?? (wanted as Blob);
  if (response?.ok !== false) {
    const bytes = new Uint8Array(await source.arrayBuffer());
    port.postMessage(bytes, [bytes.buffer]);
  }
} catch {
  // No bytes.
} finally {
  Atomics.store(isDone, 0, 1);
  Atomics.notify(isDone, 0);
}
