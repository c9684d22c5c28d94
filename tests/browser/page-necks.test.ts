// Necks, handles and tunnels on the page: found, listed, shown, and the surface cut along them; what is between two
// points; short handles removed.

import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { expect, test } from 'vitest';
import type { GirthViewer } from '../../web/src/element/index.js';
import { complaintsOfAxe } from './axe.js';
import { box, dumbbell, moebius, plateWithNeedle, torus, tube } from './meshes.js';
import {
  type BuiltPage,
  builtPage,
  drop,
  fragment,
  modelIs,
  openPanel,
  picture,
} from './page-support.js';
import { fieldComplete } from './viewer-page.js';

const openBuilt = builtPage();

/** The page with a drawn model. */
async function openWith(name: string, text: string, options = {}) {
  const built = await openBuilt(undefined, options);
  await modelIs(built.page, 'chair.glb');
  await drop(built.page, { name, bytes: Buffer.from(text) });
  await modelIs(built.page, name);
  await fieldComplete(built.viewer);
  return built;
}

/** Where on the screen two points at the two ends of the surface can be clicked. */
async function endsOf({ page, viewer }: BuiltPage) {
  const box = (await viewer.boundingBox())!;
  const ends = await viewer.evaluate((element: GirthViewer) => {
    const seen = Array.from({ length: element.info!.vertexCount }, (_, v) => ({
      v,
      ...element.screenPosition(v),
    })).filter(({ visible }) => visible);
    seen.sort((a, b) => a.x - b.x);
    const count = Math.ceil(seen.length / 4);
    // In the middle of each end: what is at the outline may be missed.
    return [seen.slice(0, count), seen.slice(-count)].map((end) => {
      const mean = (key: 'x' | 'y') => end.reduce((sum, one) => sum + one[key], 0) / end.length;
      const [x, y] = [mean('x'), mean('y')];
      const away = (one: { x: number; y: number }) => Math.hypot(one.x - x, one.y - y);
      const nearest = end.reduce((best, one) => (away(one) < away(best) ? one : best));
      return { v: nearest.v, x: nearest.x, y: nearest.y };
    });
  });
  return {
    ends,
    click: (i: number) => page.mouse.click(box.x + ends[i]!.x, box.y + ends[i]!.y),
    tap: (i: number) => page.touchscreen.tap(box.x + ends[i]!.x, box.y + ends[i]!.y),
  };
}

async function downloaded(page: Page, format: string, within = '#necks-panel') {
  const coming = page.waitForEvent('download');
  await page.locator(`${within} [data-format=${format}]`).click();
  const download = await coming;
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

test('a neck is listed, shown, and the surface cut along it', async () => {
  const { page, viewer } = await openWith('dumbbell.obj', dumbbell(16, 12));
  const panel = await openPanel(page, 'necks');
  const rows = panel.getByRole('list', { name: 'Necks' }).getByRole('button');
  await rows.first().waitFor({ timeout: 60_000 });
  const known = await viewer.evaluate(async (element: GirthViewer) => {
    const { necks } = await element.necks();
    const { area } = element.info!;
    const [{ length, sides }] = necks as [(typeof necks)[0]];
    const clear = necks.filter((neck) => neck.prominence >= 0.01 * neck.length);
    return { count: clear.length, length, sides: sides.map((side) => side.area), area };
  });
  expect(await rows.count()).toBe(known.count);
  expect(await panel.locator('h3').allTextContents()).toContain('No handle and no tunnel');
  expect(Number.parseFloat((await rows.first().textContent())!.replace(/^1/, ''))).toBeCloseTo(
    known.length,
    1,
  );
  expect(known.sides.reduce((sum, area) => sum + area, 0)).toBeCloseTo(known.area, 9);
  const cut = panel.getByRole('button', { name: 'Cut here' });
  expect(await cut.isDisabled()).toBe(true);
  await rows.first().focus();
  await page.keyboard.press('Enter');
  expect(await rows.first().getAttribute('aria-pressed')).toBe('true');
  await panel.getByText(/^Chosen: .* long; it separates an area of .* from an area of /).waitFor();
  await cut.click();
  await panel.getByText('Cut into 2 parts.').waitFor();
  const parts = panel.getByRole('list', { name: 'Parts of the cut' }).getByRole('listitem');
  expect(await parts.count()).toBe(2);
  // The dumbbell is one neck between two ends, each of them a tip.
  expect(await parts.allTextContents()).toEqual(
    [1, 2].map((part) => expect.stringMatching(`^${part}area [\\d.,]+ volume [\\d.,]+`) as unknown),
  );
  await expect.poll(() => fragment(page)).toContain('panel=necks');
  await picture(page, 'page-cut.png');
  // A line that is scrolled away in part is no touch target.
  await page.locator('aside').evaluate((aside) => aside.scrollTo(0, 0));
  expect(await complaintsOfAxe(page)).toEqual([]);

  const glb = await downloaded(page, 'glb');
  expect(glb.name).toBe('dumbbell-parts.glb');
  expect(glb.bytes.toString('latin1', 0, 4)).toBe('glTF');
  const stl = await downloaded(page, 'stl');
  expect(stl.name).toBe('dumbbell-parts-stl.zip');
  // Cut at its necks it falls into the same parts for the element, with what each is.
  const segmented = await viewer.evaluate(async (element: GirthViewer) => {
    const { length } = (await element.necks()).necks[0]!;
    const options = { minProminence: 0.01 * length };
    const { segments, labels, crossing } = await element.segments(options);
    const csv = new TextDecoder().decode(await element.exportSegments('csv', options));
    return {
      areas: segments.map(({ area }) => area),
      tips: segments.map(({ tips }) => tips.length),
      ...{ labels: [...labels], crossing, csv: csv.trim().split('\n').slice(1) },
    };
  });
  expect(segmented.crossing).toEqual([]);
  expect(segmented.tips).toEqual([1, 1]);
  expect(segmented.areas).toEqual(known.sides.map((area) => expect.closeTo(area, 9) as number));
  expect(segmented.csv.map((line) => Number(line.split(',')[1]))).toEqual(segmented.labels);
  const json = await downloaded(page, 'json');
  expect((JSON.parse(json.bytes.toString()) as { parts: unknown[] }).parts.length).toBe(2);
  const csv = await downloaded(page, 'csv');
  const rows_ = csv.bytes.toString().trim().split('\n');
  const faceCount = await viewer.evaluate((element: GirthViewer) => element.info!.faceCount);
  expect(rows_.length).toBe(1 + faceCount);
  expect(new Set(rows_.slice(1).map((line) => line.split(',')[1]))).toEqual(new Set(['0', '1']));
  await panel.getByRole('button', { name: 'Show it whole' }).click();
  expect(await parts.count()).toBe(0);

  // Which necks are listed is a matter of how far they stand out; the narrowest always does.
  await panel.locator('#neck-prominence').fill('1000000');
  await page.keyboard.press('Enter');
  expect(await rows.count()).toBe(1);
  await panel.locator('#neck-prominence').fill('-1');
  await page.keyboard.press('Enter');
  expect(await panel.locator('#neck-prominence').getAttribute('aria-invalid')).toBe('true');
});

test('the menu has what is listed as files, once it is', async () => {
  const { page, viewer } = await openWith('torus.obj', torus(16, 9));
  const openMenu = () => page.getByRole('button', { name: 'Export' }).click();
  const isOffered = (what: string) => page.locator(`#export-${what}`).isVisible();
  await openMenu();
  await page.locator('#export').waitFor();
  expect([await isOffered('necks'), await isOffered('handles')]).toEqual([false, false]);
  await page.keyboard.press('Escape');
  const panel = await openPanel(page, 'necks');
  const rows = panel.getByRole('list', { name: 'Handles and tunnels' }).getByRole('button');
  await rows.first().waitFor({ timeout: 60_000 });
  const lengths = await viewer.evaluate(async (element: GirthViewer) => {
    const mesh = await element.mesh;
    return (await mesh.handles()).handles.map(({ length }) => length);
  });
  const files: Record<string, Buffer> = {};
  for (const format of ['csv', 'json', 'obj', 'glb']) {
    await openMenu();
    const { name, bytes } = await downloaded(page, format, '#export-handles');
    expect(name).toBe(`torus-handles.${format}`);
    files[format] = bytes;
  }
  const { handles } = JSON.parse(files['json']!.toString()) as { handles: { length: number }[] };
  expect(handles.map(({ length }) => length)).toEqual(lengths);
  expect(files['csv']!.toString().trim().split('\n')).toHaveLength(1 + lengths.length);
  expect(files['obj']!.toString().match(/^l /gm)!.length).toBeGreaterThan(0);
  expect(files['glb']!.toString('latin1', 0, 4)).toBe('glTF');
  await openMenu();
  expect([await isOffered('necks'), await isOffered('bottleneck')]).toEqual([true, false]);
});

test('the bottleneck of two points that are clicked, and the profile between them', async () => {
  const built = await openWith('dumbbell.obj', dumbbell(16, 12));
  const { page, viewer } = built;
  const panel = await openPanel(page, 'necks');
  const between = panel.getByRole('region', { name: 'Between two points' });
  await panel.getByRole('list', { name: 'Necks' }).waitFor({ timeout: 60_000 });
  const { ends, click } = await endsOf(built);
  const hint = page.locator('#asking p').first();
  const button = between.getByRole('button', { name: 'Bottleneck', exact: true });

  // Escape, and the button on the surface, end it; nothing is pinned.
  await button.click();
  await hint.getByText('Choose the first point').waitFor();
  await page.keyboard.press('Escape');
  await hint.waitFor({ state: 'hidden' });
  await button.click();
  await hint.getByRole('button', { name: 'Cancel' }).click();
  await hint.waitFor({ state: 'hidden' });

  await button.click();
  await click(0);
  await hint.getByText('Choose the second point').waitFor();
  await click(1);
  const row = between.getByRole('list', { name: 'Bottleneck' }).getByRole('button');
  await row.waitFor({ timeout: 60_000 });
  expect(await hint.isVisible()).toBe(false);
  expect(await viewer.evaluate((element: GirthViewer) => element.pinned.length)).toBe(0);
  const known = await viewer.evaluate(
    async (element: GirthViewer, [from, to]) => {
      const { kind, girth } = await element.bottleneck(from!, to!);
      const { necks } = await element.necks();
      const profile = await element.profile([from!, to!]);
      const csv = await element.exportProfile([from!, to!], 'csv', {
        samples: 5,
        crossings: false,
      });
      const { length } = await element.path(from!, to!);
      return {
        ...{ kind, girth, length, along: profile.length },
        rows: new TextDecoder().decode(csv).trim().split('\n').length,
        narrowest: Math.min(...necks.map((neck) => neck.length)),
      };
    },
    ends.map(({ v }) => v),
  );
  expect(known).toMatchObject({ kind: 'neck', rows: 6 });
  expect(known.girth).toBeCloseTo(known.narrowest, 9);
  expect(known.along).toBeCloseTo(known.length, 9);
  const words = (await row.textContent())!;
  expect(Number.parseFloat(words)).toBeCloseTo(known.girth, 1);
  expect(words).toContain('a neck between the points');
  await panel.getByText(/^Chosen: .* long; it separates an area of /).waitFor();
  await picture(page, 'page-bottleneck.png');
  await panel.getByRole('button', { name: 'Cut here' }).click();
  await panel.getByText('Cut into 2 parts.').waitFor();
  await panel.getByRole('button', { name: 'Show it whole' }).click();

  await between.getByRole('button', { name: 'Profile between these points' }).click();
  const plot = between.getByRole('slider', { name: /^Girth along the path/ });
  await plot.waitFor({ timeout: 60_000 });
  expect(await row.count()).toBe(0);
  // By the keyboard: the loop at the cursor is on the surface, and Enter pins it.
  await plot.focus();
  await page.keyboard.press('Home');
  await between.getByText(/^0.* from the first point: girth /).waitFor();
  // Listened to before anything is pressed.
  const pinned = await viewer.evaluateHandle((element: GirthViewer) => ({
    length: new Promise<number>((resolve) => {
      element.addEventListener('pick', ({ detail }) => {
        if (detail.action === 'pin') resolve(detail.loop.length);
      });
    }),
  }));
  for (let i = 0; i < 3; ++i) await page.keyboard.press('PageUp');
  const said = (await between.locator('.station').textContent())!;
  await picture(page, 'page-profile.png');
  await page.keyboard.press('Enter');
  const girth = Number.parseFloat(/girth ([\d.]+)/.exec(said)![1]!);
  expect(await pinned.evaluate(({ length }) => length)).toBeCloseTo(girth, 1);
  // From the surface back to the plot: at a point of the path.
  const box = (await viewer.boundingBox())!;
  const seen = await viewer.evaluate(
    async (element: GirthViewer, [from, to]) => {
      const { stations } = await element.profile([from!, to!]);
      const places = stations.map(({ place }) => element.screenPosition(place));
      const { x, y } = places.filter(({ visible }) => visible).at(5)!;
      return { x, y };
    },
    ends.map(({ v }) => v),
  );
  await page.mouse.move(box.x + seen.x, box.y + seen.y);
  await expect.poll(() => between.locator('.plot-mark').isVisible()).toBe(true);
  await page.mouse.move(box.x + 5, box.y + box.height - 5);
  await expect.poll(() => between.locator('.plot-mark').isVisible()).toBe(false);
  await between.getByText(/^Move along the plot/).waitFor();

  const coming = page.waitForEvent('download');
  await between.getByRole('button', { name: 'CSV' }).click();
  const download = await coming;
  expect(download.suggestedFilename()).toBe('dumbbell-profile.csv');
  const lines = readFileSync(await download.path(), 'utf8')
    .trim()
    .split(/\r?\n/);
  expect(lines[0]).toMatch(/^distance.*,girth.*,kind,face or vertex$/);
  expect(lines.length).toBeGreaterThan(101);
  expect(Number(lines.at(-1)!.split(',')[0])).toBeCloseTo(known.length, 0);

  // The address has the question and its points, and undo goes from one question to the other.
  await expect.poll(() => fragment(page)).toMatch(/&profile=[^,&]+,[^,&]+&/);
  const points = /=[^,&=]+,[^,&]+(?=&panel)/.exec(fragment(page))![0];
  // Camera and pinned loop are steps of their own.
  const step = async (keys: string, question: string): Promise<void> => {
    await viewer.focus();
    for (let at = fragment(page); !at.includes(`${question}${points}`); at = fragment(page)) {
      await page.keyboard.press(keys);
      // A step more would be one too many, and the address may be heard of after the key.
      await expect.poll(() => fragment(page)).not.toBe(at);
    }
  };
  await step('Control+z', 'bottleneck');
  await row.waitFor({ timeout: 60_000 });
  expect(await row.textContent()).toBe(words);
  await step('Control+Shift+Z', 'profile');
  await plot.waitFor({ timeout: 60_000 });
  expect(await row.count()).toBe(0);

  // With the other panel open nothing of it is left on the surface.
  await openPanel(page, 'loops');
  await openPanel(page, 'necks');
  await page.locator('aside').evaluate((aside) => aside.scrollTo(0, 0));
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.keyboard.press('0');
  await plot.scrollIntoViewIfNeeded();
  await picture(page, 'page-profile-dark.png');
  await page.locator('aside').evaluate((aside) => aside.scrollTo(0, 0));
  expect(await complaintsOfAxe(page)).toEqual([]);
});

test('a stroke that begins in the moment after a click is heard, and the surface stays', async () => {
  const built = await openWith('dumbbell.obj', dumbbell(16, 12));
  const { viewer } = built;
  const { ends } = await endsOf(built);
  const camera = await viewer.evaluate((element: GirthViewer) => element.camera);
  const counts = await viewer.evaluate(async (element: GirthViewer, [from, to]) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    // Pointers that no device has cannot be captured.
    canvas.setPointerCapture = () => undefined;
    const box = canvas.getBoundingClientRect();
    const send = (type: string, share: number, buttons: number): void => {
      const x = from!.x + share * (to!.x - from!.x);
      const init = { clientX: box.left + x, clientY: box.top + from!.y, buttons };
      const kind = { pointerId: 7, isPrimary: true, pointerType: 'mouse', bubbles: true };
      canvas.dispatchEvent(new PointerEvent(type, { ...init, ...kind, button: 0 }));
    };
    // Promises that are kept are heard of; no task is done in between.
    const turns = async (): Promise<void> => {
      for (let i = 0; i < 50; ++i) await Promise.resolve();
    };
    const one = element.chooseStroke();
    await turns();
    send('pointerdown', 0, 1);
    send('pointerup', 0, 0);
    const clicked = (await one).length;
    const next = element.chooseStroke();
    await turns();
    send('pointerdown', 0, 1);
    for (let i = 1; i <= 4; ++i) send('pointermove', i / 8, 1);
    send('pointerup', 1 / 2, 0);
    return [clicked, (await next).length];
  }, ends);
  // Where the tube is thinner the pointer is beside it.
  expect(counts[0]).toBe(1);
  expect(counts[1]).toBeGreaterThan(2);
  expect(await viewer.evaluate((element: GirthViewer) => element.camera)).toEqual(camera);
});

test('a path is drawn by clicks and strokes, taken back, measured, and kept in the link', async () => {
  const built = await openWith('dumbbell.obj', dumbbell(16, 12));
  const { page, viewer } = built;
  const panel = await openPanel(page, 'necks');
  const between = panel.getByRole('region', { name: 'Between two points' });
  const draw = between.getByRole('button', { name: 'Draw a path' });
  const hint = page.locator('#asking p').filter({ visible: true });
  const plot = between.getByRole('slider', { name: /^Girth along the path/ });
  const { ends, click } = await endsOf(built);
  const box_ = (await viewer.boundingBox())!;
  const middle = { x: box_.x + (ends[0]!.x + ends[1]!.x) / 2, y: box_.y + ends[0]!.y };
  const camera = await viewer.evaluate((element: GirthViewer) => element.camera);

  // One point is no path.
  await draw.click();
  await hint.getByText('Click points of the path, or drag over the surface').waitFor();
  expect(await draw.getAttribute('aria-pressed')).toBe('true');
  await click(0);
  await hint.getByText(/^One point/).waitFor();
  await page.keyboard.press('Escape');
  await between.getByText('Not measured.').waitFor();
  expect(await hint.count()).toBe(0);

  // A click, a stroke, and what was taken back: the stroke is one step.
  await draw.click();
  await click(0);
  await hint.getByText(/^One point/).waitFor();
  await page.mouse.move(box_.x + ends[0]!.x + 12, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x, middle.y, { steps: 8 });
  await page.mouse.up();
  await hint.getByText(/^\d+ points; Escape ends it$/).waitFor();
  const count = async () => Number.parseInt((await hint.textContent())!);
  const drawn = await count();
  expect(drawn).toBeGreaterThan(3);
  await picture(page, 'page-drawing.png');
  await click(1);
  await expect.poll(count).toBe(drawn + 1);
  await hint.getByRole('button', { name: 'Undo point' }).click();
  await expect.poll(count).toBe(drawn);
  await page.keyboard.press('Delete');
  await hint.getByText(/^One point/).waitFor();
  expect(await viewer.evaluate((element: GirthViewer) => element.pinned.length)).toBe(0);
  // The surface has not turned under it.
  expect(await viewer.evaluate((element: GirthViewer) => element.camera)).toEqual(camera);
  await page.mouse.move(box_.x + ends[0]!.x + 12, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x, middle.y, { steps: 8 });
  await page.mouse.up();
  await expect.poll(count).toBe(drawn);
  await click(1);
  await expect.poll(count).toBe(drawn + 1);
  await hint.getByRole('button', { name: 'Done' }).click();
  await plot.waitFor({ timeout: 60_000 });
  expect(await hint.count()).toBe(0);

  // The link has its points, and what is measured is what the element says of them.
  await expect.poll(() => fragment(page)).toMatch(/&profile=[^&]+&panel=necks/);
  const words = /profile=([^&]+)/.exec(fragment(page))![1]!;
  expect(words.split(',')).toHaveLength(drawn + 1);
  for (const word of words.split(',')) expect(word).toMatch(/^\d+(:[01](\.\d{1,4})?){2}$/);
  const known = await viewer.evaluate(async (element: GirthViewer, words) => {
    const points = words.split(',').map((word) => {
      const [face, a, b] = word.split(':').map(Number) as [number, number, number];
      return { face, weights: [a, b, Math.max(0, 1 - a - b)] as const };
    });
    const { length, stations } = await element.profile(points);
    const pieces = points
      .slice(1)
      .map(async (to, i) => (await element.path(points[i]!, to)).length);
    const sum = (await Promise.all(pieces)).reduce((all, one) => all + one, 0);
    return { length, sum, girths: stations.map(({ girth }) => girth) };
  }, words);
  expect(known.length).toBeCloseTo(known.sum, 9);
  const coming = page.waitForEvent('download');
  await between.getByRole('button', { name: 'CSV' }).click();
  const lines = readFileSync(await (await coming).path(), 'utf8')
    .trim()
    .split(/\r?\n/);
  expect(lines.slice(1).map((line) => Number(line.split(',')[1]))).toEqual(
    known.girths.map((girth) => expect.closeTo(girth, 9) as number),
  );
  await picture(page, 'page-drawn.png');

  // Its ends are two points like others; undone, the path is there again.
  await between.getByRole('button', { name: 'Bottleneck of its ends' }).click();
  await between.getByRole('list', { name: 'Bottleneck' }).getByRole('button').waitFor();
  await expect.poll(() => fragment(page)).toMatch(/&bottleneck=[^&,]+,[^&,]+&/);
  await viewer.focus();
  for (let i = 0; i < 4 && !fragment(page).includes(`profile=${words}`); ++i) {
    await page.keyboard.press('Control+z');
  }
  await plot.waitFor({ timeout: 60_000 });
  expect(fragment(page)).toContain(`profile=${words}`);

  // Drawn tight it is shorter, is measured anew, and can be taken back.
  const tight = between.getByRole('button', { name: 'Draw the path tight' });
  await tight.click();
  const said = between.getByText(/^Drawn tight: [\d.]+ long, before [\d.]+\./);
  await said.waitFor({ timeout: 60_000 });
  const [after, before] = (await said.textContent())!.match(/\d+\.\d+/g)!.map(Number);
  expect(after).toBeLessThan(before!);
  expect(before).toBeCloseTo(known.length, 1);
  await expect.poll(() => fragment(page)).not.toContain(`profile=${words}`);
  await plot.waitFor();
  expect(await tight.isVisible()).toBe(false);
  await picture(page, 'page-drawn-tight.png');
  await viewer.focus();
  await page.keyboard.press('Control+z');
  await tight.waitFor({ timeout: 60_000 });
  expect(fragment(page)).toContain(`profile=${words}`);
});

test('two points are chosen with a finger, and by the keyboard alone', async () => {
  const built = await openWith('dumbbell.obj', dumbbell(16, 12), {
    viewport: { width: 390, height: 844 },
    hasTouch: true,
  });
  const { page } = built;
  const panel = await openPanel(page, 'necks');
  const between = panel.getByRole('region', { name: 'Between two points' });
  await panel.getByRole('list', { name: 'Necks' }).waitFor({ timeout: 60_000 });
  const { tap } = await endsOf(built);
  const profile = between.getByRole('button', { name: 'Profile', exact: true });
  await profile.tap();
  await page.locator('#asking p').getByText('Choose the first point').waitFor();
  await picture(page, 'page-choosing-phone.png');
  await tap(0);
  await page.locator('#asking p').getByText('Choose the second point').waitFor();
  await tap(1);
  const plot = between.getByRole('slider', { name: /^Girth along the path/ });
  await plot.waitFor({ timeout: 60_000 });
  await plot.scrollIntoViewIfNeeded();
  // The first tap on the plot moves the cursor, and the second pins its loop.
  const pinned = () => built.viewer.evaluate((element: GirthViewer) => element.pinned.length);
  await plot.tap();
  await between.getByText(/from the first point: girth /).waitFor();
  expect(await pinned()).toBe(0);
  await picture(page, 'page-profile-phone.png');
  await plot.tap();
  await expect.poll(pinned).toBe(1);

  await profile.focus();
  await page.keyboard.press('Enter');
  await page.locator('#asking p').getByText('Choose the first point').waitFor();
  // The probe begins in the middle of the view.
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Enter');
  await page.locator('#asking p').getByText('Choose the second point').waitFor();
  for (let i = 0; i < 3; ++i) await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press('Enter');
  await plot.waitFor({ timeout: 60_000 });
});

test('what the triangles make is not listed, and short handles are taken away and brought back', async () => {
  const { page, viewer } = await openWith('torus.obj', torus(16, 10));
  const panel = await openPanel(page, 'necks');
  const necks = panel.getByRole('list', { name: 'Necks' }).getByRole('button');
  await necks.first().waitFor({ timeout: 60_000 });
  const known = await viewer.evaluate(async (element: GirthViewer) => ({
    necks: (await element.necks()).necks.map(({ length, prominence }) => prominence / length),
    lengths: (await element.handles()).handles.map(({ length }) => length),
  }));
  const all = known.necks.length;
  const clear = known.necks.filter((share) => share >= 0.01).length;
  expect(clear).toBeLessThan(all);
  expect(await necks.count()).toBe(clear);
  await panel.getByText(/^Empty: a hundredth of the length/).waitFor();
  await panel.locator('#neck-prominence').fill('0');
  await page.keyboard.press('Enter');
  expect(await necks.count()).toBe(all);

  // Nothing is shorter; then the handle is.
  const length = panel.locator('#handle-length');
  const remove = panel.getByRole('button', { name: 'Remove', exact: true });
  await remove.click();
  await panel.getByText(/^Type a length/).waitFor();
  await length.fill(String(known.lengths[0]! / 2));
  await page.keyboard.press('Enter');
  await panel.getByText('No loop is shorter: nothing was changed.').waitFor({ timeout: 60_000 });
  const between = String((known.lengths[0]! + known.lengths[1]!) / 2);
  await length.fill(between);
  await length.blur();
  await panel.getByText(/^1 of these 2 loops are shorter than /).waitFor();
  const before = await viewer.evaluate(async (element: GirthViewer) => {
    const { info } = element;
    return { faces: info!.faceCount, girth: [...(await element.fieldOf('igf')).values] };
  });
  await remove.click();
  await panel
    .getByText('Done: 1 handle cut, too large to be removed whole; genus 1 before, 0 now.')
    .waitFor({ timeout: 60_000 });
  await fieldComplete(viewer);
  await expect.poll(() => fragment(page)).toContain('handles=');
  expect(await viewer.evaluate((element: GirthViewer) => element.info!.genus)).toEqual([0]);
  await panel.getByText('No handle and no tunnel').waitFor({ timeout: 60_000 });
  await picture(page, 'page-handles-removed.png');
  await page.locator('#details-open').click();
  await page
    .getByText(
      'Short handles removed: 1 handle cut, too large to be removed whole; genus 1 before, 0 now',
    )
    .waitFor();
  await page.keyboard.press('Escape');

  const genusIs = (genus: number) =>
    expect
      .poll(() => viewer.evaluate((element: GirthViewer) => element.info!.genus[0]), {
        timeout: 30_000,
      })
      .toBe(genus);
  await page.keyboard.press('Control+z');
  await genusIs(1);
  // The girth of the surface is there at once: it was kept.
  const after = await viewer.evaluate((element: GirthViewer) => ({
    share: element.shareOf('igf'),
    faces: element.info!.faceCount,
    girth: [...element.values('igf')],
    removal: element.removal,
  }));
  expect(after).toEqual({ ...before, share: 1, removal: undefined });
  await expect.poll(() => fragment(page)).not.toContain('handles=');
  await page.keyboard.press('Control+Shift+Z');
  await genusIs(0);
  await expect.poll(() => fragment(page)).toContain('handles=');
});

test('where there is nothing to find, and no room, the panel says so; what is no length is refused', async () => {
  const built = await openWith('box.obj', box(2, 2, 2));
  const { page, viewer } = built;
  const panel = await openPanel(page, 'necks');
  const titles = () => panel.locator('h3').allTextContents();
  const another = async (name: string, text: string): Promise<void> => {
    await drop(page, { name, bytes: Buffer.from(text) });
    await modelIs(page, name);
    await fieldComplete(viewer);
  };
  // A box has neither necks nor handles: there is nothing to ask about, and nothing to cut.
  await panel
    .getByText('No neck: no loop is shorter than all around it')
    .waitFor({ timeout: 60_000 });
  expect(await titles()).toContain('No handle and no tunnel');
  expect(await panel.locator('#neck-prominence').isVisible()).toBe(false);
  expect(await panel.locator('#handle-length').isVisible()).toBe(false);
  expect(await panel.getByRole('button', { name: 'Cut here' }).isVisible()).toBe(false);

  // A surface with one side only is told to be one.
  expect(await panel.getByText(/one side only/).isVisible()).toBe(false);
  await another('moebius.obj', moebius(24));
  await panel
    .getByText(/^The surface has one side only and was cut along \d edges?, which no loop or path/)
    .waitFor();

  // A boundary curve is no handle, and what is cut from an open surface has no volume.
  await another('tube.obj', tube(12, 16, 4));
  await panel.getByText('No handle and no tunnel').waitFor({ timeout: 60_000 });
  expect(await viewer.evaluate(({ info }: GirthViewer) => info!.boundaries)).toEqual([2]);
  const cut = await viewer.evaluate(async (element: GirthViewer) => {
    const { points } = (await element.necks()).necks[0] ?? { points: [] };
    const { parts } = await element.cut([points]);
    return parts.map(({ volume }) => Number.isNaN(volume));
  });
  expect(cut).not.toContain(false);

  await another('needle.obj', plateWithNeedle());
  await panel.getByText('1 handle, 1 tunnel').waitFor({ timeout: 60_000 });
  const length = panel.locator('#handle-length');
  for (const wrong of ['-1', 'NaN', '2 parsecs', '1e999']) {
    await length.fill(wrong);
    await page.keyboard.press('Enter');
    expect([wrong, await length.getAttribute('aria-invalid')]).toEqual([wrong, 'true']);
  }
  expect(await viewer.evaluate(({ removal }: GirthViewer) => removal)).toBeUndefined();
  await length.fill('0');
  await page.keyboard.press('Enter');
  await panel.getByText('No loop is shorter: nothing was changed.').waitFor({ timeout: 60_000 });
  await length.fill('5');
  await page.keyboard.press('Enter');
  await panel
    .getByText(
      /^Done: 1 tunnel closed; genus 1 before, 0 now; no room: \d+ faces made or moved cross others\.$/,
    )
    .waitFor({ timeout: 60_000 });
  const { genus, crossing } = await viewer.evaluate(({ info, removal }: GirthViewer) => ({
    genus: info!.genus,
    crossing: removal!.crossingFaces,
  }));
  expect(genus).toEqual([0, 0]);
  expect(crossing).toBeGreaterThan(0);
});

test('of necks that cross the first counts, and the panel says so', async () => {
  const { page, viewer } = await openWith('torus.obj', torus(16, 10));
  // The loop round a handle crosses the one through its hole.
  await viewer.evaluate(async (element: GirthViewer) => {
    const { handles } = await element.handles();
    const { necks, unresolved } = await element.necks();
    const crossing = handles.map((handle) => ({ ...necks[0]!, ...handle, prominence: Infinity }));
    Object.assign(element, { necks: () => Promise.resolve({ necks: crossing, unresolved }) });
  });
  const panel = await openPanel(page, 'necks');
  await panel.getByRole('button', { name: 'Cut at 2 necks' }).click({ timeout: 60_000 });
  await panel
    .getByText(
      'Cut, and still one part: the loops separate nothing. 1 of the 2 necks is passed over: it crosses a more prominent one.',
    )
    .waitFor();
  await expect.poll(() => fragment(page)).toContain('cut=necks');
  await panel.getByRole('button', { name: 'Show it whole' }).click();
  await expect.poll(() => fragment(page)).not.toContain('cut=');
});

test('a link shows the bottleneck of two points from where it was seen; points that the model does not have are nothing', async () => {
  const seen = 'model=dumbbell&camera=1.1,0.4,4,0,0,0';
  const { page, viewer, address } = await openBuilt(`${seen}&bottleneck=3,500&panel=necks`);
  await modelIs(page, 'dumbbell.glb');
  const between = page.getByRole('region', { name: 'Between two points' });
  const row = between.getByRole('list', { name: 'Bottleneck' }).getByRole('button');
  await row.waitFor({ timeout: 60_000 });
  expect(await row.getAttribute('aria-pressed')).toBe('true');
  const { girth, distance } = await viewer.evaluate(async (element: GirthViewer) => ({
    girth: (await element.bottleneck(3, 500)).girth,
    distance: element.camera!.distance,
  }));
  expect(Number.parseFloat((await row.textContent())!)).toBeCloseTo(girth, 2);
  expect(distance).toBeCloseTo(4, 3);
  // Cut there, and undone; then along a neck of those that stand out, with open rims.
  const panel = page.locator('#necks-panel');
  await panel.getByRole('button', { name: 'Cut here' }).click();
  await expect.poll(() => fragment(page)).toContain('cut=bottleneck');
  await viewer.focus();
  await page.keyboard.press('Control+z');
  await expect.poll(() => fragment(page)).not.toContain('cut=');
  const parts = panel.getByRole('list', { name: 'Parts of the cut' }).getByRole('listitem');
  expect(await parts.count()).toBe(0);
  await page.keyboard.press('Control+Shift+Z');
  await panel.getByText('Cut into 2 parts.').waitFor();
  const cut = `${seen}&prominence=0&cut=neck:1&rims=1&panel=necks`;
  await page.goto(`${address}/#${cut}`);
  await expect.poll(async () => (await parts.allTextContents()).join(' ')).toMatch(/open.*open/);
  expect(await panel.locator('#neck-prominence').inputValue()).toBe('0');
  expect(
    await panel
      .getByRole('list', { name: 'Necks' })
      .getByRole('button')
      .first()
      .getAttribute('aria-pressed'),
  ).toBe('true');
  expect(fragment(page)).toBe(cut);
  await page.goto(`${address}/#${seen}&bottleneck=3,500&panel=necks`);
  await row.waitFor({ timeout: 60_000 });
  expect(await parts.count()).toBe(0);

  // Along a loop that is pinned, and where the girth has a value: in links, undone and done again.
  const known = await viewer.evaluate(async (element: GirthViewer) => {
    const { vertices } = (await element.necks()).necks[0]!;
    const { points } = await element.loop(vertices[0]!);
    const levels = await element.levelCurves(0.2);
    const cuts = [[points], levels.map((curve) => curve.points)];
    const found = await Promise.all(cuts.map((curves) => element.cut(curves, { cap: true })));
    return {
      vertex: vertices[0]!,
      counts: found.map((cut) => cut.parts.length),
      none: (await element.levelCurves(100)).length,
    };
  });
  expect(known).toMatchObject({ counts: [2, 3], none: 0 });
  const alongPinned = panel.getByRole('button', { name: 'Cut along the pinned loop' });
  expect(await alongPinned.isDisabled()).toBe(true);
  await viewer.evaluate((element: GirthViewer, vertex) => element.pin(vertex), known.vertex);
  await alongPinned.click();
  await expect.poll(() => fragment(page)).toContain(`&loops=${known.vertex}`);
  await expect.poll(() => fragment(page)).toContain('&cut=pin&');
  expect(await parts.count()).toBe(2);
  const girthInput = panel.locator('#cut-girth');
  await girthInput.fill('200 mm');
  await page.keyboard.press('Enter');
  await expect.poll(() => fragment(page)).toContain('&cut=at:0.2&');
  expect(await parts.count()).toBe(3);
  await picture(page, 'page-cut-level.png');
  await page.locator('#undo').click();
  await expect.poll(() => fragment(page)).toContain('&cut=pin&');
  await expect.poll(() => parts.count()).toBe(2);
  await page.locator('#redo').click();
  await expect.poll(() => parts.count()).toBe(3);
  for (const [text, words] of [
    ['0', /^Type a length/],
    ['100 m', 'Not cut: the girth never has this value.'],
  ] as const) {
    await girthInput.fill(text);
    await page.keyboard.press('Enter');
    await panel.getByText(words).waitFor();
  }
  await expect.poll(() => fragment(page)).not.toContain('cut=');
  expect(await parts.count()).toBe(0);
  await page.goto(`${address}/#${seen}&loops=${known.vertex}&cut=pin&panel=necks`);
  await expect.poll(() => parts.count()).toBe(2);
  await page.goto(`${address}/#${seen}&cut=at:0.2&rims=1&panel=necks`);
  await expect.poll(() => parts.count()).toBe(3);
  expect(await girthInput.inputValue()).toBe('0.2');
  // A loop that was pinned, and is let go again, cuts no longer.
  await page.goto(`${address}/#${seen}&loops=${known.vertex}&cut=pin&panel=necks`);
  await expect.poll(() => parts.count()).toBe(2);
  await viewer.evaluate((element: GirthViewer) => element.unpin(element.pinned[0]!.id));
  await expect.poll(() => parts.count()).toBe(0);
  await expect.poll(() => fragment(page)).not.toContain('cut=');
  await page.goto(`${address}/#${seen}&profile=3,100000000&panel=necks`);
  await row.waitFor({ state: 'detached' });
  expect(await between.getByRole('slider').isVisible()).toBe(false);
  expect(await between.getByText(/Not measured|from the first point/).isVisible()).toBe(false);
});

test('handles and tunnels are listed by their lengths, on a phone too', async () => {
  const { page, viewer } = await openWith('torus.obj', torus(16, 10), {
    viewport: { width: 390, height: 844 },
  });
  const panel = await openPanel(page, 'necks');
  const list = panel.getByRole('list', { name: 'Handles and tunnels' });
  const rows = list.getByRole('button');
  await rows.first().waitFor({ timeout: 60_000 });
  expect(await rows.count()).toBe(2);
  expect(await panel.locator('h3').allTextContents()).toContain('1 handle, 1 tunnel');
  const lengths = await viewer.evaluate(async (element: GirthViewer) =>
    (await element.handles()).handles.map(({ kind, length }) => ({ kind, length })),
  );
  expect(lengths[0]!.length).toBeLessThanOrEqual(lengths[1]!.length);
  const words = await rows.allTextContents();
  lengths.forEach(({ kind }, i) => expect(words[i]).toContain(kind));
  await rows.first().click();
  await panel.getByRole('button', { name: 'Cut here' }).click();
  await panel.getByText('Cut, and still one part: the loop separates nothing.').waitFor();
  await picture(page, 'page-cut-phone.png');
});
