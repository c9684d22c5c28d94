// Elements side by side: one camera, one scale, and how others can follow the camera.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { CameraView, GirthViewer } from '../../web/src/element/index.js';
import { smallExamples } from './small-examples.js';
import {
  chromiumForTests,
  repository,
  requireBuilt,
  serve,
  strictPolicy,
  type StaticServer,
} from './support.js';
import { fieldComplete, framesPass } from './viewer-page.js';

const head =
  '<!doctype html><meta charset="utf-8"><title>linked</title><link rel="icon" href="data:,">';
const script = '<script type="module" src="girth/dist/girth-viewer.js"></script>';
/** As it is written in the documentation. */
const [documented = ''] =
  readFileSync(join(repository, 'web/docs/embedding.md'), 'utf8')
    .match(/^```html\n[^]*?^```$/gm)
    ?.filter((block) => block.includes('linked='))
    .map((block) => block.slice(8, -3)) ?? [];

const pages = {
  '/prism.obj': readFileSync(join(repository, 'tests/data/prism.obj'), 'utf8'),
  '/documented.html': head + documented,
  '/units.html': `${head}${script}<div style="display: flex">
    <girth-viewer src="prism.obj" unit="mm" one-scale="units"></girth-viewer>
    <girth-viewer src="prism.obj" unit="cm" one-scale="units"></girth-viewer></div>`,
  '/alone.html': `${head}${script}<div style="display: flex">
    <girth-viewer src="dumbbell.glb" field="none"></girth-viewer>
    <girth-viewer src="hook.glb" field="none"></girth-viewer></div>`,
};

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;
let complaints: string[];
let a: Locator;
let b: Locator;

beforeAll(async () => {
  requireBuilt('dist/girth-viewer.js', 'build:package');
  server = await serve(smallExamples, {
    policy: strictPolicy,
    pages,
    folders: { '/girth/dist/': join(repository, 'dist') },
  });
});
afterAll(() => server?.close());
afterEach(async () => {
  await page.context().close();
  expect(complaints).toEqual([]);
});

/** Opens a page with two elements, and waits until both show something. */
async function open(path: string): Promise<void> {
  ({ page, complaints } = await openPage(server.url + path, {}, async (page) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.addInitScript(record);
  }));
  [a, b] = [page.locator('girth-viewer').first(), page.locator('girth-viewer').last()];
  for (const viewer of [a, b]) {
    await expect.poll(() => viewer.evaluate((element: GirthViewer) => !!element.camera)).toBe(true);
  }
}

/** A record: what each drawing context has drawn, and what each element has sent, by the number of their frames. */
interface Recorded {
  drawn: number[][];
  moves: number[][];
  rests: number[][];
}

function record(): void {
  const recorded: Recorded = { drawn: [], moves: [[], []], rests: [[], []] };
  Object.assign(globalThis, { recorded });
  // The clock of animations may stand still from one frame to the next: it runs ahead between them. This callback is asked
  // for before all others of its frame, and so comes first.
  let frames = 0;
  const count = (): void => {
    ++frames;
    requestAnimationFrame(count);
  };
  requestAnimationFrame(count);
  const frame = (): number => frames;
  const contexts: object[] = [];
  const { prototype } = WebGL2RenderingContext;
  const draw = Object.getOwnPropertyDescriptor(prototype, 'drawElements')!.value as (
    ...given: unknown[]
  ) => void;
  Object.assign(prototype, {
    drawElements(this: WebGL2RenderingContext, ...given: unknown[]) {
      if (!contexts.includes(this)) contexts.push(this);
      (recorded.drawn[contexts.indexOf(this)] ??= []).push(frame());
      draw.apply(this, given);
    },
  });
  for (const [name, list] of [
    ['cameramove', recorded.moves],
    ['camera', recorded.rests],
  ] as const) {
    addEventListener(
      name,
      ({ target }) =>
        list[[...document.querySelectorAll('girth-viewer')].indexOf(target as GirthViewer)]?.push(
          frame(),
        ),
      true,
    );
  }
}

/** Forgets what was recorded, does something, and lets it come to rest. */
async function recorded(act: () => Promise<unknown>): Promise<Recorded> {
  await framesPass(page);
  await page.evaluate(() => {
    const { recorded } = globalThis as unknown as { recorded: Recorded };
    const { drawn, moves, rests } = recorded;
    for (const list of [...drawn, ...moves, ...rests]) list.length = 0;
  });
  await act();
  await framesPass(page);
  return page.evaluate(() => (globalThis as unknown as { recorded: Recorded }).recorded);
}

const viewOf = (viewer: Locator): Promise<CameraView> =>
  viewer.evaluate((element: GirthViewer) => element.camera!);

function expectSameView(one: CameraView, other: CameraView): void {
  const numbers = ({ polar, azimuth, distance, target }: CameraView): number[] => [
    ...[polar, azimuth, distance],
    ...target,
  ];
  numbers(one).forEach((number, i) => expect(number).toBeCloseTo(numbers(other)[i]!, 8));
}

async function drag(viewer: Locator, button: 'left' | 'right'): Promise<void> {
  const box = (await viewer.boundingBox())!;
  const [x, y] = [box.x + 0.1 * box.width, box.y + 0.1 * box.height];
  await page.mouse.move(x, y);
  await page.mouse.down({ button });
  await page.mouse.move(x + 60, y + 20, { steps: 6 });
  await page.mouse.up({ button });
}

test.each([
  ['as it is documented', false],
  ['where the other one asks for the frame first', true],
])(
  '%s: to turn, move and zoom one does so with the other, in the same frame',
  async (_, asksFirst) => {
    await open('/documented.html');
    await fieldComplete(a);
    await fieldComplete(b);
    if (asksFirst) {
      await page.evaluate(() => {
        const changeOthers = ({ target }: Event): void => {
          for (const viewer of document.querySelectorAll('girth-viewer')) {
            if (viewer !== target) viewer.toggleAttribute('edges');
          }
        };
        for (const type of ['pointermove', 'wheel', 'keydown']) {
          addEventListener(type, changeOthers, true);
        }
      });
    }
    expectSameView(await viewOf(a), await viewOf(b));
    for (const [moved, act] of [
      [0, () => drag(a, 'left')],
      [1, () => drag(b, 'right')],
      [0, () => page.mouse.wheel(0, 300)],
      [1, () => b.locator('canvas').press('ArrowLeft')],
    ] as const) {
      const before = await viewOf(a);
      const box = (await [a, b][moved]!.boundingBox())!;
      await page.mouse.move(box.x + 30, box.y + 30);
      const { moves, drawn, rests } = await recorded(act);
      expectSameView(await viewOf(a), await viewOf(b));
      expect(await viewOf(a)).not.toEqual(before);
      expect(moves[moved]!.length).toBeGreaterThan(0);
      // Each is told once in a frame, and each such frame has drawn both.
      for (const list of moves) expect(new Set(list).size).toBe(list.length);
      expect(moves[1 - moved]).toEqual(moves[moved]);
      for (const frame of moves[0]!) {
        expect(drawn.filter((frames) => frames.includes(frame))).toHaveLength(2);
      }
      for (const list of rests) expect(list.length).toBeGreaterThan(0);
    }
    // As at first, both are seen whole.
    await a.locator('canvas').press('0');
    await framesPass(page);
    for (const viewer of [a, b]) {
      expect(await viewer.evaluate((element: GirthViewer) => element.isAtHome)).toBe(true);
    }
    expectSameView(await viewOf(a), await viewOf(b));
  },
);

test('an element without the attribute is alone, and one that comes back takes the view of the other', async () => {
  await open('/documented.html');
  await b.evaluate((element) => element.removeAttribute('linked'));
  const before = await viewOf(b);
  await a.locator('canvas').press('ArrowLeft');
  await framesPass(page);
  expect(await viewOf(b)).toEqual(before);
  await b.evaluate((element) => element.setAttribute('linked', 'pair'));
  await expect.poll(() => viewOf(b)).not.toEqual(before);
  expectSameView(await viewOf(a), await viewOf(b));
  // One that is put on the page later, too; nothing of one that is gone stays.
  await b.evaluate((element: GirthViewer) => element.remove());
  await a.locator('canvas').press('ArrowUp');
  await page.evaluate(() => {
    const late = document.createElement('girth-viewer');
    late.setAttribute('src', 'hook.glb');
    late.setAttribute('linked', 'pair');
    document.querySelector('div')!.append(late);
  });
  await expect.poll(() => b.evaluate((element: GirthViewer) => !!element.info)).toBe(true);
  await expect.poll(async () => (await viewOf(b)).polar).toBeCloseTo((await viewOf(a)).polar, 8);
});

/** The ranges of colours of both. */
const spans = () =>
  Promise.all(
    [a, b].map((viewer) => viewer.evaluate((element: GirthViewer) => element.shown?.range)),
  );

test('one scale is one whatever the units are', async () => {
  await open('/units.html');
  await fieldComplete(a);
  await fieldComplete(b);
  const own = await a.evaluate((element: GirthViewer) => {
    const values = element.values('igf');
    return [Math.min(...values), Math.max(...values)] as const;
  });
  const [millimetres, centimetres] = await spans();
  // Their views are not linked.
  await a.locator('canvas').press('ArrowLeft');
  await framesPass(page);
  expect(await viewOf(b)).not.toEqual(await viewOf(a));
  expect(millimetres![0]).toBeCloseTo(own[0], 9);
  expect(millimetres![1]).toBeCloseTo(10 * own[1], 9);
  expect(centimetres![0]).toBeCloseTo(own[0] / 10, 9);
  expect(centimetres![1]).toBeCloseTo(own[1], 9);
});

test('one scale: from the least to the greatest; two numbers of one are for both', async () => {
  await open('/documented.html');
  const set = (viewer: Locator, name: string, value: string | null) =>
    viewer.evaluate(
      (element, [name, value]) => {
        if (value === null) element.removeAttribute(name);
        else element.setAttribute(name, value);
      },
      [name, value] as const,
    );
  await fieldComplete(a);
  await fieldComplete(b);
  const [shared, same] = await spans();
  expect(same).toEqual(shared);
  await set(a, 'one-scale', null);
  const [first, second] = await spans();
  expect(first).not.toEqual(second);
  expect(shared).toEqual([Math.min(first![0], second![0]), Math.max(first![1], second![1])]);
  await set(a, 'one-scale', 'pair');
  await expect.poll(spans).toEqual([shared, shared]);

  await set(b, 'range', '0.25 0.75');
  await expect.poll(spans).toEqual([
    [0.25, 0.75],
    [0.25, 0.75],
  ]);
  await set(b, 'range', null);
  await expect.poll(spans).toEqual([shared, shared]);
  // Another field has a scale of its own.
  await set(b, 'field', 'sdf');
  await expect.poll(async () => (await spans())[0]).toEqual(first);
});

test('two that set each other’s cameras come to rest, and nothing goes round', async () => {
  await open('/alone.html');
  await page.evaluate(() => {
    const [one, other] = document.querySelectorAll('girth-viewer');
    one!.addEventListener('cameramove', () => (other!.camera = one!.camera!));
    other!.addEventListener('cameramove', () => (one!.camera = other!.camera!));
  });
  const { moves, rests, drawn } = await recorded(() =>
    a.evaluate((element: GirthViewer) => {
      element.camera = { polar: 1, azimuth: -3, distance: 5, target: [0.1, 0, 0.2] };
    }),
  );
  expect(moves.map((list) => list.length)).toEqual([1, 1]);
  expect(moves[0]).toEqual(moves[1]);
  expect(rests.map((list) => list.length)).toEqual([1, 1]);
  expect(drawn.filter((frames) => frames.includes(moves[0]![0]!))).toHaveLength(2);
  expectSameView(await viewOf(a), await viewOf(b));
  // A camera that is set to where it is does nothing.
  const again = await recorded(() =>
    b.evaluate((element: GirthViewer) => {
      // oxlint-disable-next-line no-self-assign -- a setter
      element.camera = element.camera!;
    }),
  );
  expect(again.moves).toEqual([[], []]);
});
