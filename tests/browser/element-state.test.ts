// The state of a figure, as HTML says it and as an object that is kept: pinned loops, tips, parts, camera, controls.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, expect, test } from 'vitest';
import type { ErrorDetail, GirthViewer, ViewerState } from '../../web/src/element/index.js';
import { packed } from '../web/package/packed.js';
import { box, dumbbell } from './meshes.js';
import { chromiumForTests, command, serve, strictPolicy, type StaticServer } from './support.js';
import { fieldComplete } from './viewer-page.js';

const site = mkdtempSync(join(tmpdir(), 'girth-state-'));
const head =
  '<!doctype html><meta charset="utf-8"><title>state</title><link rel="icon" href="data:,">';
const script = '<script type="module" src="girth/dist/girth-viewer.js"></script>';
const pages = {
  '/said.html': `${head}${script}<girth-viewer src="dumbbell.obj" unit="mm" field="parts" parts="30mm 1cm"
    pins="5 left bell, 7:0.2:0.3, 100 waist" tips="0 #2" camera="1.25, 0.5, 6, 0.1, 0, 0" controls="none"></girth-viewer>`,
  '/two.html': `${head}${script}<girth-viewer id="a" src="dumbbell.obj" field="none" loop="5 100"></girth-viewer>
    <p style="height: 300vh"></p><girth-viewer id="b" loading="lazy" field="none" turn camera="top"></girth-viewer>`,
  '/figure.html': `${head}${script}<girth-viewer src="figure.glb" pins="none" tips="none"></girth-viewer>`,
};

const openPage = chromiumForTests();
let server: StaticServer;
let page: Page;
let complaints: string[];

beforeAll(async () => {
  const model = join(site, 'dumbbell.obj');
  writeFileSync(model, dumbbell(16, 12));
  writeFileSync(join(site, 'box.obj'), box(3, 2, 2));
  const figure = ['-o', join(site, 'figure.glb'), '--loops', '5,100', '--tips'];
  execFileSync(command, ['igf', model, '--unit', 'mm', ...figure]);
  server = await serve(site, {
    policy: strictPolicy,
    pages,
    folders: { '/girth/': packed().folder },
  });
});

afterAll(async () => {
  await server?.close();
  rmSync(site, { recursive: true });
});

afterEach(() => page.context().close());

async function open(path: string): Promise<void> {
  ({ page, complaints } = await openPage(server.url + path));
}

const stateOf = (viewer: Locator) => viewer.evaluate(({ state }: GirthViewer) => state);
const show = (viewer: Locator, state: ViewerState) =>
  viewer.evaluate((element: GirthViewer, state) => {
    element.state = state;
  }, state);
const pinsOf = (viewer: Locator) =>
  viewer.evaluate(({ pinned }: GirthViewer) => pinned.map(({ name, loop }) => [loop.base, name]));

test('HTML says which loops are pinned, which tips drawn, where parts begin and from where all is seen', async () => {
  await open('/said.html');
  const viewer = page.locator('girth-viewer');
  await expect.poll(() => viewer.locator('.tag').count()).toBe(3);
  await expect.poll(async () => (await stateOf(viewer)).pins).toMatch(/waist$/);
  await fieldComplete(viewer);
  expect(await pinsOf(viewer)).toEqual([
    [5, 'left bell'],
    [{ face: 7, weights: [0.2, 0.3, 0.5] }, ''],
    [100, 'waist'],
  ]);
  const shown = await viewer.evaluate(({ camera, thresholds }: GirthViewer) => ({
    camera,
    thresholds,
  }));
  expect(shown.camera).toEqual({
    polar: expect.closeTo(1.25, 9) as number,
    azimuth: expect.closeTo(0.5, 9) as number,
    distance: expect.closeTo(6, 9) as number,
    target: [0.1, 0, 0],
  });
  expect(shown.thresholds).toEqual({ girth: 30, shapeDiameter: 10, smoothing: 0 });
  await expect.poll(async () => (await stateOf(viewer)).tips).toBe('all #2');
  expect(await viewer.locator('.legend').isVisible()).toBe(false);
  expect(await viewer.locator('.bar-tools').isVisible()).toBe(false);

  // Followed when they change, too.
  await viewer.evaluate((element) => element.setAttribute('controls', 'legend'));
  expect(await viewer.locator('.legend').isVisible()).toBe(true);
  await viewer.evaluate((element) => element.setAttribute('controls', ''));
  expect(await viewer.locator('.bar-tools').isVisible()).toBe(true);
  await viewer.evaluate((element) => {
    element.setAttribute('pins', '5 right bell, 6');
    element.removeAttribute('tips');
    element.setAttribute('parts', 'inf 12 0.1');
    element.setAttribute('camera', 'front');
  });
  await expect
    .poll(() => pinsOf(viewer))
    .toEqual([
      [5, 'right bell'],
      [6, ''],
    ]);
  expect(await viewer.evaluate(({ camera }: GirthViewer) => camera!.polar)).toBeCloseTo(1.5708, 4);
  expect(await stateOf(viewer)).toMatchObject({ parts: 'inf 12 0.1' });
  await expect.poll(async () => (await stateOf(viewer)).tips).toBeUndefined();
  await viewer.evaluate((element) => element.removeAttribute('camera'));
  expect(await viewer.evaluate(({ isAtHome }: GirthViewer) => isAtHome)).toBe(true);

  // Points that the surface does not have are an error, between others the path is drawn.
  const refused = await viewer.evaluate(
    (element) =>
      new Promise<string>((resolve) => {
        element.addEventListener('error', (event) =>
          resolve((event as CustomEvent<ErrorDetail>).detail.code),
        );
        element.setAttribute('profile', '5, 1000000');
      }),
  );
  expect(refused).toBe('VERTEX_OUT_OF_RANGE');
  await viewer.evaluate((element) => element.setAttribute('bottleneck', '0, 193'));
  expect(await stateOf(viewer)).toMatchObject({ bottleneck: '0, 193', profile: '5, 1000000' });
  expect(complaints).toEqual([]);
});

test('what was done by hand is in the state, and JSON brings it to another element, even one nobody has seen', async () => {
  await open('/two.html');
  const [a, b] = [page.locator('#a'), page.locator('#b')];
  // As long as nothing is shown, attributes are all there is.
  expect(await stateOf(b)).toEqual({ field: 'none', turn: true, camera: 'top' });
  await expect.poll(() => a.locator('.tag').count()).toBe(2);
  const text = await a.evaluate(async (viewer: GirthViewer) => {
    viewer.unpin(viewer.pinned[0]!.id);
    viewer.nameLoop(viewer.pinned[0]!.id, 'waist, tight');
    await viewer.pin({ face: 3, weights: [0.25, 0.25, 0.5] });
    viewer.camera = { polar: 1.1, azimuth: -0.7, distance: 5.3, target: [0, 0.2, 0] };
    viewer.setAttribute('shading', 'flat');
    await viewer.showTips({ shown: true, leastJump: 0.01, selected: 0 });
    return JSON.stringify(viewer.state);
  });
  const state = JSON.parse(text) as ViewerState;
  expect(state).toEqual({
    ...{ src: 'dumbbell.obj', field: 'none', shading: 'flat', tips: '0.01 #1' },
    pins: '100 waist%2C tight, 3:0.25:0.25',
    camera: expect.stringMatching(/^1\.1\d*,-0\.7\d*,5\.3\d*,0,0\.2,0$/) as string,
  });
  await show(b, state);
  expect(await stateOf(b)).toEqual(state);
  await b.evaluate((element) => element.scrollIntoView());
  await expect.poll(() => b.locator('.tag').count()).toBe(2);
  await expect.poll(async () => (await pinsOf(b)).at(-1)?.[1]).toBe('');
  await expect.poll(() => b.evaluate((viewer: GirthViewer) => viewer.state.tips)).toBe('0.01 #1');
  const { camera, ...rest } = await stateOf(b);
  expect({ ...rest, camera: state.camera }).toEqual(state);
  const numbers = (words: unknown) => String(words).split(',').map(Number);
  numbers(camera).forEach((number, i) => expect(number).toBeCloseTo(numbers(state.camera)[i]!, 9));
  expect(await pinsOf(b)).toEqual(await pinsOf(a));

  // Setting the state again brings back what has changed since, though no attribute has.
  await b.evaluate(async (viewer: GirthViewer) => {
    viewer.resetView();
    viewer.unpin(viewer.pinned[1]!.id);
    await viewer.showTips({ shown: false });
  });
  expect((await stateOf(b)).camera).toBeUndefined();
  await show(b, state);
  await expect.poll(() => b.locator('.tag').count()).toBe(2);
  expect(await b.evaluate((viewer: GirthViewer) => viewer.camera!.azimuth)).toBeCloseTo(-0.7, 9);
  await expect.poll(async () => (await stateOf(b)).tips).toBe('0.01 #1');

  // A model that came otherwise has no address; a state without one leaves the model.
  const kept = await b.evaluate(async (viewer: GirthViewer) => {
    await viewer.load('box.obj');
    const { src } = viewer.state;
    viewer.state = { field: 'none', edges: true };
    return { src, name: viewer.info!.name, state: viewer.state, has: viewer.hasAttribute('edges') };
  });
  expect(kept).toMatchObject({ name: 'box.obj', state: { field: 'none', edges: true }, has: true });
  expect(kept.src).toBeUndefined();
  // With one, that model comes.
  await show(b, state);
  await expect.poll(() => b.evaluate(({ info }: GirthViewer) => info?.name)).toBe('dumbbell.obj');
  expect(complaints).toEqual([]);
});

test('what is no state is refused with a code, and nothing is lost; a loop that cannot be is an error of its own', async () => {
  await open('/two.html');
  const viewer = page.locator('#a');
  await expect.poll(() => viewer.locator('.tag').count()).toBe(2);
  const before = await stateOf(viewer);
  const codes = await viewer.evaluate((viewer: GirthViewer) =>
    [null, 'text', { edges: true, colour: 'red' }, { edges: true, pins: '1 2' }].map((state) => {
      try {
        viewer.state = state as ViewerState;
        return '';
      } catch (error) {
        return (error as ErrorDetail).code;
      }
    }),
  );
  expect(codes).toEqual(Array.from({ length: 4 }, () => 'INVALID_OPTION'));
  expect(await stateOf(viewer)).toEqual(before);

  const heard = await viewer.evaluate(async (viewer: GirthViewer) => {
    const error = new Promise<string>((done) =>
      viewer.addEventListener('error', ({ detail }) => done(detail.code)),
    );
    viewer.setAttribute('pins', '999999, 7 there');
    return error;
  });
  expect(heard).toBe('VERTEX_OUT_OF_RANGE');
  await expect.poll(() => pinsOf(viewer)).toEqual([[7, 'there']]);
});

test('a text that a framework sets as a property is the attribute, and methods stay', async () => {
  await open('/two.html');
  const viewer = page.locator('#b');
  const found = await viewer.evaluate((viewer: GirthViewer) => {
    const texts = { loop: 'none', tips: true, parts: '1 2', unit: 'mm', camera: 'front' };
    Object.assign(viewer, texts, { shownUnit: 'cm' });
    const names = ['loop', 'tips', 'parts', 'unit', 'camera', 'shown-unit'];
    const set = names.map((name) => viewer.getAttribute(name));
    Object.assign(viewer, { loop: undefined, tips: false, parts: null });
    const left = names.map((name) => viewer.hasAttribute(name));
    const { unit, shownUnit } = viewer;
    const methods = [typeof viewer.loop, typeof viewer.tips, typeof viewer.parts];
    return { set, left, methods, unit, shownUnit };
  });
  expect(found).toEqual({
    set: ['none', '', '1 2', 'mm', 'front', 'cm'],
    left: [false, false, false, true, true, true],
    methods: ['function', 'function', 'function'],
    unit: 'mm',
    shownUnit: 'cm',
  });
  expect(complaints).toEqual([]);
});

test('what a file has can be left out, without anything that computes', async () => {
  const before = server.requests.length;
  await open('/figure.html');
  const viewer = page.locator('girth-viewer');
  await expect.poll(() => viewer.locator('.legend').innerText()).toContain('Girth, mm');
  await expect
    .poll(() => stateOf(viewer))
    .toEqual({ src: 'figure.glb', pins: 'none', tips: 'none' });
  expect(await viewer.locator('.tag').count()).toBe(0);
  await viewer.evaluate((element) => {
    element.setAttribute('pins', '100 waist');
    element.removeAttribute('tips');
  });
  await expect
    .poll(() => stateOf(viewer))
    .toEqual({
      ...{ src: 'figure.glb', pins: '100 waist' },
      tips: 'all',
    });
  expect(server.requests.slice(before).filter((path) => /\.wasm$|worker/.test(path))).toEqual([]);
  expect(complaints).toEqual([]);
});
