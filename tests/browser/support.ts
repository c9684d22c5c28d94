// Tools of every browser test: a static server with the headers under test, and Chromium.

import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer, type IncomingMessage, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, resolve, sep } from 'node:path';
import { fileURLToPath } from 'node:url';
import {
  chromium,
  type Browser,
  type BrowserContext,
  type BrowserContextOptions,
  type Page,
} from 'playwright-core';
import { afterAll, beforeAll } from 'vitest';
import { chromiumPath } from '../../web/scripts/chromium.mjs';
import { delayAnswers, delayScript } from './late-answers.js';

/** The top of the repository. */
export const repository = fileURLToPath(new URL('../..', import.meta.url));

/** The command that says what is right; `GIRTH_COMMAND` names another one than that of the build tree. */
export const command =
  process.env['GIRTH_COMMAND'] ?? join(repository, 'build/native/cpp/cli/girth');

/** A policy under which no eval, no inline script and no blob worker runs. */
export const strictPolicy =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:";

/** Scripts are started only by what this policy of ours has let through; to be joined with another policy by '; '. */
export const trustedTypes =
  "require-trusted-types-for 'script'; trusted-types girth 'allow-duplicates'";

export interface ServeOptions {
  /** Send the two headers that make a page cross-origin isolated, so that it may use threads. */
  isolated?: boolean;
  /** Paths that pages of other origins may read too. */
  shared?: RegExp;
  /** A Content-Security-Policy, for example `strictPolicy`. */
  policy?: string;
  /** Pages and scripts that need no file: path, for example '/test.html', to content. */
  pages?: Record<string, string>;
  /** Other folders, by the path that each is served below, for example '/data/'. */
  folders?: Record<string, string>;
  /** The answer in place of a file of a folder, where there is one. */
  answers?: (path: string, body: Buffer) => Answer | undefined;
}

/** Default: as the file is. */
export interface Answer {
  status?: number;
  type?: string;
  body?: string | Buffer;
}

export interface StaticServer {
  /** Without a slash at the end. */
  url: string;
  /** Paths asked for so far, in order. */
  requests: string[];
  close(): Promise<void>;
}

const mediaTypes: Record<string, string> = {
  '.css': 'text/css',
  '.glb': 'model/gltf-binary',
  '.gltf': 'model/gltf+json',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.map': 'application/json',
  '.mjs': 'text/javascript',
  '.obj': 'text/plain',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

/** Serves a folder like a plain static host: no special headers unless asked for. */
export async function serve(folder: string, options: ServeOptions = {}): Promise<StaticServer> {
  const roots = Object.entries({ ...options.folders, '/': folder }).map(
    ([mount, root]) => [mount, resolve(root)] as const,
  );
  const requests: string[] = [];
  const headers: Record<string, string> = { 'Cache-Control': 'no-store' };
  if (options.isolated) {
    headers['Cross-Origin-Opener-Policy'] = 'same-origin';
    headers['Cross-Origin-Embedder-Policy'] = 'require-corp';
  }
  if (options.policy) headers['Content-Security-Policy'] = options.policy;

  const answer = async (request: IncomingMessage, response: ServerResponse): Promise<void> => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname);
    requests.push(path);
    if (options.shared?.test(path)) response.setHeader('Access-Control-Allow-Origin', '*');
    const page = options.pages?.[path];
    if (page !== undefined) {
      const type = mediaTypes[extname(path)] ?? mediaTypes['.html']!;
      response.writeHead(200, { ...headers, 'Content-Type': type }).end(page);
      return;
    }
    const [mount, root] = roots.find(([mount]) => path.startsWith(mount))!;
    const inside = path.slice(mount.length);
    const file = resolve(root, path.endsWith('/') ? `${inside}index.html` : inside);
    // Read as a whole: a test may take files away at any moment.
    const body = file.startsWith(root + sep)
      ? await readFile(file).catch(() => undefined)
      : undefined;
    if (!body) {
      response.writeHead(404, headers).end('not found');
      return;
    }
    if (extname(file) === '.js') await delayScript();
    const type = mediaTypes[extname(file)] ?? 'application/octet-stream';
    const instead = options.answers?.(path, body);
    const status = instead?.status ?? 200;
    response.writeHead(status, { ...headers, 'Content-Type': instead?.type ?? type });
    response.end(instead?.body ?? body);
  };
  const server = createServer((request, response) => void answer(request, response));
  await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}`,
    requests,
    close: () =>
      new Promise<void>((done) => {
        server.close(() => done());
        server.closeAllConnections();
      }),
  };
}

interface LaunchOptions {
  /** Command line arguments, beside those that every test needs. */
  args?: readonly string[];
  /** All of Chromium, not its engine alone: see `chromiumPath`. Default: false. */
  whole?: boolean;
}

/** Chromium without a window. */
function launchChromium({ args = [], whole = false }: LaunchOptions = {}): Promise<Browser> {
  return chromium.launch({
    executablePath: chromiumPath({ whole }),
    args: [
      '--no-sandbox',
      '--disable-gpu',
      // Smooth outlines cost a quarter of a run's processor time without a graphics card; no test looks at them.
      '--webgl-antialiasing-mode=none',
      '--disable-quic',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      ...args,
    ],
  });
}

/** The file of a build, which must be there: tests run what `command` has built. */
export function requireBuilt(file: string, command: string): void {
  if (!existsSync(join(repository, file))) throw new Error(`first: npm run ${command}`);
}

/** Whether tests make the pictures that are to be looked at, of all pixels. */
export const picturesWanted = Boolean(process.env['GIRTH_PICTURES']);

/** Where they are put. */
export const pictures = join(repository, 'build/pictures');

/** For tests that look at pixels. */
export const allPixels = { deviceScaleFactor: 1 } as const;

/**
 * Options of every context. A quarter of the pixels take five sixths of the processor time, without a graphics card.
 * Files that a service worker keeps would come before what a test serves.
 */
const usual = {
  viewport: { width: 1024, height: 768 },
  deviceScaleFactor: picturesWanted ? 1 : 0.5,
  serviceWorkers: 'block',
} as const;

export interface OpenPage {
  browser: Browser;
  context: BrowserContext;
  page: Page;
  /** Complaints of it that nobody caught, as they happen. */
  complaints: string[];
}

/**
 * Chromium for the tests of one file: gives them pages, each in a context of its own. `prepare`: what is
 * done to a page before it goes to the address.
 */
export function chromiumForTests(
  launch: LaunchOptions = {},
): (
  address: string,
  options?: BrowserContextOptions,
  prepare?: (page: Page) => Promise<unknown>,
) => Promise<OpenPage> {
  let browser: Browser;
  beforeAll(async () => {
    browser = await launchChromium(launch);
  });
  afterAll(() => browser?.close());
  return async (address, options = {}, prepare = () => Promise.resolve()) => {
    const context = await browser.newContext({ ...usual, ...options });
    await delayAnswers(context);
    const page = await context.newPage();
    const complaints = complaintsOf(page);
    await prepare(page);
    await page.goto(address);
    return { browser, context, page, complaints };
  };
}

/** Complaints of a page that nobody caught: errors, console errors, violations of the policy. */
function complaintsOf(page: Page): string[] {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(`uncaught: ${error.message}`));
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(`console: ${message.text()}`);
  });
  return complaints;
}

export interface LentPage {
  page: Page;
  /** Complaints of it that nobody caught, as they happen. */
  complaints: string[];
  /** Closes it and what it has opened, and clears what they have stored and been permitted. */
  giveBack: () => Promise<void>;
}

/**
 * Chromium for the tests of one file that open pages of one origin: every page is new, but those with the
 * same options share a context, and so a process, one after the other. Starting a process takes as long
 * as opening the page in it. In each context a page without content keeps the process alive, and with it the wasm
 * modules of these paths, which are compiled once so.
 */
export function pagesForTests(
  modules: string[] = [],
): (address: string, options?: BrowserContextOptions) => Promise<LentPage> {
  let browser: Browser;
  const free = new Map<string, Page[]>();
  beforeAll(async () => {
    browser = await launchChromium({ args: ['--process-per-site'] });
  });
  afterAll(() => browser?.close());
  return async (address, options = {}) => {
    const { origin } = new URL(address);
    const key = JSON.stringify([origin, options]);
    let keeper = free.get(key)?.pop();
    if (!keeper) {
      const context = await browser.newContext({ ...usual, ...options });
      await delayAnswers(context);
      keeper = await context.newPage();
      await keeper.goto(`${origin}/no-content`);
      await keeper.evaluate(async (modules) => {
        const compiled = modules.map((path) => WebAssembly.compileStreaming(fetch(path)));
        Object.assign(globalThis, { kept: await Promise.all(compiled) });
      }, modules);
    }
    const context = keeper.context();
    const page = await context.newPage();
    const complaints = complaintsOf(page);
    await page.goto(address);
    const giveBack = async (): Promise<void> => {
      const others = context.pages().filter((other) => other !== keeper);
      await Promise.all(others.map((other) => other.close()));
      await context.clearPermissions();
      await context.clearCookies();
      const session = await context.newCDPSession(keeper);
      await session.send('Storage.clearDataForOrigin', { origin, storageTypes: 'all' });
      await session.detach();
      free.set(key, [...(free.get(key) ?? []), keeper]);
    };
    return { page, complaints, giveBack };
  };
}

/** How many numbers differ, bit for bit. */
export const differing = (a: number[], b: number[]): number =>
  a.length === b.length ? a.filter((value, i) => !Object.is(value, b[i])).length : Infinity;
