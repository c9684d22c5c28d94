// Where a thread begins that is one of the kernel's workers: it makes the scope of a browser's worker, as far as the
// kernel's scripts and Emscripten's use it, and runs the script.

import { readFile } from 'node:fs/promises';
import { parentPort, workerData } from 'node:worker_threads';
import { failure, fieldsOf } from '../kernel/types/errors.js';
import { installAgain } from '../kernel/workers/loading-failure.js';
import type { Reply, Request } from '../kernel/types/protocol.js';
import { workerFiles } from '../kernel/workers/worker-files.js';
import { threadFiles } from './thread-files.js';
import { WebWorker } from './web-worker.js';

const script = workerData as string;
const port = parentPort!;
const fetchFromNet = globalThis.fetch;

Object.assign(workerFiles, threadFiles);
Object.assign(globalThis, {
  self: globalThis,
  location: { href: script },
  Worker: WebWorker,
  /** By this Emscripten recognises a worker; scripts that are modules do not call it. */
  importScripts() {},
  postMessage: (message: unknown, transfer?: ArrayBuffer[]) => port.postMessage(message, transfer),
  /** Node's own opens no files. */
  async fetch(address: string | URL, options?: RequestInit) {
    if (!/^file:/.test(String(address))) return fetchFromNet(address, options);
    const headers = { 'Content-Type': 'application/wasm' };
    return new Response(await readFile(new URL(address)), { headers });
  },
});
/**
 * Compiles at once, in this thread: Node.js (20, at the least) crashes where a thread is ended while a module is
 * checked as it streams in.
 */
WebAssembly.instantiateStreaming = async (source, imports) => {
  const module = new WebAssembly.Module(await (await source).arrayBuffer());
  return { module, instance: new WebAssembly.Instance(module, imports) };
};
Object.defineProperty(globalThis, 'onmessage', {
  // Messages that have come before are kept for it.
  set: (listener: (event: object) => void) => {
    port.on('message', (data: unknown) => listener({ data }));
  },
});

try {
  await import(script);
} catch (cause) {
  const { message } = fieldsOf(cause);
  const error = failure('PROGRAM_NOT_LOADED', `a worker's script cannot be loaded: ${message}`, {
    hint: installAgain,
  });
  port.once('message', ({ id }: Request) => {
    const reply: Reply = { id, error: fieldsOf(error), fatal: true };
    port.postMessage(reply);
  });
}
