// Faults of browsers, networks and people: each ends in a working page, or in a message with a way out.

import { mkdtempSync, readFileSync, rmSync, truncateSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { strToU8, zipSync } from 'fflate';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { overlapsOf, stormOfSizes } from './faults.js';
import {
  type Faulty,
  changed,
  cube,
  cubeIsComputed,
  faultyPages,
  folders,
  isTooLarge,
  memoryEndsAt,
  messageIs,
} from './faulty-page.js';
import { box, torus } from './meshes.js';
import { drop, modelIs, openPanel, picture, site } from './page-support.js';
import { serve, strictPolicy } from './support.js';
import { fieldComplete, framesPass, hover, placeOnSurface } from './viewer-page.js';

const { openWith, keep } = faultyPages();
const scratch = mkdtempSync(join(tmpdir(), 'girth-faults-'));
afterAll(() => rmSync(scratch, { recursive: true }));

// ---- the program

test.each([
  ['missing', (page: Page) => page.route(/\.wasm$/, (route) => route.fulfill({ status: 404 }))],
  ['corrupt', (page: Page) => changed(page, /\.wasm$/, (body) => Buffer.alloc(body.length, 1))],
  ['cut off', (page: Page) => changed(page, /\.wasm$/, (body) => body.subarray(0, 20_000))],
])('the WebAssembly is %s: the program is blamed, not the model', async (_, prepare) => {
  const faulty = await openWith(prepare);
  const text = await messageIs(faulty, 'PROGRAM_NOT_LOADED');
  expect(text).toMatch(/reload the page/);
  expect(text).not.toMatch(/chair/);
});

test('WebAssembly of the wrong type and without shared memory: everything works', async () => {
  const plain = await serve(site, {
    policy: strictPolicy,
    folders,
    answers: (path) => (path.endsWith('.wasm') ? { type: 'text/plain' } : undefined),
  });
  try {
    const faulty = await openWith(() => Promise.resolve(), plain.url);
    await fieldComplete(faulty.viewer);
    expect(await faulty.page.evaluate(() => crossOriginIsolated)).toBe(false);
    expect(await faulty.message.isVisible()).toBe(false);
  } finally {
    await plain.close();
  }
});

test('WebAssembly that the content security policy blocks: the message names what to allow', async () => {
  const policy = strictPolicy.replace(" 'wasm-unsafe-eval'", '');
  const blocked = await serve(site, { isolated: true, policy, folders });
  try {
    const faulty = await openWith(() => Promise.resolve(), blocked.url);
    expect(await messageIs(faulty, 'PROGRAM_NOT_LOADED')).toContain(
      "script-src 'wasm-unsafe-eval'",
    );
  } finally {
    await blocked.close();
  }
});

test.each([
  ['there are no workers', () => Reflect.deleteProperty(globalThis, 'Worker')],
  [
    'workers that are modules are refused',
    () => {
      globalThis.Worker = class {
        constructor() {
          throw new TypeError('Module scripts are not supported on DedicatedWorker yet.');
        }
      } as unknown as typeof Worker;
    },
  ],
])('%s: words, and no error that nobody caught', async (_, prepare) => {
  const faulty = await openWith((page) => page.addInitScript(prepare));
  expect(await messageIs(faulty, 'PROGRAM_NOT_LOADED')).toMatch(/browser/);
  expect(faulty.complaints).toEqual([]);
});

test('a worker that throws while it starts', async () => {
  const faulty = await openWith((page) =>
    changed(page, /job-worker.*\.js$/, () => Buffer.from('throw new Error("no luck");')),
  );
  expect(await messageIs(faulty, 'PROGRAM_NOT_LOADED')).toMatch(/no luck.*reload the page/);
});

/** A file that has this size and no bytes on the disk: an STL of triangles that are points. */
function emptyFile(name: string, size: number): string {
  const path = join(scratch, name);
  const head = Buffer.alloc(84);
  head.writeUInt32LE(Math.floor((size - head.length) / 50), 80);
  writeFileSync(path, head);
  truncateSync(path, size);
  return path;
}

test('memory that ends at 128 MB: words, the model before stays, and small ones are computed', async () => {
  const faulty = await openWith((page) => memoryEndsAt(page, 128 << 20));
  await modelIs(faulty.page, 'chair.glb');
  await faulty.page.setInputFiles('#file', emptyFile('large.stl', (128 << 20) + 134));
  await isTooLarge(faulty, 'large.stl');
});

test('workers that die while they compute: words, and the next model is computed', async () => {
  const faulty = await openWith((page) =>
    page.addInitScript(() => {
      const all: Worker[] = [];
      Object.assign(globalThis, { all });
      const Usual = Worker;
      globalThis.Worker = class extends Usual {
        constructor(...args: ConstructorParameters<typeof Worker>) {
          super(...args);
          all.push(this);
        }
      };
    }),
  );
  await modelIs(faulty.page, 'chair.glb');
  await faulty.page.evaluate(() => {
    for (const worker of (globalThis as unknown as { all: Worker[] }).all) {
      worker.dispatchEvent(new ErrorEvent('error', { message: 'killed' }));
      worker.terminate();
    }
  });
  await cubeIsComputed(faulty);
  expect(faulty.complaints).toEqual([]);
});

// ---- the picture

test('no WebGL: how to get it is said; all else works without the picture', async () => {
  const faulty = await openWith((page) =>
    page.addInitScript(() => {
      const { prototype } = HTMLCanvasElement;
      const usual = Reflect.get(prototype, 'getContext');
      prototype.getContext = new Proxy(usual, {
        apply: (usual, canvas, args: [string]) =>
          /^webgl/.test(args[0]) ? null : (Reflect.apply(usual, canvas, args) as RenderingContext),
      });
    }),
  );
  const { page, viewer } = faulty;
  await fieldComplete(viewer);
  expect(await messageIs(faulty, 'NO_WEBGL')).toMatch(
    /no 3D graphics.*work without the picture.*hardware acceleration/,
  );
  // Computing, plots, lists and exports.
  await expect.poll(() => page.locator('#field .caption').textContent()).toMatch(/^median \d/);
  const tips = await openPanel(page, 'tips');
  await tips.locator('.places button').first().waitFor();
  const print = await openPanel(page, 'print');
  await page.locator('#min-wall').fill('1 m');
  await page.locator('#check').click();
  await print.locator('.places button').first().waitFor();
  await page.getByRole('button', { name: 'Export' }).click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.locator('#export button', { hasText: 'CSV' }).first().click(),
  ]);
  expect(readFileSync(await download.path(), 'utf8')).toMatch(/^vertex,igf,kind\n0,\d/);
  await page.getByRole('button', { name: 'Export' }).click();
  await page.locator('#export button', { hasText: 'PNG' }).click();
  await expect.poll(() => page.locator('#export-failure').textContent()).toMatch(/no 3D graphics/);
  await cubeIsComputed(faulty);
  expect(faulty.complaints).toEqual([]);
});

test('graphics that are taken away and given back: said, and the picture is there again', async () => {
  const faulty = await openWith((page) =>
    page.addInitScript(() => {
      const { prototype } = HTMLCanvasElement;
      const usual = Reflect.get(prototype, 'getContext');
      prototype.getContext = new Proxy(usual, {
        apply(usual, canvas, args: [string]) {
          const context = Reflect.apply(usual, canvas, args) as RenderingContext;
          if (args[0] === 'webgl2') Object.assign(globalThis, { drawing: context });
          return context;
        },
      });
    }),
  );
  const { page, viewer } = faulty;
  await fieldComplete(viewer);
  // The loop that is shown until somebody comes.
  await viewer.locator('.readout').waitFor();
  await page.mouse.move(1, 1);
  await viewer.locator('.readout').waitFor({ state: 'hidden' });
  // The shadow on the ground comes later than the colours, and is grey.
  const coloured = (): Promise<number> =>
    viewer.evaluate(async (element: GirthViewer) => {
      const bitmap = await createImageBitmap(await element.snapshot());
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const pen = canvas.getContext('2d')!;
      pen.drawImage(bitmap, 0, 0);
      const { data } = pen.getImageData(0, 0, bitmap.width, bitmap.height);
      return data.filter((red, i) => i % 4 === 0 && Math.abs(red - data[i + 2]!) > 40).length;
    });
  const before = await coloured();
  expect(before).toBeGreaterThan(1000);
  await page.evaluate(() => {
    const { drawing } = globalThis as unknown as { drawing: WebGL2RenderingContext };
    const extension = drawing.getExtension('WEBGL_lose_context')!;
    Object.assign(globalThis, { giveBack: () => extension.restoreContext() });
    extension.loseContext();
  });
  await messageIs(faulty, 'NO_WEBGL');
  await page.evaluate(() => (globalThis as unknown as { giveBack: () => void }).giveBack());
  await faulty.message.waitFor({ state: 'hidden' });
  await expect.poll(coloured).toBe(before);
});

test('a canvas of no size, and a storm of sizes: the picture fits the last one', async () => {
  const faulty = await openWith((page) =>
    page.addInitScript(() =>
      document.addEventListener('DOMContentLoaded', () => {
        document.querySelector<HTMLElement>('.surface')!.style.display = 'none';
      }),
    ),
  );
  const { page, viewer } = faulty;
  await page.locator('#examples button').first().waitFor();
  await page.evaluate(stormOfSizes);
  await modelIs(page, 'chair.glb');
  await framesPass(page);
  const { picture, element } = await viewer.evaluate(async (element: GirthViewer) => {
    const { width, height } = await createImageBitmap(await element.snapshot());
    const points = [width, height].map((pixels) => pixels / devicePixelRatio);
    return { picture: points, element: [element.clientWidth, element.clientHeight] };
  });
  expect(picture).toEqual(element);
  expect(faulty.complaints).toEqual([]);
});

// ---- the network

test('a download that is cut off, one that never ends, and one that is not allowed', async () => {
  // Promises more than it sends, and then breaks off or stays silent.
  const liar = createServer((request, response) => {
    response.writeHead(200, { 'Content-Length': '100000', 'Access-Control-Allow-Origin': '*' });
    response.write(box(1, 1, 1));
    if (request.url?.includes('cut')) setTimeout(() => response.destroy(), 20);
  });
  await new Promise<void>((done) => liar.listen(0, '127.0.0.1', done));
  const { port } = liar.address() as AddressInfo;
  const at = (path: string): string => `http://127.0.0.1:${port}/${path}`;
  const allowed = await serve(site, { folders });
  const other = await serve(site, { folders });
  try {
    const faulty = await openWith(() => Promise.resolve(), allowed.url);
    const { page, viewer, message } = faulty;
    await modelIs(page, 'chair.glb');
    const go = (model: string): Promise<void> =>
      page.evaluate((model) => {
        location.hash = `model=${encodeURIComponent(model)}`;
      }, model);
    await go(at('cut.obj'));
    expect(await messageIs(faulty, 'FILE_UNREADABLE')).toMatch(/check the address and the conn/);
    await message.getByRole('button').click();
    await go(at('silent.obj'));
    const cross = viewer.getByRole('button', { name: 'Cancel reading' });
    await cross.click();
    await cross.waitFor({ state: 'hidden' });
    expect(await message.isVisible()).toBe(false);
    await go(`${other.url}/examples/cup.glb`);
    expect(await messageIs(faulty, 'FILE_UNREADABLE')).toMatch(/CORS/);
    await cubeIsComputed(faulty);
  } finally {
    liar.closeAllConnections();
    liar.close();
    await allowed.close();
    await other.close();
  }
});

test('offline while a model is fetched: words, the model before stays; then it can be had', async () => {
  const faulty = await openWith(() => Promise.resolve());
  const { page } = faulty;
  await modelIs(page, 'chair.glb');
  const cup = page.locator('#examples button[data-example=cup]');
  await page.context().setOffline(true);
  await cup.click();
  expect(await messageIs(faulty, 'FILE_UNREADABLE')).toMatch(/The former model is still here/);
  await page.context().setOffline(false);
  await cup.click();
  await modelIs(page, 'cup.glb');
  expect(await faulty.message.isVisible()).toBe(false);
});

// ---- people, and what they have forbidden

/** Lets a tab be hidden by `hide(true)`, as the page sees it. */
const canBeHidden = (): void => {
  const [frame, timer] = [requestAnimationFrame, setTimeout];
  const pending: FrameRequestCallback[] = [];
  let isHidden = false;
  const said = {
    hidden: () => isHidden,
    visibilityState: () => (isHidden ? 'hidden' : 'visible'),
  };
  for (const [name, get] of Object.entries(said)) {
    Object.defineProperty(Document.prototype, name, { get });
  }
  globalThis.requestAnimationFrame = (draw) => (isHidden ? pending.push(draw) : frame(draw));
  globalThis.setTimeout = ((act: () => void, ms = 0) =>
    timer(act, isHidden ? Math.max(1000, ms) : ms)) as typeof setTimeout;
  const hide = (hidden: boolean): void => {
    isHidden = hidden;
    document.dispatchEvent(new Event('visibilitychange'));
    if (!hidden) for (const draw of pending.splice(0)) frame(draw);
  };
  Object.assign(globalThis, { hide });
};

describe('on one page, one after the other', () => {
  let faulty: Faulty;
  beforeAll(async () => {
    faulty = await openWith((page) => page.addInitScript(canBeHidden));
    keep();
    await modelIs(faulty.page, 'chair.glb');
  });
  afterAll(async () => {
    await faulty.context.close();
    expect(faulty.complaints).toEqual([]);
  });

  test('files that are dropped one upon the other: the last one is shown, and nothing else is said', async () => {
    const { page, viewer } = faulty;
    await drop(page, { name: 'first.obj', bytes: Buffer.from(torus(60, 40)) });
    await drop(page, { name: 'second.obj', bytes: Buffer.from(torus(50, 40)) });
    await drop(page, cube);
    await modelIs(page, cube.name);
    await fieldComplete(viewer);
    await framesPass(page);
    expect(await page.locator('#model b').textContent()).toBe(cube.name);
    expect(await faulty.message.isVisible()).toBe(false);
  });

  test('a zip, whose looking into is held up, does not come over what was dropped after it', async () => {
    const { page, viewer } = faulty;
    let letGo = (): void => undefined;
    const held = new Promise<void>((resolve) => (letGo = resolve));
    await page.route(/\/project-[\w-]+\.js$/, async (route) => {
      await held;
      await route.continue();
    });
    const names = await viewer.evaluateHandle((element: GirthViewer) => {
      const names: string[] = [];
      element.addEventListener('load', ({ detail }) => names.push(detail.info.name));
      return names;
    });
    const zipped = (name: string) => {
      const bytes = Buffer.from(zipSync({ [`${name}.obj`]: strToU8(box(1, 2, 2)) }));
      return { name: `${name}.zip`, bytes };
    };
    await drop(page, zipped('held'));
    await drop(page, cube);
    await modelIs(page, cube.name);
    await fieldComplete(viewer);
    const comes = page.waitForResponse(/\/project-[\w-]+\.js$/);
    letGo();
    await comes;
    await framesPass(page);
    // A zip that is looked into after it comes after it.
    await drop(page, zipped('next'));
    await modelIs(page, 'next.obj');
    expect(await names.jsonValue()).toEqual([cube.name, 'next.obj']);
    await page.unroute(/\/project-[\w-]+\.js$/);
  });

  test('a folder, whose listing is held up, does not come over what was dropped after it', async () => {
    const { page, viewer } = faulty;
    const names = await viewer.evaluateHandle((element: GirthViewer) => {
      const names: string[] = [];
      element.addEventListener('load', ({ detail }) => names.push(detail.info.name));
      return names;
    });
    /** Drops a folder with one file in it, which can be read when `letGo` is called. */
    const dropFolder = (name: string) =>
      page.evaluateHandle(
        ([name, text]) => {
          let letGo = (): void => undefined;
          const held = new Promise<void>((resolve) => (letGo = resolve));
          const file = {
            ...{ isFile: true, isDirectory: false, name, fullPath: `/folder/${name}` },
            file: (take: (file: File) => void) => take(new File([text], name)),
          };
          const portions = [[file], []];
          const readEntries = (take: (entries: unknown[]) => void): void =>
            void held.then(() => take(portions.shift()!));
          const folder = {
            ...{ isFile: false, isDirectory: true, name: 'folder', fullPath: '/folder' },
            createReader: () => ({ readEntries }),
          };
          const items = [{ kind: 'file', webkitGetAsEntry: () => folder }];
          const event = new DragEvent('drop', { bubbles: true, cancelable: true });
          Object.defineProperty(event, 'dataTransfer', {
            value: { types: ['Files'], files: [], items },
          });
          document.body.dispatchEvent(event);
          return letGo;
        },
        [name, box(1, 2, 2)] as const,
      );
    const held = await dropFolder('held.obj');
    await drop(page, cube);
    await modelIs(page, cube.name);
    await fieldComplete(viewer);
    await held.evaluate((letGo) => letGo());
    await framesPass(page);
    const next = await dropFolder('next.obj');
    await next.evaluate((letGo) => letGo());
    await modelIs(page, 'next.obj');
    expect(await names.jsonValue()).toEqual([cube.name, 'next.obj']);
  });

  test('a file of 2 GB: words, before anything of it is read', async () => {
    const { page } = faulty;
    const before = await page.locator('#model b').textContent();
    await page.setInputFiles('#file', emptyFile('scan.stl', 2 ** 31));
    expect(await messageIs(faulty, 'LIMIT_EXCEEDED')).toMatch(/scan\.stl.*2\.1 GB.*smaller model/);
    expect(await page.locator('#model b').textContent()).toBe(before);
    await faulty.message.getByRole('button').click();
  });

  test('a hidden tab, whose timers are slow and which has no frames: computed meanwhile, drawn once it is seen', async () => {
    const { page, viewer } = faulty;
    const hide = (hidden: boolean) =>
      page.evaluate(
        (hidden) => (globalThis as unknown as { hide(hidden: boolean): void }).hide(hidden),
        hidden,
      );
    await hide(true);
    const name = 'unseen.obj';
    await drop(page, { name, bytes: cube.bytes });
    await modelIs(page, name);
    await fieldComplete(viewer);
    await hide(false);
    const { x, y } = await placeOnSurface(viewer, 0.5, 0.5);
    expect((await hover(page, viewer, x, y)).length).toBeGreaterThan(0);
  });
});

test('names that are scripts are names', async () => {
  const faulty = await openWith(() => Promise.resolve());
  const name = '<img src=x onerror="document.title=666">.obj';
  await modelIs(faulty.page, 'chair.glb');
  await drop(faulty.page, { name, bytes: cube.bytes });
  await expect.poll(() => faulty.page.locator('#model b').textContent()).toBe(name);
  await drop(faulty.page, { name, bytes: Buffer.from('nothing') });
  await faulty.message.waitFor();
  expect(await faulty.message.textContent()).toContain(name);
  expect(await faulty.page.title()).toContain(name);
  expect(faulty.complaints).toEqual([]);
});

test('nothing stored, nothing copied, and a clock that jumps', async () => {
  const faulty = await openWith((page) =>
    page.addInitScript(() => {
      const denied = (): never => {
        throw new DOMException('denied', 'SecurityError');
      };
      for (const name of ['localStorage', 'sessionStorage', 'indexedDB', 'caches']) {
        Object.defineProperty(globalThis, name, { get: denied });
      }
      Object.defineProperty(Navigator.prototype, 'clipboard', { get: () => undefined });
      const usual = Date.now;
      let jump = 0;
      Date.now = () => usual() + 1e10 * Math.sin(++jump);
    }),
  );
  const { page } = faulty;
  await fieldComplete(faulty.viewer);
  await page.getByRole('button', { name: 'Share' }).click();
  await page.getByRole('button', { name: 'Copy link' }).click();
  await expect.poll(() => page.locator('#share').textContent()).toMatch(/does not let pages copy/);
  expect(faulty.complaints).toEqual([]);
});

test('what is wrong with a file lies over nothing else, at any size', async () => {
  const faulty = await openWith(() => Promise.resolve());
  const { page, viewer, message } = faulty;
  await fieldComplete(viewer);
  await drop(page, { name: 'nothing.obj', bytes: Buffer.from('nothing') });
  await message.waitFor();
  // The first is what is left at four times the size.
  for (const [width, height] of [
    [320, 256],
    [390, 844],
    [1440, 900],
  ] as const) {
    await page.setViewportSize({ width, height });
    await framesPass(page);
    const size = `${width}x${height}`;
    const boxes = await page.evaluate(() => {
      const viewer = document.querySelector('girth-viewer')!;
      const all = [
        ...document.querySelectorAll('header, #meaning, #invitation, #examples, aside'),
        ...viewer.shadowRoot!.querySelectorAll('.message, .legend'),
      ].filter((element) => element.checkVisibility({ visibilityProperty: true }));
      return all.map((element) => {
        const { left, right, top, bottom } = element.getBoundingClientRect();
        return {
          name: element.id || element.className || element.localName,
          ...{ left, right, top, bottom },
        };
      });
    });
    expect(
      boxes.map(({ name }) => name),
      size,
    ).toEqual(
      expect.arrayContaining(['header', 'meaning', 'invitation', 'message', 'examples', 'aside']),
    );
    expect(overlapsOf(boxes), size).toEqual([]);
    // Nothing is cut off at the sides, and the rest can be scrolled to.
    for (const { name, left, right } of boxes) {
      expect(left, name).toBeGreaterThanOrEqual(0);
      expect(right, name).toBeLessThanOrEqual(width);
    }
    await picture(page, `fault-${size}.png`);
    await page.getByRole('button', { name: 'Share' }).click();
    await page.locator('#share').waitFor();
    await page.keyboard.press('Escape');
    await page.locator('#share').waitFor({ state: 'hidden' });
  }
  await message.getByRole('button').click();
  await message.waitFor({ state: 'hidden' });
});
