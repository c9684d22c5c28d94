// Workers whose scripts lie on another origin, with a `Worker` that refuses them as browsers do.

import { resolveObjectURL } from 'node:buffer';
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import {
  openWorker,
  scriptFromElsewhere,
} from '../../../web/src/kernel/workers/worker-from-elsewhere.js';

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
  const worker = openWorker(() => new Worker(new URL(script)));
  expect(made).toEqual([{ script, type: undefined }]);
  expect(scriptFromElsewhere(worker)).toBeUndefined();
});

test('one of another origin is imported by a script of the page’s', async () => {
  const worker = openWorker(() => new Worker(new URL(elsewhere)));
  expect(scriptFromElsewhere(worker)).toBe(elsewhere);
  expect(made).toEqual([{ script: expect.stringMatching(/^blob:/) as string, type: 'module' }]);
  expect(await resolveObjectURL(made[0]!.script)!.text()).toBe(`import "${elsewhere}";`);
  // The constructor that others make workers with stays as it was.
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
  expect(() => openWorker(() => new Worker(new URL(`${page}/w.js`)))).toThrow(
    expect.objectContaining({ name: 'SecurityError' }) as Error,
  );
});

test('where there are no workers, the browser’s own error is thrown', () => {
  vi.stubGlobal('Worker', undefined);
  expect(() => openWorker(() => new Worker(new URL(`${page}/w.js`)))).toThrow(TypeError);
});

describe('where a page wants addresses to be trusted', () => {
  /** Takes only what a policy has made. */
  class Demanding extends RefusingWorker {
    constructor(script: string | URL, options?: WorkerOptions) {
      if (!String(script).startsWith('trusted ')) throw new TypeError('TrustedScriptURL');
      super(String(script).slice('trusted '.length), options);
    }
  }
  const trusting = (rules: { createScriptURL(address: string): string }) => ({
    createScriptURL: (address: string) => `trusted ${rules.createScriptURL(address)}`,
  });
  const createPolicy = vi.fn((_name: string, rules: Parameters<typeof trusting>[0]) =>
    trusting(rules),
  );
  /** The module as it is on a page that has them. */
  const fresh = async () => {
    vi.resetModules();
    vi.stubGlobal('Worker', Demanding);
    vi.stubGlobal('trustedTypes', { createPolicy });
    return import('../../../web/src/kernel/workers/worker-from-elsewhere.js');
  };
  beforeEach(() => void createPolicy.mockReset().mockImplementation((_, rules) => trusting(rules)));

  test('the policy girth trusts them, made once and for the first of them', async () => {
    const { openWorker } = await fresh();
    expect(createPolicy).not.toHaveBeenCalled();
    for (const script of [`${page}/worker.js`, `${page}/other.js`, elsewhere]) {
      openWorker(() => new Worker(new URL(script)));
    }
    const scripts = made.map(({ script }) => script.replace(/^blob:.*/, 'blob:'));
    expect(scripts).toEqual([`${page}/worker.js`, `${page}/other.js`, 'blob:']);
    expect(createPolicy.mock.calls.map(([name]) => name)).toEqual(['girth']);
  });

  test('where that policy is not allowed, it is the page’s own that decides', async () => {
    createPolicy.mockImplementation(() => {
      throw new TypeError('disallowed by Content Security Policy');
    });
    const { openWorker } = await fresh();
    const open = () => openWorker(() => new Worker(new URL(`${page}/worker.js`)));
    expect(open).toThrow('TrustedScriptURL');
    vi.stubGlobal('Worker', RefusingWorker);
    open();
    expect(made).toHaveLength(1);
  });
});
