// Workers of a copy of the package's folder, with a `Worker` that notes what it is made of.

import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { workersIn } from '../../../web/src/kernel/page/workers.js';

let scripts: string[];

beforeEach(() => {
  scripts = [];
  vi.stubGlobal('origin', 'https://page.example');
  vi.stubGlobal('document', { baseURI: 'https://page.example/tools/index.html' });
  vi.stubGlobal(
    'Worker',
    class {
      constructor(script: string | URL) {
        scripts.push(String(script));
      }
    },
  );
});
afterEach(() => vi.unstubAllGlobals());

test.each([
  ['girth/dist/', 'https://page.example/tools/girth/dist/workers/'],
  ['girth/dist', 'https://page.example/tools/girth/dist/workers/'],
  ['/girth/', 'https://page.example/girth/workers/'],
  [new URL('https://page.example/a/b/'), 'https://page.example/a/b/workers/'],
])('%s is a folder, relative to the page', (base, folder) => {
  const workers = workersIn(base);
  workers.single();
  workers.threads();
  workers.job();
  workers.studies();
  const names = ['worker', 'threads-worker', 'job-worker', 'studies-worker'];
  expect(scripts).toEqual(names.map((name) => `${folder}${name}.js`));
});

test('of another origin they are imported by scripts of the page’s own', () => {
  workersIn('https://cdn.example/girth/').single();
  expect(scripts).toEqual([expect.stringMatching(/^blob:/)]);
});

test('what is no address is refused, with words', () => {
  const wrong = expect.objectContaining({
    code: 'USAGE',
    hint: expect.stringContaining('dist') as string,
  }) as Error;
  expect(() => workersIn('http://')).toThrow(wrong);
});
