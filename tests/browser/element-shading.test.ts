// Fields, tips and parts as a user sees them: pixels of drawn surfaces with drawn values.

import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, test } from 'vitest';
import type { GirthViewer, HoverDetail } from '../../web/src/element/index.js';
import type { SurfacePoint } from '../../web/src/kernel/types/types.js';
import { partKinds } from '../../web/src/view/categories.js';
import { colourAt } from '../../web/src/view/colormaps.js';
import {
  draw,
  drawnPages,
  expectHue,
  overSquare,
  pixelsAt,
  square,
  timesAsked,
  vertexAt,
  type Pixel,
} from './drawn-page.js';
import {
  allPixels,
  chromiumForTests,
  repository,
  requireBuilt,
  serve,
  strictPolicy,
  type StaticServer,
} from './support.js';

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;
let complaints: string[];

beforeAll(async () => {
  requireBuilt('dist/girth-viewer.js', 'build:package');
  server = await serve(join(repository, 'dist'), {
    policy: strictPolicy,
    pages: drawnPages,
  });
  ({ page, complaints } = await openPage(`${server.url}/drawn.html`, allPixels));
});

afterAll(() => server?.close());

beforeEach(() =>
  page.locator('girth-viewer').evaluate((element) => {
    for (const name of element.getAttributeNames()) element.removeAttribute(name);
  }),
);

afterEach(() => expect(complaints.splice(0)).toEqual([]));

/** Waits until the legend says so. */
async function legendSays(viewer: Locator, text: string): Promise<void> {
  await expect.poll(() => viewer.locator('.legend').innerText()).toContain(text);
}

/** Where a vertex is on the page, and what `hover` says last from now on. */
async function hoverOver(viewer: Locator, vertex: number) {
  const place = await viewer.evaluate((element: GirthViewer, vertex) => {
    const seen: HoverDetail[] = [];
    Object.assign(globalThis, { seen });
    element.addEventListener('hover', (event) => seen.push(event.detail));
    return element.screenPosition(vertex);
  }, vertex);
  const last = () =>
    viewer.evaluate(() => (globalThis as unknown as { seen: HoverDetail[] }).seen.at(-1));
  return { place, last };
}

const set = (viewer: Locator, name: string, value: string): Promise<void> =>
  viewer.evaluate((element, [name, value]) => element.setAttribute(name!, value!), [name, value]);

const sum = ({ r, g, b }: Pixel): number => r + g + b;
const isGrey = ({ r, g, b, alpha }: Pixel): boolean =>
  alpha === 255 && Math.max(r, g, b) - Math.min(r, g, b) < 8;

const rising = { ...square(), fields: { igf: overSquare((x) => 2 + 2 * x) } };

describe('fields', () => {
  test('while it is computed, every place has the colour of the nearest value so far', async () => {
    const falling = overSquare((x) => 2 - 2 * x);
    const viewer = await draw(page, {
      ...rising,
      fields: { igf: rising.fields.igf, sdf: falling },
      begun: {
        igf: [vertexAt(-0.6, 0), vertexAt(0.6, 0)],
        sdf: [vertexAt(-0.6, 0), vertexAt(0.6, 0)],
      },
    });
    const places = [
      [-0.6, 0],
      [-0.3, 0.5],
      [0.3, 0.5],
      [0.6, 0],
    ] as const;
    /** Whether the colour at each place is one end of the colours or the other. */
    const ends = async () =>
      (await pixelsAt(viewer, places)).map((pixel) => {
        if (isGrey(pixel)) return 'grey';
        return pixel.b > pixel.g ? 'low' : 'high';
      });
    await expect.poll(ends).toEqual(['low', 'low', 'high', 'high']);
    // Another field takes the place of the first one's colours with its first values.
    await set(viewer, 'field', 'sdf');
    await expect.poll(ends).toEqual(['high', 'high', 'low', 'low']);
  });

  test('until the first values of another field are there, colours and legend stay as they are', async () => {
    const falling = overSquare((x) => 20 - 2 * x);
    const viewer = await draw(page, {
      ...rising,
      fields: { igf: rising.fields.igf, sdf: falling, hks: falling },
      begun: { sdf: [] },
      once: ['hks'],
    });
    const places = [
      [-0.6, 0],
      [0.6, 0],
    ] as const;
    await legendSays(viewer, 'Girth');
    const legend = () => viewer.locator('.legend').innerText();
    const [colours, words] = [await pixelsAt(viewer, places), await legend()];
    await set(viewer, 'field', 'sdf');
    expect(await pixelsAt(viewer, places)).toEqual(colours);
    expect(await legend()).toBe(words);
    expect(await viewer.evaluate((element: GirthViewer) => element.shown!.name)).toBe('igf');
    // A field that is there is shown at once; and another number of it, which never comes, is awaited.
    await set(viewer, 'field', 'hks');
    await legendSays(viewer, 'Heat');
    const [heat, heatWords] = [await pixelsAt(viewer, places), await legend()];
    expect(heat).not.toEqual(colours);
    await set(viewer, 'time', '0.5');
    expect(await pixelsAt(viewer, places)).toEqual(heat);
    expect(await legend()).toBe(heatWords);
    await set(viewer, 'colormap', 'magma');
    expect(await pixelsAt(viewer, places)).not.toEqual(heat);
    expect(await legend()).toBe(heatWords);
    await set(viewer, 'field', 'none');
    expect((await pixelsAt(viewer, places)).every(isGrey)).toBe(true);
  });

  test('a value has the colour that the legend gives it', async () => {
    const viewer = await draw(page, { ...rising, unit: 'mm' });
    await legendSays(viewer, 'Girth, mm');
    const places = [-0.9, -0.5, 0, 0.5, 0.9].map((x) => [x, 0.3] as const);
    const pixels = await pixelsAt(viewer, places);
    pixels.forEach((pixel, i) => expectHue(pixel, colourAt('viridis', (places[i]![0] + 1) / 2)));
  });

  test('a range by numbers, by percentages, and one colour beyond its ends', async () => {
    const squares = overSquare((x) => ((x + 1) / 2) ** 2);
    const viewer = await draw(page, { ...square(), fields: { igf: squares } });
    await legendSays(viewer, 'Girth');
    await set(viewer, 'range', '0.25 0.5');
    const [low, high] = await pixelsAt(viewer, [
      [-0.4, 0],
      [0.8, 0],
    ]);
    expectHue(low!, colourAt('viridis', 0));
    expectHue(high!, colourAt('viridis', 1));
    // A quarter and three quarters of the square's area lie below 1/16 and 9/16.
    await set(viewer, 'range', '25% 75%');
    await expect.poll(() => timesAsked(page, 'areas')).toBe(1);
    const shown = () => viewer.evaluate((element: GirthViewer) => element.shown!.range!);
    await expect.poll(async () => Math.abs((await shown())[0] - 1 / 16)).toBeLessThan(0.02);
    expect((await shown())[1]).toBeCloseTo(9 / 16, 1);
    const ends = await viewer.locator('.legend-tick:not(.inner)').allInnerTexts();
    expect(ends[0]).toMatch(/^≥/);
    expect(ends[1]).toMatch(/^≤/);
    for (const wrong of ['5 1', '5% 200%', '1% 2', 'x y', '']) {
      await set(viewer, 'range', wrong);
      expect(await shown(), wrong).toEqual([0, 1]);
    }
  });

  test('values of both signs get a map that diverges at 0', async () => {
    const viewer = await draw(page, { ...square(), fields: { igf: overSquare((x) => 1 + 3 * x) } });
    await legendSays(viewer, '4.000');
    expect(await viewer.evaluate((element: GirthViewer) => element.shown)).toMatchObject({
      colormap: 'rdbu',
      range: [-4, 4],
      extent: [-2, 4],
    });
    const [below, above] = await pixelsAt(viewer, [
      [-0.95, 0],
      [0.95, 0],
    ]);
    expect(below!.b).toBeGreaterThan(below!.r + 20);
    expect(above!.r).toBeGreaterThan(above!.b + 20);
  });

  test('where there is no value the surface is grey, and the legend says so', async () => {
    const igf = overSquare((x, y) => (x > 0 && y > 0 ? null : 1 + x));
    const viewer = await draw(page, { ...square(), fields: { igf } });
    await legendSays(viewer, 'grey: no value at 400 vertices');
    const [without, beside] = await pixelsAt(viewer, [
      [0.5, 0.5],
      [0.5, -0.5],
    ]);
    expect(isGrey(without!)).toBe(true);
    expect(isGrey(beside!)).toBe(false);
  });

  test('what the core says of a field is said beside it, also where nothing has a value', async () => {
    const note = 'the surface is inside out: turn the faces over';
    const sdf = overSquare(() => null);
    const viewer = await draw(page, { ...rising, fields: { ...rising.fields, sdf }, note });
    await legendSays(viewer, note);
    await set(viewer, 'field', 'sdf');
    await legendSays(viewer, 'Shape diameter');
    await legendSays(viewer, `${note} (grey)`);
    const [pixel] = await pixelsAt(viewer, [[0.3, 0.3]]);
    expect(isGrey(pixel!)).toBe(true);
    const picture = await viewer.evaluate(async (element: GirthViewer) => {
      const blob = await element.snapshot({ legend: true });
      return blob.size;
    });
    expect(picture).toBeGreaterThan(1000);
  });

  test('lines of equal value are where the field has these values', async () => {
    const viewer = await draw(page, rising);
    await legendSays(viewer, 'Girth');
    // From 0 to 4, three lines: at 1, 2 and 3, which is x = -0.5, 0 and 0.5.
    const row = Array.from({ length: 361 }, (_, i) => [(i - 180) / 200, 0.22] as const);
    const plain = await pixelsAt(viewer, row);
    await set(viewer, 'isolines', '3');
    const lined = await pixelsAt(viewer, row);
    const changed = row.filter((_, i) => Math.abs(sum(plain[i]!) - sum(lined[i]!)) > 60);
    for (const [x] of changed) {
      const away = Math.min(...[-0.5, 0, 0.5].map((line) => Math.abs(x - line)));
      expect(away).toBeLessThan(0.012);
    }
    for (const line of [-0.5, 0, 0.5]) {
      expect(changed.some(([x]) => Math.abs(x - line) < 0.012)).toBe(true);
    }
    expect(await viewer.locator('.legend-line').count()).toBe(3);
  });

  test('there are no lines of equal value where the girth jumps', async () => {
    // From 0 to 4 within a single column of triangles, 0.05 wide.
    const igf = overSquare((x) => (x < 0.01 ? 0 : 4));
    const viewer = await draw(page, { ...square(), fields: { igf, sdf: igf } });
    await legendSays(viewer, 'Girth');
    await viewer.evaluate((element: GirthViewer) => {
      element.camera = { ...element.camera!, distance: 0.4 };
    });
    const across = Array.from({ length: 120 }, (_, i) => [i / 2000, 0.01] as const);
    const plain = await pixelsAt(viewer, across);
    await set(viewer, 'isolines', '3');
    expect(await pixelsAt(viewer, across)).toEqual(plain);
    await set(viewer, 'field', 'sdf');
    await legendSays(viewer, 'Shape diameter');
    const lined = await pixelsAt(viewer, across);
    expect(lined.filter((pixel, i) => Math.abs(sum(pixel) - sum(plain[i]!)) > 60)).not.toEqual([]);
  });

  test('each field is computed once, when it is asked for', async () => {
    const fields = {
      igf: overSquare((x) => 2 + x),
      angle: overSquare((x) => (Math.PI * (x + 1)) / 2),
    };
    const viewer = await draw(page, { ...square(), fields, unit: 'm' });
    await legendSays(viewer, 'Girth, m');
    const changes = await viewer.evaluate(async (element: GirthViewer) => {
      const seen: unknown[] = [];
      element.addEventListener('fieldchange', (event) => seen.push(event.detail.name));
      const until = (name: string) =>
        new Promise<void>((done) => {
          const check = () => (seen.at(-1) === name ? done() : setTimeout(check, 5));
          element.setAttribute('field', name);
          check();
        });
      for (const name of ['angle', 'none', 'igf', 'angle']) await until(name);
      return seen;
    });
    expect(changes).toEqual(['angle', 'none', 'igf', 'angle']);
    await legendSays(viewer, 'Angle of the loop, °');
    await legendSays(viewer, '180.0');
    expect(await timesAsked(page, 'igf')).toBe(1);
    expect(await timesAsked(page, 'angle')).toBe(1);
  });

  test('kinds of loops are colours with names', async () => {
    const kinds = overSquare((x) => (x < 0 ? 0 : 1));
    const viewer = await draw(page, { ...rising, kinds });
    await set(viewer, 'field', 'kind');
    await legendSays(viewer, 'there and back');
    expect(await viewer.locator('.legend li').allInnerTexts()).toEqual(['loop', 'there and back']);
    const [left, right] = await pixelsAt(viewer, [
      [-0.5, 0],
      [0.5, 0],
    ]);
    expectHue(left!, '#56b4e9');
    expectHue(right!, '#d55e00');
  });
});

describe('parts', () => {
  // Girth from 0 to 2 to the right, diameter from 0 to 2 upwards.
  const drawing = {
    ...square(),
    fields: {
      igf: overSquare((x) => 1 + x),
      sdf: overSquare((x, y) => (x > 0.8 ? null : 1 + y)),
    },
    smoothed: overSquare(() => 2),
  };
  const corners = [
    [0.5, 0.5],
    [-0.5, -0.5],
    [0.5, -0.5],
    [0.95, 0.5],
  ] as const;

  test('begin at the suggested thresholds, and a move of them recolours without computing', async () => {
    const viewer = await draw(page, drawing);
    await set(viewer, 'field', 'parts');
    await legendSays(viewer, 'tube');
    expect(await viewer.evaluate((element: GirthViewer) => element.thresholds)).toEqual({
      girth: 1,
      shapeDiameter: 1,
      smoothing: 0,
    });
    const [body, tube, plate, unknown] = partKinds.map(({ colour }) => colour);
    const begun = await pixelsAt(viewer, corners);
    expectHue(begun[0]!, body!);
    expectHue(begun[1]!, tube!);
    expectHue(begun[2]!, plate!);
    expect(isGrey(begun[3]!)).toBe(true);
    expect(unknown).not.toBe(body);
    const moved = await viewer.evaluate((element: GirthViewer) =>
      element.setThresholds({ girth: 1.7, shapeDiameter: 1.7 }),
    );
    expect(moved).toBeUndefined();
    const after = await pixelsAt(viewer, corners);
    for (const pixel of after.slice(0, 3)) expectHue(pixel, tube!);
    await viewer.evaluate((element: GirthViewer) =>
      element.setThresholds({ girth: Infinity, shapeDiameter: 0 }),
    );
    for (const pixel of (await pixelsAt(viewer, corners)).slice(0, 3)) expectHue(pixel, body!);
    expect(await timesAsked(page, 'parts')).toBe(0);
    expect(await timesAsked(page, 'sdf')).toBe(1);
  });

  test('the boundary lies where the value is the threshold', async () => {
    const viewer = await draw(page, drawing);
    await set(viewer, 'field', 'parts');
    await legendSays(viewer, 'tube');
    await viewer.evaluate((element: GirthViewer) =>
      element.setThresholds({ girth: 1.231, shapeDiameter: 1 }),
    );
    const [left, right] = await pixelsAt(viewer, [
      [0.215, -0.5],
      [0.247, -0.5],
    ]);
    expectHue(left!, partKinds[1]!.colour);
    expectHue(right!, partKinds[2]!.colour);
  });

  test('smoothed parts come from the kernel', async () => {
    const viewer = await draw(page, drawing);
    await set(viewer, 'field', 'parts');
    await legendSays(viewer, 'tube');
    await viewer.evaluate((element: GirthViewer) =>
      element.setThresholds({ girth: 1, shapeDiameter: 1, smoothing: 2 }),
    );
    await expect
      .poll(async () => {
        const [pixel] = await pixelsAt(viewer, [[0.5, 0.5]]);
        return pixel!.r > pixel!.b + 60;
      })
      .toBe(true);
    expect(await timesAsked(page, 'parts')).toBe(1);
  });

  test('thresholds that are none are refused in words', async () => {
    const viewer = await draw(page, drawing);
    const refused = await viewer.evaluate((element: GirthViewer) =>
      [NaN, -1].map((girth) => {
        try {
          element.setThresholds({ girth, shapeDiameter: 1 });
          return 'taken';
        } catch (error) {
          return String(error);
        }
      }),
    );
    for (const words of refused) expect(words).toContain('numbers from 0 on');
    expect(await viewer.evaluate((element: GirthViewer) => element.thresholds)).toBeUndefined();
  });
});

describe('tips', () => {
  const inside = (x: number, y: number): boolean => Math.abs(x) < 0.5 && Math.abs(y) < 0.5;
  const ring = [-0.5, -0.5, 0, 0.5, -0.5, 0, 0.5, 0.5, 0, -0.5, 0.5, 0];
  const drawing = {
    ...rising,
    tips: [
      {
        vertices: overSquare(inside).flatMap((isIn, v) => (isIn ? [v] : [])),
        contour: ring,
        apex: vertexAt(0, 0),
        jump: 3,
      },
    ],
    arcs: [{ polyline: [-0.8, -0.8, 0, 0.8, -0.8, 0], jump: 1 }],
  };

  test('contours are lines, regions are tinted, the apex is a dot; noise is ranked away', async () => {
    const viewer = await draw(page, drawing);
    await legendSays(viewer, 'Girth');
    const places = [
      [0.5, 0.1],
      [0.25, 0.3],
      [0, 0],
      [0.75, 0.3],
    ] as const;
    const plain = await pixelsAt(viewer, places);
    await viewer.evaluate((element: GirthViewer) => element.showTips({ shown: true }));
    const [line, region, apex, beside] = await pixelsAt(viewer, places);
    for (const white of [line!, apex!]) expect(sum(white)).toBeGreaterThan(700);
    expect(region!.r).toBeGreaterThan(plain[1]!.r + 20);
    expect(beside).toEqual(plain[3]);
    await viewer.evaluate((element: GirthViewer) => element.showTips({ shown: true, selected: 0 }));
    const [chosen, strong] = await pixelsAt(viewer, places);
    expectHue(chosen!, '#ff7a45');
    expect(strong!.r).toBeGreaterThan(region!.r + 20);
    await viewer.evaluate((element: GirthViewer) =>
      element.showTips({ shown: true, leastJump: 4 }),
    );
    expect(await pixelsAt(viewer, places)).toEqual(plain);
    expect(await timesAsked(page, 'tips')).toBe(1);
  });

  test('an open line is dashed', async () => {
    const viewer = await draw(page, drawing);
    await legendSays(viewer, 'Girth');
    await viewer.evaluate((element: GirthViewer) => element.showTips({ shown: true }));
    const along = Array.from({ length: 200 }, (_, i) => [(i - 100) / 130, -0.8] as const);
    const lights = (await pixelsAt(viewer, along)).map((pixel) => sum(pixel) > 600);
    const turns = lights.filter((light, i) => i > 0 && light !== lights[i - 1]).length;
    expect(turns).toBeGreaterThan(20);
    const closed = Array.from({ length: 100 }, (_, i) => [(i - 50) / 130, 0.5] as const);
    expect((await pixelsAt(viewer, closed)).every((pixel) => sum(pixel) > 600)).toBe(true);
  });

  test('as a field they are coloured without the areas of vertices, until a range is in shares of these', async () => {
    await set(page.locator('girth-viewer'), 'field', 'tips');
    const viewer = await draw(page, drawing);
    await legendSays(viewer, 'Rise at the tip');
    expect(await timesAsked(page, 'areas')).toBe(0);
    await set(viewer, 'range', '25% 75%');
    await expect.poll(() => timesAsked(page, 'areas')).toBe(1);
  });

  test('as a field: how far the girth rises', async () => {
    const viewer = await draw(page, drawing);
    await set(viewer, 'field', 'tips');
    await legendSays(viewer, 'Rise at the tip');
    const [within, without] = await pixelsAt(viewer, [
      [0.2, 0.2],
      [0.8, 0.8],
    ]);
    expectHue(within!, colourAt('viridis', 1));
    expectHue(without!, colourAt('viridis', 0));
  });
});

describe('places', () => {
  test('points to compare with are diamonds', async () => {
    const viewer = await draw(page, rising);
    await legendSays(viewer, 'Girth');
    const vertex = vertexAt(0.5, 0.5);
    // On the diamond, and in the corner that a square would have.
    const places = [
      [0.5, 0.5],
      [0.525, 0.525],
    ] as const;
    const plain = await pixelsAt(viewer, places);
    await viewer.evaluate((element: GirthViewer, v) => element.showPoints([v]), vertex);
    const [middle, corner] = await pixelsAt(viewer, places);
    expect(middle!.b).toBeGreaterThan(middle!.r + 80);
    expect(corner).toEqual(plain[1]);
    await viewer.evaluate((element: GirthViewer) => element.showPoints());
    expect(await pixelsAt(viewer, places)).toEqual(plain);
  });

  test('marked vertices keep their colours, the others fade', async () => {
    const viewer = await draw(page, rising);
    await legendSays(viewer, 'Girth');
    const places = [
      [0.5, 0.2],
      [-0.5, 0.2],
    ] as const;
    const plain = await pixelsAt(viewer, places);
    const right = overSquare((x) => x > 0).flatMap((isIn, v) => (isIn ? [v] : []));
    await viewer.evaluate((element: GirthViewer, right) => element.mark(right), right);
    const [kept, faded] = await pixelsAt(viewer, places);
    expect(kept).toEqual(plain[0]);
    expect(isGrey(faded!)).toBe(true);
    await viewer.evaluate((element: GirthViewer) => element.mark());
    expect(await pixelsAt(viewer, places)).toEqual(plain);
  });

  test('the pointer tells the vertex and its values', async () => {
    const viewer = await draw(page, rising);
    await legendSays(viewer, 'Girth');
    const vertex = vertexAt(0.5, 0.25);
    const { place, last } = await hoverOver(viewer, vertex);
    await page.mouse.move(place.x + 1, place.y + 1);
    await expect.poll(async () => (await last())?.vertex).toBe(vertex);
    expect((await last())!.values).toEqual({ igf: rising.fields.igf[vertex] });
    await page.mouse.move(3, 3);
    await expect.poll(async () => (await last())?.vertex).toBeUndefined();
  });

  test('a pointer that rests or clicks on the surface before it can be picked is heard', async () => {
    let release = (): void => undefined;
    const released = new Promise<void>((resolve) => (release = resolve));
    let held = 0;
    const fresh = await openPage(page.url(), allPixels, (page) =>
      page.route(/bvh/i, async (route) => {
        ++held;
        await released;
        await route.continue();
      }),
    );
    try {
      const viewer = await draw(fresh.page, rising);
      await legendSays(viewer, 'Girth');
      await expect.poll(() => held).toBeGreaterThan(0);
      const vertex = vertexAt(0.5, 0.25);
      const { place, last } = await hoverOver(viewer, vertex);
      await viewer.evaluate((element: GirthViewer) => {
        const chosen = { at: undefined as SurfacePoint | undefined };
        Object.assign(globalThis, { chosen });
        void element.choosePoint().then((point) => (chosen.at = point));
      });
      const chosen = () =>
        fresh.page.evaluate(
          () => (globalThis as unknown as { chosen: { at?: SurfacePoint } }).chosen.at,
        );
      await fresh.page.mouse.click(place.x + 1, place.y + 1);
      await viewer.evaluate(async () => {
        for (let i = 0; i < 3; ++i) await new Promise((done) => requestAnimationFrame(done));
      });
      expect(await last()).toBeUndefined();
      expect(await chosen()).toBeUndefined();
      release();
      await expect.poll(async () => (await last())?.vertex).toBe(vertex);
      await expect.poll(chosen).toMatchObject({ face: expect.any(Number) as number });
      expect(fresh.complaints).toEqual([]);
    } finally {
      release();
      await fresh.page.context().close();
    }
  });

  test('the camera goes to a place, and a picture of a place leaves it where it is', async () => {
    const viewer = await draw(page, rising);
    await legendSays(viewer, 'Girth');
    const corner = overSquare((x, y) => x > 0.7 && y > 0.7).flatMap((isIn, v) => (isIn ? [v] : []));
    const before = await pixelsAt(viewer, [[0.5, 0.5]]);
    const picture = await viewer.evaluate(async (element: GirthViewer, vertices) => {
      const view = element.camera!;
      const bitmap = await createImageBitmap(
        await element.snapshotOf({ vertices, width: 320, height: 200 }),
      );
      const pen = new OffscreenCanvas(320, 200).getContext('2d')!;
      pen.drawImage(bitmap, 0, 0);
      const [r, g, b, alpha] = pen.getImageData(160, 100, 1, 1).data;
      const isSame = JSON.stringify(view) === JSON.stringify(element.camera);
      const { width, height } = bitmap;
      return { width, height, isSame, middle: { r: r!, g: g!, b: b!, alpha: alpha! } };
    }, corner);
    expect(picture).toMatchObject({ width: 320, height: 200, isSame: true });
    expectHue(picture.middle, colourAt('viridis', 0.925));
    expect(await pixelsAt(viewer, [[0.5, 0.5]])).toEqual(before);

    await viewer.evaluate((element: GirthViewer, vertices) => element.flyTo({ vertices }), corner);
    const place = await viewer.evaluate(
      (element: GirthViewer, vertex) => element.screenPosition(vertex),
      vertexAt(0.85, 0.85),
    );
    expect(Math.hypot(place.x - 300, place.y - 300)).toBeLessThan(60);
  });

  test('the camera flies where motion is allowed', async () => {
    const viewer = await draw(page, rising);
    await legendSays(viewer, 'Girth');
    await page.emulateMedia({ reducedMotion: 'no-preference' });
    const target = () => viewer.evaluate((element: GirthViewer) => element.camera!.target[0]);
    const begun = await viewer.evaluate(
      (element: GirthViewer, vertex) => {
        element.flyTo({ vertex });
        return element.camera!.target[0];
      },
      vertexAt(0.8, 0),
    );
    expect(begun).toBeCloseTo(0);
    // The square's radius is the root of 2.
    await expect.poll(target).toBeCloseTo(0.8 / Math.SQRT2, 2);
  });

  test('the picture with the legend has it in its corner', async () => {
    const viewer = await draw(page, rising);
    await legendSays(viewer, 'Girth');
    const inked = await viewer.evaluate(async (element: GirthViewer) => {
      const bitmap = await createImageBitmap(await element.snapshot({ legend: true }));
      const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
      pen.drawImage(bitmap, 0, 0);
      const { data } = pen.getImageData(12, bitmap.height - 190, 60, 180);
      let [strong, clear] = [0, 0];
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b] = [data[i]!, data[i + 1]!, data[i + 2]!];
        if (Math.max(r, g, b) - Math.min(r, g, b) > 60) ++strong;
        if (data[i + 3]! < 255) ++clear;
      }
      return { strong, clear };
    });
    // A bar of 10 by 150, and nothing to see through.
    expect(inked.strong).toBeGreaterThan(1000);
    expect(inked.clear).toBe(0);
  });
});
