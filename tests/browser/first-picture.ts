// The wait of a visitor before the page shows its first surface: how much is fetched until then.

import { existsSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { type chromiumForTests, serve } from './support.js';

/** Bytes by gzip that the page may fetch before its first surface: scripts and styles, and with WebAssembly and the model. */
export const mostProgramsBeforePicture = 400_000;
export const mostBeforePicture = 1_550_000;

/** Whether a file is a script, a style or the page itself. */
export const isProgram = ({ path }: Fetched): boolean => /(\.(js|css)|\/)$/.test(path);

/** Asked for by the page as soon as its first model is there. */
const marker = '/first-picture';

/** A file that was fetched. */
export interface Fetched {
  path: string;
  /** By gzip. */
  bytes: number;
}

/** Opens the page of a folder, and lists what it has asked for when its first surface is there to be drawn. */
export async function fetchedBeforePicture(
  openPage: ReturnType<typeof chromiumForTests>,
  folder: string,
): Promise<Fetched[]> {
  const server = await serve(folder, { isolated: true, pages: { [marker]: '' } });
  const { context } = await openPage(server.url, {}, (page: Page) =>
    page.addInitScript((marker) => {
      document.addEventListener(
        'load',
        ({ target }) => {
          if (target instanceof Element && target.id === 'viewer') void fetch(marker);
        },
        true,
      );
    }, marker),
  );
  const until = Date.now() + 60_000;
  while (!server.requests.includes(marker)) {
    if (Date.now() > until) throw new Error('no surface was shown in time');
    await new Promise((done) => setTimeout(done, 20));
  }
  await context.close();
  await server.close();
  const paths = server.requests.slice(0, server.requests.indexOf(marker));
  return [...new Set(paths)].flatMap((path) => {
    const file = join(folder, path.endsWith('/') ? `${path}index.html` : path);
    if (!existsSync(file) || !statSync(file).isFile()) return [];
    return [{ path, bytes: gzipSync(readFileSync(file)).length }];
  });
}

/** The bytes of some files together. */
export const bytesOf = (files: readonly Fetched[]): number =>
  files.reduce((sum, { bytes }) => sum + bytes, 0);
