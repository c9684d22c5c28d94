// Signals that stop work: several as one, and promises that do not outlive them.

import { cancelled } from '../types/errors.js';

/**
 * A signal that fires when one of several does. Call `release` when the work is done, to remove the
 * listeners: a page's signal may live as long as the page.
 */
export function linked(signals: (AbortSignal | undefined)[]): {
  signal: AbortSignal;
  release: () => void;
} {
  const controller = new AbortController();
  const undo: (() => void)[] = [];
  for (const signal of signals) {
    if (!signal) continue;
    const abort = () => controller.abort(signal.reason);
    if (signal.aborted) abort();
    signal.addEventListener('abort', abort);
    undo.push(() => signal.removeEventListener('abort', abort));
  }
  return { signal: controller.signal, release: () => undo.forEach((f) => f()) };
}

/** The promise's outcome, or CANCELLED as soon as the signal fires. */
export function untilAborted<T>(promise: Promise<T>, signal: AbortSignal): Promise<T> {
  return new Promise<T>((resolve, reject) => {
    const abort = () => {
      const { reason } = signal as { reason: unknown };
      reject(cancelled(typeof reason === 'string' ? reason : 'cancelled', reason));
    };
    if (signal.aborted) abort();
    signal.addEventListener('abort', abort, { once: true });
    promise.then(resolve, reject).finally(() => signal.removeEventListener('abort', abort));
  });
}
