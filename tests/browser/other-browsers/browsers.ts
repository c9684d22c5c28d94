// Firefox and WebKit, where they are installed, as the tests drive them. Debian's packages: firefox-esr,
// webkit2gtk-driver, xvfb.

import { type ChildProcess, spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import puppeteer from 'puppeteer-core';

/** A page of another browser than Chromium. */
export interface OtherPage {
  open(address: string): Promise<void>;
  /** The result of a function that is sent to the page with its argument, both as JSON. */
  evaluate<A, T>(task: (argument: A) => T | Promise<T>, argument: A): Promise<T>;
  /** Moves the mouse there, in pixels of the page. */
  moveTo(x: number, y: number): Promise<void>;
  /** A PNG of what is seen. */
  screenshot(): Promise<Uint8Array>;
  close(): Promise<void>;
}

export interface OtherBrowser {
  name: 'Firefox' | 'WebKit';
  isThere: boolean;
  open: () => Promise<OtherPage>;
}

const programOf = (...names: string[]): string | undefined =>
  names
    .flatMap((name) => (process.env['PATH'] ?? '').split(delimiter).map((at) => join(at, name)))
    .find(existsSync);
const firefox = programOf('firefox-esr', 'firefox');
const webKitDriver = programOf('WebKitWebDriver');
const miniBrowser = ['webkit2gtk-4.1', 'webkit2gtk-4.0']
  .flatMap((version) =>
    ['x86_64', 'aarch64'].map((machine) => `/usr/lib/${machine}-linux-gnu/${version}/MiniBrowser`),
  )
  .find(existsSync);
const xvfb = programOf('Xvfb');

const [width, height] = [1024, 768];

/** Opens a screen without a monitor: without a screen browsers have no WebGL. */
async function openScreen(): Promise<{ display: string; close: () => void }> {
  const size = `${width + 100}x${height + 200}x24`;
  const args = ['-displayfd', '3', '-screen', '0', size, '-nolisten', 'tcp'];
  const server = spawn(xvfb!, args, { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  const number = await new Promise<Buffer>((done, fail) => {
    server.on('error', fail);
    server.stdio[3]!.once('data', done);
  });
  return { display: `:${number.toString().trim()}`, close: () => void server.kill() };
}

async function openFirefox(): Promise<OtherPage> {
  const screen = await openScreen();
  const browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath: firefox!,
    headless: false,
    defaultViewport: { width, height },
    env: { ...process.env, DISPLAY: screen.display },
  });
  const page = await browser.newPage();
  return {
    open: async (address) => void (await page.goto(address)),
    evaluate: (task, argument) => page.evaluate<[never], never>(task as never, argument as never),
    moveTo: (x, y) => page.mouse.move(x, y),
    screenshot: () => page.screenshot(),
    close: async () => {
      await browser.close();
      screen.close();
    },
  };
}

/** By the W3C's WebDriver. Under the language 'C' the browser has none. */
export async function openWebKit(language = 'en_US.UTF-8'): Promise<OtherPage> {
  const screen = await openScreen();
  const port = 4455;
  const driver: ChildProcess = spawn(webKitDriver!, [`--port=${port}`], {
    env: {
      ...process.env,
      DISPLAY: screen.display,
      LANG: language,
      LC_ALL: language,
      LIBGL_ALWAYS_SOFTWARE: '1',
      // Root has no sandbox.
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
  const stop = () => {
    process.kill(-driver.pid!);
    screen.close();
  };
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
  const session = `/session/${sessionId}`;
  await ask('POST', `${session}/timeouts`, { script: 120_000, pageLoad: 60_000 });
  await ask('POST', `${session}/window/rect`, { x: 0, y: 0, width: width + 50, height });
  return {
    open: async (url) => void (await ask('POST', `${session}/url`, { url })),
    evaluate: async (task, argument) => {
      const script = `const done = arguments[1];
        (async () => (${task.toString()})(arguments[0]))()
          .then((value) => done({ value }), (error) => done({ error: String(error) }));`;
      const answer = (await ask('POST', `${session}/execute/async`, {
        script,
        args: [argument],
      })) as { value: never; error?: string };
      if (answer.error !== undefined) throw new Error(answer.error);
      return answer.value;
    },
    moveTo: async (x, y) => {
      const actions = [
        {
          type: 'pointerMove',
          duration: 0,
          x: Math.round(x),
          y: Math.round(y),
          origin: 'viewport',
        },
      ];
      const mouse = { type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions };
      await ask('POST', `${session}/actions`, { actions: [mouse] });
    },
    screenshot: async () =>
      Buffer.from((await ask('GET', `${session}/screenshot`)) as string, 'base64'),
    close: async () => {
      await ask('DELETE', session);
      stop();
    },
  };
}

export const otherBrowsers: OtherBrowser[] = [
  { name: 'Firefox', isThere: !!firefox && !!xvfb, open: openFirefox },
  { name: 'WebKit', isThere: !!webKitDriver && !!miniBrowser && !!xvfb, open: () => openWebKit() },
];
