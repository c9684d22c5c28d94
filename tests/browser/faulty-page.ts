// The page in which something goes wrong, and how a test sees that it has been dealt with.

import type { Locator, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect } from 'vitest';
import { endsAt } from './faults.js';
import { box } from './meshes.js';
import { drop, modelIs, site } from './page-support.js';
import { smallExamples } from './small-examples.js';
import {
  type OpenPage,
  type StaticServer,
  chromiumForTests,
  requireBuilt,
  serve,
  strictPolicy,
} from './support.js';
import { fieldComplete } from './viewer-page.js';

/** Folders that are served beside the page. */
export const folders = { '/examples/': smallExamples };

export interface Faulty extends OpenPage {
  viewer: Locator;
  message: Locator;
}

export interface FaultyPages {
  /** Opens the page after something was done to it, before any script of it runs, for the length of a test. */
  openWith: (prepare: (page: Page) => Promise<unknown>, address?: string) => Promise<Faulty>;
  /** Keeps the page that was opened last beyond the test: it is the caller's to close. */
  keep: () => void;
}

/** The built page, isolated and under a strict content security policy, for the tests of one file. */
export function faultyPages(): FaultyPages {
  const openPage = chromiumForTests();
  let server: StaticServer;
  let opened: OpenPage | undefined;
  beforeAll(async () => {
    requireBuilt('build/page/index.html', 'build:page');
    server = await serve(site, { isolated: true, policy: strictPolicy, folders });
  });
  afterAll(() => server?.close());
  afterEach(async () => {
    // Files that the page still fetches when its test is over are no error of the test.
    await opened?.page.unrouteAll({ behavior: 'ignoreErrors' });
    await opened?.context.close();
    opened = undefined;
  });
  return {
    openWith: async (prepare, address = `${server.url}/`) => {
      opened = await openPage(address, { reducedMotion: 'reduce' }, prepare);
      const viewer = opened.page.locator('girth-viewer');
      return { ...opened, viewer, message: viewer.locator('.message') };
    },
    keep: () => {
      opened = undefined;
    },
  };
}

/** Waits for a message; it is announced, and names neither the model nor the inside of the program. */
export async function messageIs({ message }: Faulty, code: string): Promise<string> {
  await message.waitFor();
  expect(await message.getAttribute('role')).toBe('alert');
  const text = (await message.textContent())!;
  expect(await message.getAttribute('data-code'), text).toBe(code);
  expect(text).toMatch(/What helps: /);
  expect(text).not.toMatch(/ASSERTIONS|undefined|\[object/);
  return text;
}

export const cube = { name: 'cube.obj', bytes: Buffer.from(box(2, 2, 2)) };

/** Drops a model and waits for all of its girth. */
export async function cubeIsComputed({ page, viewer }: Faulty): Promise<void> {
  await drop(page, cube);
  await modelIs(page, cube.name);
  await fieldComplete(viewer);
}

/** Answers with what `change` makes of a file of the page. */
export const changed = (page: Page, path: RegExp, change: (body: Buffer) => Buffer) =>
  page.route(path, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: change(await response.body()) });
  });

/** Before the page is opened: memory of its WebAssembly modules ends there, in bytes. */
export const memoryEndsAt = (page: Page, bytes: number) => {
  const most = Buffer.from(endsAt(bytes));
  return changed(page, /worker.*\.js$/, (body) => Buffer.concat([most, body]));
};

/** Expects that a file was too large for the memory, that the former model is there, and that small ones are computed. */
export async function isTooLarge(faulty: Faulty, name: string): Promise<void> {
  const text = await messageIs(faulty, 'OUT_OF_MEMORY');
  expect(text).toContain(name);
  expect(text).toMatch(/The former model is still here/);
  await cubeIsComputed(faulty);
}
