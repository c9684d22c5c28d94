// Workers whose scripts lie on another origin, with a `Worker` that refuses them as browsers do.

import { resolveObjectURL } from 'node:buffer';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { openWorker, scriptFromElsewhere } from '../../../web/src/kernel/worker-from-elsewhere.js';

const page = 'https://page.example';
const elsewhere = 'https://cdn.example/assets/worker.js';
let made: { script: string; type: string | undefined }[];

class RefusingWorker {
  constructor(script: string | URL, options?: WorkerOptions) {
    const { protocol, origin } = new URL(script);
    if (protocol !== 'blob:' && origin !== page) throw new DOMException('refused', 'SecurityError');
    made.push({ script: String(script), type: options?.type });
  }
}

beforeEach(() => {
  made = [];
  vi.stubGlobal('origin', page);
  vi.stubGlobal('Worker', RefusingWorker);
});
afterEach(() => vi.unstubAllGlobals());

test('one of the page’s own origin is started as it is', () => {
  const script = `${page}/worker.js`;
  const worker = openWorker(() => new Worker(new URL(script)), `${page}/kernel.js`);
  expect(made).toEqual([{ script, type: undefined }]);
  expect(scriptFromElsewhere(worker)).toBeUndefined();
});

test.each([
  ['the kernel lies there too', 'https://cdn.example/kernel.js'],
  ['a bundler has put only the workers there', `${page}/kernel.js`],
  ['a bundler names no address', 'file:///somewhere/kernel.js'],
])('one of another origin is imported by a script of the page’s: %s', async (_, from) => {
  const worker = openWorker(() => new Worker(new URL(elsewhere)), from);
  expect(scriptFromElsewhere(worker)).toBe(elsewhere);
  expect(made).toEqual([{ script: expect.stringMatching(/^blob:/) as string, type: 'module' }]);
  expect(await resolveObjectURL(made[0]!.script)!.text()).toBe(`import "${elsewhere}";`);
  // What others make workers with stays as it was.
  expect(globalThis.Worker).toBe(RefusingWorker);
});

test('what a policy refuses stays refused', () => {
  vi.stubGlobal(
    'Worker',
    class {
      constructor() {
        throw new DOMException('refused', 'SecurityError');
      }
    },
  );
  expect(() => openWorker(() => new Worker(new URL(`${page}/w.js`)), `${page}/k.js`)).toThrow(
    expect.objectContaining({ name: 'SecurityError' }) as Error,
  );
});
