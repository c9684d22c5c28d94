// The page on which the kernel's browser tests run: the public API, and what the tests measure with.

import { createKernel, GirthError } from '../../web/src/kernel/index.js';
import type { FieldName, FieldOptions, Mesh } from '../../web/src/kernel/index.js';

/** A field with everything that was reported on the way, as plain data. */
async function watchedField(mesh: Mesh, options: FieldOptions = {}, name: FieldName = 'igf') {
  const progress: number[] = [];
  const reported = new Uint8Array(mesh.info.vertexCount);
  let wrong = 0;
  let batches = 0;
  const partials: [number, number][] = [];
  const from = performance.now();
  const field = await mesh.field(name, {
    ...options,
    onProgress: (fraction) => progress.push(fraction),
    onPartial: (partial) => {
      ++batches;
      partial.vertices.forEach((vertex, i) => {
        ++reported[vertex]!;
        partials.push([vertex, partial.values[i]!]);
      });
    },
  });
  const milliseconds = performance.now() - from;
  for (const [vertex, value] of partials) if (!Object.is(field.values[vertex], value)) ++wrong;
  return {
    values: Array.from(field.values),
    kinds: Array.from(field.kinds),
    range: field.range,
    unit: field.unit,
    method: field.method,
    withoutValue: field.withoutValue,
    note: field.note,
    milliseconds,
    progress,
    batches,
    reportedOnce: reported.every((times) => times === 1),
    wrong,
  };
}

/** The code, message and hint with which a promise is rejected. */
async function refusal(promise: Promise<unknown>) {
  try {
    await promise;
  } catch (error) {
    if (!(error instanceof GirthError)) return { code: `not a GirthError: ${String(error)}` };
    const { code, element, message, hint } = error;
    return { code, element, message, hint };
  }
  return { code: 'nothing was refused' };
}

/** Content as it can leave the page: typed arrays as plain ones. */
type Plain<T> = T extends { readonly BYTES_PER_ELEMENT: number }
  ? number[]
  : T extends object
    ? { [K in keyof T]: Plain<T[K]> }
    : T;

function plain<T>(content: T): Plain<T> {
  const unwrap = (_: string, value: unknown) =>
    ArrayBuffer.isView(value) ? Array.from(value as Float64Array) : value;
  return JSON.parse(JSON.stringify(content, unwrap)) as Plain<T>;
}

const obj = (text: string, name = 'test.obj') => new File([text], name);

/** The longest time for which the page could not do anything else, until `stop` is called. */
function watchPage() {
  let longest = 0;
  let last = performance.now();
  const timer = setInterval(() => {
    const now = performance.now();
    longest = Math.max(longest, now - last);
    last = now;
  }, 1);
  return {
    stop: () => {
      clearInterval(timer);
      return longest;
    },
  };
}

const tools = { createKernel, GirthError, watchedField, refusal, plain, obj, watchPage };
export type KernelPage = typeof tools;
Object.assign(globalThis, { girth: tools });
