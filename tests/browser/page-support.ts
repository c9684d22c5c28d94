// Helpers of the page's tests: opening it, dropping files on it, and waiting for models.

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import type { BrowserContextOptions, Locator, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect } from 'vitest';
import {
  type LentPage,
  type StaticServer,
  pagesForTests,
  pictures,
  picturesWanted,
  repository,
  requireBuilt,
  serve,
  strictPolicy,
} from './support.js';
import { smallExamples } from './small-examples.js';
import { framesPass } from './viewer-page.js';

/** The page as `npm run build:page` puts it. */
export const site = join(repository, 'build/page');

/** The page as a test has it. */
export interface BuiltPage {
  page: Page;
  viewer: Locator;
  /** Where it is served. */
  address: string;
}

export interface BuiltPageOptions {
  /** Whether it is cross-origin isolated, so that it may use threads. Default: true. */
  isolated?: boolean;
  /** The examples as they are, or with few faces. Default: 'small'. */
  examples?: 'real' | 'small';
}

/**
 * The built page for the tests of one file, under a strict content security policy. Opens it anew, where
 * wanted at a state of its address, for the length of a test, which fails if anything went wrong on the
 * page that nobody caught.
 */
export function builtPage({ isolated = true, examples = 'small' }: BuiltPageOptions = {}): (
  state?: string,
  options?: BrowserContextOptions,
) => Promise<BuiltPage> {
  const modules = readdirSync(join(site, 'assets')).filter((name) => name.endsWith('.wasm'));
  const openPage = pagesForTests(modules.map((name) => `/assets/${name}`));
  const open: LentPage[] = [];
  let server: StaticServer;
  beforeAll(async () => {
    requireBuilt('build/page/index.html', 'build:page');
    server = await serve(site, {
      isolated,
      policy: strictPolicy,
      folders: examples === 'small' ? { '/examples/': smallExamples } : {},
    });
  });
  afterAll(() => server?.close());
  afterEach(async () => {
    for (const { complaints, giveBack } of open.splice(0)) {
      await giveBack();
      expect(complaints).toEqual([]);
    }
  });
  return async (state, options = {}) => {
    const { url } = server;
    const opened = await openPage(state === undefined ? url : `${url}/#${state}`, {
      reducedMotion: 'reduce',
      ...options,
    });
    open.push(opened);
    return { page: opened.page, viewer: opened.page.locator('girth-viewer'), address: url };
  };
}

/** Keeps a picture of the page in build/pictures, to be looked at, where pictures are wanted (`GIRTH_PICTURES`). */
export async function picture(page: Page, name: string): Promise<void> {
  if (picturesWanted) await page.screenshot({ path: join(pictures, name) });
}

/** The screen that a page is looked at on. */
export interface Screen {
  width: number;
  height: number;
  scheme: 'dark' | 'light';
}

const large = { width: 1440, height: 900 };
const small = { width: 1024, height: 768 };
const phone = { width: 390, height: 844 };

/** A large screen, a small one, and a phone. */
export const screens: readonly Screen[] = [
  { ...large, scheme: 'light' },
  { ...small, scheme: 'dark' },
  { ...phone, scheme: 'light' },
];

/** A large screen and a phone, each in dark and in light. */
export const screensInBoth: readonly Screen[] = [
  { ...large, scheme: 'dark' },
  { ...large, scheme: 'light' },
  { ...phone, scheme: 'dark' },
  { ...phone, scheme: 'light' },
];

/** Shows a page that is open on a screen, and waits until it is drawn so. Returns what keeps a picture of it. */
export async function showOn(
  page: Page,
  { width, height, scheme }: Screen,
): Promise<(name: string) => Promise<void>> {
  await page.setViewportSize({ width, height });
  await page.emulateMedia({ colorScheme: scheme });
  await framesPass(page);
  return (name) => picture(page, `${name}-${width}x${height}-${scheme}.png`);
}

/** Drops files onto the window, as from the desktop. */
export async function drop(page: Page, ...files: { name: string; bytes: Buffer }[]): Promise<void> {
  await page.evaluate(
    (files) => {
      const dataTransfer = new DataTransfer();
      for (const { name, base64 } of files) {
        const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
        dataTransfer.items.add(new File([bytes], name));
      }
      for (const type of ['dragenter', 'dragover', 'drop']) {
        document.body.dispatchEvent(
          new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }),
        );
      }
    },
    files.map(({ name, bytes }) => ({ name, base64: bytes.toString('base64') })),
  );
}

/** Waits for the model of that name in the line on top. */
export const modelIs = (page: Page, name: string): Promise<void> =>
  page.locator('#model b', { hasText: name }).waitFor({ timeout: 30_000 });

/** Opens a panel of the side. */
export async function openPanel(page: Page, name: string): Promise<Locator> {
  const panel = page.locator(`#${name}-panel`);
  if (!(await panel.evaluate((element: HTMLDetailsElement) => element.open))) {
    await panel.locator('summary').click();
  }
  return panel;
}

/** The words of every visible list that its arrow would cut, but for lists that say so by an ellipsis. */
export const cutWords = (page: Page): Promise<string[]> =>
  page.locator('select').evaluateAll((selects: HTMLSelectElement[]) =>
    selects
      .filter((select) => select.checkVisibility())
      .filter((select) => getComputedStyle(select).textOverflow !== 'ellipsis')
      .flatMap((select) =>
        [...select.options].flatMap(({ text }) => {
          const words = document.createElement('span');
          const { font } = getComputedStyle(select);
          words.textContent = text;
          words.style.cssText = `position: absolute; white-space: nowrap; font: ${font}`;
          document.body.append(words);
          const needed = words.offsetWidth;
          words.remove();
          // The arrow takes some 20 pixels.
          return needed + 20 > select.clientWidth ? [`${text}: ${select.clientWidth}`] : [];
        }),
      ),
  );

/** The part of the address behind '#'. */
export function fragment(page: Page): string {
  return decodeURIComponent(new URL(page.url()).hash.slice(1));
}
