// Operations that are calls of a module's functions, one each.

import {
  type FunctionsOf,
  type MessagesOf,
  type OperationTable,
  isSurface,
} from '../types/operations/table.js';
import type { Answer, Arguments } from '../types/protocol.js';
import type { SurfaceStore } from './surface-store.js';
import { type ReportSink, checked, progressTo } from './worker-loop.js';

type Forwards<T> = {
  [K in keyof T]: (args: Arguments<T, K>, report: ReportSink) => Answer<T, K>;
};

/** Answers all operations of a table by the functions of a module, which is there with the first request. */
export function forwards<T extends OperationTable, S extends { delete(): void }>(
  table: T,
  module: () => FunctionsOf<T, S>,
  surfaces: SurfaceStore<S>,
): Forwards<MessagesOf<T>> {
  const forward =
    (name: keyof T, { takes }: T[keyof T]) =>
    (args: Readonly<Record<string, unknown>>, report: ReportSink): object => {
      const given = takes.map((argument) => {
        if (argument === 'onProgress') return progressTo(report);
        return isSurface(argument) ? surfaces.get(args[argument] as number) : args[argument];
      });
      const call = module()[name] as (...given: unknown[]) => object;
      return checked(call(...given));
    };
  const all = Object.entries(table).map(([name, row]) => [name, forward(name, row as T[keyof T])]);
  return Object.fromEntries(all) as Forwards<MessagesOf<T>>;
}
