// `Worker` as browsers have it, as far as the kernel and Emscripten use it, of a thread of Node.js. The thread
// begins with `worker-scope.js`, which makes the scope that the script expects.

import { Worker } from 'node:worker_threads';

type Listener = (event: object) => void;

export class WebWorker {
  onmessage: Listener | null = null;
  onerror: Listener | null = null;
  onmessageerror: Listener | null = null;
  protected readonly thread: Worker;

  constructor(script: string | URL) {
    this.thread = new Worker(new URL('./worker-scope.js', import.meta.url), {
      workerData: String(script),
      // The program's own options may not suit: `--input-type`, for one, is refused beside a file.
      execArgv: [],
    });
    let isOver = false;
    const fail = (message: string) => {
      if (isOver) return;
      isOver = true;
      this.onerror?.({ message });
    };
    this.thread
      .on('message', (data) => this.receive(data))
      .on('messageerror', () => this.onmessageerror?.({}))
      .on('error', (thrown: unknown) => fail(String(thrown)))
      .on('exit', () => fail('it has ended'));
  }

  postMessage(message: unknown, transfer: ArrayBuffer[] = []): void {
    this.thread.postMessage(message, transfer);
  }

  terminate(): void {
    this.onmessage = this.onerror = this.onmessageerror = null;
    void this.thread.terminate();
  }

  protected receive(data: unknown): void {
    this.onmessage?.({ data });
  }
}
