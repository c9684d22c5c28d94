// The worker's side of the protocol: takes requests, answers each once. What the requests mean is in
// `worker.ts` and `threads-worker.ts`.

import { GirthError, fieldsOf } from './errors.js';
import type { Answer, Arguments, CommonOperations, Reply, Report, Request } from './protocol.js';
import type { GirthErrorFields } from './types.js';

/** Passes a report to the page, also while a request is being worked on. */
export type ReportSink = (report: Report) => void;

/** Passes the finished share of a call on to the page. */
export const progressTo = (report: ReportSink) => (progress: number) => report({ progress });

type Handlers<T> = {
  [K in keyof T]: (
    args: Arguments<T, K>,
    report: ReportSink,
  ) => Answer<T, K> | Promise<Answer<T, K>>;
};

/** The result of a call into a module; its failure is thrown. */
export function checked<R extends object>(result: R | GirthErrorFields): R {
  if ('code' in result) throw new GirthError(result);
  return result;
}

/** The buffers of an answer's or report's typed arrays, which are the page's from then on. */
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

/** Serves requests, one after the other, in the order in which they arrive. */
export function serveRequests<T extends CommonOperations>(handlers: Handlers<T>): void {
  const scope = self as unknown as DedicatedWorkerGlobalScope;
  const post = (reply: Reply, content: object) => scope.postMessage(reply, buffersOf(content));

  const serve = async ({ id, operation, arguments: args }: Request) => {
    try {
      const handler = handlers[operation as keyof T] as (
        args: object,
        report: ReportSink,
      ) => object | Promise<object>;
      const answer = await handler(args, (report) => post({ id, report }, report));
      post({ id, answer }, answer);
    } catch (thrown) {
      // The core's failures leave the module as it was; anything else may have torn it in mid-work.
      const reply: Reply = { id, error: fieldsOf(thrown), fatal: !(thrown instanceof GirthError) };
      scope.postMessage(reply);
    }
  };

  let last = Promise.resolve();
  scope.onmessage = (event: MessageEvent<Request>) => {
    last = last.then(() => serve(event.data));
  };
}
