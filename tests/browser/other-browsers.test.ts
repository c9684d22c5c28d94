// Firefox and WebKit, where they are installed: the kernel on a page that is cross-origin isolated and on one
// that is not gives the bits of the command. Debian's packages: firefox-esr; webkit2gtk-driver and xvfb.

import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import puppeteer from 'puppeteer-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { kernelSite } from './build-kernel-site.js';
import type { KernelPage } from './kernel-page.js';
import { kernelHtml } from './kernel-site.js';
import {
  command,
  differing,
  repository,
  requireBuilt,
  serve,
  type StaticServer,
} from './support.js';

/** Inside `evaluate` only. */
declare const girth: KernelPage;

/** A page of another browser. */
interface OtherPage {
  open(address: string): Promise<void>;
  /** The result of a function that is sent to the page with its argument. */
  evaluate<T>(task: (text: string) => Promise<T>, text: string): Promise<T>;
  close(): Promise<void>;
}

const programOf = (...names: string[]): string | undefined =>
  names
    .flatMap((name) => (process.env['PATH'] ?? '').split(delimiter).map((at) => join(at, name)))
    .find(existsSync);
const firefox = programOf('firefox-esr', 'firefox');
const webKitDriver = programOf('WebKitWebDriver');
const miniBrowser = [
  '/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser',
  '/usr/lib/x86_64-linux-gnu/webkit2gtk-4.0/MiniBrowser',
  '/usr/lib/aarch64-linux-gnu/webkit2gtk-4.1/MiniBrowser',
].find(existsSync);
const xvfb = programOf('xvfb-run');

async function openFirefox(): Promise<OtherPage> {
  const browser = await puppeteer.launch({ browser: 'firefox', executablePath: firefox! });
  const page = await browser.newPage();
  return {
    open: async (address) => void (await page.goto(address)),
    evaluate: (task, text) => page.evaluate(task, text),
    close: () => browser.close(),
  };
}

/** WebKit by the W3C's WebDriver, on a screen of its own; under LANG=C the browser has no language. */
async function openWebKit(language = 'en_US.UTF-8'): Promise<OtherPage> {
  const port = 4455;
  const screen = ['-a', '-s', '-screen 0 1280x900x24 +extension GLX'];
  const driver: ChildProcess = spawn(xvfb!, [...screen, webKitDriver!, `--port=${port}`], {
    env: {
      ...process.env,
      LANG: language,
      LC_ALL: language,
      // Root has no sandbox.
      LIBGL_ALWAYS_SOFTWARE: '1',
      WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: '1',
    },
    stdio: 'ignore',
    detached: true,
  });
  const ask = async (method: string, path: string, body?: object): Promise<unknown> => {
    const response = await fetch(`http://127.0.0.1:${port}${path}`, {
      method,
      ...(body ? { body: JSON.stringify(body) } : {}),
    });
    const { value } = (await response.json()) as { value: unknown };
    if (!response.ok) throw new Error(`WebDriver: ${JSON.stringify(value)}`);
    return value;
  };
  const stop = () => process.kill(-driver.pid!);
  const capabilities = {
    alwaysMatch: {
      browserName: 'MiniBrowser',
      'webkitgtk:browserOptions': { binary: miniBrowser, args: ['--automation'] },
    },
  };
  const until = Date.now() + 60_000;
  for (;;) {
    try {
      await ask('GET', '/status');
      break;
    } catch (error) {
      if (Date.now() > until) {
        stop();
        throw error;
      }
      await new Promise((done) => setTimeout(done, 100));
    }
  }
  const { sessionId } = (await ask('POST', '/session', { capabilities })) as { sessionId: string };
  await ask('POST', `/session/${sessionId}/timeouts`, { script: 120_000, pageLoad: 60_000 });
  return {
    open: async (url) => void (await ask('POST', `/session/${sessionId}/url`, { url })),
    evaluate: async (task, text) => {
      const script = `const done = arguments[1];
        (${task.toString()})(arguments[0]).then((value) => done({ value }), (error) => done({ error: String(error) }));`;
      const answer = (await ask('POST', `/session/${sessionId}/execute/async`, {
        script,
        args: [text],
      })) as { value: never; error?: string };
      if (answer.error !== undefined) throw new Error(answer.error);
      return answer.value;
    },
    close: async () => {
      await ask('DELETE', `/session/${sessionId}`);
      stop();
    },
  };
}

const hasWebKit = !!webKitDriver && !!miniBrowser && !!xvfb;
const browsers: [string, boolean, () => Promise<OtherPage>][] = [
  ['Firefox', !!firefox, openFirefox],
  ['WebKit', hasWebKit, () => openWebKit()],
];

test.runIf(hasWebKit)(
  'WebKit without a language: the page opens and computes its example',
  async () => {
    requireBuilt('build/page/index.html', 'build:page');
    const server = await serve(join(repository, 'build/page'), { isolated: true });
    const browser = await openWebKit('C');
    try {
      await browser.open(server.url);
      const isComplete = await browser.evaluate(async (wanted) => {
        const { dataset } = document.documentElement;
        while (dataset['field'] !== wanted) await new Promise((done) => setTimeout(done, 50));
        return true;
      }, 'complete');
      expect(isComplete).toBe(true);
    } finally {
      await browser.close();
      await server.close();
    }
  },
);

describe.each(browsers)('%s', (_, isThere, openBrowser) => {
  const folder = mkdtempSync(join(tmpdir(), 'girth-other-browsers-'));
  const model = readFileSync(join(repository, 'tests/data/prism.obj'), 'utf8');
  let browser: OtherPage;
  let server: StaticServer | undefined;
  beforeAll(async () => {
    if (isThere) browser = await openBrowser();
  });
  afterAll(async () => {
    await browser?.close();
    await server?.close();
    rmSync(folder, { recursive: true });
  });

  test.runIf(isThere).each([true, false])(
    'isolated %s: the values are those of the command, to the bit',
    async (isolated) => {
      await server?.close();
      server = await serve(kernelSite, { isolated, pages: { '/': kernelHtml } });
      await browser.open(server.url);
      const { values, error } = await browser.evaluate(async (text) => {
        try {
          while (!('girth' in globalThis)) await new Promise((done) => setTimeout(done, 20));
          const kernel = await girth.createKernel({ threads: 2 });
          const mesh = await kernel.load(girth.obj(text));
          const { values } = await mesh.field('igf');
          kernel.dispose();
          // As text: every digit arrives.
          return { values: Array.from(values, String), error: '' };
        } catch (thrown) {
          return { values: [], error: String(thrown) };
        }
      }, model);
      expect(error).toBe('');
      const csv = join(folder, 'prism.csv');
      execFileSync(command, ['igf', join(repository, 'tests/data/prism.obj'), '-o', csv]);
      const rows = readFileSync(csv, 'utf8').trim().split('\n').slice(1);
      const truth = rows.map((row) => Number(row.split(',')[1]));
      expect(truth.length).toBeGreaterThan(0);
      expect(differing(values.map(Number), truth)).toBe(0);
    },
  );
});
