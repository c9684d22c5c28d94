// The tests of the web side: `web` runs in Node.js, `browser` drives Chromium; `node` runs the package in Node.js, beside
// the command; `python` opens what the Python package saves. `bench` is no test: it measures.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const root = fileURLToPath(new URL('..', import.meta.url));

/** What depends on the values that the core computes, and on how it reads files. */
const kernelInBrowser = ['kernel*', 'files', 'corpus', 'examples'].map(
  (name) => `tests/browser/${name}.test.ts`,
);

/** Files that are run by one process share what they import: none of them leaves anything behind that another could see. */
const shared = { isolate: false };

/** Nothing here depends on how long something takes: files run beside each other, each with a Chromium of its own. */
const inBrowser = {
  ...shared,
  testTimeout: 120_000,
  hookTimeout: 120_000,
  // Generous: a slow machine is no failure.
  expect: { poll: { timeout: 30_000 } },
};

export default defineConfig({
  test: {
    projects: [
      {
        root,
        test: {
          name: 'web',
          include: ['tests/web/**/*.test.ts'],
          ...shared,
          testTimeout: 60_000,
        },
      },
      {
        root,
        test: {
          name: 'node',
          include: ['tests/node/**/*.test.ts'],
          // A document's commands run one after the other: generous, since a busy machine is no failure.
          testTimeout: 600_000,
          hookTimeout: 120_000,
        },
      },
      {
        root,
        test: {
          name: 'python',
          include: ['tests/python/**/*.test.ts'],
          ...inBrowser,
        },
      },
      {
        root,
        test: {
          name: 'browser',
          include: ['tests/browser/**/*.test.ts'],
          exclude: [...kernelInBrowser, 'tests/browser/long/**', 'tests/browser/other-browsers/**'],
          globalSetup: ['tests/browser/small-examples.ts'],
          ...inBrowser,
        },
      },
      {
        root,
        test: {
          name: 'browser-long',
          include: ['tests/browser/long/*.test.ts'],
          globalSetup: ['tests/browser/small-examples.ts'],
          ...inBrowser,
        },
      },
      {
        root,
        test: {
          name: 'browser-kernel',
          include: kernelInBrowser,
          globalSetup: ['tests/browser/build-kernel-site.ts'],
          ...inBrowser,
        },
      },
      {
        root,
        test: {
          name: 'other-browsers',
          include: ['tests/browser/other-browsers/*.test.ts'],
          globalSetup: ['tests/browser/build-kernel-site.ts', 'tests/browser/small-examples.ts'],
          fileParallelism: false,
          testTimeout: 120_000,
          hookTimeout: 120_000,
        },
      },
      {
        root,
        test: {
          name: 'bench',
          include: ['tests/bench/**/*.bench.ts'],
          fileParallelism: false,
          testTimeout: 600_000,
          hookTimeout: 120_000,
        },
      },
    ],
  },
});
