// The worker's side of the protocol: it receives requests and answers each once. The workers' own files
// (`worker.ts` and others) have the operations.

import { GirthError, fieldsOf } from '../types/errors.js';
import { findKeptModules } from './kept-modules.js';
import type { SurfaceStore } from './surface-store.js';
import type {
  Answer,
  Arguments,
  CommonOperations,
  Reply,
  Report,
  Request,
} from '../types/protocol.js';
import type { GirthErrorFields } from '../types/types.js';

/** Sends a report to the page, while a request is being served. */
export type ReportSink = (report: Report) => void;

/** Reports the finished share of a call. */
export const progressTo = (report: ReportSink) => (progress: number) => report({ progress });

type Handlers<T> = {
  [K in keyof T]: (
    args: Arguments<T, K>,
    report: ReportSink,
  ) => Answer<T, K> | Promise<Answer<T, K>>;
};

/** The result of a call into a module. A failure is thrown. */
export function checked<R extends object>(result: R | GirthErrorFields): R {
  if ('code' in result) throw new GirthError(result);
  return result;
}

/** The buffers of the typed arrays of an answer or report. They are moved to the page. */
function buffersOf(content: object): ArrayBuffer[] {
  const buffers = new Set<ArrayBuffer>();
  for (const value of Object.values(content) as unknown[]) {
    if (ArrayBuffer.isView(value) && value.buffer instanceof ArrayBuffer) buffers.add(value.buffer);
    else if (typeof value === 'object' && value !== null) {
      for (const inner of buffersOf(value)) buffers.add(inner);
    }
  }
  return [...buffers];
}

/** Serves requests, one after the other, in the order in which they arrive; `surfaces` are those that it holds. */
export function serveRequests<T extends CommonOperations>(
  surfaces: Pick<SurfaceStore<never>, 'drop'>,
  operations: Omit<Handlers<T>, 'drop'>,
): void {
  findKeptModules();
  const drop = ({ surface }: Arguments<CommonOperations, 'drop'>) => {
    surfaces.drop(surface);
    return {};
  };
  const handlers = { ...operations, drop };
  const scope = self as unknown as DedicatedWorkerGlobalScope;
  const post = (reply: Reply, content: object) => scope.postMessage(reply, buffersOf(content));

  const serve = async ({ id, operation, arguments: args }: Request) => {
    try {
      const handler = handlers[operation as keyof typeof handlers] as (
        args: object,
        report: ReportSink,
      ) => object | Promise<object>;
      const answer = await handler(args, (report) => post({ id, report }, report));
      post({ id, answer }, answer);
    } catch (thrown) {
      // The core's failures leave the module intact. Anything else may have left it inconsistent, and a
      // module that was not loaded is loaded again by a worker that starts again.
      const isOurs = thrown instanceof GirthError && thrown.code !== 'PROGRAM_NOT_LOADED';
      const reply: Reply = { id, error: fieldsOf(thrown), fatal: !isOurs };
      scope.postMessage(reply);
    }
  };

  let last = Promise.resolve();
  scope.onmessage = (event: MessageEvent<Request>) => {
    last = last.then(() => serve(event.data));
  };
}
