// The page's side of one worker. Requests are promises of their answers. The worker is given each surface
// once. A worker that has died is replaced with the next request.

import { copiedInPieces } from './copied-arrays.js';
import { cancelled, failure, fieldsOf, GirthError } from '../types/errors.js';
import { workerNotLoaded, workerNotMade, workerNotStarted } from '../workers/loading-failure.js';
import type {
  AdoptedArrays,
  Answer,
  Arguments,
  CommonOperations,
  Reply,
  Report,
  Request,
} from '../types/protocol.js';
import { bytesOf, type SurfaceSource } from './surface-source.js';

/** The part of `Worker` that is used here. */
export interface WorkerLike {
  postMessage(message: Request, transfer: ArrayBuffer[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Reply>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  onmessageerror: ((event: MessageEvent) => void) | null;
}

/** A worker that has not started after so many milliseconds is given up. */
export const longestStart = 30_000;

interface Pending {
  resolve(answer: object): void;
  reject(error: GirthError): void;
  onReport?: ((report: Report) => void) | undefined;
}

interface HeldSurface {
  adopted: Promise<object>;
  bytes: number;
  /** Whether it has been sent. */
  isSent: boolean;
}

/** Larger surfaces are copied piece by piece. */
const mostBytesAtOnce = 1 << 21;

/** The surfaces that a worker takes: with the arrays that its operation `adopt` asks for. */
export type SourceFor<T> = SurfaceSource<AdoptedArrays<T>>;

export class WorkerClient<T extends CommonOperations> {
  readonly #create: () => WorkerLike;
  readonly #threads: number;
  #worker: WorkerLike | undefined;
  #closed: GirthError | undefined;
  /** Why the last worker ended. */
  #ended: GirthError | undefined;
  #started: Promise<Answer<CommonOperations, 'start'>> | undefined;
  #lastId = 0;
  readonly #pending = new Map<number, Pending>();
  /** Surfaces that the present worker has or is about to have, the least recently used first. */
  readonly #surfaces = new Map<number, HeldSurface>();

  /** Nothing happens before `start` or the first request. */
  constructor(create: () => WorkerLike, threads = 1) {
    this.#create = create;
    this.#threads = threads;
  }

  /** Starts the worker and loads its module, unless that has been done. */
  start(): Promise<Answer<CommonOperations, 'start'>> {
    if (this.#closed) return Promise.reject(this.#closed);
    if (!this.#started) {
      try {
        this.#worker = this.#create();
      } catch (thrown) {
        return Promise.reject(workerNotMade(thrown));
      }
      const worker = this.#worker;
      let isRunning = false;
      worker.onmessage = ({ data }) => this.#receive(data);
      worker.onerror = (event) => {
        event.preventDefault?.();
        if (isRunning) {
          const { message, ...fields } = fieldsOf(event.message || 'it has ended');
          this.#die(new GirthError({ ...fields, message: `a worker has failed: ${message}` }));
        } else if (event.message) this.#die(workerNotStarted(event.message));
        else
          void workerNotLoaded(worker).then((error) => {
            if (this.#worker === worker) this.#die(error);
          });
      };
      worker.onmessageerror = () =>
        this.#die(failure('OUT_OF_MEMORY', 'a message of a worker could not be received'));
      this.#started = this.#post('start', { threads: this.#threads }, []);
      // JavaScript and WebAssembly of different builds may wait for each other for ever.
      const overdue = setTimeout(
        () =>
          this.#die(
            failure(
              'PROGRAM_NOT_LOADED',
              `a worker has not started within ${longestStart / 1000} s`,
              {
                hint: 'begin again; if it stays, the .mjs and .wasm files are of different builds',
              },
            ),
          ),
        longestStart,
      );
      // Requests report a failed start. Without a request, it is not reported.
      this.#started
        .then(() => (isRunning = true))
        .catch(() => undefined)
        .finally(() => clearTimeout(overdue));
    }
    return this.#started;
  }

  /** Sends a request. The buffers of `transfer` are moved to the worker. */
  async request<K extends keyof T & string>(
    operation: K,
    args: Arguments<T, K>,
    { transfer = [], onReport }: { transfer?: ArrayBuffer[]; onReport?: (r: Report) => void } = {},
  ): Promise<Answer<T, K>> {
    await this.start();
    return (await this.#post(operation, args, transfer, onReport)) as Answer<T, K>;
  }

  /** Sends a request on a surface. The worker is given the surface first unless it has it. */
  async requestOn<K extends keyof T & string>(
    surface: SourceFor<T>,
    operation: K,
    args: Omit<Arguments<T, K>, 'surface'>,
    options: { onReport?: (report: Report) => void } = {},
  ): Promise<Answer<T, K>> {
    await this.adopt(surface);
    const whole = { ...args, surface: surface.number } as Arguments<T, K>;
    return this.request(operation, whole, options);
  }

  /** Gives the worker a surface, once. CANCELLED where the surface's mesh has been disposed of. */
  async adopt(surface: SourceFor<T>): Promise<void> {
    await this.start();
    const { number, life } = surface;
    if (life.aborted) throw cancelled();
    let held = this.#surfaces.get(number);
    if (held) {
      this.#surfaces.delete(number);
    } else {
      const made: HeldSurface = {
        adopted: Promise.resolve({}),
        bytes: bytesOf(surface),
        isSent: false,
      };
      made.adopted = this.#give(surface, made);
      made.adopted.catch(() => {
        if (this.#surfaces.get(number) === made) this.#surfaces.delete(number);
      });
      held = made;
    }
    this.#surfaces.set(number, held);
    await held.adopted;
  }

  async #give({ number, arrays }: SourceFor<T>, held: HeldSurface): Promise<object> {
    let transfer: ArrayBuffer[] = [];
    if (held.bytes > mostBytesAtOnce) {
      const worker = this.#worker;
      arrays = await copiedInPieces(arrays);
      if (this.#worker !== worker) throw this.#ended ?? cancelled();
      if (this.#surfaces.get(number) !== held) throw cancelled();
      transfer = (Object.values(arrays) as Float64Array<ArrayBuffer>[]).map(({ buffer }) => buffer);
    }
    held.isSent = true;
    return this.#post('adopt', { surface: number, arrays }, transfer);
  }

  /** Whether the present worker has been given the surface. */
  knows(surface: number): boolean {
    return this.#surfaces.has(surface);
  }

  /** Bytes of each surface that the present worker has, the least recently used first. */
  get held(): ReadonlyMap<number, number> {
    return new Map([...this.#surfaces].map(([number, { bytes }]) => [number, bytes]));
  }

  /** Frees a surface in the worker. */
  drop(surface: number): void {
    const held = this.#surfaces.get(surface);
    this.#surfaces.delete(surface);
    if (!held?.isSent) return;
    void this.#post('drop', { surface }, []).catch(() => undefined);
  }

  /** Ends the worker at once. Pending requests fail with `error`. The next one starts another worker. */
  restart(error: GirthError): void {
    this.#die(error);
  }

  /** Ends the worker at once and for good. Pending and later requests fail with `error`. */
  terminate(error: GirthError): void {
    this.#closed = error;
    this.#die(error);
  }

  #post(
    operation: string,
    args: object,
    transfer: ArrayBuffer[],
    onReport?: (report: Report) => void,
  ): Promise<object> {
    const worker = this.#worker;
    if (!worker) return Promise.reject(failure('INTERNAL', 'the worker has ended'));
    const id = ++this.#lastId;
    return new Promise((resolve, reject) => {
      this.#pending.set(id, { resolve, reject, onReport });
      try {
        worker.postMessage({ id, operation, arguments: args }, transfer);
      } catch (thrown) {
        this.#pending.delete(id);
        reject(new GirthError(fieldsOf(thrown), { cause: thrown }));
      }
    });
  }

  #receive(reply: Reply): void {
    const pending = this.#pending.get(reply.id);
    if (!pending) return;
    if ('report' in reply) {
      pending.onReport?.(reply.report);
      return;
    }
    this.#pending.delete(reply.id);
    if ('answer' in reply) {
      pending.resolve(reply.answer);
      return;
    }
    const error = new GirthError(reply.error);
    pending.reject(error);
    if (reply.fatal) this.#die(error);
  }

  #die(error: GirthError): void {
    const worker = this.#worker;
    if (!worker) return;
    worker.onmessage = worker.onerror = worker.onmessageerror = null;
    worker.terminate();
    this.#worker = undefined;
    this.#started = undefined;
    this.#ended = error;
    this.#surfaces.clear();
    const pending = [...this.#pending.values()];
    this.#pending.clear();
    for (const request of pending) request.reject(error);
  }
}
