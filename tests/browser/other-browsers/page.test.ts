// The page in Firefox and WebKit: what browsers, networks and people do wrong ends in a working page, or in a message
// with a way out, as in Chromium (page-faults.test.ts).

import { mkdirSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from 'vitest';
import type { GirthViewer } from '../../../web/src/element/index.js';
import { type NamedBox, endsAt, overlapsOf, stormOfSizes } from '../faults.js';
import { box, torus } from '../meshes.js';
import { site } from '../page-support.js';
import { smallExamples } from '../small-examples.js';
import {
  type ServeOptions,
  type StaticServer,
  pictures,
  picturesWanted,
  requireBuilt,
  serve,
  strictPolicy,
} from '../support.js';
import { type OtherPage, openWebKit, otherBrowsers } from './browsers.js';

interface Fault extends ServeOptions {
  /** A script of the page that runs before its others. */
  first?: string;
}

/** The words and pictures of the page. */
interface Seen {
  model: string;
  /** Whether the whole field is there. */
  isComplete: boolean;
  code: string;
  message: string;
  title: string;
}

function see(): Seen {
  const viewer = document.querySelector<GirthViewer>('girth-viewer');
  const message = viewer?.shadowRoot?.querySelector<HTMLElement>('.message');
  const isSaid = message?.checkVisibility() ?? false;
  return {
    model: document.querySelector('#model b')?.textContent ?? '',
    isComplete:
      !!viewer?.info &&
      viewer.values('igf').every((value) => !Number.isNaN(value)) &&
      !viewer.shadowRoot!.querySelector('[role=progressbar]')!.checkVisibility(),
    code: isSaid ? (message!.dataset['code'] ?? '') : '',
    message: isSaid ? (message!.textContent ?? '') : '',
    title: document.title,
  };
}

/** Drops files onto the window, as from the desktop. */
function dropAll(files: { name: string; text: string }[]): void {
  const dataTransfer = new DataTransfer();
  for (const { name, text } of files) dataTransfer.items.add(new File([text], name));
  for (const type of ['dragenter', 'dragover', 'drop']) {
    document.body.dispatchEvent(
      new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }),
    );
  }
}

const folders = { '/examples/': smallExamples };
const cube = { name: 'cube.obj', text: box(2, 2, 2) };
const ofProgram = (path: string): boolean => path.endsWith('.wasm');

describe.each(otherBrowsers)('$name', ({ name: browserName, isThere, open }) => {
  let page: OtherPage;
  const servers: StaticServer[] = [];
  beforeAll(async () => {
    requireBuilt('build/page/index.html', 'build:page');
    if (isThere) page = await open();
  });
  afterAll(() => page?.close());
  afterEach(async () => {
    if (isThere) await page.open('about:blank');
    for (const server of servers.splice(0)) await server.close();
  });
  const inIt = test.runIf(isThere);

  const serveIt = async (options: ServeOptions): Promise<StaticServer> => {
    const server = await serve(site, { isolated: true, policy: strictPolicy, folders, ...options });
    servers.push(server);
    return server;
  };

  /** Opens the page with a fault. */
  async function openWith({ first, ...options }: Fault = {}, at = '/'): Promise<StaticServer> {
    const { answers } = options;
    const server = await serveIt({
      ...options,
      ...(first === undefined ? {} : { pages: { '/first.js': first } }),
      answers: (path, body) =>
        first !== undefined && path === '/'
          ? { body: String(body).replace('<head>', '<head><script src="/first.js"></script>') }
          : answers?.(path, body),
    });
    await page.open(`${server.url}${at}`);
    return server;
  }

  const seen = (): Promise<Seen> => page.evaluate(see, null);

  const isTrue = (what: (seen: Seen) => boolean): Promise<void> =>
    expect.poll(async () => what(await seen()), { timeout: 60_000, interval: 50 }).toBe(true);

  /** Waits for a message; it says what helps and nothing of the inside of the program. */
  async function messageIs(code: string): Promise<string> {
    await expect.poll(async () => (await seen()).code, { timeout: 60_000 }).toBe(code);
    const { message } = await seen();
    expect(message).toMatch(/What helps: /);
    expect(message).not.toMatch(/ASSERTIONS|undefined|\[object/);
    return message;
  }

  const exampleIsComputed = () => isTrue((seen) => seen.model === 'chair.glb' && seen.isComplete);

  async function cubeIsComputed(): Promise<void> {
    await page.evaluate(dropAll, [cube]);
    await isTrue((seen) => seen.model === cube.name && seen.isComplete);
    expect((await seen()).message).toBe('');
  }

  const dismiss = (): Promise<void> =>
    page.evaluate(() => {
      const { shadowRoot } = document.querySelector('girth-viewer')!;
      shadowRoot!.querySelector<HTMLElement>('.message button')!.click();
    }, null);

  const keep = async (name: string): Promise<void> => {
    if (!picturesWanted) return;
    mkdirSync(pictures, { recursive: true });
    const file = join(pictures, `${browserName.toLowerCase()}-${name}.png`);
    writeFileSync(file, await page.screenshot());
  };

  // ---- what is right

  inIt(
    'the example is computed, and a file that is dropped; the loop under the pointer is shown',
    async () => {
      await openWith();
      await exampleIsComputed();
      await keep('example');
      await cubeIsComputed();
      const place = await page.evaluate(() => {
        const { left, top, width, height } = document
          .querySelector('girth-viewer')!
          .getBoundingClientRect();
        return { x: left + width / 2, y: top + height / 2 };
      }, null);
      await page.moveTo(1, 1);
      await page.moveTo(place.x, place.y);
      await expect
        .poll(
          () =>
            page.evaluate(() => {
              const { shadowRoot } = document.querySelector('girth-viewer')!;
              const readout = shadowRoot!.querySelector<HTMLElement>('.readout')!;
              return readout.checkVisibility() ? Number(readout.dataset['length']) : 0;
            }, null),
          { timeout: 30_000 },
        )
        .toBeGreaterThan(0);
    },
  );

  // ---- the program

  inIt.each([
    ['missing', () => ({ status: 404, body: 'not found' })],
    ['corrupt', (body: Buffer) => ({ body: Buffer.alloc(body.length, 1) })],
    ['cut off', (body: Buffer) => ({ body: body.subarray(0, 20_000) })],
  ])('the WebAssembly is %s: the program is blamed, not the model', async (_, changed) => {
    await openWith({ answers: (path, body) => (ofProgram(path) ? changed(body) : undefined) });
    const message = await messageIs('PROGRAM_NOT_LOADED');
    expect(message).toMatch(/reload the page/);
    expect(message).not.toMatch(/chair/);
  });

  inIt('WebAssembly of the wrong type and without shared memory: everything works', async () => {
    await openWith({
      isolated: false,
      answers: (path) => (ofProgram(path) ? { type: 'text/plain' } : undefined),
    });
    await exampleIsComputed();
    expect((await seen()).message).toBe('');
  });

  inIt(
    'WebAssembly that the content security policy blocks: the message names what to allow',
    async () => {
      await openWith({ policy: strictPolicy.replace(" 'wasm-unsafe-eval'", '') });
      expect(await messageIs('PROGRAM_NOT_LOADED')).toContain("script-src 'wasm-unsafe-eval'");
    },
  );

  inIt.each([
    ['there are no workers', 'delete globalThis.Worker;'],
    [
      'workers that are modules are refused',
      "globalThis.Worker = class { constructor() { throw new TypeError('Module scripts are not supported'); } };",
    ],
  ])('%s: words', async (_, first) => {
    await openWith({ first });
    expect(await messageIs('PROGRAM_NOT_LOADED')).toMatch(/browser/);
  });

  inIt('a worker that throws while it starts: words', async () => {
    await openWith({
      answers: (path) =>
        /job-worker.*\.js$/.test(path) ? { body: 'throw new Error("no luck");' } : undefined,
    });
    expect(await messageIs('PROGRAM_NOT_LOADED')).toMatch(/no luck.*reload the page/);
  });

  inIt(
    'memory that ends at 64 MB: words, the model before stays, and small ones are computed',
    async () => {
      const end = endsAt(64 << 20);
      await openWith({
        answers: (path, body) =>
          /worker.*\.js$/.test(path) ? { body: end + String(body) } : undefined,
      });
      await exampleIsComputed();
      await page.evaluate(dropAll, [{ name: 'large.obj', text: torus(500, 400) }]);
      expect(await messageIs('OUT_OF_MEMORY')).toMatch(
        /large\.obj.*The former model is still here/,
      );
      await cubeIsComputed();
    },
  );

  inIt('workers that die while they compute: words, and the next model is computed', async () => {
    await openWith({
      first: `globalThis.all = [];
        const Usual = Worker;
        globalThis.Worker = class extends Usual { constructor(...a) { super(...a); all.push(this); } };`,
    });
    await isTrue(({ model }) => model === 'chair.glb');
    await page.evaluate(() => {
      for (const worker of (globalThis as unknown as { all: Worker[] }).all) {
        worker.dispatchEvent(new ErrorEvent('error', { message: 'killed' }));
        worker.terminate();
      }
    }, null);
    await cubeIsComputed();
  });

  // ---- the picture

  inIt('no WebGL: how to get it is said; all else works without the picture', async () => {
    await openWith({
      first: `const usual = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
          return /^webgl/.test(kind) ? null : usual.call(this, kind, ...rest);
        };`,
    });
    expect(await messageIs('NO_WEBGL')).toMatch(/no 3D graphics.*work without the picture/);
    await exampleIsComputed();
    await expect
      .poll(() => page.evaluate(() => document.querySelector('#field .caption')!.textContent, null))
      .toMatch(/^median \d/);
  });

  inIt(
    'graphics that are taken away and given back: said, and the picture is there again',
    async () => {
      await openWith({
        first: `const usual = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
          const context = usual.call(this, kind, ...rest);
          if (kind === 'webgl2') globalThis.drawing = context;
          return context;
        };`,
      });
      await exampleIsComputed();
      await page.evaluate(() => {
        const { drawing } = globalThis as unknown as { drawing: WebGL2RenderingContext };
        const extension = drawing.getExtension('WEBGL_lose_context')!;
        Object.assign(globalThis, { giveBack: () => extension.restoreContext() });
        extension.loseContext();
      }, null);
      await messageIs('NO_WEBGL');
      await page.evaluate(
        () => (globalThis as unknown as { giveBack: () => void }).giveBack(),
        null,
      );
      await isTrue(({ message }) => message === '');
    },
  );

  inIt('a canvas of no size, and a storm of sizes: the picture fits the last one', async () => {
    await openWith({
      first: `document.addEventListener('DOMContentLoaded', () => {
        document.querySelector('.surface').style.display = 'none';
      });`,
    });
    await isTrue(({ model }) => model === 'chair.glb');
    await page.evaluate(stormOfSizes, undefined);
    const { picture, element } = await page.evaluate(async () => {
      const viewer = document.querySelector<GirthViewer>('girth-viewer')!;
      while (!viewer.info) await new Promise((resolve) => setTimeout(resolve, 20));
      for (let i = 0; i < 4; ++i) await new Promise((done) => requestAnimationFrame(done));
      const { width, height } = await createImageBitmap(await viewer.snapshot());
      return { picture: [width, height], element: [viewer.clientWidth, viewer.clientHeight] };
    }, null);
    expect(picture).toEqual(element);
  });

  // ---- the network

  inIt('a download that is cut off, and one that is not allowed: words', async () => {
    const liar = createServer((_, response) => {
      response.writeHead(200, { 'Content-Length': '100000', 'Access-Control-Allow-Origin': '*' });
      response.write(box(1, 1, 1));
      setTimeout(() => response.destroy(), 20);
    });
    await new Promise<void>((done) => liar.listen(0, '127.0.0.1', done));
    const { port } = liar.address() as AddressInfo;
    const other = await serveIt({});
    try {
      await openWith({ isolated: false, policy: '' });
      await exampleIsComputed();
      const go = (model: string): Promise<void> =>
        page.evaluate(
          (model) => void (location.hash = `model=${encodeURIComponent(model)}`),
          model,
        );
      await go(`http://127.0.0.1:${port}/cut.obj`);
      expect(await messageIs('FILE_UNREADABLE')).toMatch(/check the address and the conn/);
      await dismiss();
      await go(`${other.url}/examples/cup.glb`);
      expect(await messageIs('FILE_UNREADABLE')).toMatch(/CORS/);
      await cubeIsComputed();
    } finally {
      liar.closeAllConnections();
      liar.close();
    }
  });

  inIt('the server is gone after the first visit: the page opens and computes', async () => {
    // It keeps what the list of the page names, to the byte.
    const server = await openWith({ folders: {} });
    await exampleIsComputed();
    await expect
      .poll(() => page.evaluate(() => document.getElementById('offline')!.textContent, null), {
        timeout: 60_000,
      })
      .toMatch(/works offline/);
    servers.splice(servers.indexOf(server), 1);
    await server.close();
    await page.open(`${server.url}/`);
    await exampleIsComputed();
    await cubeIsComputed();
  });

  // ---- people, and what they have forbidden

  inIt('files that are dropped one upon the other: the last one is shown', async () => {
    await openWith();
    await isTrue(({ model }) => model === 'chair.glb');
    await page.evaluate(dropAll, [{ name: 'first.obj', text: torus(60, 40) }]);
    await page.evaluate(dropAll, [{ name: 'second.obj', text: torus(50, 40) }]);
    await cubeIsComputed();
  });

  inIt('names that are scripts are names', async () => {
    await openWith();
    await isTrue(({ model }) => model === 'chair.glb');
    const name = '<img src=x onerror="document.title=666">.obj';
    await page.evaluate(dropAll, [{ name, text: cube.text }]);
    await isTrue(({ model, title }) => model === name && title.includes(name));
    await page.evaluate(dropAll, [{ name, text: 'nothing' }]);
    await isTrue(({ message }) => message.includes(name));
  });

  inIt('an address without sense: the example is shown', async () => {
    await openWith({}, '/#model=%E0%A4%A&pins=NaN,-1&camera=1,x&range=9..1&field=<script>&tau=');
    await isTrue(({ model, isComplete }) => model === 'chair.glb' && isComplete);
  });

  inIt('nothing stored, nothing copied, and a clock that jumps', async () => {
    await openWith({
      first: `const denied = () => { throw new DOMException('denied', 'SecurityError'); };
        for (const name of ['localStorage', 'sessionStorage', 'indexedDB', 'caches']) {
          Object.defineProperty(globalThis, name, { get: denied });
        }
        Object.defineProperty(Navigator.prototype, 'clipboard', { get: () => undefined });
        const usual = Date.now;
        let jump = 0;
        Date.now = () => usual() + 1e10 * Math.sin(++jump);`,
    });
    await exampleIsComputed();
    await page.evaluate(() => {
      const press = (name: string): void =>
        [...document.querySelectorAll('button')]
          .find((button) => (button.ariaLabel ?? button.textContent).trim().startsWith(name))!
          .click();
      press('Share');
      press('Copy link');
    }, null);
    await expect
      .poll(() => page.evaluate(() => document.querySelector('#share')!.textContent, null))
      .toMatch(/does not let pages copy/);
  });

  inIt('a window of 320 by 256: what is wrong with a file lies over nothing else', async () => {
    const server = await openWith({
      pages: {
        '/framed.html':
          '<!doctype html><style>iframe { width: 320px; height: 256px; border: 0 }</style><iframe src="/"></iframe>',
      },
    });
    await page.open(`${server.url}/framed.html`);
    const boxes = await page.evaluate(
      async ({ name, text }) => {
        const sleep = () => new Promise((resolve) => setTimeout(resolve, 50));
        const within = (): Document => document.querySelector('iframe')!.contentDocument!;
        const message = (): HTMLElement | null | undefined =>
          within()
            .querySelector('girth-viewer')
            ?.shadowRoot?.querySelector<HTMLElement>('.message');
        while (!within().querySelector('#model b')?.textContent) await sleep();
        const window = within().defaultView!;
        const dataTransfer = new window.DataTransfer();
        dataTransfer.items.add(new window.File([text], name));
        for (const type of ['dragenter', 'dragover', 'drop']) {
          const event = new window.DragEvent(type, {
            dataTransfer,
            bubbles: true,
            cancelable: true,
          });
          within().body.dispatchEvent(event);
        }
        while (!message()?.checkVisibility()) await sleep();
        const viewer = within().querySelector('girth-viewer')!;
        return [
          ...within().querySelectorAll('header, #meaning, #invitation, #examples, aside'),
          ...viewer.shadowRoot!.querySelectorAll('.message, .legend'),
        ]
          .filter((element) => element.checkVisibility({ visibilityProperty: true }))
          .map((element): NamedBox => {
            const { left, right, top, bottom } = element.getBoundingClientRect();
            const name = element.id || element.className || element.localName;
            return { name, left, right, top, bottom };
          });
      },
      { name: 'nothing.obj', text: 'nothing' },
    );
    expect(boxes.length).toBeGreaterThan(4);
    expect(overlapsOf(boxes)).toEqual([]);
    expect(boxes.filter(({ left, right }) => left < 0 || right > 320)).toEqual([]);
    await keep('320x256');
  });
});

test.runIf(otherBrowsers.some(({ name, isThere }) => name === 'WebKit' && isThere))(
  'WebKit without a language: the page opens and computes its example',
  async () => {
    const server = await serve(site, { isolated: true, folders });
    const page = await openWebKit('C');
    try {
      await page.open(server.url);
      await expect
        .poll(async () => (await page.evaluate(see, null)).isComplete, { timeout: 60_000 })
        .toBe(true);
    } finally {
      await page.close();
      await server.close();
    }
  },
);
